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
     * @return length; negative if they overlap: then the least way that parts them
     */
    public double between(Body a, Body b) {
        place(0, a);
        place(1, b);
        pose.load(0, 1);
        pose.moveTo(0);
        pose.turn();
        features.find(ClosestFeatures.NO_FEATURES);
        return features.gap;
    }

    /**
     * Direction from the first to the second body of the last measurement.
     *
     * @return x of a unit normal
     */
    public double normalX() {
        return features.nx;
    }

    /**
     * Direction from the first to the second body of the last measurement.
     *
     * @return y of a unit normal
     */
    public double normalY() {
        return features.ny;
    }

    private void place(int slot, Body body) {
        if (measured[slot] != null) {
            shapes.remove(slot, measured[slot]);
        }
        measured[slot] = body.getShape();
        shapes.set(slot, measured[slot]);
        double[] m = trajectories.data();
        int o = slot * Trajectories.STRIDE;
        System.arraycopy(body.state().x(), State.BLOCK * body.index(), m, o, State.BLOCK);
    }
}
