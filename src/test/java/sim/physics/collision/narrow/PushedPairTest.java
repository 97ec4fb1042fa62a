// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sim.physics.motion.Trajectories;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Bodies that are pushed evenly: nothing overlaps before the instant that the search finds, and what hardly moves on one another is soon looked at. */
class PushedPairTest extends MovingPair {
    private static final double END = 1;

    /** Far below what a search may be wrong by. */
    private static final double NONE = 1e-12;

    private final TimeOfImpact search = new TimeOfImpact(pose, features);

    PushedPairTest() {
        super(5);
    }

    private void push(int body, double ax, double ay, double alpha) {
        trajectories.accelerate(body, ax, ay, alpha);
    }

    @Test
    void nothingOverlapsBeforeTheInstantThatIsFound() {
        trajectories.begin(0, END);
        trajectories.ensure(2);
        int contacts = 0;
        for (int k = 0; k < 4000; k++) {
            double spin = k % 7 == 0 ? 0 : k % 3 == 0 ? 10 : 2;
            place(0, shape(k % 5 < 3 ? 0 : 1), 0, 0, spin); // a disc more often than not
            place(1, shape(k % 3), between(-4, 4), between(-4, 4), spin);
            double pull = k % 4 == 0 ? 0 : 5;
            push(0, pull * between(-1, 1), pull * between(-1, 1), spin * between(-1, 1));
            push(1, pull * between(-1, 1), pull * between(-1, 1), spin * between(-1, 1));
            if (gap(0) <= 0) {
                continue;
            }
            pose.load(0, 1);
            pose.lies = k % 2 == 0;
            double found = search.search(0, END, ClosestFeatures.NO_FEATURES);
            boolean isTouching = search.touching;
            double until = Math.min(END, found);
            for (int i = 0; i < 400; i++) {
                assertThat(gap(until * i / 400)).as("pair %d at %d", k, i).isGreaterThan(-NONE);
            }
            if (isTouching) {
                contacts++;
                assertThat(gap(found)).as("pair %d", k).isCloseTo(0, within(NONE));
            }
        }
        assertThat(contacts).isGreaterThan(600);
    }

    /** A disc that another body keeps at a tiny distance for the whole step, sliding and turning with it. */
    private long looks(Shape shape, double x, double y) {
        double h = 1.0 / 60;
        double spin = 0.5;
        double speed = 0.6;
        double pull = 0.7;
        trajectories.begin(0, h);
        trajectories.ensure(2);
        place(0, new Circle(0.2), 0, 0, 0);
        place(1, shape, x, y, 0);
        double[] m = trajectories.data();
        m[Trajectories.STRIDE + Trajectories.THETA0] = 0;
        for (int body = 0; body < 2; body++) {
            int o = body * Trajectories.STRIDE;
            m[o + Trajectories.VX] = speed;
            m[o + Trajectories.VY] = 0;
        }
        // both follow a turn of the whole about the disc's centre, up to what parabolas leave out: of third order
        m[Trajectories.STRIDE + Trajectories.VX] -= spin * y;
        m[Trajectories.STRIDE + Trajectories.VY] += spin * x;
        m[Trajectories.STRIDE + Trajectories.OMEGA] = spin;
        push(0, pull, 0, 0);
        push(1, pull - spin * spin * x, -spin * spin * y, 1e-3);
        pose.load(0, 1);
        pose.lies = true;
        long before = search.evaluations;
        assertThat(search.search(0, h, ClosestFeatures.NO_FEATURES)).isGreaterThanOrEqualTo(h);
        assertThat(search.touching).isFalse();
        return search.evaluations - before;
    }

    @Test
    void whatIsPushedAlongIsLookedAtAFewTimes() {
        double open = 1e-7;
        Shape box = new Rectangle(0.6, 0.4);
        assertThat(looks(box, 0.1, 0.4 + open)).as("along an edge").isLessThan(4);
        double part = (0.2 + open) / Math.sqrt(2);
        assertThat(looks(box, 0.3 + part, 0.2 + part)).as("round a corner").isLessThan(4);
        assertThat(looks(new Circle(0.3), 0.3, Math.sqrt(0.25 - 0.09) + open)).as("round a disc").isLessThan(4);
    }
}
