// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.response.LastingContact;
import sim.physics.shape.Rectangle;

/** What groups of thousands of bodies cost that do have to do with each other: towers, chains, nets and hubs. */
class LargeGroupsTest {
    private static final double G = 10;

    /** Room for calls, in bytes: some hundreds of them. */
    private static final int SMALL_STACK = 1 << 18;

    private static PhysicsEngine engine(int substeps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 64);
        engine.setTimeStepping(substeps);
        return engine;
    }

    /** Runs something where calls cannot be nested deep. */
    private static void withSmallStack(Runnable what) {
        AtomicReference<Throwable> thrown = new AtomicReference<>();
        Thread thread = new Thread(null, what, "small stack", SMALL_STACK);
        thread.setUncaughtExceptionHandler((t, e) -> thrown.set(e));
        thread.start();
        try {
            thread.join();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
        assertThat(thrown.get()).isNull();
    }

    @Test
    void aTowerOfAThousandBoxesStandsOnItsGround() {
        int n = 1000;
        PhysicsEngine engine = engine(0);
        engine.add(new Gravity(0, -G));
        Body ground = engine.add(Body.fixed(new Rectangle(16, 2)).at(0, -1));
        List<Body> tower = new ArrayList<>();
        for (int k = 0; k < n; k++) {
            tower.add(engine.add(new Body(new Rectangle(1, 1)).at(0, k + 0.5)));
        }
        engine.bodies().forEach(body -> body.setRestitution(0));
        withSmallStack(() -> {
            engine.step();
            engine.step();
        });
        List<LastingContact> below = engine.contacts(ground);
        assertThat(below).hasSize(1);
        assertThat(below.get(0).normalForce()).isCloseTo(n * G, within(1e-6 * n * G));
        for (int k = 0; k < n; k++) {
            assertThat(tower.get(k).getY()).isCloseTo(k + 0.5, within(1e-7));
            assertThat(tower.get(k).getVelocityY()).isCloseTo(0, within(1e-6));
        }
    }
}
