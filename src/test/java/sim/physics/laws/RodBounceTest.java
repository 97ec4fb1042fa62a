// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.hipparchus.dfp.Dfp;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.references.ExactRodBounce;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Rectangle;

/**
 * Hard case I02: a rod that bounces on a floor hits it at the times of a computation in 60 digits, to ten units of rounding
 * times the most that the motion has made of one in the rod's first angle and height until then.
 */
class RodBounceTest {
    private static final double G = 9.81;
    private static final double INERTIA = 1.0 / 12;
    private static final double HEIGHT = 1.5;
    private static final double ANGLE = 0.3;
    private static final double SMALL = 1e-30;

    private static List<Double> times(double width, double step, int impacts) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        engine.add(new Gravity(0, -G));
        engine.add(Body.fixed(new Rectangle(2, 2)).at(0, -1));
        Body rod = new Body(new Rectangle(1, width)).at(0, HEIGHT, ANGLE);
        rod.setMass(1, INERTIA);
        engine.add(rod);
        List<Double> times = new ArrayList<>();
        engine.addListener(new CollisionListener() {
            private static final long serialVersionUID = 1L;

            @Override
            public void collided(Contact contact) {
                times.add(contact.time());
            }
        });
        while (times.size() < impacts) {
            engine.step();
        }
        return times;
    }

    private static ExactRodBounce exact(double width, double higher, double more) {
        return new ExactRodBounce(1, width, INERTIA, HEIGHT, higher, ANGLE, more, G);
    }

    @ParameterizedTest
    @CsvSource({
        "1e-6, 0.016666666666666666", "1e-4, 0.016666666666666666", "1e-4, 0.37", "0.05, 0.016666666666666666", "0.05, 2"
    })
    void allImpactsUpToThe25thAreAtTheExactTimes(double width, double step) {
        List<Double> times = times(width, step, 25);
        ExactRodBounce exact = exact(width, 0, 0);
        ExactRodBounce turned = exact(width, 0, SMALL);
        ExactRodBounce higher = exact(width, SMALL, 0);
        double amplification = 0;
        for (int k = 0; k < 25; k++) {
            Dfp time = exact.next();
            double byAngle = Math.abs(turned.next().subtract(time).toDouble() / SMALL);
            double byHeight = Math.abs(higher.next().subtract(time).toDouble() / SMALL);
            amplification = Math.max(amplification, byAngle + byHeight);
            double error = time.subtract(time.newInstance(times.get(k))).toDouble();
            assertThat(Math.abs(error) / (0x1p-52 * amplification)).as("impact %d", k + 1).isLessThan(10);
        }
    }
}
