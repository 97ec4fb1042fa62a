// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.broad.Pairs;
import sim.physics.collision.narrow.Manifold;
import sim.physics.internal.IntList;
import sim.physics.motion.Trajectories;

/**
 * What the points of lasting pairs bear: their forces since these were found last, and their impulses in the step until then.
 * Forces of what stands still hold over any number of steps, without being written again. A pair that ends within a step keeps its page
 * until the step is over, so that what it has borne until then can be read.
 */
public final class ContactLedger implements Serializable {
    private static final long serialVersionUID = 2L;

    /**
     * Values per pair: the step that the impulses are of, from when on the forces hold, the normal; what impulses, and forces, lack if they
     * are taken to act along it; the pair and its bodies; the last step in which it has ended; then its two points.
     */
    private static final int STRIDE = 28;

    private static final int STEP = 0;
    private static final int FROM = 1;
    private static final int NX = 2;
    private static final int NY = 3;
    private static final int LACK = 4;
    private static final int LACKING = 6;
    private static final int PAIR = 8;
    private static final int A = 9;
    private static final int B = 10;
    private static final int ENDED = 11;
    private static final int POINTS = 12;

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
    private final Pairs pairs;

    /** By pair: where its page is, plus 1. */
    private int[] places = {};

    private double[] data = {};
    private int used;

    /** Pages of pairs that have ended in the step, some of which may have begun again; and pages of no pair. */
    private final IntList ended = new IntList();

    private final IntList free = new IntList();

    /** The number of the step, and the offset in it of what is being handled. */
    private double step;

    private double now;

    /**
     * Makes an empty ledger.
     *
     * @param trajectories where time is
     * @param pairs the pairs
     */
    public ContactLedger(Trajectories trajectories, Pairs pairs) {
        this.trajectories = trajectories;
        this.pairs = pairs;
    }

    /** Begins a step. */
    public void begin() {
        step++; // a step that was broken off is another one than that which goes on from there
        now = 0;
        for (int k = 0; k < ended.size; k++) {
            release(ended.values[k]);
        }
        ended.clear();
    }

    /**
     * Says when in the step that is which is being handled.
     *
     * @param tau offset in the step
     */
    public void setNow(double tau) {
        now = tau;
    }

    /**
     * Begins a page for a pair that lasts from now on.
     *
     * @param goesOn whether it has a page on which it has borne something until now
     */
    void begin(int pair, boolean goesOn) {
        if (pair >= places.length) {
            places = Arrays.copyOf(places, Math.max(2 * places.length, pair + 1));
        }
        boolean isAgain = places[pair] != 0 && isOf(places[pair] - 1, pair);
        if (isAgain && goesOn) {
            leave(pair, now);
        } else if (places[pair] == 0 || !isAgain && isKept(places[pair] - 1)) {
            places[pair] = open() + 1;
        }
        int o = places[pair] - 1;
        isAgain &= data[o + STEP] == step;
        for (int k = NX; k < STRIDE; k++) {
            boolean isKept = k == ENDED || isAgain && (k >= POINTS ? (k - POINTS) % WIDTH / 2 == IMPULSE / 2 : k < LACKING);
            data[o + k] = isKept ? data[o + k] : 0;
        }
        data[o + STEP] = step;
        data[o + FROM] = now;
        data[o + PAIR] = pair;
        data[o + A] = pairs.first(pair);
        data[o + B] = pairs.second(pair);
    }

    /** A new page. */
    private int open() {
        if (free.size > 0) {
            return free.values[--free.size];
        }
        used += STRIDE;
        data = used > data.length ? Arrays.copyOf(data, 2 * used) : data;
        return used - STRIDE;
    }

    private boolean isOf(int o, int pair) {
        return data[o + A] == pairs.first(pair) && data[o + B] == pairs.second(pair);
    }

    /** Whether a page is of a pair that has ended in this step, having borne something. */
    private boolean isKept(int o) {
        return data[o + FROM] == LEFT && data[o + STEP] == step && bears(o);
    }

    private boolean bears(int o) {
        return data[o + POINTS + IMPULSE] > 0 || data[o + POINTS + WIDTH + IMPULSE] > 0;
    }

    /**
     * A pair lasts no more: what its points have borne until now is kept for this step.
     *
     * @param goesOn whether it does, for another reason, or has not lasted
     */
    void leave(int pair, boolean goesOn) {
        if (!goesOn) {
            leave(pair, now);
        }
    }

    /** The same at an instant of the step. */
    void leave(int pair, double tau) {
        int o = turn(pair);
        if (data[o + FROM] == LEFT) {
            return;
        }
        close(o, tau);
        data[o + FROM] = LEFT;
        if (bears(o) && data[o + ENDED] != step) {
            data[o + ENDED] = step;
            ended.add(o);
        }
    }

    /** Forces hold no more. */
    private void close(int o, double tau) {
        double time = tau - data[o + FROM];
        for (int c = 0; c < 2; c++) {
            for (int p = o + POINTS + c; p < o + STRIDE; p += WIDTH) {
                data[p + IMPULSE] += data[p + FORCE] * time;
                data[p + FORCE] = 0;
            }
            data[o + LACK + c] += data[o + LACKING + c] * time;
            data[o + LACKING + c] = 0;
        }
        data[o + FROM] = tau;
    }

    /** The points of a pair bear nothing from an instant on, until forces are found anew. */
    void relax(int pair, double tau) {
        close(turn(pair), tau);
    }

    /**
     * Takes in where the points of a pair are whose forces are being found.
     *
     * @param onA whether points are taken relative to its first body, else to the second one
     */
    void open(int pair, double tau, Manifold m, boolean onA) {
        int o = turn(pair);
        close(o, tau);
        face(o, m.nx, m.ny);
        for (int k = 0; k < m.count; k++) {
            int p = o + POINTS + WIDTH * k;
            data[p] = onA ? m.rAx[k] : m.rBx[k];
            data[p + 1] = onA ? m.rAy[k] : m.rBy[k];
        }
    }

    /** Takes another normal for that of a pair, along which the same impulses lack something. */
    private void face(int o, double nx, double ny) {
        double dx = data[o + NX] - nx;
        double dy = data[o + NY] - ny;
        if (dx != 0 || dy != 0) {
            data[o + NX] = nx;
            data[o + NY] = ny;
            for (int p = o + POINTS; p < o + STRIDE; p += WIDTH) {
                lack(o + LACK, dx, dy, data[p + IMPULSE], data[p + IMPULSE + 1]);
            }
        }
    }

    /** What lacks to what acts along a normal and its tangent, but is taken to act along another one. */
    private void lack(int at, double dx, double dy, double normal, double tangential) {
        data[at] += normal * dx - tangential * dy;
        data[at + 1] += normal * dy + tangential * dx;
    }

    /**
     * Says along which normal the force of a point acts, and where the point is then, if that is not as it was taken in.
     *
     * @param isFirst whether it is the first point of its pair, whose normal is that of the pair
     */
    void turn(int pair, int point, boolean isFirst, double nx, double ny, double rx, double ry) {
        int o = places[pair] - 1;
        int p = o + POINTS + WIDTH * point;
        if (isFirst) {
            face(o, nx, ny);
        }
        lack(o + LACKING, nx - data[o + NX], ny - data[o + NY], data[p + FORCE], data[p + FORCE + 1]);
        data[p] = rx;
        data[p + 1] = ry;
    }

    /** Adds what the second body of a pair gets beside what its points bear: evenly over a time from now on, or at once if that is 0. */
    void lack(int pair, double x, double y, double time) {
        int at = places[pair] - 1 + (time > 0 ? LACKING : LACK);
        data[at] += time > 0 ? x / time : x;
        data[at + 1] += time > 0 ? y / time : y;
    }

    /** Turns a pair's page to this step; returns where it is. */
    private int turn(int pair) {
        int o = places[pair] - 1;
        if (data[o + STEP] != step) {
            data[o + STEP] = step;
            data[o + FROM] = data[o + FROM] == LEFT ? LEFT : 0;
            data[o + LACK] = 0;
            data[o + LACK + 1] = 0;
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

    /** The same along another normal than that of the pair. */
    void strike(int pair, int point, double nx, double ny, double normal, double tangential) {
        strike(pair, point, normal, tangential);
        int o = places[pair] - 1;
        lack(o + LACK, nx - data[o + NX], ny - data[o + NY], normal, tangential);
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
     * Adds the pages of pairs that have ended in the step that is over, and have borne something in it.
     *
     * @param pages takes them
     */
    public void addEnded(IntList pages) {
        for (int k = 0; k < ended.size; k++) {
            if (isKept(ended.values[k])) {
                pages.add(ended.values[k]);
            }
        }
    }

    /**
     * A body leaves, and nobody asks any more what has borne it.
     *
     * @param body index
     */
    public void drop(int body) {
        int count = 0;
        for (int k = 0; k < ended.size; k++) {
            int o = ended.values[k];
            if (data[o + A] == body || data[o + B] == body) {
                Arrays.fill(data, o + POINTS, o + STRIDE, 0);
                data[o + ENDED] = 0;
                release(o);
            } else {
                ended.values[count++] = o;
            }
        }
        ended.size = count; // else who removes thousands looks through all of theirs each time
    }

    /** A page is free if its pair has begun again on another one. */
    private void release(int o) {
        if (places[(int) data[o + PAIR]] != o + 1) {
            free.add(o);
        }
    }

    /**
     * The page of a pair.
     *
     * @param pair its number; it lasts
     * @return where the page is
     */
    public int page(int pair) {
        return places[pair] - 1;
    }

    /**
     * The number of a page's pair.
     *
     * @param page where it is
     * @return −1 if that number is of another pair now
     */
    public int pair(int page) {
        int pair = (int) data[page + PAIR];
        return places[pair] == page + 1 ? pair : -1;
    }

    /**
     * The bodies of a page's pair.
     *
     * @param page where it is
     * @param side 0 or 1
     * @return index of its first body, or its second one
     */
    public int body(int page, int side) {
        return (int) data[page + A + side];
    }

    /**
     * The normal of a pair.
     *
     * @param page of the pair
     * @param component 0 or 1
     * @return from its first body to the second one
     */
    public double normal(int page, int component) {
        return data[page + NX + component];
    }

    /**
     * The place of a point.
     *
     * @param page of the pair
     * @param point 0 or 1
     * @param component 0 or 1
     * @return relative to the pair's first body that moves
     */
    public double place(int page, int point, int component) {
        return data[page + POINTS + WIDTH * point + component];
    }

    /**
     * The mean force of a point over the present step, which is over.
     *
     * @param page of the pair
     * @param point 0 or 1
     * @param tangential whether along the tangent, else along the normal
     * @return 0 if it bears nothing
     */
    public double meanForce(int page, int point, boolean tangential) {
        double mean = mean(page, page + POINTS + WIDTH * point + IMPULSE + (tangential ? 1 : 0), IMPULSE - FORCE);
        return tangential ? mean : Math.max(0, mean); // impulses that were taken back leave a rounding
    }

    /**
     * What lacks to the mean forces of a pair's points, which have not all acted along its normal and its tangent.
     *
     * @param page of the pair
     * @param component 0 or 1
     * @return force on the second body
     */
    public double lack(int page, int component) {
        return mean(page, page + LACK + component, LACK - LACKING);
    }

    /** The mean over the step of an impulse, whose force is that far before it. */
    private double mean(int page, int impulse, int before) {
        double force = data[impulse - before];
        if (data[page + STEP] != step) {
            return force;
        }
        double h = trajectories.h();
        return data[page + FROM] == LEFT ? data[impulse] / h : (data[impulse] + force * (h - data[page + FROM])) / h;
    }
}
