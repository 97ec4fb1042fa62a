// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import sim.physics.internal.DisjointSets;
import sim.physics.internal.IntList;
import sim.physics.internal.Trig;

/**
 * Springs that are too stiff for a substep of time stepping: rows whose impulse is that of the spring at the end of the substep, which no stiffness
 * makes unstable (Catto, <i>Soft constraints</i>, GDC 2011). What they cannot follow they damp. All other springs are forces.
 */
public final class SpringRows implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Values of a row: normal, arms, what is missing, softness, mass and impulse. */
    private static final int STRIDE = 10;

    private static final int ARMS = 2;
    private static final int BIAS = 6;
    private static final int SOFTNESS = 7;
    private static final int MASS = 8;
    private static final int IMPULSE = 9;

    private final State state;
    private final Generators generators;
    private final List<Generators.Entry> stiff = new ArrayList<>();
    private double[] rows = {};

    /** Whether a body of a spring is asleep. */
    private boolean[] isIdle = {};

    private final double[] turn = new double[2];
    private final double[] ends = new double[4];
    private boolean areNew;

    SpringRows(State state, Generators generators) {
        this.state = state;
        this.generators = generators;
    }

    /**
     * Begins a step: finds out which springs are too stiff.
     *
     * @param h substep
     * @param asleep by body
     */
    public void begin(double h, boolean[] asleep) {
        List<Generators.Entry> all = generators.driving();
        List<Generators.Entry> before = stiff.isEmpty() ? List.of() : new ArrayList<>(stiff);
        double[] old = before.isEmpty() ? rows : rows.clone();
        stiff.clear();
        for (int k = 0; k < all.size(); k++) {
            Generators.Entry entry = all.get(k);
            if (entry.generator instanceof Spring spring) {
                entry.isRow = isThere(spring) && isStiff(spring, h);
                if (entry.isRow) {
                    add(entry, before.indexOf(entry), old);
                    isIdle[stiff.size() - 1] = isMarked(spring, asleep);
                }
            }
        }
        areNew = before.size() != stiff.size();
        for (int k = 0; !areNew && k < stiff.size(); k++) {
            areNew = before.get(k) != stiff.get(k);
        }
    }

    /** {@return whether they are others than in the step before} */
    public boolean areNew() {
        return areNew;
    }

    /** Lets all springs be forces again. */
    void forget() {
        stiff.forEach(entry -> entry.isRow = false);
        stiff.clear();
    }

    private void add(Generators.Entry entry, int place, double[] old) {
        int o = STRIDE * stiff.size();
        stiff.add(entry);
        if (o + STRIDE > rows.length) {
            rows = Arrays.copyOf(rows, 2 * (o + STRIDE));
            isIdle = Arrays.copyOf(isIdle, rows.length / STRIDE);
        }
        rows[o + IMPULSE] = place < 0 ? 0 : old[STRIDE * place + IMPULSE];
    }

    private boolean isThere(Spring spring) {
        return spring.getBodyA().state() == state && (spring.getBodyB() == null || spring.getBodyB().state() == state);
    }

    /** Whether a substep is too long to follow the spring by forces. */
    private boolean isStiff(Spring spring, double h) {
        double most = lightness(spring.getBodyA(), spring.getAnchorAX(), spring.getAnchorAY())
                + lightness(spring.getBodyB(), spring.getAnchorBX(), spring.getAnchorBY());
        return most * h * (spring.getStiffness() * h + spring.getDamping()) > 1;
    }

    /** What a unit of impulse at an end moves it at most. */
    private double lightness(Body body, double x, double y) {
        double[] w = state.w().values();
        int b = block(body);
        return b < 0 ? 0 : w[b] + w[b + 2] * (x * x + y * y);
    }

    /**
     * Evaluates the springs where the bodies are at the start of a substep.
     *
     * @param h its length
     */
    public void evaluate(double h) {
        double[] w = state.w().values();
        for (int k = 0; k < stiff.size(); k++) {
            if (isIdle[k]) {
                continue;
            }
            Spring spring = (Spring) stiff.get(k).generator;
            int o = STRIDE * k;
            int a = block(spring.getBodyA());
            int b = block(spring.getBodyB());
            arm(rows, o + ARMS, a, spring.getAnchorAX(), spring.getAnchorAY());
            arm(rows, o + ARMS + 2, b, spring.getAnchorBX(), spring.getAnchorBY());
            double dx = state.x()[a] + rows[o + 2] - rows[o + 4] - (b < 0 ? 0 : state.x()[b]);
            double dy = state.x()[a + 1] + rows[o + 3] - rows[o + 5] - (b < 0 ? 0 : state.x()[b + 1]);
            double distance = Math.sqrt(dx * dx + dy * dy);
            double nx = distance > 0 ? dx / distance : 0;
            double ny = distance > 0 ? dy / distance : 0;
            rows[o] = nx;
            rows[o + 1] = ny;
            double leverA = rows[o + 2] * ny - rows[o + 3] * nx;
            double inverse = (w[a] + w[a + 2] * leverA * leverA) * (distance > 0 ? 1 : 0);
            if (b >= 0) {
                double leverB = rows[o + 4] * ny - rows[o + 5] * nx;
                inverse += (w[b] + w[b + 2] * leverB * leverB) * (distance > 0 ? 1 : 0);
            }
            double stiffness = h * spring.getStiffness();
            double softness = 1 / (h * (spring.getDamping() + stiffness));
            rows[o + SOFTNESS] = softness;
            rows[o + BIAS] = (distance - spring.getLength()) * stiffness * softness;
            rows[o + MASS] = inverse > 0 ? 1 / (inverse + softness) : 0;
        }
    }

    /** The distance of a spring's ends where the bodies are now. */
    private double distance(Spring spring) {
        int a = block(spring.getBodyA());
        int b = block(spring.getBodyB());
        arm(ends, 0, a, spring.getAnchorAX(), spring.getAnchorAY());
        arm(ends, 2, b, spring.getAnchorBX(), spring.getAnchorBY());
        double dx = state.x()[a] + ends[0] - ends[2] - (b < 0 ? 0 : state.x()[b]);
        double dy = state.x()[a + 1] + ends[1] - ends[3] - (b < 0 ? 0 : state.x()[b + 1]);
        return Math.sqrt(dx * dx + dy * dy);
    }

    private static int block(Body body) {
        return body == null ? -1 : State.BLOCK * body.index();
    }

    private void arm(double[] to, int at, int block, double px, double py) {
        to[at] = px;
        to[at + 1] = py;
        if (block >= 0 && (px != 0 || py != 0)) {
            Trig.sinCos(state.x()[block + State.THETA], turn, 0);
            to[at] = turn[0] * px - turn[1] * py;
            to[at + 1] = turn[1] * px + turn[0] * py;
        }
    }

    /** Gives the bodies the impulses of the substep before. */
    public void start() {
        for (int k = 0; k < stiff.size(); k++) {
            if (!isIdle[k]) {
                push(k, rows[STRIDE * k + IMPULSE]);
            }
        }
    }

    private void push(int k, double by) {
        Spring spring = (Spring) stiff.get(k).generator;
        int o = STRIDE * k;
        push(block(spring.getBodyA()), o, o + ARMS, by);
        if (spring.getBodyB() != null) {
            push(block(spring.getBodyB()), o, o + ARMS + 2, -by);
        }
    }

    private void push(int block, int o, int arm, double by) {
        double[] v = state.v();
        double[] w = state.w().values();
        double jx = rows[o] * by;
        double jy = rows[o + 1] * by;
        v[block] += w[block] * jx;
        v[block + 1] += w[block + 1] * jy;
        v[block + 2] += w[block + 2] * (rows[arm] * jy - rows[arm + 1] * jx);
    }

    /** Solves all of them once. */
    public void solve() {
        for (int k = 0; k < stiff.size(); k++) {
            if (!isIdle[k]) {
                solve(k);
            }
        }
    }

    private void solve(int k) {
        Spring spring = (Spring) stiff.get(k).generator;
        int o = STRIDE * k;
        double speed = speed(block(spring.getBodyA()), o, o + ARMS);
        if (spring.getBodyB() != null) {
            speed -= speed(block(spring.getBodyB()), o, o + ARMS + 2);
        }
        double by = -rows[o + MASS] * (speed + rows[o + BIAS] + rows[o + SOFTNESS] * rows[o + IMPULSE]);
        rows[o + IMPULSE] += by;
        push(k, by);
    }

    /** Whether one of the bodies of a spring is marked. */
    private static boolean isMarked(Spring spring, boolean[] marks) {
        return marks[spring.getBodyA().index()] || spring.getBodyB() != null && marks[spring.getBodyB().index()];
    }

    /**
     * Takes the impulses of some bodies away, without a change of their velocities.
     *
     * @param marks by body
     */
    public void clear(boolean[] marks) {
        for (int k = 0; k < stiff.size(); k++) {
            if (isMarked((Spring) stiff.get(k).generator, marks)) {
                rows[STRIDE * k + IMPULSE] = 0;
            }
        }
    }

    /**
     * Takes a part of the impulses of the substep back, of whose velocities that was taken.
     *
     * @param shares what each body keeps
     */
    public void limit(double[] shares) {
        for (int k = 0; k < stiff.size(); k++) {
            Spring spring = (Spring) stiff.get(k).generator;
            double second = spring.getBodyB() == null ? 1 : shares[spring.getBodyB().index()];
            rows[STRIDE * k + IMPULSE] *= Math.min(shares[spring.getBodyA().index()], second);
        }
    }

    /**
     * Solves the springs of some bodies once.
     *
     * @param marks by body
     */
    public void solve(boolean[] marks) {
        for (int k = 0; k < stiff.size(); k++) {
            if (isMarked((Spring) stiff.get(k).generator, marks)) {
                solve(k);
            }
        }
    }

    /**
     * Marks the bodies that have such springs.
     *
     * @param marks by body
     */
    public void mark(boolean[] marks) {
        for (int k = 0; k < stiff.size(); k++) {
            if (isIdle[k]) {
                continue;
            }
            Spring spring = (Spring) stiff.get(k).generator;
            marks[spring.getBodyA().index()] = true;
            if (spring.getBodyB() != null) {
                marks[spring.getBodyB().index()] = true;
            }
        }
    }

    /**
     * Finds the bodies that such springs tie to the world, or to what cannot move.
     *
     * @param found takes them, each with the body that it is tied to, −1 for the world
     */
    public void findFastened(IntList found) {
        for (int k = 0; k < stiff.size(); k++) {
            Spring spring = (Spring) stiff.get(k).generator;
            Body a = spring.getBodyA();
            Body b = spring.getBodyB();
            if (!isIdle[k] && isFelt(spring) && (b == null || !mayMove(a) || !mayMove(b))) {
                found.add(movable(spring));
                found.add(b == null ? -1 : mayMove(a) ? b.index() : a.index());
            }
        }
    }

    /** Whether one of its bodies can move. */
    private boolean isFelt(Spring spring) {
        return mayMove(spring.getBodyA()) || spring.getBodyB() != null && mayMove(spring.getBodyB());
    }

    private boolean mayMove(Body body) {
        return state.w().values()[State.BLOCK * body.index()] > 0;
    }

    /**
     * Joins the sets of movable bodies between which there are such springs.
     *
     * @param parent sets of bodies
     */
    public void join(int[] parent) {
        for (int k = 0; k < stiff.size(); k++) {
            if (isIdle[k]) {
                continue;
            }
            Spring spring = (Spring) stiff.get(k).generator;
            Body b = spring.getBodyB();
            if (b != null && mayMove(b) && mayMove(spring.getBodyA())) {
                DisjointSets.join(parent, spring.getBodyA().index(), b.index());
            }
        }
    }

    /**
     * Adds what these springs may have given bodies in the substep: what they have less; negative if that is more.
     *
     * @param group group of each movable body
     * @param given takes twice the energy, by group
     * @param h substep
     */
    public void give(int[] group, double[] given, double h) {
        for (int k = 0; k < stiff.size(); k++) {
            Spring spring = (Spring) stiff.get(k).generator;
            if (isIdle[k] || spring.getStiffness() == 0 || !isFelt(spring)) {
                continue; // a damper has no energy
            }
            int o = STRIDE * k;
            double stretch = rows[o + BIAS] / (rows[o + SOFTNESS] * h * spring.getStiffness());
            double now = distance(spring) - spring.getLength();
            double energy = spring.getStiffness() * (stretch * stretch - now * now);
            given[group[movable(spring)]] += energy;
        }
    }

    /**
     * Adds the impulses with which they press.
     *
     * @param group by body
     * @param pressed takes them, by group
     */
    public void press(int[] group, double[] pressed) {
        for (int k = 0; k < stiff.size(); k++) {
            if (!isIdle[k] && isFelt((Spring) stiff.get(k).generator)) {
                pressed[group[movable((Spring) stiff.get(k).generator)]] += Math.abs(rows[STRIDE * k + IMPULSE]);
            }
        }
    }

    private int movable(Spring spring) {
        return (mayMove(spring.getBodyA()) ? spring.getBodyA() : spring.getBodyB()).index(); // what cannot move has no group
    }

    private double speed(int block, int o, int arm) {
        double[] v = state.v();
        double ux = v[block] - rows[arm + 1] * v[block + 2];
        double uy = v[block + 1] + rows[arm] * v[block + 2];
        return rows[o] * ux + rows[o + 1] * uy;
    }
}
