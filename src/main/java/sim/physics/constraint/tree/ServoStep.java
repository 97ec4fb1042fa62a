// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint.tree;

import java.io.Serializable;
import sim.physics.motion.Loads;
import sim.physics.motion.State;

/**
 * A step of a tree of pins with motors and stops of their angles: RK4, (13), on the angles of the links ({@link ServoTree}). A step in
 * which a motor or a stop that holds would have to give more than it can is left to the general code, and so is all that is out of the
 * ordinary: then nothing has changed.
 */
public final class ServoStep implements Serializable {
    private static final long serialVersionUID = 1L;

    /**
     * What the stages may disagree about, as in {@link TreeStep}, and the most parts in which a rougher step is made. Less than there: strong servos
     * turn links to and fro within a step, and the work that they do is no better known than the way.
     */
    private static final double ROUGH = 5e-4;

    private static final int MOST_PARTS = 16;

    private final TreeStep step;
    private final PinTree tree;
    private final ServoTree servos;
    private final TreeHost island;

    /** The links where the last step began, as long as that is known. */
    private double[] start = {};

    private boolean isStartKnown;

    /** Null until other forces than uniform fields act. */
    private TreeLoads loaded;

    private ServoStep(TreeHost island, TreeStep step) {
        this.island = island;
        this.step = step;
        tree = step.tree();
        servos = new ServoTree(tree);
    }

    /**
     * Makes the steps of an island's pins.
     *
     * @param island its pins
     * @param a by pin: the place of the one body among those of the island; −1 for what does not move
     * @param b the other body
     * @param arms by pin: the arms of both bodies; places in the world for what does not move
     * @return null if there are loops, or no pins
     */
    public static ServoStep of(TreeHost island, int[] a, int[] b, double[] arms) {
        TreeStep step = TreeStep.of(island, a, b, arms);
        return step == null ? null : new ServoStep(island, step);
    }

    /**
     * The link at whose near pin two bodies meet.
     *
     * @param blockA block of a body in the state vectors, −1 for what does not move
     * @param blockB the same of another one
     * @return its number; −1 if they do not meet so
     */
    public int link(int blockA, int blockB) {
        int found = -1;
        for (int k = tree.isFree ? 1 : 0; k < tree.links; k++) {
            int before = tree.parent[k] < 0 ? -1 : tree.block[tree.parent[k]];
            boolean meets = tree.block[k] == blockA && before == blockB || tree.block[k] == blockB && before == blockA;
            found = meets ? k : found;
        }
        return found;
    }

    /**
     * Whether a body is that of a link.
     *
     * @param link number
     * @param block of a body in the state vectors
     * @return false for the one before it
     */
    public boolean is(int link, int block) {
        return tree.block[link] == block;
    }

    /** Masses may have changed. */
    public void forgetMasses() {
        isStartKnown = false;
        step.forgetMasses();
    }

    /** {@return how many links were passed since this was asked last, to find their accelerations} */
    public long takePassed() {
        return step.takePassed();
    }

    /** Lets nothing act at any pin. */
    public void clear() {
        servos.clear();
    }

    /**
     * Lets a torque act at the near pin of a link.
     *
     * @param link number
     * @param given torque on it, beside others
     */
    public void push(int link, double given) {
        servos.push(link, given);
    }

    /**
     * Holds a link at its near pin, where all that pushes has been given.
     *
     * @param link number
     * @param from the least torque on it of what holds it
     * @param to the greatest one
     * @return false if it is held already
     */
    public boolean hold(int link, double from, double to) {
        return servos.hold(link, from, to);
    }

    /**
     * The torque of what holds a link, as it was found last.
     *
     * @param link one that is held
     * @return on the link, without what was given
     */
    public double holds(int link) {
        return servos.holds(link);
    }

    /**
     * Finds the accelerations of the links.
     *
     * @param state where they are
     * @param a has those of each body as if it were alone, x″, y″, θ″ by block; gets those that it has
     * @return false if the general code must find them
     */
    public boolean accelerate(State state, double[] a) {
        if (!begin(state)) {
            return false;
        }
        servos.accelerations(a);
        island.step();
        return true;
    }

    /**
     * Lets the velocity of a link that is held jump.
     *
     * @param link number
     * @param rate by how much, beside that of the link before it
     */
    public void jump(int link, double rate) {
        servos.jump(link, rate);
    }

    /**
     * Changes the velocities as little as what is held, and jumps, asks for.
     *
     * @param state its velocities are changed
     * @return false if the general code must change them
     */
    public boolean jump(State state) {
        if (!begin(state)) {
            return false;
        }
        if (tree.isFree) {
            tree.places.locate();
        }
        servos.jump();
        tree.places.place();
        if (tree.isFree) {
            tree.places.shift(0, 0, 0, 0);
        }
        tree.places.scatterVelocities(state);
        tree.forget();
        isStartKnown = false;
        return true;
    }

    private boolean isAtStart(State state) {
        boolean yes = true;
        for (int k = 0, o = 0; k < tree.links && yes; k++, o += PinTree.STRIDE) {
            int b = tree.block[k];
            for (int c = 0; c < State.BLOCK; c++) {
                yes &= start[o + PinTree.X + c] == state.x()[b + c] && start[o + PinTree.U + c] == state.v()[b + c];
            }
        }
        return yes;
    }

    /** Takes the state over; false if it is not one for the tree. Where the last step began is where many begin, to find out how long it is to be. */
    private boolean begin(State state) {
        if (isStartKnown && isAtStart(state)) {
            System.arraycopy(start, 0, tree.link, 0, start.length);
            return true;
        }
        isStartKnown = step.begin(state);
        if (isStartKnown) {
            start = start.length == 0 ? new double[tree.link.length] : start;
            System.arraycopy(tree.link, 0, start, 0, start.length);
            servos.forgetFirst();
        }
        return isStartKnown;
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
        boolean isDone = false;
        for (int parts = 1; !isDone && parts <= MOST_PARTS && begin(state); parts *= 2) {
            servos.begin();
            if (tree.isFree) {
                tree.places.locate();
            }
            isDone = true;
            for (int k = 0; k < parts && isDone; k++) {
                isDone = isMade(gx, gy, h / parts, k == 0);
            }
            if (!isDone) {
                tree.forget();
            }
            if (!servos.isWithin()) {
                return false;
            }
        }
        if (isDone) {
            tree.places.place();
            if (tree.isFree) {
                tree.places.shift(gx, gy, h);
            }
            tree.places.scatter(state, PinTree.ANGLE, PinTree.OMEGA);
            island.step();
        }
        return isDone;
    }

    private boolean isMade(double gx, double gy, double part, boolean isFirst) {
        if (isFirst) {
            servos.first(gx, gy, TreeLoads.NODE[1] * part);
        } else {
            servos.forgetFirst();
        }
        for (int stage = isFirst ? 1 : 0; stage < TreeLoads.STAGES - 1; stage++) {
            servos.eliminate(null, gx, gy);
            servos.accelerate(stage, TreeLoads.NODE[stage + 1] * part);
        }
        servos.eliminate(null, gx, gy);
        servos.finish(part);
        return isGood(part);
    }

    private boolean isGood(double part) {
        return part * part * tree.roughness() <= ROUGH && servos.isWithin();
    }

    /**
     * Advances the tree under any forces that act on each link by itself.
     *
     * @param state its vectors are changed, if all is well
     * @param loads the forces
     * @param a workspace for accelerations, [x″, y″, θ″] per body of the state
     * @param t time of the start
     * @param h step, of either sign
     * @return false if the general code must make this step
     */
    public boolean advance(State state, Loads loads, double[] a, double t, double h) {
        loaded = loaded == null ? new ServoLoads(tree, servos) : loaded;
        boolean isDone = false;
        for (int parts = 1; !isDone && parts <= MOST_PARTS && begin(state); parts *= 2) {
            servos.begin();
            servos.forgetFirst();
            loaded.keep(state);
            isDone = true;
            for (int k = 0; k < parts && isDone; k++) {
                loaded.step(state, island.bodies(), loads, a, t + k * (h / parts), h / parts, false);
                isDone = isGood(h / parts);
            }
            if (!isDone) {
                loaded.restore(state);
                tree.forget();
            }
            if (!servos.isWithin()) {
                return false;
            }
        }
        if (isDone) {
            island.step();
        }
        return isDone;
    }

    /** RK4 steps under any forces, in which servos find the accelerations. */
    private static final class ServoLoads extends TreeLoads {
        private static final long serialVersionUID = 1L;

        private final ServoTree servos;

        ServoLoads(PinTree tree, ServoTree servos) {
            super(tree);
            this.servos = servos;
        }

        @Override
        void eliminate(double[] a) {
            servos.eliminate(a, 0, 0);
        }

        @Override
        void accelerate(int stage, double c) {
            servos.accelerate(stage, c);
        }

        @Override
        void finish(double h) {
            servos.finish(h);
        }
    }
}
