// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.narrow.Manifold;
import sim.physics.motion.Trajectories;

/**
 * What the points of lasting pairs bear: their forces since these were found last, and their impulses in the step until then.
 * Forces of what stands still hold over any number of steps, without being written again.
 */
public final class ContactLedger implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Values per pair: the step that the impulses are of, from when on the forces hold, the normal; then its two points. */
    private static final int STRIDE = 20;

    private static final int STEP = 0;
    private static final int FROM = 1;
    private static final int NX = 2;
    private static final int NY = 3;
    private static final int POINTS = 4;

    /**
     * Values per point: its place relative to the first body that moves; forces, impulses, and forces to start the next
     * solution from, each along normal and tangent.
     */
    private static final int WIDTH = 8;

    private static final int FORCE = 2;
    private static final int IMPULSE = 4;
    private static final int START = 6;

    /** From when on forces hold that hold no more. */
    private static final double LEFT = -1;

    private final Trajectories trajectories;

    /** By pair: where its values are, plus 1. */
    private int[] places = {};

    private double[] data = {};
    private int used;

    /**
     * Makes an empty ledger.
     *
     * @param trajectories where time is
     */
    public ContactLedger(Trajectories trajectories) {
        this.trajectories = trajectories;
    }

    /** Begins a page for a pair that lasts from now on. */
    void begin(int pair) {
        if (pair >= places.length) {
            places = Arrays.copyOf(places, Math.max(2 * places.length, pair + 1));
        }
        if (places[pair] == 0) {
            places[pair] = used + 1;
            used += STRIDE;
            data = used > data.length ? Arrays.copyOf(data, 2 * used) : data;
        }
        int o = places[pair] - 1;
        boolean isAgain = data[o + FROM] == LEFT && data[o + STEP] == trajectories.step();
        for (int k = 0; k < STRIDE; k++) {
            boolean isKept = isAgain && k >= POINTS && (k - POINTS) % WIDTH / 2 == IMPULSE / 2;
            data[o + k] = isKept ? data[o + k] : 0;
        }
        data[o + STEP] = trajectories.step();
    }

    /** A pair parts at an instant of the step: what its points have borne until then is kept for when it begins again within the step. */
    void leave(int pair, double tau) {
        int o = turn(pair);
        for (int p = o + POINTS; p < o + STRIDE; p += WIDTH) {
            for (int c = 0; c < 2; c++) {
                data[p + IMPULSE + c] += data[p + FORCE + c] * (tau - data[o + FROM]);
                data[p + FORCE + c] = 0;
            }
        }
        data[o + FROM] = LEFT;
    }

    /**
     * Takes in where the points of a pair are whose forces are being found.
     *
     * @param onA whether points are taken relative to its first body, else to the second one
     */
    void open(int pair, double tau, Manifold m, boolean onA) {
        int o = turn(pair);
        data[o + NX] = m.nx;
        data[o + NY] = m.ny;
        for (int k = 0; k < 2; k++) {
            int p = o + POINTS + WIDTH * k;
            if (k < m.count) {
                data[p] = onA ? m.rAx[k] : m.rBx[k];
                data[p + 1] = onA ? m.rAy[k] : m.rBy[k];
            }
            for (int c = 0; c < 2; c++) {
                data[p + IMPULSE + c] += data[p + FORCE + c] * (tau - data[o + FROM]);
                data[p + FORCE + c] = 0;
            }
        }
        data[o + FROM] = tau;
    }

    /** Says along which normal the forces of a pair act, and where a point is then, if that is not as it was taken in. */
    void turn(int pair, int point, double nx, double ny, double rx, double ry) {
        int o = places[pair] - 1;
        data[o + NX] = nx;
        data[o + NY] = ny;
        data[o + POINTS + WIDTH * point] = rx;
        data[o + POINTS + WIDTH * point + 1] = ry;
    }

    /** Turns a pair's page to this step; returns where it is. */
    private int turn(int pair) {
        int o = places[pair] - 1;
        if (data[o + STEP] != trajectories.step()) {
            data[o + STEP] = trajectories.step();
            data[o + FROM] = 0;
            for (int k = 0; k < 2; k++) {
                data[o + POINTS + WIDTH * k + IMPULSE] = 0;
                data[o + POINTS + WIDTH * k + IMPULSE + 1] = 0;
            }
        }
        return o;
    }

    /** Sets the forces of a point. */
    void press(int pair, int point, double normal, double tangential) {
        int p = places[pair] - 1 + POINTS + WIDTH * point;
        data[p + FORCE] = normal;
        data[p + FORCE + 1] = tangential;
    }

    /** The force of a point along the normal, or the tangent. */
    double force(int pair, int point, boolean tangential) {
        return data[places[pair] - 1 + POINTS + WIDTH * point + FORCE + (tangential ? 1 : 0)];
    }

    /** Whether a point of a pair has pressed in the last solution. */
    boolean presses(int pair) {
        return start(pair, 0, false) > 0 || start(pair, 1, false) > 0;
    }

    /** Adds impulses of a point. */
    void strike(int pair, int point, double normal, double tangential) {
        int p = places[pair] - 1 + POINTS + WIDTH * point;
        data[p + IMPULSE] += normal;
        data[p + IMPULSE + 1] += tangential;
    }

    /** Sets the forces of a point to start its next solution from. */
    void setStart(int pair, int point, double normal, double tangential) {
        int p = places[pair] - 1 + POINTS + WIDTH * point;
        data[p + START] = normal;
        data[p + START + 1] = tangential;
    }

    /** The forces of a point to start its next solution from: along the normal, or the tangent. */
    double start(int pair, int point, boolean tangential) {
        return data[places[pair] - 1 + POINTS + WIDTH * point + START + (tangential ? 1 : 0)];
    }

    /**
     * The normal of a pair.
     *
     * @param pair number of the pair
     * @param component 0 or 1
     * @return from its first body to the second one
     */
    public double normal(int pair, int component) {
        return data[places[pair] - 1 + NX + component];
    }

    /**
     * The place of a point.
     *
     * @param pair number of the pair
     * @param point 0 or 1
     * @param component 0 or 1
     * @return relative to the pair's first body that moves
     */
    public double place(int pair, int point, int component) {
        return data[places[pair] - 1 + POINTS + WIDTH * point + component];
    }

    /**
     * The mean force of a point over the present step, which is over.
     *
     * @param pair number of the pair
     * @param point 0 or 1
     * @param tangential whether along the tangent, else along the normal
     * @return 0 if it bears nothing
     */
    public double meanForce(int pair, int point, boolean tangential) {
        int o = places[pair] - 1;
        int p = o + POINTS + WIDTH * point + (tangential ? 1 : 0);
        if (data[o + STEP] != trajectories.step()) {
            return data[p + FORCE];
        }
        double h = trajectories.h();
        double mean = (data[p + IMPULSE] + data[p + FORCE] * (h - data[o + FROM])) / h;
        return tangential ? mean : Math.max(0, mean); // impulses that were taken back leave a rounding
    }
}
