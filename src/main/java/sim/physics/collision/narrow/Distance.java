// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

import sim.physics.motion.Body;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;
import sim.physics.shape.Shape;

/** Distances between bodies where they are now, in an engine or not: for placing bodies and for looking at scenes. */
public final class Distance {
    private final ShapeTable shapes = new ShapeTable();
    private final Trajectories trajectories = new Trajectories();
    private final Pose pose = new Pose(shapes, trajectories);
    private final ClosestFeatures features = new ClosestFeatures(pose);

    private final Shape[] measured = new Shape[2];
    private double gap;
    private double nx;
    private double ny;

    /** Makes an object that measures; not for use by several threads at once. */
    public Distance() {
        trajectories.begin(0, 1);
        trajectories.ensure(2);
    }

    /**
     * Distance of the surfaces of two bodies.
     *
     * @param a a body
     * @param b another body
     * @return length; negative if they overlap: then the least way that parts them, or of bodies of several parts the two that
     *     are deepest in one another
     */
    public double between(Body a, Body b) {
        place(0, a);
        place(1, b);
        gap = Double.POSITIVE_INFINITY;
        for (int i = 0; i < measured[0].partCount(); i++) {
            for (int j = 0; j < measured[1].partCount(); j++) {
                pose.load(0, shapes.base(0, i), 1, shapes.base(1, j));
                pose.moveTo(0);
                pose.turn();
                features.find(ClosestFeatures.NO_FEATURES);
                if (features.gap < gap) {
                    gap = features.gap;
                    nx = features.nx;
                    ny = features.ny;
                }
            }
        }
        return gap;
    }

    /**
     * Direction from the first to the second body of the last measurement.
     *
     * @return x of a unit normal
     */
    public double normalX() {
        return nx;
    }

    /**
     * Direction from the first to the second body of the last measurement.
     *
     * @return y of a unit normal
     */
    public double normalY() {
        return ny;
    }

    private void place(int slot, Body body) {
        if (measured[slot] != null) {
            shapes.remove(slot);
        }
        measured[slot] = body.getShape();
        shapes.set(slot, measured[slot]);
        double[] m = trajectories.data();
        int o = slot * Trajectories.STRIDE;
        System.arraycopy(body.state().x(), State.BLOCK * body.index(), m, o, State.BLOCK);
    }
}
