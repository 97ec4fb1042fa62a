// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Stroke;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.Curve;
import sim.physics.constraint.GearJoint;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.PulleyJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.constraint.SlotJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.constraint.Wheel;
import sim.physics.constraint.WireJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;
import sim.portrayal.DrawInfo2D;
import sim.portrayal.LocationWrapper;
import sim.portrayal.SimpleInspector;
import sim.portrayal.simple.CircledPortrayal2D;
import sim.util.Bag;
import sim.util.Double2D;
import sim.util.Properties;

/** Joints, motors, stops, springs and contacts are drawn where they are, grow with the zoom, and are found under the mouse. */
class JointsPortrayalTest {
    private static final int WORLD = 100;

    private final PhysicsEngine engine = new PhysicsEngine();
    private final JointsPortrayal2D joints = new JointsPortrayal2D(WORLD, WORLD);
    private final ContactsPortrayal2D contacts = new ContactsPortrayal2D(WORLD, WORLD);

    private Body box(double x, double y) {
        return engine.add(new Body(new Rectangle(4, 4)).at(x, y));
    }

    /** What a layer draws of a part of the world, without the bodies. */
    private BufferedImage draw(EnginePortrayal2D layer, double x, double y, double size, double scale) {
        return new Picture(x, y, size, size, scale, Color.BLACK, body -> null).draw(engine, layer);
    }

    /** Whether something is drawn within half a unit of a point. */
    private boolean isDrawn(double x, double y) {
        BufferedImage image = draw(joints, x - 0.5, y - 0.5, 1, 20);
        return count(image) > 0;
    }

    private static int count(BufferedImage image) {
        int painted = 0;
        for (int pixel : image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth())) {
            painted += (pixel & 0xffffff) != 0 ? 1 : 0;
        }
        return painted;
    }

    /** The area that is painted, in pixels of full red. */
    private static double covered(BufferedImage image) {
        double sum = 0;
        for (int pixel : image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth())) {
            sum += (pixel >> 16 & 0xff) / 255.0;
        }
        return sum;
    }

    /** What is at a point of a display that shows the whole world with some pixels for a unit. */
    private List<LocationWrapper> hit(EnginePortrayal2D layer, double x, double y, double scale) {
        Bag found = new Bag();
        layer.setField(engine);
        Rectangle2D.Double all = new Rectangle2D.Double(-3, -5, WORLD * scale, WORLD * scale);
        Rectangle2D.Double mouse = new Rectangle2D.Double(x * scale - 3 - 0.5, y * scale - 5 - 0.5, 1, 1);
        layer.hitObjects(new DrawInfo2D(null, layer, all, mouse), found);
        List<LocationWrapper> list = new ArrayList<>();
        for (int k = 0; k < found.numObjs; k++) {
            list.add((LocationWrapper) found.objs[k]);
        }
        return list;
    }

    private List<Object> hitObjects(double x, double y) {
        return hit(joints, x, y, 10).stream().map(LocationWrapper::getObject).toList();
    }

    /** A force of an author's between two bodies. */
    private static final class Pull implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private final List<Body> bodies;

        Pull(Body a, Body b) {
            bodies = List.of(a, b);
        }

        @Override
        public List<Body> getBodies() {
            return bodies;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            // too weak to be felt
        }
    }

    @Test
    void jointsAreDrawnWhereTheyAre() {
        PinJoint pin = engine.add(new PinJoint(box(10, 10), null, 12, 12));
        WeldJoint weld = engine.add(new WeldJoint(box(30, 10), box(36, 10), 33, 10));
        RodJoint rod = engine.add(new RodJoint(box(50, 10), 50, 10, null, 60, 10));
        SliderJoint slider = engine.add(new SliderJoint(box(80, 10), null, 80, 10, 0, 1));
        Limit ends = engine.add(Limit.travel(slider, -2, 12));
        SlotJoint slot = engine.add(new SlotJoint(box(90, 10), null, 90, 10, 1, 0));
        Spring spring = new Spring(box(10, 40), 0, 0, null, 20, 40, 5, 1, 0);
        engine.add(spring);
        Limit rope = engine.add(Limit.rope(box(40, 40), 0, 0, null, 50, 40, 10));
        PulleyJoint pulley = engine.add(PulleyJoint.worldPoints(box(10, 70), 10, 70, 15, 60, box(30, 70), 30, 70, 25, 60, 1));
        Pull pull = new Pull(box(70, 40), box(80, 40));
        engine.add(pull);
        engine.add(new Gravity(0, 0)); // has no ends
        assertThat(hitObjects(12, 12)).containsExactly(pin);
        assertThat(hitObjects(33, 10)).containsExactly(weld);
        assertThat(hitObjects(55, 10)).containsExactly(rod);
        assertThat(hitObjects(80.9, 22)).containsExactly(ends);
        assertThat(hitObjects(80.5, 10)).contains(slider);
        assertThat(hitObjects(92, 10)).contains(slot);
        assertThat(hitObjects(10, 40)).containsExactly(spring);
        assertThat(hitObjects(20, 40)).containsExactly(spring);
        assertThat(hitObjects(45, 40)).containsExactly(rope);
        assertThat(hitObjects(70, 40)).containsExactly(pull);
        assertThat(hitObjects(20, 60)).containsExactly(pulley);
        assertThat(hitObjects(12.5, 65)).containsExactly(pulley);
        assertThat(isDrawn(12, 12)).isTrue();
        assertThat(isDrawn(55, 10)).isTrue();
        assertThat(isDrawn(80, 22)).isTrue();
        assertThat(isDrawn(15, 40)).isTrue();
        assertThat(isDrawn(45, 40)).isTrue();
        assertThat(isDrawn(75, 40)).isTrue();
        assertThat(isDrawn(20, 60)).isTrue();
        assertThat(isDrawn(12, 20)).isFalse();
        assertThat(hitObjects(12, 20)).isEmpty();
    }

    /** The anchors, seen from outside, are those that the joint was made with. */
    @Test
    void motorsAndStopsAreAtTheirPins() {
        Body arm = engine.add(new Body(new Rectangle(10, 1)).at(25, 50));
        engine.add(new PinJoint(arm, 20, 50));
        Motor motor = engine.add(Motor.turning(arm, null, 1, 1));
        Limit stops = engine.add(Limit.angle(arm, null, -1, 1));
        Body wheel = engine.add(new Body(new Circle(2)).at(70, 50));
        Body other = engine.add(new Body(new Circle(2)).at(80, 50));
        GearJoint gear = engine.add(new GearJoint(wheel, other, 2));
        Motor alone = engine.add(Motor.turning(wheel, null, -1, 1));
        joints.setField(engine);
        assertThat(joints.getObjectLocation(motor, null)).isEqualTo(new Double2D(20, 50));
        assertThat(joints.getObjectLocation(stops, null)).isEqualTo(new Double2D(20, 50));
        assertThat(joints.getObjectLocation(gear, null)).isEqualTo(new Double2D(70, 50));
        assertThat(joints.getObjectLocation(alone, null)).isEqualTo(new Double2D(70, 50));
        double s = Sketch.size(arm, null);
        assertThat(hitObjects(20 + 2.6 * s, 50)).containsExactly(stops);
        assertThat(hitObjects(20 + 1.8 * s, 50)).containsExactly(motor);
        assertThat(hitObjects(75, 50)).contains(gear);
    }

    @Test
    void wheelsAreWhereTheyStand() {
        Body car = box(20, 20);
        Wheel ideal = engine.add(new Wheel(car, 5, 0));
        Wheel other = new Wheel(car, 0, 6, Math.PI / 2);
        Motor grip = engine.add(Motor.gripping(other, 5));
        Motor drive = engine.add(Motor.rolling(new Wheel(car, -7, 0), 2, 5));
        assertThat(hitObjects(25, 20)).containsExactly(ideal);
        assertThat(hitObjects(20, 26)).containsExactly(grip);
        assertThat(hitObjects(13, 20)).containsExactly(drive);
        assertThat(isDrawn(25, 20)).isTrue();
        assertThat(isDrawn(13, 20)).isTrue();
    }

    @Test
    void aWireIsDrawnAsItsCurve() {
        Body bead = engine.add(new Body(new Circle(0.5)).at(60, 50));
        WireJoint joint = engine.add(new WireJoint(bead, Curve.circle(50, 50, 10)));
        for (int k = 0; k < 16; k++) {
            double angle = Math.PI * k / 8;
            double x = 50 + 10 * Math.cos(angle);
            double y = 50 + 10 * Math.sin(angle);
            assertThat(isDrawn(x, y)).isTrue();
            assertThat(hitObjects(x, y)).containsExactly(joint);
        }
        int ring = count(draw(joints, 30, 30, 40, 10));
        assertThat((double) ring).isBetween(2 * Math.PI * 100, 4 * 2 * Math.PI * 100 + 200);
        engine.remove(joint);
        engine.add(new WireJoint(bead, Curve.line(60, 50, 1, 1)));
        assertThat(isDrawn(20, 10)).isTrue();
        assertThat(isDrawn(90, 80)).isTrue();
        assertThat(isDrawn(40, 50)).isFalse();
    }

    @Test
    void symbolsGrowWithTheZoom() {
        engine.add(new PinJoint(box(50, 50), null, 50, 50));
        double far = covered(draw(joints, 40, 40, 20, 20));
        double near = covered(draw(joints, 40, 40, 20, 80));
        assertThat(near / 16).isCloseTo(far, within(0.03 * far));
        assertThat(hit(joints, 51, 50, 10)).isEmpty();
        LinkPortrayal2D large = new LinkPortrayal2D(Color.RED);
        large.setSize(2 * Sketch.size(engine.bodies().get(0), null));
        joints.setPortrayalForClass(PinJoint.class, large);
        assertThat(covered(draw(joints, 40, 40, 20, 80)) / 4).isCloseTo(near * 255 / 220, within(0.03 * near));
    }

    @Test
    void whatIsUnderTheMouseIsFoundAtAnyZoomAndFollowed() {
        Body body = box(50, 50);
        PinJoint pin = engine.add(new PinJoint(body, box(50, 50), 51, 50));
        for (double scale : new double[] {2, 8, 100}) {
            assertThat(hit(joints, 51, 50, scale)).hasSize(1);
            assertThat(hit(joints, 56, 50, scale)).isEmpty();
        }
        LocationWrapper wrapper = hit(joints, 51, 50, 8).get(0);
        assertThat(wrapper.getLocation()).isEqualTo(new Double2D(51, 50));
        body.setPosition(60, 50);
        assertThat(((Double2D) wrapper.getLocation()).x).isEqualTo(61);
        engine.remove(pin);
        assertThat(wrapper.getLocation()).isNull();
        assertThat(wrapper.getLocationName()).isEqualTo("gone");
    }

    private static Object value(Object view, String name) {
        Properties properties = Properties.getProperties(view);
        for (int k = 0; k < properties.numProperties(); k++) {
            if (properties.getName(k).equals(name)) {
                return properties.getValue(k);
            }
        }
        throw new AssertionError("no property " + name);
    }

    private static void set(Object view, String name, String value) {
        Properties properties = Properties.getProperties(view);
        for (int k = 0; k < properties.numProperties(); k++) {
            if (properties.getName(k).equals(name) && properties.isReadWrite(k)) {
                properties.setValue(k, value);
                return;
            }
        }
        throw new AssertionError("no property to write " + name);
    }

    @Test
    void inspectorsShowForcesAndGaps() {
        engine.add(new Gravity(0, 10));
        Body bob = box(50, 60);
        RodJoint rod = engine.add(new RodJoint(bob, 50, 60, null, 50, 40));
        Spring spring = new Spring(box(10, 30), 0, 0, null, 10, 20, 4, 3, 0);
        engine.add(spring);
        InspectedJoint view = new InspectedJoint(engine, rod);
        assertThat((double) value(view, "ForceY")).isCloseTo(-160, within(1e-9));
        assertThat((double) value(view, "Gap")).isZero();
        assertThat(value(view, "BodyA")).isSameAs(bob);
        assertThat(value(view, "BodyB")).isNull();
        assertThat((double) value(new InspectedSpring(spring), "Tension")).isCloseTo(3 * 6, within(1e-12));
        assertThat((double) value(new InspectedSpring(spring), "Length")).isEqualTo(10);
        set(view, "BreakingForce", "100");
        engine.step();
        assertThat(value(view, "Present")).isEqualTo(false);
        assertThat(value(view, "ForceY")).isEqualTo(0.0);
        joints.setField(engine);
        LinkPortrayal2D portrayal = new LinkPortrayal2D(Color.RED);
        for (Object object : new Object[] {rod, spring, Motor.turning(bob, null, 1, 1), Limit.angle(bob, null, 0, 1)}) {
            LocationWrapper wrapper = new LocationWrapper(object, null, joints);
            assertThat(portrayal.getInspector(wrapper, null)).isInstanceOf(SimpleInspector.class);
            assertThat(portrayal.getName(wrapper)).isEqualTo(object.getClass().getSimpleName());
        }
    }

    @Test
    void motorsAndStopsAreInspected() {
        Body cabin = box(50, 50);
        SliderJoint rail = engine.add(new SliderJoint(cabin, null, 50, 50, 0, 1));
        Motor drive = engine.add(Motor.sliding(rail, 0.5, 100));
        Limit ends = engine.add(Limit.travel(rail, -1, 10));
        set(new InspectedMotor(engine, drive), "Speed", "2");
        set(new InspectedMotor(engine, drive), "Limit", "1000");
        engine.step();
        engine.step();
        assertThat((double) value(new InspectedLimit(engine, ends), "Coordinate")).isCloseTo(4, within(0.05));
        assertThat(value(new InspectedLimit(engine, ends), "Upper")).isEqualTo(10.0);
        assertThat((double) value(new InspectedLimit(engine, ends), "Gap")).isZero();
        assertThat(drive.getCoordinate()).isSameAs(rail);
        assertThat(rail.getDirectionY()).isEqualTo(1);
    }

    /** A scene with joints, motors, stops and contacts. */
    private static PhysicsEngine machine() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 60);
        engine.add(new Gravity(0, 10));
        engine.add(Body.fixed(new Rectangle(100, 2)).at(50, 90)).setFriction(0.5);
        Body last = null;
        for (int k = 0; k < 5; k++) {
            Body one = engine.add(new Body(new Rectangle(4, 1)).at(30 + 4 * k, 85));
            one.setRestitution(0);
            one.setFriction(0.5);
            if (last != null) {
                engine.add(new PinJoint(one, last, 28 + 4 * k, 85));
                engine.add(Limit.angle(one, last, -0.5, 0.5));
                engine.add(Motor.turning(one, last, 0.1 * k, 50));
            }
            last = one;
        }
        return engine;
    }

    @Test
    void drawingAndInspectingChangeNoBit() {
        PhysicsEngine seen = machine();
        PhysicsEngine unseen = machine();
        Picture picture = new Picture(0, 0, 100, 100, 2, Color.BLACK, body -> Color.GRAY);
        for (int k = 0; k < 200; k++) {
            seen.step();
            unseen.step();
            picture.draw(seen, joints, contacts);
            for (Constraint one : seen.allConstraints()) {
                new InspectedConstraint(seen, one).getForceX();
            }
            for (int b = 0; b < seen.bodies().size(); b++) {
                assertThat(seen.bodies().get(b).getX()).isEqualTo(unseen.bodies().get(b).getX());
                assertThat(seen.bodies().get(b).getAngularVelocity()).isEqualTo(unseen.bodies().get(b).getAngularVelocity());
            }
        }
        assertThat(unseen.contacts()).isNotEmpty();
    }

    @Test
    void contactsAreDrawnWithTheirForces() {
        engine.setTimeStep(0.1);
        engine.add(new Gravity(0, 10));
        engine.add(Body.fixed(new Rectangle(100, 2)).at(50, 61));
        Body box = box(50, 58);
        box.setRestitution(0);
        for (int k = 0; k < 5; k++) {
            engine.step();
        }
        assertThat(hit(contacts, 50, 60, 10)).hasSize(1);
        LocationWrapper wrapper = hit(contacts, 50, 60, 10).get(0);
        assertThat(wrapper.getLocationName()).startsWith("(");
        ContactPortrayal2D portrayal = new ContactPortrayal2D(Color.RED, Color.GREEN);
        portrayal.setForceScale(0.1); // a weight of 160: an arrow of 16
        ContactsPortrayal2D layer = new ContactsPortrayal2D(WORLD, WORLD, portrayal);
        BufferedImage image = draw(layer, 0, 0, WORLD, 4);
        int top = 0;
        while (top < image.getHeight() && (image.getRGB(200, top) & 0xff00) == 0) {
            top++;
        }
        assertThat(top / 4.0).isCloseTo(60 - 16, within(0.5));
        InspectedContact view = new InspectedContact(engine, engine.contacts().get(0));
        assertThat((double) value(view, "NormalForce")).isCloseTo(160, within(1e-6));
        assertThat(contacts.getPortrayalForObject(wrapper.getObject())).isInstanceOf(ContactPortrayal2D.class);
        assertThat(portrayal.getInspector(wrapper, null)).isInstanceOf(SimpleInspector.class);
        engine.remove(box);
        assertThat(view.isPresent()).isFalse();
        assertThat(view.getNormalForce()).isZero();
        assertThat(wrapper.getLocation()).isNull();
    }

    /** MASON's wrappers draw around it, with the stroke that they find. */
    @Test
    void otherPortrayalsFindTheGraphicsAsTheyWere() {
        engine.add(new PinJoint(box(50, 50), null, 50, 50));
        BufferedImage image = new BufferedImage(100, 100, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        Stroke stroke = graphics.getStroke();
        Object control = graphics.getRenderingHint(RenderingHints.KEY_STROKE_CONTROL);
        joints.setField(engine);
        joints.setPortrayalForAll(new CircledPortrayal2D(new LinkPortrayal2D(Color.RED), 0, 10, Color.GREEN, false));
        Rectangle2D.Double all = new Rectangle2D.Double(0, 0, 100, 100);
        joints.draw(engine, graphics, new DrawInfo2D(null, joints, all, all));
        assertThat(graphics.getStroke()).isSameAs(stroke);
        assertThat(graphics.getRenderingHint(RenderingHints.KEY_STROKE_CONTROL)).isEqualTo(control);
        assertThat(image.getRGB(50, 50) & 0xff0000).isNotZero();
        assertThat(image.getRGB(55, 50) & 0xff00).isNotZero();
    }

    @Test
    void theFieldIsAnEngine() {
        assertThatThrownBy(() -> joints.setField("engine")).hasMessageContaining("PhysicsEngine");
        joints.setField(null);
        Bag found = new Bag();
        joints.hitObjects(new DrawInfo2D(null, joints, new Rectangle2D.Double(0, 0, 1, 1), new Rectangle2D.Double(0, 0, 1, 1)), found);
        assertThat(found.numObjs).isZero();
    }
}
