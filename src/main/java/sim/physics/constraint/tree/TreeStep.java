// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint.tree;

import java.io.Serializable;
import sim.physics.motion.Loads;
import sim.physics.motion.State;
import sim.physics.motion.TiedCoordinates;

/**
 * A step of a tree of pins: RK4, (13), on its angles. Its joints close of themselves, so there is no
 * projection. What is out of the ordinary it leaves to the general code: then it has changed nothing.
 */
public final class TreeStep implements Serializable {
    private static final long serialVersionUID = 1L;

    /**
     * What the stages may disagree about, in rad: h² times the {@link PinTree#roughness}. A step that is rougher is made again in
     * more parts: where there is nothing to close, a step that is too long would not be seen otherwise, and could gain energy.
     */
    private static final double ROUGH = 0.0125;

    /** The same where the energy is known, and kept. */
    private static final double ROUGH_IF_KNOWN = 0.2;

    /** The same under loads where light links swing heavy ones: nobody knows the energy there. */
    private static final double ROUGH_IF_SPREAD = 1e-6;

    /** From here on it is looked at: below, the error of the energy is that of the method, and a small one. */
    private static final double WATCHED = 0.001;

    /** The same where light links swing heavy ones: what those miss of an angle is much of the energy of these. */
    private static final double WATCHED_IF_SPREAD = 1e-9;

    /** The same of the finest parts of steps for which even ones would be too many, and by how much finer they are if the energy is wrong. */
    private static final double FINEST = 1e-5;

    private static final double FINER = 16;

    /** Gap, relative to the largest coordinate, and slip, to the speeds, that a projection leaves behind. */
    private static final double CLOSED = 0x1p-45;

    private static final double SLIP = 1e-11;

    private static final int MOST_PARTS = 64;

    private final TreeHost island;
    private final PinTree tree;
    private final double[] open = new double[2];
    private boolean isWeighed;
    private boolean isHub;

    /** The same tree if it is a chain that hangs in the world; null if it is not. */
    private HungChain hung;

    /** Null until other forces than uniform fields act. */
    private TreeLoads loaded;

    /** Parts in which the next step is made at first, as the last one was enough for; and the roughest of the last. */
    private int parts = 1;

    private double worst;

    private final TreeEnergy energy;

    /** Null until a step takes parts of different lengths. */
    private FineStep fine;

    /** Null until a method asks for them that chooses its steps. */
    private TreeCoordinates coordinates;

    private TreeStep(TreeHost island, PinTree tree) {
        this.island = island;
        this.tree = tree;
        energy = new TreeEnergy(tree);
    }

    /**
     * Makes the steps of an island's pins.
     *
     * @param island all its constraints are pins
     * @param a by pin: the place of the one body among those of the island; −1 for what does not move
     * @param b the other body
     * @param arms by pin: the arms of both bodies; places in the world for what does not move
     * @return null if there are loops
     */
    public static TreeStep of(TreeHost island, int[] a, int[] b, double[] arms) {
        PinTree tree = TreeLayout.find(island.bodies(), a, b, arms);
        return tree == null ? null : new TreeStep(island, tree);
    }

    /** Masses may have changed. */
    public void forgetMasses() {
        isWeighed = false;
    }

    /**
     * Advances the tree under a uniform field.
     *
     * @param state its vectors are changed, if all is well
     * @param gx the field, length/time²
     * @param gy the field, length/time²
     * @param h step, of either sign
     * @return false if the general code must make this step
     */
    public boolean advance(State state, double gx, double gy, double h) {
        weigh(state);
        if (!(hung == null ? follow(state) : hang(state))) {
            return false;
        }
        boolean isUnforced = gx == 0 && gy == 0;
        double most = tree.isFree && !isUnforced ? ROUGH : ROUGH_IF_KNOWN;
        boolean isFine = false;
        while (!isFine && (!isDone(gx, gy, h, most) || !isUnforced && !keepsEnergy(state, gx, gy))) {
            isFine = !divide(state, hung, most);
            if (isFine && !goFinely(state, gx, gy, h)) {
                return false;
            }
        }
        unite(most);
        if (isUnforced) {
            island.keepInvariants(state);
        }
        if (hung == null || isFine) {
            tree.places.scatter(state, PinTree.ANGLE, PinTree.OMEGA);
        } else {
            hung.ends.scatter(state);
        }
        island.step();
        if (isUnforced) {
            keepInvariants(state, hung);
        }
        return true;
    }

    /** Gives a tree that is where the state vectors have it what nothing can have taken since the invariants were begun. */
    void keepInvariants(State state) {
        keepInvariants(state, null);
    }

    private void keepInvariants(State state, HungChain chain) {
        island.restoreInvariants(state);
        if (chain == null && !gather(state)) {
            tree.begin();
        } else if (chain != null && !chain.ends.isAt(state)) {
            chain.begin(state);
        }
    }

    /**
     * Advances the tree under any forces that act on each link by itself.
     *
     * @param state its vectors are changed, if all is well
     * @param loads the forces
     * @param a gets the accelerations at the start, with what the pins do, [x″, y″, θ″] per body of the state
     * @param t time of the start
     * @param h step, of either sign
     * @return false if the general code must make this step
     */
    public boolean advance(State state, Loads loads, double[] a, double t, double h) {
        if (!begin(state)) {
            return false;
        }
        if (loaded == null) {
            loaded = isHub ? new HubLoads(tree) : new TreeLoads(tree);
        }
        loaded.keep(state);
        double most = tree.isSpread && !isHub ? ROUGH_IF_SPREAD : ROUGH;
        boolean isFine = false;
        while (!isFine && !isDone(state, loads, a, t, h, most)) {
            loaded.restore(state);
            isFine = !divide(state, null, most);
            if (isFine && !goFinely(state, loads, a, t, h, most)) {
                loaded.restore(state);
                return false;
            }
        }
        unite(most);
        loaded.tellFirst(a);
        island.step();
        return true;
    }

    PinTree tree() {
        return tree;
    }

    /** {@return how many links were passed since this was asked last, to find their accelerations} */
    public long takePassed() {
        long taken = tree.passed;
        tree.passed = 0;
        return taken;
    }

    /** Takes the state over; false if it is not one for the tree. */
    boolean begin(State state) {
        weigh(state);
        return follow(state);
    }

    /**
     * Whether the tree is a hub, in which nothing is solved for under loads, however light what it carries is.
     *
     * @param state has the masses
     * @return false for most
     */
    public boolean isHub(State state) {
        weigh(state);
        return isHub;
    }

    private void weigh(State state) {
        if (isWeighed) {
            return;
        }
        tree.weigh(state.w().values());
        hung = HungChain.of(tree);
        isHub = HubLoads.isHub(tree);
        loaded = loaded instanceof HubLoads == isHub ? loaded : null;
        if (loaded != null) {
            loaded.weigh();
        }
        isWeighed = true;
    }

    private boolean hang(State state) {
        boolean isThere = hung.ends.isAt(state);
        if (!isThere && follow(state)) {
            hung.begin(state);
            isThere = true;
        }
        return isThere;
    }

    private boolean follow(State state) {
        if (!gather(state)) {
            tree.begin();
            if (!isClosed()) {
                tree.forget();
                return false;
            }
        }
        return true;
    }

    /** Begins again, with shorter parts, as what is rough is of fourth order; false if they are short enough as they are. */
    private boolean divide(State state, HungChain chain, double most) {
        boolean isPossible = parts < MOST_PARTS;
        double needed = worst > most ? parts * Math.sqrt(Math.sqrt(worst / most)) : MOST_PARTS;
        int more = (int) Math.min(Math.max(parts + 1, Math.ceil(needed)), Math.min(2 * parts, MOST_PARTS));
        parts = isPossible ? more : 1;
        if (!isPossible) {
            forget(chain);
        } else if (chain == null) {
            gather(state);
            tree.begin();
        } else {
            chain.begin(state);
        }
        return isPossible;
    }

    private void forget(HungChain chain) {
        tree.forget();
        if (chain != null) {
            chain.ends.forget();
        }
    }

    private void beginFinely() {
        fine = fine == null ? new FineStep(tree) : fine;
        worst = Double.POSITIVE_INFINITY; // of even parts
    }

    /** Makes a step under loads for which even parts would be too many; false if it cannot be followed. */
    private boolean goFinely(State state, Loads loads, double[] a, double t, double h, double most) {
        beginFinely();
        FineStep.Part parts = (done, part) -> {
            tree.places.scatter(state, PinTree.ANGLE, PinTree.OMEGA); // of a part that was too long there are others
            loaded.step(state, island.bodies(), loads, a, t + done, part, done == 0);
            return tree.roughness();
        };
        return follow(state) && fine.advance(parts, h, h / MOST_PARTS, most);
    }

    /** Makes a step for which even parts would be too many; false if it cannot be followed, or its energy is wrong however fine the parts are. */
    private boolean goFinely(State state, double gx, double gy, double h) {
        beginFinely();
        for (double most = ROUGH; most >= FINEST; most /= FINER) {
            if (!follow(state)) {
                return false;
            }
            if (tree.isFree) {
                tree.places.locate();
            }
            boolean isThere = fine.advance((done, part) -> step(tree, gx, gy, part), h, h / MOST_PARTS, most);
            tree.places.place();
            if (tree.isFree) {
                tree.places.shift(gx, gy, h);
            }
            if (isThere && (tree.isFree || energy.restore(state, gx, gy))) {
                return true;
            }
            tree.forget();
        }
        return false;
    }

    /** Lets the next step be made in one part less, if this one would hardly have been too rough then. */
    private void unite(double most) {
        double longer = parts / (parts - 1.0);
        parts = worst * longer * longer * (longer * longer) * longer < most ? Math.max(1, parts - 1) : parts;
    }

    /** Gives a held tree that falls the energy back that it had at the start; false if the step was wrong. */
    private boolean keepsEnergy(State state, double gx, double gy) {
        return tree.isFree
                || worst < (tree.isSpread ? WATCHED_IF_SPREAD : WATCHED)
                || (hung == null ? energy.restore(state, gx, gy) : hung.ends.restoreEnergy(state, gx, gy));
    }

    /** Makes the step in its parts; false if they are too long to follow the links. */
    private boolean isDone(double gx, double gy, double h, double most) {
        double part = h / parts;
        worst = 0;
        if (tree.isFree) {
            tree.places.locate();
        }
        for (int k = 0; k < parts; k++) {
            if (!isSmooth(part, step(gx, gy, part, k == parts - 1), most)) {
                return false;
            }
        }
        if (hung == null) {
            tree.places.place();
        }
        if (tree.isFree) {
            tree.places.shift(gx, gy, h);
        }
        return true;
    }

    /** RK4, (13), under a uniform field; returns how rough it was. */
    private double step(double gx, double gy, double h, boolean isLast) {
        if (hung != null) {
            return hung.step(gx, gy, h, isLast);
        }
        return step(tree, gx, gy, h);
    }

    /** The same of a tree of any kind, whose places are not asked for. */
    static double step(PinTree tree, double gx, double gy, double h) {
        tree.eliminate(gx, gy);
        tree.accelerate(0, 0.5 * h);
        tree.eliminate(gx, gy);
        tree.accelerate(1, 0.5 * h);
        tree.eliminate(gx, gy);
        tree.accelerate(2, h);
        tree.eliminate(gx, gy);
        tree.finish(h);
        return tree.roughness();
    }

    private boolean isDone(State state, Loads loads, double[] a, double t, double h, double most) {
        double part = h / parts;
        worst = 0;
        for (int k = 0; k < parts; k++) {
            loaded.step(state, island.bodies(), loads, a, t + k * part, part, k == 0);
            if (!isSmooth(part, tree.roughness(), most)) {
                return false;
            }
        }
        return true;
    }

    private boolean isSmooth(double part, double roughness, double most) {
        double rough = part * part * roughness;
        worst = Math.max(worst, rough); // NaN stays
        return rough <= most;
    }

    /** Takes the state over; true if it is that of the end of the last step. */
    boolean gather(State state) {
        double[] l = tree.link;
        double[] x = state.x();
        double[] v = state.v();
        long different = 0;
        for (int k = 0, o = 0; k < tree.links; k++, o += PinTree.STRIDE) {
            int b = tree.block[k];
            for (int c = 0; c < State.BLOCK; c++) {
                different |= bits(l[o + PinTree.X + c]) ^ bits(x[b + c]) | bits(l[o + PinTree.U + c]) ^ bits(v[b + c]);
            }
        }
        boolean same = different == 0;
        if (!same) {
            for (int k = 0, o = 0; k < tree.links; k++, o += PinTree.STRIDE) {
                System.arraycopy(x, tree.block[k], l, o + PinTree.X, State.BLOCK);
                System.arraycopy(v, tree.block[k], l, o + PinTree.U, State.BLOCK);
            }
        }
        return same;
    }

    private static long bits(double value) {
        return Double.doubleToRawLongBits(value);
    }

    private boolean isClosed() {
        tree.places.gaps(open);
        double place = island.mostSize();
        double speed = 0;
        for (int o = 0; o < tree.link.length; o += PinTree.STRIDE) {
            double[] l = tree.link;
            place = Math.max(place, Math.max(Math.abs(l[o + PinTree.X]), Math.abs(l[o + PinTree.Y])));
            double turning = island.leastSize() * Math.abs(l[o + PinTree.OMEGA]);
            speed = Math.max(speed, Math.abs(l[o + PinTree.U]) + Math.abs(l[o + PinTree.V]) + turning);
        }
        return open[0] <= CLOSED * place && open[1] <= SLIP * speed;
    }

    /**
     * Whether the tree, as it was last weighed, is a chain that hangs.
     *
     * @return false before its first step
     */
    public boolean isHung() {
        return hung != null;
    }

    /**
     * The coordinates of the tree, for other methods.
     *
     * @param state its vectors are those of the tree
     * @param isFit whether it may be moved in them now
     * @return to be begun; valid until the next call
     */
    public TiedCoordinates coordinates(State state, boolean isFit) {
        coordinates = coordinates == null ? new TreeCoordinates(island, this, tree) : coordinates;
        return coordinates.of(state, isFit);
    }
}
