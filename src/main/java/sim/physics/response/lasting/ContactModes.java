// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;

/**
 * Exact forces of a {@link ContactSystem} of not too many points: each is open, sticks or slides, and the rows of those that
 * are not open are equations, which are solved by elimination. Modes that turn out wrong are changed, until all are right.
 */
final class ContactModes implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int OPEN = 0;
    private static final int STICK = 1;
    private static final int SLIDE = 2;

    private static final int CHANGES = 40;
    private static final int REFINEMENTS = 6;

    /** What is none, relative to the largest value. */
    private static final double NONE = 1e-11;

    private double[] start = {};
    private int[] mode = {};
    private double[] side = {};

    /** Number of a point's normal and tangential unknown, or −1. */
    private int[] normal = {};

    private int[] tangent = {};
    private int unknowns;
    private final ContactEquations equations = new ContactEquations(false, REFINEMENTS);

    /** What a unit at a point does there, at most. */
    private double heaviest;

    ContactModes() {
        // grows with the clusters
    }

    /** Keeps the values that are there without contact forces. */
    void keep(double[] u) {
        start = start.length < u.length ? u.clone() : start;
        System.arraycopy(u, 0, start, 0, u.length);
    }

    void restore(double[] u) {
        System.arraycopy(start, 0, u, 0, u.length);
    }

    /** Displacements that close all gaps. */
    void close(ContactSystem s) {
        keep(s.u);
        ensure(s.size());
        for (int p = 0; p < s.size(); p++) {
            mode[p] = s.parts(p) ? OPEN : SLIDE;
            side[p] = 0;
        }
        assemble(s, false, true);
        equations.solve(unknowns);
        apply(s);
    }

    /** Finds the forces, from the modes that relaxation guesses; false if the modes go round in a circle. */
    boolean solve(ContactSystem s, boolean forces) {
        int n = s.size();
        ensure(n);
        for (int p = 0; p < n; p++) {
            double most = s.friction(p) * s.normalForce(p);
            double t = s.tangentForce(p);
            boolean slides = Math.abs(t) >= most * (1 - 1e-6);
            mode[p] = !(s.normalForce(p) > 0) ? OPEN : slides ? SLIDE : STICK;
            side[p] = forces && s.sliding(p) != 0 ? -Math.signum(s.sliding(p)) : Math.signum(t);
            if (forces && s.sliding(p) != 0 && mode[p] == STICK) {
                mode[p] = SLIDE;
            }
            mode[p] = forces && s.parts(p) ? OPEN : mode[p];
        }
        for (int change = 0; change < CHANGES; change++) {
            assemble(s, forces, false);
            equations.solve(unknowns);
            apply(s);
            if (!improve(s, forces)) {
                return isFinite(s);
            }
        }
        return false;
    }

    private void ensure(int n) {
        if (mode.length < n) {
            mode = new int[n];
            side = new double[n];
            normal = new int[n];
            tangent = new int[n];
            equations.ensure(2 * n);
        }
    }

    /** The equations of the points that are not open: a column is what a unit of its unknown does. */
    private void assemble(ContactSystem s, boolean forces, boolean gaps) {
        unknowns = 0;
        for (int p = 0; p < s.size(); p++) {
            normal[p] = mode[p] == OPEN ? -1 : unknowns++;
            tangent[p] = mode[p] == STICK ? unknowns++ : -1;
        }
        heaviest = 0;
        for (int p = 0; p < s.size(); p++) {
            if (normal[p] >= 0) {
                column(s, p, normal[p], 1, mode[p] == SLIDE ? side[p] * s.friction(p) : 0);
            }
            if (tangent[p] >= 0) {
                column(s, p, tangent[p], 0, 1);
            }
        }
        restore(s.u);
        for (int p = 0; p < s.size(); p++) {
            if (normal[p] >= 0) {
                equations.setRight(normal[p], -(s.normal(p) + (gaps ? s.gap(p) : forces ? s.bias(p) : 0)), heaviest);
            }
            if (tangent[p] >= 0) {
                equations.setRight(tangent[p], -s.slip(p, forces), heaviest);
            }
        }
    }

    private void column(ContactSystem s, int p, int column, double fn, double ft) {
        Arrays.fill(s.u, 0);
        s.push(p, fn, ft);
        for (int q = 0; q < s.size(); q++) {
            if (normal[q] >= 0) {
                set(normal[q], column, s.normal(q));
            }
            if (tangent[q] >= 0) {
                set(tangent[q], column, s.tangent(q));
            }
        }
    }

    private void set(int row, int column, double value) {
        equations.set(row * unknowns + column, value);
        heaviest = row == column ? Math.max(heaviest, Math.abs(value)) : heaviest;
    }

    private double forceN(int p) {
        return normal[p] < 0 ? 0 : equations.solution(normal[p]);
    }

    private double forceT(ContactSystem s, int p) {
        return mode[p] == SLIDE ? side[p] * s.friction(p) * forceN(p) : tangent[p] < 0 ? 0 : equations.solution(tangent[p]);
    }

    private void apply(ContactSystem s) {
        restore(s.u);
        for (int p = 0; p < s.size(); p++) {
            s.push(p, forceN(p), forceT(s, p));
            s.setForces(p, forceN(p), forceT(s, p));
        }
    }

    private static boolean isFinite(ContactSystem s) {
        for (int k = 0; k < s.u.length; k++) {
            if (!(Math.abs(s.u[k]) < Double.POSITIVE_INFINITY)) {
                return false;
            }
        }
        return true;
    }

    /** Changes modes that are wrong; false if none is. */
    private boolean improve(ContactSystem s, boolean forces) {
        double most = 0;
        double fastest = 0;
        for (int p = 0; p < s.size(); p++) {
            most = Math.max(most, Math.abs(forceN(p)));
            fastest = Math.max(fastest, most * s.normalMobility(p));
        }
        boolean changed = false;
        for (int p = 0; p < s.size(); p++) {
            changed |= improve(s, p, forces, NONE * most, NONE * fastest);
        }
        return changed;
    }

    private boolean improve(ContactSystem s, int p, boolean forces, double force, double speed) {
        boolean fixed = forces && s.sliding(p) != 0;
        if (forces && s.parts(p)) {
            return false;
        }
        if (mode[p] == OPEN) {
            boolean approaches = s.normal(p) + (forces ? s.bias(p) : 0) < -speed;
            mode[p] = approaches ? fixed || s.friction(p) == 0 ? SLIDE : STICK : OPEN;
            return approaches;
        }
        if (forceN(p) < -force) {
            mode[p] = OPEN;
            return true;
        }
        if (mode[p] == STICK && Math.abs(forceT(s, p)) > s.friction(p) * forceN(p) + force) {
            side[p] = Math.signum(forceT(s, p));
            mode[p] = SLIDE;
            return true;
        }
        if (mode[p] == SLIDE && !fixed && s.friction(p) > 0 && side[p] * s.slip(p, forces) > speed) {
            mode[p] = STICK; // friction would speed it up
            return true;
        }
        return false;
    }
}
