// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint.tree;

import sim.physics.internal.IntList;
import sim.physics.internal.SineTable;
import sim.physics.motion.Loads;
import sim.physics.motion.State;

/**
 * RK4 steps of a free {@link PinTree} that is a hub: one body with others that are pinned to it at their own centres of mass,
 * as wheels, discs and what a robot holds are. However these turn, the hub feels them as points that it carries, so that nothing is
 * left to eliminate. With r from the common centre of mass to that of body k, M = Σ m and J = I + Σ m r²:
 *
 * <pre>
 *   M C″ = Σ F,   J θ″ = τ + Σ r × F,   I' θ'″ = τ' for each of the others
 * </pre>
 */
final class HubLoads extends TreeLoads {
    private static final long serialVersionUID = 1L;

    /** By link: its centre of mass from the common one, in the coordinates of the hub. */
    private final double[] arm;

    /** By link, then by stage: angular acceleration. */
    private final double[] alpha;

    /** By link: m/M and m. */
    private final double[] mass;

    /** Cosine and sine. */
    private final double[] turn = new double[2];

    /** J. */
    private double inertia;

    /** Where the common centre of mass is, how fast it moves, and how fast the hub turns; at a stage, and at the start. */
    private double x;

    private double y;
    private double u;
    private double v;
    private double startX;
    private double startY;
    private double startU;
    private double startV;

    HubLoads(PinTree tree) {
        super(tree);
        arm = new double[2 * tree.links];
        alpha = new double[STAGES * tree.links];
        mass = new double[2 * tree.links];
        weigh();
    }

    /** Whether a tree is a hub. */
    static boolean isHub(PinTree tree) {
        boolean yes = tree.isFree && tree.links > 1 && tree.link[PinTree.INERTIA] < Double.POSITIVE_INFINITY;
        for (int k = 1; yes && k < tree.links; k++) {
            int o = PinTree.STRIDE * k;
            yes = tree.parent[k] == 0 && tree.link[o + PinTree.DX] == 0 && tree.link[o + PinTree.DY] == 0;
        }
        return yes;
    }

    @Override
    void weigh() {
        double centreX = 0;
        double centreY = 0;
        for (int k = 0; k < tree.links; k++) {
            int o = PinTree.STRIDE * k;
            mass[2 * k] = tree.link[o + PinTree.SHARE];
            mass[2 * k + 1] = tree.link[o + PinTree.MASS];
            arm[2 * k] = k == 0 ? 0 : k == 1 ? tree.link[PinTree.EX] : tree.side[PinTree.SIDE * k];
            arm[2 * k + 1] = k == 0 ? 0 : k == 1 ? tree.link[PinTree.EY] : tree.side[PinTree.SIDE * k + 1];
            centreX += mass[2 * k] * arm[2 * k];
            centreY += mass[2 * k] * arm[2 * k + 1];
        }
        inertia = tree.link[PinTree.INERTIA];
        for (int k = 0; k < tree.links; k++) {
            arm[2 * k] -= centreX;
            arm[2 * k + 1] -= centreY;
            inertia += mass[2 * k + 1] * (arm[2 * k] * arm[2 * k] + arm[2 * k + 1] * arm[2 * k + 1]);
        }
    }

    @Override
    void step(State state, IntList bodies, Loads loads, double[] a, double t, double h, boolean isFirst) {
        tree.passed += (long) STAGES * tree.links;
        begin();
        double[] l = tree.link;
        double turning = l[PinTree.OMEGA];
        for (int stage = 0; stage < STAGES; stage++) {
            double c = NODE[stage] * h;
            if (stage > 0) {
                double before = NODE[stage - 1] * h;
                double angle = l[PinTree.ANGLE] + c * turning;
                turning = l[PinTree.OMEGA] + c * alpha[stage - 1];
                fall(stage, c, before);
                SineTable.direct(angle, SineTable.quarters(0), turn, 0);
                place(state, angle, turning);
                spin(state, stage, c, before);
            }
            loads.load(bodies, t + c, a);
            accelerate(stage, a);
            if (stage == 0 && isFirst) {
                noteFirst(turning * turning);
            }
        }
        finish(state, h);
    }

    /** Takes the common centre of mass over from the hub. */
    private void begin() {
        double[] l = tree.link;
        turn[0] = l[PinTree.COS];
        turn[1] = l[PinTree.SIN];
        double rx = turn[0] * arm[0] - turn[1] * arm[1];
        double ry = turn[1] * arm[0] + turn[0] * arm[1];
        startX = l[PinTree.X] - rx;
        startY = l[PinTree.Y] - ry;
        startU = l[PinTree.U] + l[PinTree.OMEGA] * ry;
        startV = l[PinTree.V] - l[PinTree.OMEGA] * rx;
    }

    /** The centre of mass at a stage: by c times the rates of the stage before from the start. */
    private void fall(int stage, double c, double before) {
        double wayX = stage > 1 ? before * fallX[stage - 2] : 0;
        double wayY = stage > 1 ? before * fallY[stage - 2] : 0;
        x = startX + c * (startU + wayX);
        y = startY + c * (startV + wayY);
        u = startU + c * fallX[stage - 1];
        v = startV + c * fallY[stage - 1];
    }

    /** Puts the bodies where the common centre and the angle of the hub say, and the hub's angle. */
    private void place(State state, double angle, double turning) {
        double[] place = state.x();
        double[] speed = state.v();
        for (int k = 0; k < tree.links; k++) {
            double rx = turn[0] * arm[2 * k] - turn[1] * arm[2 * k + 1];
            double ry = turn[1] * arm[2 * k] + turn[0] * arm[2 * k + 1];
            int b = tree.block[k];
            place[b] = x + rx;
            place[b + 1] = y + ry;
            speed[b] = u - turning * ry;
            speed[b + 1] = v + turning * rx;
        }
        place[tree.block[0] + State.THETA] = angle;
        speed[tree.block[0] + State.THETA] = turning;
    }

    /** Turns the others, each by itself. */
    private void spin(State state, int stage, double c, double before) {
        for (int k = 1; k < tree.links; k++) {
            int o = PinTree.STRIDE * k;
            int b = tree.block[k] + State.THETA;
            double omega = tree.link[o + PinTree.OMEGA];
            double rate = stage > 1 ? omega + before * alpha[STAGES * k + stage - 2] : omega;
            state.x()[b] = tree.link[o + PinTree.ANGLE] + c * rate;
            state.v()[b] = omega + c * alpha[STAGES * k + stage - 1];
        }
    }

    /** What the forces do. */
    private void accelerate(int stage, double[] a) {
        double ax = 0;
        double ay = 0;
        double torque = 0;
        for (int k = 0; k < tree.links; k++) {
            double bx = a[tree.block[k]];
            double by = a[tree.block[k] + 1];
            double rx = turn[0] * arm[2 * k] - turn[1] * arm[2 * k + 1];
            double ry = turn[1] * arm[2 * k] + turn[0] * arm[2 * k + 1];
            ax += mass[2 * k] * bx;
            ay += mass[2 * k] * by;
            torque += mass[2 * k + 1] * (rx * by - ry * bx);
            alpha[STAGES * k + stage] = a[tree.block[k] + State.THETA];
        }
        fallX[stage] = ax;
        fallY[stage] = ay;
        alpha[stage] = (torque + tree.link[PinTree.INERTIA] * a[tree.block[0] + State.THETA]) / inertia;
    }

    private void noteFirst(double square) {
        for (int k = 0; k < tree.links; k++) {
            double rx = turn[0] * arm[2 * k] - turn[1] * arm[2 * k + 1];
            double ry = turn[1] * arm[2 * k] + turn[0] * arm[2 * k + 1];
            first[State.BLOCK * k] = fallX[0] - square * rx - alpha[0] * ry;
            first[State.BLOCK * k + 1] = fallY[0] - square * ry + alpha[0] * rx;
            first[State.BLOCK * k + 2] = alpha[STAGES * k];
        }
    }

    /** The end of the step, (13), for the tree as for the state vectors. */
    private void finish(State state, double h) {
        double[] l = tree.link;
        double sixth = h / 6;
        x = startX + h * (startU + sixth * (fallX[0] + fallX[1] + fallX[2]));
        y = startY + h * (startV + sixth * (fallY[0] + fallY[1] + fallY[2]));
        u = startU + sixth * (fallX[0] + 2 * (fallX[1] + fallX[2]) + fallX[3]);
        v = startV + sixth * (fallY[0] + 2 * (fallY[1] + fallY[2]) + fallY[3]);
        double most = 0;
        for (int k = 0; k < tree.links; k++) {
            int o = PinTree.STRIDE * k;
            int s = STAGES * k;
            double before = l[o + PinTree.OMEGA];
            double middle = alpha[s + 1] + alpha[s + 2];
            double rough = Math.abs(alpha[s] - middle + alpha[s + 3]) + Math.abs(alpha[s + 1] - alpha[s + 2]);
            most = Math.max(most, PinTree.follows(h * before) ? rough : Double.POSITIVE_INFINITY); // NaN stays
            l[o + PinTree.ANGLE] += h * (before + sixth * (alpha[s] + middle));
            l[o + PinTree.OMEGA] = before + sixth * (alpha[s] + 2 * middle + alpha[s + 3]);
            l[o + PinTree.TURNING] = l[o + PinTree.OMEGA];
            state.x()[tree.block[k] + State.THETA] = l[o + PinTree.ANGLE];
            state.v()[tree.block[k] + State.THETA] = l[o + PinTree.OMEGA];
        }
        tree.setRoughness(most);
        SineTable.turn(l[PinTree.ANGLE], l[PinTree.EX], l[PinTree.EY], l, PinTree.COS);
        turn[0] = l[PinTree.COS];
        turn[1] = l[PinTree.SIN];
        place(state, l[PinTree.ANGLE], l[PinTree.OMEGA]);
        for (int k = 0; k < tree.links; k++) { // directions of the others matter to nobody
            int o = PinTree.STRIDE * k;
            int b = tree.block[k];
            l[o + PinTree.X] = state.x()[b];
            l[o + PinTree.Y] = state.x()[b + 1];
            l[o + PinTree.U] = state.v()[b];
            l[o + PinTree.V] = state.v()[b + 1];
        }
    }
}
