// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import sim.physics.internal.Trig;
import sim.physics.motion.Body;
import sim.physics.motion.State;

/** The rows of an island's pins, (42)–(46), all in one loop: {@link PinJoint#evaluate} without a call for each. */
final class PinRows implements Serializable {
    private static final long serialVersionUID = 1L;

    private final Island island;
    private final boolean[] isPin;

    /** Nodes of the pins. */
    private final int[] pins;

    /** By node: the arms in the coordinates of the bodies, or of the world where a body cannot move. */
    private final double[] arms;

    /** Cosine and sine of each body's orientation. */
    private final double[] turn;

    PinRows(Island island) {
        this.island = island;
        int n = island.constraints.length;
        isPin = new boolean[n];
        int count = 0;
        for (int k = 0; k < n; k++) {
            isPin[k] = island.constraints[k] instanceof PinJoint;
            count += isPin[k] ? 1 : 0;
        }
        pins = new int[count];
        arms = new double[4 * island.nodes];
        turn = new double[2 * island.bodies.size];
        for (int k = 0, at = 0; k < n; k++) {
            if (isPin[k]) {
                pins[at++] = island.firstNode[k];
                prepare(island.firstNode[k], (PinJoint) island.constraints[k]);
            }
        }
    }

    boolean has(int constraint) {
        return isPin[constraint];
    }

    private void prepare(int p, PinJoint pin) {
        anchor(4 * p, pin.getBodyA(), pin.getAnchorAX(), pin.getAnchorAY());
        anchor(4 * p + 2, pin.getBodyB(), pin.getAnchorBX(), pin.getAnchorBY());
        if (island.a[p] >= 0) {
            island.j[Island.J * p] = 1;
            island.j[Island.J * p + 4] = 1;
        }
        if (island.b[p] >= 0) {
            island.j[Island.J * p + 6] = -1;
            island.j[Island.J * p + 10] = -1;
        }
    }

    /** Keeps an anchor in the coordinates of its body, or where it is in the world if it does not move. */
    private void anchor(int at, Body body, double x, double y) {
        arms[at] = x;
        arms[at + 1] = y;
        if (body != null && body.isFixed()) {
            double cos = Trig.cos(body.getAngle());
            double sin = Trig.sin(body.getAngle());
            arms[at] = body.getX() + (cos * x - sin * y);
            arms[at + 1] = body.getY() + (sin * x + cos * y);
        }
    }

    /** Evaluates C, J and J̇ ẋ of all pins at the positions and velocities of the state vectors. */
    void evaluate(State state) {
        if (pins.length == 0) {
            return;
        }
        double[] x = state.x();
        for (int k = 0; k < island.bodies.size; k++) {
            Trig.sinCos(x[State.BLOCK * island.bodies.values[k] + State.THETA], turn, 2 * k);
        }
        for (int k = 0; k < pins.length; k++) {
            evaluate(pins[k], x, state.v());
        }
    }

    private void evaluate(int p, double[] x, double[] v) {
        double[] j = island.j;
        double ax = arms[4 * p];
        double ay = arms[4 * p + 1];
        double bx = arms[4 * p + 2];
        double by = arms[4 * p + 3];
        double rateX = 0;
        double rateY = 0;
        int o = Island.J * p;
        if (island.a[p] >= 0) {
            double cos = turn[2 * island.a[p]];
            double sin = turn[2 * island.a[p] + 1];
            double rx = cos * ax - sin * ay; // (45), (46)
            double ry = sin * ax + cos * ay;
            double omega = v[island.blockA[p] + State.THETA];
            rateX = -omega * omega * rx;
            rateY = -omega * omega * ry;
            j[o + 2] = -ry;
            j[o + 5] = rx;
            ax = x[island.blockA[p]] + rx; // (42)
            ay = x[island.blockA[p] + 1] + ry;
        }
        if (island.b[p] >= 0) {
            double cos = turn[2 * island.b[p]];
            double sin = turn[2 * island.b[p] + 1];
            double rx = cos * bx - sin * by;
            double ry = sin * bx + cos * by;
            double omega = v[island.blockB[p] + State.THETA];
            rateX += omega * omega * rx;
            rateY += omega * omega * ry;
            j[o + 8] = ry;
            j[o + 11] = -rx;
            bx = x[island.blockB[p]] + rx; // (43)
            by = x[island.blockB[p] + 1] + ry;
        }
        island.c[2 * p] = ax - bx; // (44)
        island.c[2 * p + 1] = ay - by;
        island.rate[2 * p] = rateX;
        island.rate[2 * p + 1] = rateY;
    }
}
