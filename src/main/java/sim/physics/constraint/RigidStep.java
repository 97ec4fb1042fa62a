// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Trig;
import sim.physics.motion.State;

/**
 * An island that is one rigid body: bodies that nothing but welds connects, and of which none is welded to what does not move. In a
 * uniform field its centre of mass follows a parabola and it spins evenly, so that it goes through any time at once and exactly, as a
 * single body does.
 */
final class RigidStep implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Gap of a weld, relative to the smallest body, beyond rounding: it is for others to close. */
    private static final double OPEN = 1e-9;

    /** Rounding of a sum over the bodies, relative to what is summed. */
    private static final double ROUNDING = 1e-13;

    private final Island island;

    /** The welds of a tree from the first body on; for each the body that is placed by the other one, as places in the island. */
    private final WeldJoint[] welds;

    private final int[] from;
    private final int[] to;

    /** By body: the angle to the first one, and its place beside it, as the welds have them. */
    private final double[] angle;

    private final double[] place;
    private final double[] turn = new double[4];

    private double mass;
    private double inertia;
    private double centreX;
    private double centreY;
    private double spin;

    private RigidStep(Island island) {
        this.island = island;
        int n = island.bodies.size;
        welds = new WeldJoint[n - 1];
        from = new int[n - 1];
        to = new int[n - 1];
        angle = new double[n];
        place = new double[2 * n];
    }

    /** That of an island, or null if it is none. */
    static RigidStep of(Island island) {
        for (int k = 0; k < island.constraints.length; k++) {
            int p = island.firstNode[k];
            if (!(island.constraints[k] instanceof WeldJoint) || island.a[p] < 0 || island.b[p] < 0) {
                return null;
            }
        }
        RigidStep step = new RigidStep(island);
        step.grow();
        return step;
    }

    /** Finds the tree: each turn reaches the neighbours of those that were reached in the last one. */
    private void grow() {
        boolean[] has = new boolean[angle.length];
        has[0] = true;
        int count = 0;
        while (count < welds.length) {
            for (int k = 0; k < island.constraints.length; k++) {
                int a = island.a[island.firstNode[k]];
                int b = island.b[island.firstNode[k]];
                if (has[a] != has[b]) {
                    welds[count] = (WeldJoint) island.constraints[k];
                    from[count] = has[a] ? a : b;
                    to[count++] = has[a] ? b : a;
                    has[a] = true;
                    has[b] = true;
                }
            }
        }
    }

    /**
     * Moves the bodies of the state vectors under a uniform field.
     *
     * @param h time, of either sign; 0 to ask only
     * @param a gets the accelerations at the start, [x″, y″, θ″] per body of the state
     * @return false if that cannot be done, and nothing has changed: somebody has put a body off its welds, or it cannot move
     */
    boolean advance(State state, double gx, double gy, double h, double[] a) {
        if (h == 0) {
            return true;
        }
        double[] x = state.x();
        double[] v = state.v();
        int first = State.BLOCK * island.bodies.values[0];
        if (!measure(state) || !lay(x, first)) {
            return false;
        }
        double[] w = state.w().values();
        double px = 0;
        double py = 0;
        for (int k = 0; k < angle.length; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            px += (v[s] - v[first]) / w[s];
            py += (v[s + 1] - v[first + 1]) / w[s];
        }
        double vx = v[first] + px / mass;
        double vy = v[first + 1] + py / mass;
        accelerate(x, gx, gy, a);
        double theta = x[first + State.THETA] + h * spin;
        place(state, centreX + h * (vx + 0.5 * h * gx), centreY + h * (vy + 0.5 * h * gy), theta, vx + h * gx, vy + h * gy);
        return true;
    }

    /** Mass, centre, inertia and spin of the whole: the velocities that the bodies would have if they were welded now. */
    private boolean measure(State state) {
        double[] x = state.x();
        double[] v = state.v();
        double[] w = state.w().values();
        int first = State.BLOCK * island.bodies.values[0];
        mass = 0;
        centreX = 0;
        centreY = 0;
        for (int k = 0; k < angle.length; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            if (w[s] == 0 || w[s + State.THETA] == 0) {
                return false;
            }
            mass += 1 / w[s];
            centreX += (x[s] - x[first]) / w[s];
            centreY += (x[s + 1] - x[first + 1]) / w[s];
        }
        centreX = x[first] + centreX / mass;
        centreY = x[first + 1] + centreY / mass;
        inertia = 0;
        double momentum = 0;
        for (int k = 0; k < angle.length; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            double rx = x[s] - centreX;
            double ry = x[s + 1] - centreY;
            inertia += (rx * rx + ry * ry) / w[s] + 1 / w[s + State.THETA];
            momentum += (rx * (v[s + 1] - v[first + 1]) - ry * (v[s] - v[first])) / w[s] + v[s + State.THETA] / w[s + State.THETA];
        }
        spin = spin(state, momentum / inertia, first);
        return true;
    }

    /**
     * The spin that all bodies have, if that is what momentum says but for rounding: that of velocities, at what distance ever, is not to
     * add up from step to step.
     */
    private double spin(State state, double found, int first) {
        double[] x = state.x();
        double[] v = state.v();
        double own = v[first + State.THETA];
        boolean isOne = true;
        for (int k = 1; isOne && k < angle.length; k++) {
            isOne = v[State.BLOCK * island.bodies.values[k] + State.THETA] == own;
        }
        double speed = Math.abs(v[first]) + Math.abs(v[first + 1]) + Math.abs(own) * (Math.abs(x[first]) + Math.abs(x[first + 1]));
        return isOne && Math.abs(found - own) <= ROUNDING * (Math.abs(own) + speed / island.leastSize) ? own : found;
    }

    /** Finds the places beside the first body, turned as it is now, and whether the bodies are there. */
    private boolean lay(double[] x, int first) {
        double far = OPEN * island.leastSize;
        angle[0] = 0;
        place(x[first + State.THETA]);
        boolean yes = true;
        for (int k = 1; yes && k < angle.length; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            double gapX = x[s] - x[first] - place[2 * k];
            double gapY = x[s + 1] - x[first + 1] - place[2 * k + 1];
            double gap = x[s + State.THETA] - x[first + State.THETA] - angle[k];
            yes = Math.abs(gapX) + Math.abs(gapY) <= far && Math.abs(gap) <= OPEN;
        }
        return yes;
    }

    /** Finds the places beside the first body for an angle of it. */
    private void place(double theta) {
        Arrays.fill(place, 0, 2, 0);
        for (int k = 0; k < welds.length; k++) {
            WeldJoint weld = welds[k];
            boolean isOfA = island.bodies.values[to[k]] == weld.getBodyA().index();
            int known = from[k];
            int next = to[k];
            angle[next] = angle[known] + (isOfA ? weld.angle() : -weld.angle());
            Trig.sinCos(theta + angle[known], turn, 0);
            Trig.sinCos(theta + angle[next], turn, 2);
            double ax = isOfA ? weld.getAnchorBX() : weld.getAnchorAX();
            double ay = isOfA ? weld.getAnchorBY() : weld.getAnchorAY();
            double bx = isOfA ? weld.getAnchorAX() : weld.getAnchorBX();
            double by = isOfA ? weld.getAnchorAY() : weld.getAnchorBY();
            place[2 * next] = place[2 * known] + (turn[0] * ax - turn[1] * ay) - (turn[2] * bx - turn[3] * by); // (45), (46)
            place[2 * next + 1] = place[2 * known + 1] + (turn[1] * ax + turn[0] * ay) - (turn[3] * bx + turn[2] * by);
        }
    }

    private void accelerate(double[] x, double gx, double gy, double[] a) {
        for (int k = 0; k < angle.length; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            a[s] = gx - spin * spin * (x[s] - centreX);
            a[s + 1] = gy - spin * spin * (x[s + 1] - centreY);
            a[s + State.THETA] = 0;
        }
    }

    /** Puts the bodies where they are when the centre is somewhere and the first one has an angle, with the velocities that they have then. */
    private void place(State state, double atX, double atY, double theta, double vx, double vy) {
        double[] x = state.x();
        double[] v = state.v();
        double[] w = state.w().values();
        place(theta);
        double meanX = 0;
        double meanY = 0;
        for (int k = 0; k < angle.length; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            meanX += place[2 * k] / w[s];
            meanY += place[2 * k + 1] / w[s];
        }
        meanX /= mass;
        meanY /= mass;
        for (int k = 0; k < angle.length; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            double rx = place[2 * k] - meanX;
            double ry = place[2 * k + 1] - meanY;
            x[s] = atX + rx;
            x[s + 1] = atY + ry;
            x[s + State.THETA] = theta + angle[k];
            v[s] = vx - spin * ry;
            v[s + 1] = vy + spin * rx;
            v[s + State.THETA] = spin;
        }
    }
}
