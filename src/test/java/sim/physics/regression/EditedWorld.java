// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import java.util.List;
import java.util.SplittableRandom;
import sim.physics.PhysicsEngine;
import sim.physics.collision.narrow.Distance;
import sim.physics.constraint.Constraint;
import sim.physics.motion.Automatic;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.Euler;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.GraggBulirschStoer;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.motion.KinematicBody;
import sim.physics.motion.RadauIIA;
import sim.physics.motion.Rattle;
import sim.physics.motion.RungeKutta4;
import sim.physics.motion.SurfaceFriction;
import sim.physics.motion.SymplecticEuler;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.response.ContactListener;
import sim.physics.response.LastingContact;
import sim.physics.shape.Circle;
import sim.physics.shape.Compound;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/**
 * A world of bodies, joints and forces between walls that is drawn from a seed, measured in any units, and edited at random, by an author
 * between steps and by its own listeners within them. All draws come from seeds: two worlds of one seed are the same, and so are their edits.
 */
final class EditedWorld implements CollisionListener, ContactListener {
    private static final long serialVersionUID = 1L;

    /** Impacts of one step beyond which it is taken not to end. */
    private static final int ENDLESS = 2_000_000;

    private static final int MOST_BODIES = 30;

    final PhysicsEngine engine = new PhysicsEngine();

    /** What a metre, a second and a kilogram are. */
    final double length;

    final double time;
    final double mass;

    /** Half the width between the walls, in metres. */
    final double half;

    final double restitution;
    private final double friction;
    private final Edits edits;

    /** Of what listeners draw. */
    private long seed;

    /** Whether listeners edit the world, decide about collisions, and are there at all. */
    boolean meddles;

    boolean listens;
    boolean tells;

    private int impactsInStep;

    /** Whether there are kinematic bodies, and bodies get other shapes. */
    final boolean hasMore;

    /** A force of an author that pulls to the origin and damps; threads may share it or not. */
    static final class Pull implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private final double stiffness;
        private final double damping;
        private final boolean isConcurrent;

        Pull(double stiffness, double damping, boolean isConcurrent) {
            this.stiffness = stiffness;
            this.damping = damping;
            this.isConcurrent = isConcurrent;
        }

        @Override
        public boolean isConcurrent() {
            return isConcurrent;
        }

        @Override
        public boolean isAutonomous() {
            return isConcurrent;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            double m = body.getMass();
            forces.add(
                    body,
                    -m * (stiffness * body.getX() + damping * body.getVelocityX()),
                    -m * (stiffness * body.getY() + damping * body.getVelocityY()));
            forces.addTorque(body, -damping * body.getInertia() * body.getAngularVelocity());
        }
    }

    EditedWorld(long seed, boolean hasMore, double length, double time, double mass) {
        this.hasMore = hasMore;
        this.length = length;
        this.time = time;
        this.mass = mass;
        SplittableRandom r = new SplittableRandom(seed);
        this.seed = r.nextLong();
        engine.setTimeStep(time / (20 + r.nextInt(220)));
        engine.setIntegrator(method(r));
        engine.setTimeStepping(r.nextInt(3) == 0 ? 1 + r.nextInt(6) : 0);
        int count = 1 + r.nextInt(14);
        half = 2 * Math.sqrt(count) * (1 + r.nextDouble());
        friction = r.nextInt(3) == 0 ? 0 : r.nextDouble();
        restitution = r.nextInt(3) * 0.5;
        r.nextInt(); // not made use of any more; seeds keep their worlds
        edits = new Edits(this);
        addForces(r);
        boolean hasWalls = r.nextInt(5) > 0;
        for (int side = -1; hasWalls && side <= 1; side += 2) {
            rub(engine.add(Body.fixed(box(2 * half + 4, 2)).at(0, side * (half + 1) * length)));
            rub(engine.add(Body.fixed(box(2, 2 * half + 4)).at(side * (half + 1) * length, 0)));
        }
        for (int k = 0; k < count; k++) {
            addBody(r, true);
        }
        edits.begin(r);
        meddles = r.nextInt(3) == 0;
        listens = r.nextInt(2) == 0;
        if (listens) {
            engine.addListener(this);
        }
        tells = r.nextInt(2) == 0;
        if (tells) {
            engine.addContactListener(this);
        }
        edits.chooseKinds(r);
    }

    private void addForces(SplittableRandom r) {
        if (r.nextInt(3) > 0) {
            edits.add(new Gravity(2 * signed(r) * acceleration(), -10 * r.nextDouble() * acceleration()));
        }
        if (r.nextInt(4) == 0) {
            edits.add(new SurfaceFriction(9.81 * acceleration()));
        }
        if (r.nextInt(5) == 0) {
            edits.add(new Pull(r.nextDouble() / (time * time), 0.3 * r.nextDouble() / time, r.nextBoolean()));
        }
    }

    double acceleration() {
        return length / (time * time);
    }

    double force() {
        return mass * acceleration();
    }

    /** From −1 to 1. */
    static double signed(SplittableRandom r) {
        return 2 * r.nextDouble() - 1;
    }

    /** A method of integration. */
    Integrator method(SplittableRandom r) {
        double tolerance = StrictMath.scalb(1.0, -10 - r.nextInt(24)) * length;
        return switch (r.nextInt(10)) {
            case 0 -> new Euler();
            case 1 -> new DormandPrince853(tolerance);
            case 2 -> new GraggBulirschStoer(tolerance);
            case 3 -> new RadauIIA(tolerance);
            case 4 -> new SymplecticEuler();
            case 5 -> new Automatic(tolerance);
            case 6 -> new Rattle(2 + 2 * r.nextInt(3));
            default -> new RungeKutta4();
        };
    }

    private Shape box(double width, double height) {
        return new Rectangle(width * length, height * length);
    }

    /** Gives a body the world's coefficients. */
    Body rub(Body body) {
        body.setFriction(friction);
        body.setRestitution(restitution);
        return body;
    }

    Shape shape(SplittableRandom r) {
        double size = 0.3 + 0.7 * r.nextDouble();
        switch (r.nextInt(6)) {
            case 0, 1 -> {
                return new Circle(size * length);
            }
            case 2 -> {
                return box(2 * size, size * (0.2 + r.nextDouble()));
            }
            case 3 -> {
                return compound(r, size * length);
            }
            default -> {
                double[] xy = new double[2 * (3 + r.nextInt(5))];
                for (int k = 0; k < xy.length; k += 2) {
                    double angle = 2 * Math.PI * (k + r.nextDouble()) / xy.length;
                    xy[k] = size * StrictMath.cos(angle) * length;
                    xy[k + 1] = size * StrictMath.sin(angle) * length;
                }
                return new Polygon(xy);
            }
        }
    }

    private static Shape compound(SplittableRandom r, double arm) {
        double thick = 0.3 * arm;
        return r.nextBoolean()
                ? new Compound(Compound.box(0, 0, 2 * arm, thick), Compound.box(0.5 * arm, 0.5 * (thick + arm), thick, arm))
                : new Compound(Compound.disc(0, 0, 0.5 * arm), Compound.disc(0.8 * arm, 0, 0.4 * arm), Compound.box(0.4 * arm, 0, arm, thick));
    }

    private boolean isFree(Body body) {
        Distance distance = new Distance();
        return engine.bodies().stream().allMatch(other -> distance.between(body, other) > 1e-3 * length);
    }

    /** Adds a body somewhere: where it is free, or anywhere. */
    void addBody(SplittableRandom r, boolean isToBeFree) {
        Shape shape = shape(r);
        boolean isFixed = r.nextInt(9) == 0;
        boolean isKinematic = hasMore && r.nextInt(6) == 0;
        Body body = isKinematic ? new KinematicBody(shape) : isFixed ? Body.fixed(shape) : new Body(shape);
        double heavy = r.nextInt(3) == 0 ? StrictMath.pow(10, signed(r)) : 1;
        boolean moves = r.nextInt(3) > 0;
        double vx = 3 * signed(r);
        double vy = 3 * signed(r);
        double omega = 3 * signed(r);
        rub(body).setSurfaceFriction(0.3 * r.nextDouble());
        if (body.isDynamic()) {
            body.setMass(heavy * mass);
        }
        boolean isFree = false;
        for (int k = 0; k < 30 && !isFree; k++) {
            body.at(half * signed(r) * length, half * signed(r) * length, 3 * signed(r));
            isFree = !isToBeFree || isFree(body);
        }
        if (isFree && engine.bodies().size() < MOST_BODIES) {
            if (!body.isFixed() && moves) {
                body.moving(vx * length / time, vy * length / time, omega / time);
            }
            engine.add(body);
        }
    }

    /** An edit; the same seed does the same to the same world. */
    Edits.Kind edit(long editSeed) {
        return edits.make(editSeed, false);
    }

    /** {@return what the last edit was} */
    String lastEdit() {
        return edits.last;
    }

    /** Makes a step; listeners may edit the world in it. */
    void step() {
        impactsInStep = 0;
        engine.step();
    }

    private SplittableRandom meddle(int chance) {
        SplittableRandom r = new SplittableRandom(seed++);
        if (meddles && r.nextInt(chance) == 0) {
            edits.make(r.nextLong(), true);
        }
        return r;
    }

    @Override
    public Decision colliding(Contact contact) {
        int k = meddle(12).nextInt(14);
        return !meddles || k > 1 ? Decision.BOUNCE : k == 0 ? Decision.STICK : Decision.IGNORE;
    }

    @Override
    public void collided(Contact contact) {
        if (++impactsInStep > ENDLESS) {
            throw new AssertionError("a step does not end");
        }
        meddle(12);
    }

    @Override
    public void began(LastingContact contact) {
        if (!(contact.normalForce() >= 0)) {
            throw new AssertionError("a contact pulls: " + contact);
        }
        meddle(12);
    }

    @Override
    public void lasts(LastingContact contact) {
        meddle(60);
    }

    @Override
    public void ended(Body a, Body b) {
        seed++;
    }

    /** Places and velocities in metres, radians and seconds; what is lost by scaling is zero. */
    double[] plain() {
        List<Body> bodies = engine.bodies();
        double[] all = new double[6 * bodies.size()];
        int k = 0;
        for (Body body : bodies) {
            all[k++] = body.getX() / length;
            all[k++] = body.getY() / length;
            all[k++] = body.getAngle();
            all[k++] = body.getVelocityX() / length * time;
            all[k++] = body.getVelocityY() / length * time;
            all[k++] = body.getAngularVelocity() * time;
        }
        for (int i = 0; i < all.length; i++) {
            all[i] = Math.abs(all[i]) < Float.MIN_NORMAL ? 0 : all[i];
        }
        return all;
    }

    /** {@return the constraints that are in the engine} */
    List<Constraint> ties() {
        return engine.allConstraints();
    }
}
