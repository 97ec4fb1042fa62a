// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Locale;
import java.util.SplittableRandom;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.dynamics.joint.FrictionJoint;
import org.dyn4j.geometry.Geometry;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Vector2;
import org.dyn4j.world.World;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.SurfaceFriction;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * Robots that push boxes about on a plane with friction, seen from above, as controllers that are evolved do: discs that head
 * for changing directions by forces set anew in each step, and boxes with friction on the plane, between four walls. dyn4j's
 * friction with the plane is its friction joint, which bounds force and torque one by one.
 *
 * <pre>
 * CrowdRun robots boxes steps rounds        CrowdRun 20 15 5000 3
 * </pre>
 */
public final class CrowdRun {
    private static final ThreadMXBean THREAD = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private static final double WARM_UP = 30;
    private static final double STEP = 1.0 / 60;
    private static final double SIDE = 8;
    private static final double G = 9.81;

    private CrowdRun() {}

    /** Where a robot wants to go. */
    private static final class Will {
        private final SplittableRandom random;
        private double heading;
        private double speed;
        private int left;

        Will(long seed) {
            random = new SplittableRandom(seed);
        }

        void decide() {
            if (--left <= 0) {
                left = 30 + random.nextInt(120);
                heading = random.nextDouble() * 2 * Math.PI;
                speed = random.nextDouble();
            }
        }

        double along(double component, double velocity) {
            return 20 * (speed * component - velocity);
        }

        double turn(double angle, double omega) {
            double error = heading - angle;
            error -= 2 * Math.PI * Math.rint(error / (2 * Math.PI));
            return 0.5 * error - 0.2 * omega;
        }
    }

    /**
     * Runs the comparison.
     *
     * @param args numbers of robots, boxes, steps and rounds
     */
    public static void main(String[] args) {
        int robots = Integer.parseInt(args[0]);
        int boxes = Integer.parseInt(args[1]);
        int steps = Integer.parseInt(args[2]);
        int rounds = Integer.parseInt(args[3]);
        double[] own = new double[rounds];
        double[] stepped = new double[rounds];
        double[] peer = new double[rounds];
        WarmUp.run(WARM_UP, () -> {
            double[][] places = places(robots + boxes, 6);
            own(robots, places, steps, 0);
            own(robots, places, steps, 4);
            dyn4j(robots, places, steps);
        });
        for (int r = 0; r < rounds; r++) {
            double[][] places = places(robots + boxes, 7 + r);
            own[r] = own(robots, places, steps, 0);
            stepped[r] = own(robots, places, steps, 4);
            peer[r] = dyn4j(robots, places, steps);
        }
        Arrays.sort(own);
        Arrays.sort(stepped);
        Arrays.sort(peer);
        System.out.printf(
                Locale.ROOT, "%d robots, %d boxes: ours %.1f us/step [%.1f, %.1f], by time stepping %.1f [%.1f, %.1f], dyn4j %.1f [%.1f, %.1f]%n",
                robots, boxes, own[rounds / 2], own[0], own[rounds - 1],
                stepped[rounds / 2], stepped[0], stepped[rounds - 1], peer[rounds / 2], peer[0], peer[rounds - 1]);
    }

    /** Centre and angle of each body, apart from all others. */
    private static double[][] places(int n, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        double[][] places = new double[n][];
        for (int k = 0; k < n; ) {
            double[] place = {
                0.5 + random.nextDouble() * (SIDE - 1), 0.5 + random.nextDouble() * (SIDE - 1), 6 * random.nextDouble()
            };
            boolean free = true;
            for (int m = 0; m < k; m++) {
                free &= Math.hypot(places[m][0] - place[0], places[m][1] - place[1]) > 0.8;
            }
            if (free) {
                places[k++] = place;
            }
        }
        return places;
    }

    private static double own(int robots, double[][] places, int steps, int substeps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(STEP);
        engine.setTimeStepping(substeps);
        engine.setSleepAllowed(false); // nor do the peers
        engine.add(new SurfaceFriction(G));
        for (int end = 0; end < 2; end++) {
            engine.add(Body.fixed(new Rectangle(1, SIDE + 2)).at(end * (SIDE + 1) - 0.5, SIDE / 2));
            engine.add(Body.fixed(new Rectangle(SIDE + 2, 1)).at(SIDE / 2, end * (SIDE + 1) - 0.5));
        }
        Body[] bodies = new Body[places.length];
        Will[] wills = new Will[robots];
        for (int k = 0; k < places.length; k++) {
            boolean isRobot = k < robots;
            Body body = new Body(isRobot ? new Circle(0.2) : new Rectangle(0.6, 0.4));
            body.setMass(isRobot ? 3 : 2);
            body.setSurfaceFriction(isRobot ? 0 : 0.4);
            body.setRestitution(0.1);
            body.setFriction(0.2);
            bodies[k] = engine.add(body.at(places[k][0], places[k][1], places[k][2]));
            if (isRobot) {
                wills[k] = new Will(k);
            }
        }
        long begun = THREAD.getCurrentThreadCpuTime();
        for (int step = 0; step < steps; step++) {
            for (int k = 0; k < robots; k++) {
                Body body = bodies[k];
                wills[k].decide();
                body.addForce(
                        wills[k].along(Math.cos(body.getAngle()), body.getVelocityX()),
                        wills[k].along(Math.sin(body.getAngle()), body.getVelocityY()));
                body.addTorque(wills[k].turn(body.getAngle(), body.getAngularVelocity()));
            }
            engine.step();
        }
        return (THREAD.getCurrentThreadCpuTime() - begun) / 1e3 / steps;
    }

    private static double dyn4j(int robots, double[][] places, int steps) {
        World<org.dyn4j.dynamics.Body> world = new World<>();
        world.setGravity(0, 0);
        world.getSettings().setStepFrequency(STEP);
        world.getSettings().setAtRestDetectionEnabled(false);
        org.dyn4j.dynamics.Body ground = null;
        for (int end = 0; end < 2; end++) {
            ground = add(world, Geometry.createRectangle(1, SIDE + 2), 0, end * (SIDE + 1) - 0.5, SIDE / 2, 0);
            add(world, Geometry.createRectangle(SIDE + 2, 1), 0, SIDE / 2, end * (SIDE + 1) - 0.5, 0);
        }
        org.dyn4j.dynamics.Body[] bodies = new org.dyn4j.dynamics.Body[places.length];
        Will[] wills = new Will[robots];
        for (int k = 0; k < places.length; k++) {
            double[] p = places[k];
            if (k < robots) {
                bodies[k] = add(world, Geometry.createCircle(0.2), 3 / (Math.PI * 0.04), p[0], p[1], p[2]);
                wills[k] = new Will(k);
                continue;
            }
            bodies[k] = add(world, Geometry.createRectangle(0.6, 0.4), 2 / 0.24, p[0], p[1], p[2]);
            FrictionJoint<org.dyn4j.dynamics.Body> rub = new FrictionJoint<>(ground, bodies[k], bodies[k].getWorldCenter());
            rub.setMaximumForce(0.4 * 2 * G);
            rub.setMaximumTorque(0.4 * 2 * G * 0.2);
            rub.setCollisionAllowed(true);
            world.addJoint(rub);
        }
        long begun = THREAD.getCurrentThreadCpuTime();
        for (int step = 0; step < steps; step++) {
            for (int k = 0; k < robots; k++) {
                org.dyn4j.dynamics.Body body = bodies[k];
                wills[k].decide();
                double angle = body.getTransform().getRotationAngle();
                body.applyForce(new Vector2(
                        wills[k].along(Math.cos(angle), body.getLinearVelocity().x),
                        wills[k].along(Math.sin(angle), body.getLinearVelocity().y)));
                body.applyTorque(wills[k].turn(angle, body.getAngularVelocity()));
            }
            world.step(1, STEP);
        }
        return (THREAD.getCurrentThreadCpuTime() - begun) / 1e3 / steps;
    }

    private static org.dyn4j.dynamics.Body add(
            World<org.dyn4j.dynamics.Body> world,
            org.dyn4j.geometry.Convex shape,
            double density,
            double x,
            double y,
            double angle) {
        org.dyn4j.dynamics.Body body = new org.dyn4j.dynamics.Body();
        BodyFixture fixture = density == 0 ? body.addFixture(shape) : body.addFixture(shape, density);
        fixture.setRestitution(0.1);
        fixture.setFriction(0.2);
        body.setMass(density == 0 ? MassType.INFINITE : MassType.NORMAL);
        body.rotate(angle);
        body.translate(x, y);
        world.addBody(body);
        return body;
    }
}
