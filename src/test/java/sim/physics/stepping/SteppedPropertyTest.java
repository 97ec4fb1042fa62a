// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.Equations;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Time stepping: who sets properties of jointed bodies, or removes some, moves nothing by it, and has no joints closed anew. */
class SteppedPropertyTest {
    private static final double STEP = 1.0 / 60;

    @Test
    void propertiesSetToWhatTheyAreMoveNothing() {
        List<Double> left = car(body -> {});
        assertThat(car(body -> body.setMass(body.getMass(), body.getInertia()))).as("mass").isEqualTo(left);
        assertThat(car(body -> body.setSurfaceFriction(0))).as("friction with the plane").isEqualTo(left);
        assertThat(car(body -> body.setCollisionGroup(1, -1))).as("filter").isEqualTo(left);
    }

    /** A car whose pins are open by what its load and its drive give; where it is after each step. */
    private static List<Double> car(Consumer<Body> eachStep) {
        PhysicsEngine engine = Stepped.onGround(STEP, 4);
        engine.setSleepAllowed(false);
        Body chassis = Stepped.box(engine, 3, 0.5, 20, 0, 0.8);
        List<Body> bodies = new ArrayList<>(List.of(chassis));
        for (int x = -1; x <= 1; x += 2) {
            Body wheel = Stepped.rough(engine.add(new Body(new Circle(0.4)).at(x, 0.4)));
            engine.add(new PinJoint(chassis, wheel, x, 0.4));
            engine.add(Motor.turning(wheel, chassis, -8, 20));
            bodies.add(wheel);
        }
        List<Double> places = new ArrayList<>();
        for (int k = 0; k < 120; k++) {
            bodies.forEach(eachStep);
            engine.step();
            bodies.forEach(body -> places.addAll(List.of(body.getX(), body.getY(), body.getAngle())));
        }
        return places;
    }

    /** Welds that contradict one another cannot be closed, and to find that out takes hundreds of looks at them. */
    @Test
    void whatIsRemovedOrGrowsClosesNoOthers() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        engine.add(new Gravity(0, -Stepped.G));
        Body[][] plate = new Body[4][4];
        for (int k = 0; k < 16; k++) {
            plate[k / 4][k % 4] = Stepped.box(engine, 1, 1, 1, k % 4, k / 4);
        }
        for (int k = 0; k < 16; k++) {
            weld(engine, plate[k / 4][k % 4], k % 4 < 3 ? plate[k / 4][k % 4 + 1] : null);
            weld(engine, plate[k / 4][k % 4], k < 12 ? plate[k / 4 + 1][k % 4] : null);
        }
        Counted counted = engine.add(new Counted(plate[0][0]));
        Stepped.ground(engine).setPosition(0, -4);
        Stepped.run(engine, 120); // it falls on its corner: the welds are open
        engine.add(new PinJoint(plate[3][3], plate[2][2], plate[3][3].getX(), plate[3][3].getY()));
        Stepped.run(engine, 2);
        counted.looks = 0;
        engine.step();
        int usual = counted.looks;
        counted.looks = 0;
        plate[0][1].setShape(new Circle(0.4));
        plate[0][2].setMass(1.01);
        engine.step();
        assertThat(counted.looks).as("looks of a step in which two grow, %s as a rule", usual).isLessThanOrEqualTo(4 * usual);
        counted.looks = 0;
        engine.remove(engine.allConstraints().get(3));
        engine.step();
        assertThat(counted.looks).as("one weld less").isLessThanOrEqualTo(4 * usual);
        counted.looks = 0;
        engine.remove(plate[3][3]);
        engine.step();
        assertThat(counted.looks).as("one body less").isLessThanOrEqualTo(4 * usual);
    }

    private static void weld(PhysicsEngine engine, Body a, Body b) {
        if (b != null) {
            engine.add(new WeldJoint(a, b, 0.5 * (a.getX() + b.getX()), 0.5 * (a.getY() + b.getY())));
        }
    }

    /** A body goes straight up and down; counts how often it is looked at. */
    private static final class Counted implements Constraint {
        private static final long serialVersionUID = 1L;

        private final Body body;
        private final double x;
        private int looks;

        Counted(Body body) {
            this.body = body;
            x = body.getX();
        }

        @Override
        public Body getBodyA() {
            return body;
        }

        @Override
        public Body getBodyB() {
            return null;
        }

        @Override
        public int getRows() {
            return 1;
        }

        @Override
        public void evaluate(Equations equations) {
            looks++;
            equations.set(0, body.getX() - x, 0);
            equations.setA(0, 1, 0, 0);
        }
    }
}
