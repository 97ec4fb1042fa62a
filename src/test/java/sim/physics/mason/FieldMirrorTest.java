// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Test;
import sim.field.continuous.Continuous2D;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;
import sim.portrayal.DrawInfo2D;
import sim.portrayal.continuous.ContinuousPortrayal2D;
import sim.util.Double2D;

/** A field of MASON shows the bodies of an engine where they are, and nothing else changes in it. */
class FieldMirrorTest {
    private final PhysicsEngine engine = new PhysicsEngine();
    private final Continuous2D field = new Continuous2D(100, 100, 100);
    private final Body body = engine.add(new Body(new Circle(1)).at(10, 20).moving(3, 4));

    @Test
    void showsWhereBodiesAre() {
        FieldMirror mirror = new FieldMirror(engine, field);
        assertThat(field.getObjectLocation(body)).isEqualTo(new Double2D(10, 20));
        engine.step();
        mirror.step(null);
        assertThat(field.getObjectLocation(body)).isEqualTo(new Double2D(13, 24));
    }

    @Test
    void showsWhereBodiesAreUnderTimeStepping() {
        engine.setTimeStepping(4);
        FieldMirror mirror = new FieldMirror(engine, field);
        Body other = engine.add(new Body(new Circle(1)).at(14, 24)); // is struck
        for (int k = 0; k < 5; k++) {
            engine.step();
            mirror.step(null);
            assertThat(field.getObjectLocation(body)).isEqualTo(new Double2D(body.getX(), body.getY()));
            assertThat(field.getObjectLocation(other)).isEqualTo(new Double2D(other.getX(), other.getY()));
        }
        assertThat(other.getX()).isGreaterThan(14);
    }

    @Test
    void bodiesThatAnotherOneReplacesAreGoneAtOnce() {
        FieldMirror mirror = new FieldMirror(engine, field);
        engine.remove(body);
        Body next = engine.add(new Body(new Circle(1)));
        mirror.update();
        assertThat(field.getAllObjects().toArray()).containsExactly(next);
    }

    @Test
    void whatElseIsInTheFieldStays() {
        field.setObjectLocation("flag", new Double2D(5, 5));
        FieldMirror mirror = new FieldMirror(engine, field);
        mirror.update();
        engine.remove(body);
        mirror.update();
        assertThat(field.getAllObjects().toArray()).containsExactly("flag");
        assertThat(field.getObjectLocation("flag")).isEqualTo(new Double2D(5, 5));
    }

    @Test
    void bodiesOfAModelThatWasStartedBeforeAreGone() {
        new FieldMirror(engine, field);
        PhysicsEngine second = new PhysicsEngine();
        Body only = second.add(new Body(new Circle(2)).at(1, 1));
        new FieldMirror(second, field);
        assertThat(field.getAllObjects().toArray()).containsExactly(only);
    }

    @Test
    void wallsAreSeenFromNear() {
        PhysicsEngine walled = new PhysicsEngine();
        walled.add(Body.fixed(new Rectangle(100, 2)).at(50, 50));
        Continuous2D wide = new Continuous2D(50, 100, 100); // half the wall's length
        new FieldMirror(walled, wide);
        ContinuousPortrayal2D portrayal = new ContinuousPortrayal2D();
        portrayal.setField(wide);
        portrayal.setPortrayalForAll(new BodyPortrayal2D(Color.RED));
        double scale = 20; // pixels for a unit of length: the window shows 20 of 100, far left of the wall's centre
        BufferedImage image = new BufferedImage(400, 400, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        Rectangle2D.Double all = new Rectangle2D.Double(0, 200 - 50 * scale, 100 * scale, 100 * scale);
        portrayal.draw(wide, graphics, new DrawInfo2D(null, portrayal, all, new Rectangle2D.Double(0, 0, 400, 400)));
        graphics.dispose();
        int red = 0;
        for (int pixel : image.getRGB(0, 0, 400, 400, null, 0, 400)) {
            red += (pixel & 0xff0000) != 0 ? 1 : 0;
        }
        assertThat((double) red).isCloseTo(400 * 2 * scale, within(400.0));
    }
}
