// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.DisjointSets;

/**
 * What is taken from the motion of a heap's bodies beside what the impulses of their contacts do: it is told as if pressing contacts had
 * done that, too, so that what is told of a body's contacts is all that they have given it.
 */
final class TakenMotion implements Serializable {
    private static final long serialVersionUID = 1L;

    private final HeapSystem s;

    /** Momenta that are not told yet, 2 per body. */
    private double[] momenta = {};

    /** By body, and last by what is fixed: which are connected, and by how many contacts that are left. */
    private int[] groups = {};

    private int[] degrees = {};

    /** Whether a contact is left, of those that connect what others do not. */
    private boolean[] isLeft = {};

    TakenMotion(HeapSystem system) {
        s = system;
    }

    /** Keeps the velocities from which something is to be taken. */
    void keep() {
        int n = s.bodyCount();
        if (groups.length <= n) {
            momenta = new double[4 * n + 4];
            groups = new int[2 * n + 2];
            degrees = new int[2 * n + 2];
        }
        for (int k = 0; k < n; k++) {
            momenta[2 * k] = -s.v[3 * k];
            momenta[2 * k + 1] = -s.v[3 * k + 1];
        }
    }

    /** Tells what has been taken since then: evenly over a time, or at once if that is 0. */
    void tell(HeapNotes notes, double time) {
        for (int k = 0; k < s.bodyCount(); k++) {
            momenta[2 * k] = (momenta[2 * k] + s.v[3 * k]) / s.w[2 * k];
            momenta[2 * k + 1] = (momenta[2 * k + 1] + s.v[3 * k + 1]) / s.w[2 * k];
        }
        connect();
        boolean isAny = true;
        while (isAny) {
            isAny = false;
            for (int p = 0; p < s.contacts(); p++) {
                int end = isLeft[p] ? end(p) : -1;
                if (end >= 0) {
                    isAny = true;
                    tell(p, end, notes, time);
                }
            }
        }
    }

    /** Finds contacts that connect bodies with one another, and with what is fixed, each by one way only; those that press first. */
    private void connect() {
        int n = s.bodyCount();
        isLeft = isLeft.length < s.contacts() ? new boolean[2 * s.contacts()] : isLeft;
        Arrays.fill(degrees, 0, n + 1, 0);
        for (int k = 0; k <= n; k++) {
            groups[k] = k;
        }
        for (int p = 0; p < s.contacts(); p++) {
            isLeft[p] = s.normalImpulse(p) != 0 && joins(body(p, 0), body(p, 1));
        }
        for (int p = 0; p < s.contacts(); p++) {
            isLeft[p] |= s.normalImpulse(p) == 0 && joins(body(p, 0), body(p, 1));
        }
    }

    private boolean joins(int a, int b) {
        boolean yes = DisjointSets.find(groups, a) != DisjointSets.find(groups, b);
        if (yes) {
            DisjointSets.join(groups, a, b);
            degrees[a]++;
            degrees[b]++;
        }
        return yes;
    }

    private int body(int p, int side) {
        int body = s.rows().body(p, side);
        return body < 0 ? s.bodyCount() : body;
    }

    /** The side of a contact on which it is the last one of a body, −1 if there is none. */
    private int end(int p) {
        for (int side = 0; side < 2; side++) {
            int body = body(p, side);
            if (body < s.bodyCount() && degrees[body] == 1) {
                return side;
            }
        }
        return -1;
    }

    private void tell(int p, int side, HeapNotes notes, double time) {
        int body = body(p, side);
        int other = body(p, 1 - side);
        double x = momenta[2 * body];
        double y = momenta[2 * body + 1];
        notes.lack(p, side == 1 ? x : -x, side == 1 ? y : -y, time);
        isLeft[p] = false;
        degrees[body]--;
        degrees[other]--;
        if (other < s.bodyCount()) {
            momenta[2 * other] += x;
            momenta[2 * other + 1] += y;
        }
    }
}
