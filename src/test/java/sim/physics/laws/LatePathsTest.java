// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.scenes.Deed;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * Chains that collide with nobody get no paths before something happens in a step. Nobody can tell: an audit, which changes no
 * bit of a run, wants all paths at once.
 */
class LatePathsTest {
    private static final int LINKS = 4;

    /** Does something to the second chain in each third collision, and takes note of where its tip was at that instant. */
    private static final class Doer implements CollisionListener {
        private static final long serialVersionUID = 1L;

        private final Deed deed;
        private final PhysicsEngine engine;
        private final List<Body> chain;
        private final List<Double> seen = new ArrayList<>();
        private int collisions;

        private Doer(Deed deed, PhysicsEngine engine, List<Body> chain) {
            this.deed = deed;
            this.engine = engine;
            this.chain = chain;
        }

        @Override
        public void collided(Contact contact) {
            Body tip = chain.get(LINKS - 1);
            if (++collisions % 3 != 0 || !engine.contains(tip)) {
                return;
            }
            if (deed == Deed.NOTHING) {
                return;
            }
            deed.act(engine, chain.get(0), tip);
            seen.add(tip.getX());
            seen.add(tip.getVelocityY());
        }
    }

    private static List<Body> chain(PhysicsEngine engine, double y) {
        List<Body> chain = new ArrayList<>();
        for (int k = 0; k < LINKS; k++) {
            Body link = engine.add(new Body(new Rectangle(1, 0.1)).at(k + 0.5, y));
            link.setCollisionGroup(1, 0);
            engine.add(k == 0 ? new PinJoint(link, 0, y) : new PinJoint(chain.get(k - 1), link, k, y));
            chain.add(link);
        }
        return chain;
    }

    /** Two chains, a ball in a box elsewhere that strikes a wall in some of the steps, and a pair of pinned balls that does, too. */
    private static PhysicsEngine scene() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -9.81));
        engine.add(Body.fixed(new Rectangle(10, 1)).at(20, -3));
        engine.add(Body.fixed(new Rectangle(1, 10)).at(16, 0));
        engine.add(Body.fixed(new Rectangle(1, 10)).at(24, 0));
        Body ball = engine.add(new Body(new Circle(0.3)).at(20, 1).moving(3, 0, 1));
        ball.setRestitution(1);
        Body one = engine.add(new Body(new Circle(0.3)).at(18, 0.5).moving(-1, 0, 0));
        Body two = engine.add(new Body(new Circle(0.3)).at(19, 0.5));
        one.setRestitution(1);
        two.setRestitution(1);
        engine.add(new PinJoint(one, two, 18.5, 0.5));
        return engine;
    }

    private static List<Double> run(Deed deed, boolean isAudited, boolean isRestored) {
        PhysicsEngine engine = scene();
        chain(engine, 0);
        int pushed = chain(engine, 18).get(2).index();
        engine.add(Body.fixed(new Circle(0.3)).at(1.5, 5.5)); // in the way of what is caught
        Doer doer = new Doer(deed, engine, chain(engine, 9));
        engine.addListener(doer);
        engine.setAudited(isAudited);
        List<Double> all = new ArrayList<>();
        for (int k = 0; k < 240; k++) {
            if (k % 3 == 1) {
                engine.bodies().get(pushed).addForce(2, 1);
            }
            engine.step();
            if (isRestored && k == 120) {
                Doer copy = Checkpoint.copy(doer);
                engine = copy.engine;
                doer = copy;
            }
            for (Body body : engine.bodies()) {
                all.add(body.getX());
                all.add(body.getAngle());
                all.add(body.getVelocityX());
                all.add(body.getVelocityY());
            }
        }
        assertThat(doer.collisions).isGreaterThan(10);
        all.addAll(doer.seen);
        return all;
    }

    @ParameterizedTest
    @EnumSource(Deed.class)
    void nobodyCanTell(Deed deed) {
        assertThat(run(deed, false, false)).isEqualTo(run(deed, true, false));
    }

    @ParameterizedTest
    @EnumSource(Deed.class)
    void aRestoredEngineGoesOnBitForBit(Deed deed) {
        assertThat(run(deed, false, true)).isEqualTo(run(deed, false, false));
    }

    /** Throws in one of its calls. */
    private static final class Storm implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private final Body body;
        private int calls;
        private int last = Integer.MAX_VALUE;

        private Storm(Body body) {
            this.body = body;
        }

        @Override
        public boolean actsOn(Body other) {
            return other == body;
        }

        @Override
        public void addForce(Body other, double time, Forces forces) {
            if (++calls == last) {
                throw new IllegalArgumentException("a storm");
            }
            forces.add(other, Math.sin(time), 0);
        }
    }

    @Test
    void aStepThatFailsLeavesChainsWhereTheyWereAtThatInstant() {
        PhysicsEngine engine = scene();
        List<Body> first = chain(engine, 0);
        List<Body> second = chain(engine, 9);
        List<Body> third = chain(engine, 18);
        Storm storm = new Storm(second.get(2));
        engine.add(storm);
        for (int k = 0; k < 50; k++) {
            engine.step();
        }
        List<Body> all = new ArrayList<>(first);
        all.addAll(second);
        all.addAll(third);
        List<Double> before = places(all);
        storm.last = storm.calls + 3; // within the step of the second chain, when the first one has made it
        assertThatThrownBy(engine::step).hasMessage("a storm");
        assertThat(places(all)).isEqualTo(before);
        storm.last = Integer.MAX_VALUE;
        engine.step();
        assertThat(first.get(LINKS - 1).getY()).isNotCloseTo(before.get(2 * LINKS - 1), within(1e-6));
    }

    private static List<Double> places(List<Body> bodies) {
        List<Double> all = new ArrayList<>();
        for (Body body : bodies) {
            all.add(body.getX());
            all.add(body.getY());
        }
        return all;
    }
}
