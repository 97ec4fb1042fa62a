// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import java.util.List;
import sim.physics.collision.Overlap;
import sim.physics.collision.Overlaps;
import sim.physics.constraint.KeptTurns;
import sim.physics.internal.Progress;
import sim.physics.motion.Body;

/**
 * Parts overlapping bodies. Where that opens joints, both are done in turn until nothing is left to do, or it is no use: limbs may have no
 * room beside one another. Then all is as it was.
 */
final class Separation {
    /** How often joints are closed at most, and how often although the bodies overlap no less. */
    private static final int MAX_ROUNDS = 10_000;

    private static final int PATIENCE = 200;

    private final Overlaps overlaps;
    private final List<Body> bodies;

    /** By body: place, angle, and velocities before. */
    private final double[][] before;

    /** What joints know of them before. */
    private final KeptTurns turns;

    Separation(Overlaps overlaps, List<Body> bodies, KeptTurns turns) {
        this.overlaps = overlaps;
        this.bodies = bodies;
        this.turns = turns;
        before = bodies.stream().map(Separation::now).toArray(double[][]::new);
    }

    private static double[] now(Body body) {
        return new double[] {body.getX(), body.getY(), body.getAngle(), body.getVelocityX(), body.getVelocityY(), body.getAngularVelocity()};
    }

    /**
     * Parts the bodies.
     *
     * @param joints closes them; null if there are none
     * @return number of sweeps over all pairs
     * @throws RuntimeException if there is no room, or joints cannot be closed
     */
    int run(Runnable joints) {
        boolean isDone = false;
        try {
            int sweeps = part(joints);
            isDone = true;
            return sweeps;
        } finally {
            if (!isDone) {
                putBack();
            }
        }
    }

    private int part(Runnable joints) {
        int sweeps = overlaps.separate(bodies);
        Progress progress = new Progress(PATIENCE);
        int round = 0;
        for (int more = sweeps; more > 0 && joints != null; sweeps += more) {
            joints.run();
            List<Overlap> found = overlaps.find(bodies);
            if (++round > MAX_ROUNDS || progress.stalls(Overlaps.depth(found))) {
                throw new IllegalStateException(found.size() + " pairs of bodies still overlap after " + round
                        + " rounds of parting them and closing their joints: is there room?");
            }
            more = overlaps.separate(bodies);
        }
        return sweeps;
    }

    private void putBack() {
        for (int k = 0; k < before.length; k++) {
            putBack(bodies.get(k), before[k], now(bodies.get(k)));
        }
        turns.putBack();
    }

    private static void putBack(Body body, double[] to, double[] from) {
        if (from[0] != to[0] || from[1] != to[1]) {
            body.setPosition(to[0], to[1]);
        }
        if (from[2] != to[2]) {
            body.setAngle(to[2]);
        }
        if (from[3] != to[3] || from[4] != to[4]) {
            body.setVelocity(to[3], to[4]);
        }
        if (from[5] != to[5]) {
            body.setAngularVelocity(to[5]);
        }
    }
}
