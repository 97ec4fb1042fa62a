// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Link;
import sim.physics.shape.Rectangle;

/** Joints by points of the world, and by points of the bodies that are in the same places, are the same. */
class JointPointsTest {
    private final PhysicsEngine engine = new PhysicsEngine();
    private final Body a = engine.add(new Body(new Rectangle(2, 1)).at(3, -1, 0.7));
    private final Body b = engine.add(new Body(new Rectangle(1, 3)).at(-2, 4, -1.9));

    private void same(Link one, Link other) {
        assertThat(one.getAnchorAX()).isCloseTo(other.getAnchorAX(), within(1e-14));
        assertThat(one.getAnchorAY()).isCloseTo(other.getAnchorAY(), within(1e-14));
        assertThat(one.getAnchorBX()).isCloseTo(other.getAnchorBX(), within(1e-14));
        assertThat(one.getAnchorBY()).isCloseTo(other.getAnchorBY(), within(1e-14));
    }

    @Test
    void rods() {
        RodJoint rod = RodJoint.bodyPoints(a, 1, 0.5, b, -0.5, 1.5);
        double ax = a.worldX(1, 0.5);
        double ay = a.worldY(1, 0.5);
        double bx = b.worldX(-0.5, 1.5);
        double by = b.worldY(-0.5, 1.5);
        same(rod, RodJoint.worldPoints(a, ax, ay, b, bx, by));
        same(rod, new RodJoint(a, ax, ay, b, bx, by)); // the same numbers of a pin are points of its bodies
        same(rod, RodJoint.bodyPoints(a, 1, 0.5, b, -0.5, 1.5, 9));
        assertThat(rod.getLength()).isCloseTo(Math.hypot(ax - bx, ay - by), within(1e-14));
        assertThat(RodJoint.worldPoints(a, ax, ay, b, bx, by).getLength()).isCloseTo(rod.getLength(), within(1e-14));
        assertThat(RodJoint.bodyPoints(a, 1, 0.5, b, -0.5, 1.5, 9).getLength()).isEqualTo(9);
        engine.add(rod); // it is closed where the bodies are
        same(RodJoint.bodyPoints(a, 1, 0.5, null, 7, 8), RodJoint.worldPoints(a, ax, ay, null, 7, 8));
    }

    @Test
    void pins() {
        double x = a.worldX(1, 0.5);
        double y = a.worldY(1, 0.5);
        same(PinJoint.bodyPoints(a, 1, 0.5, null, x, y), PinJoint.worldPoint(a, null, x, y));
        PinJoint pin = PinJoint.bodyPoints(a, 1, 0.5, b, -0.5, 1.5);
        same(pin, new PinJoint(a, 1, 0.5, b, -0.5, 1.5));
        engine.assemble(pin);
        assertThat(a.worldX(1, 0.5)).isCloseTo(b.worldX(-0.5, 1.5), within(1e-14));
        assertThat(a.worldY(1, 0.5)).isCloseTo(b.worldY(-0.5, 1.5), within(1e-14));
    }

    @Test
    void whatNeedsABodyOrALength() {
        assertThatNullPointerException()
                .isThrownBy(() -> RodJoint.bodyPoints(null, 0, 0, a, 1, 1))
                .withMessageContaining("only the second body of a joint may be null, for the world");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> RodJoint.bodyPoints(a, 0, 0, null, a.getX(), a.getY()))
                .withMessageContaining("distance of the two points in the world is 0.0");
    }
}
