// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/** Time stepping: links that fall from the level, with elastic stops between them. One stop throws the links against the next one. */
class StoppedChainTest {
    private static final double G = 9.81;
    private static final double RATE = 960;

    private static List<Body> chain(PhysicsEngine engine, SplittableRandom random) {
        engine.add(new Gravity(0, -G));
        List<Body> links = new ArrayList<>();
        for (int k = 0; k < 6; k++) {
            Body link = engine.add(new Body(new Rectangle(0.5, 0.1)).at(0.5 * k + 0.25, 0));
            link.setMass(1 + random.nextDouble());
            link.setAngularVelocity(6 * random.nextDouble() - 3);
            if (k == 0) {
                engine.add(new PinJoint(link, 0, 0));
            } else {
                engine.add(new PinJoint(links.get(k - 1), link, 0.5 * k, 0));
                engine.add(Limit.angle(link, links.get(k - 1), -0.5, 0.5, 1));
            }
            links.add(link);
        }
        for (Body link : links) {
            link.setCollisionGroup(1, 0);
        }
        return links;
    }

    private static double energy(List<Body> links) {
        double sum = 0;
        for (Body link : links) {
            sum += link.kineticEnergy() + G * link.getMass() * link.getY();
        }
        return sum;
    }

    /** Nothing takes energy, of which there is as much as the links have fallen by: some 80 J. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void elasticStopsTakeNoEnergyHoweverSoonOneFollowsTheOther(long seed) {
        PhysicsEngine engine = Stepped.engine(1 / RATE, 4);
        List<Body> links = chain(engine, new SplittableRandom(seed));
        engine.step(); // what does not go with the joints is gone
        double before = energy(links);
        for (int k = 0; k < 8 * RATE; k++) {
            engine.step();
        }
        assertThat(energy(links)).isCloseTo(before, within(1.5));
    }
}
