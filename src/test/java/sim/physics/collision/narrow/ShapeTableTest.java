// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.shape.Circle;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

class ShapeTableTest {
    private final ShapeTable table = new ShapeTable();

    @Test
    void equalShapesAreStoredOnceUntilTheLastBodyHasGone() {
        table.set(0, new Rectangle(2, 1));
        table.set(1, new Rectangle(2, 1));
        assertThat(table.base(1)).isEqualTo(table.base(0));
        table.remove(0);
        table.set(2, new Rectangle(4, 1));
        assertThat(table.base(2)).isNotEqualTo(table.base(1));
        int place = table.base(1);
        table.remove(1);
        table.set(3, new Rectangle(8, 1));
        assertThat(table.base(3)).isEqualTo(place);
        assertThat(table.data()[place + ShapeTable.FIRST]).isEqualTo(new Rectangle(8, 1).vertexX(0));
    }

    @Test
    void bodiesThatComeAndGoWithShapesOfTheirOwnTakeNoMoreRoom() {
        for (int k = 0; k < 3; k++) {
            table.set(k, shape(k));
        }
        int room = table.data().length;
        for (int k = 3; k < 10_000; k++) {
            table.remove(k % 3);
            table.set(k % 3, shape(k));
        }
        assertThat(table.data()).hasSize(room);
    }

    /** A circle, a rectangle and a triangle in turns, each of another size. */
    private static Shape shape(int k) {
        double size = 1 + k * 1e-3;
        return switch (k % 3) {
            case 0 -> new Circle(size);
            case 1 -> new Rectangle(size, 1);
            default -> new Polygon(0, 0, size, 0, 0, 1);
        };
    }

    @Test
    void aBodyCollidesWithItsOwnShapeAfterOthersHaveGone() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.5);
        engine.add(Body.fixed(new Rectangle(2, 20)).at(11, 0));
        Body gone = engine.add(new Body(new Circle(3)));
        engine.step();
        engine.remove(gone);
        Body ball = engine.add(new Body(new Circle(1)).at(0, 0).moving(1, 0));
        for (int k = 0; k < 20; k++) {
            engine.step();
        }
        assertThat(ball.getX()).isCloseTo(8, within(1e-12)); // it has turned back at 9
        assertThat(ball.getVelocityX()).isEqualTo(-1);
    }
}
