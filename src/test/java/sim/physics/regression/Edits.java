// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import static sim.physics.regression.EditedWorld.signed;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.collision.broad.BruteForce;
import sim.physics.collision.broad.CellGrid;
import sim.physics.collision.broad.SortAndSweep;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.DirectSolver;
import sim.physics.constraint.Reaction;
import sim.physics.constraint.Stabilization;
import sim.physics.constraint.Wheel;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Gravity;
import sim.physics.motion.KinematicBody;
import sim.physics.motion.Spring;
import sim.physics.motion.SurfaceFriction;
import sim.physics.motion.ViscousFriction;
import sim.physics.response.PairRule;

/** What an author does to an {@link EditedWorld} at random. Calls that the engine must refuse are in {@link BadEdits}, and joints in {@link DrawnTies}. */
final class Edits implements Serializable {
    private static final long serialVersionUID = 1L;

    /** What became of an edit. Only what is done may leave a trace. */
    enum Kind {
        DONE,
        REFUSED,
        QUERY
    }

    private static final int KINDS = 40;
    private static final int CLEAR = 32;
    private static final int THREADS = 24; // these are set by the test, since they must not matter

    /** What the last edit was. */
    String last = "";

    private final EditedWorld world;
    private final PhysicsEngine engine;
    private final DrawnTies drawn;
    private final List<Body> out = new ArrayList<>();
    private final List<Constraint> cut = new ArrayList<>();
    private final List<ForceGenerator> generators = new ArrayList<>();

    /** How often each kind of edit is made, relative to others. */
    private final int[] weights = new int[KINDS];

    Edits(EditedWorld world) {
        this.world = world;
        engine = world.engine;
        drawn = new DrawnTies(world);
    }

    void add(ForceGenerator generator) {
        generators.add(engine.add(generator));
    }

    /** Ties some bodies that the world begins with. */
    void begin(SplittableRandom r) {
        for (int k = r.nextInt(6); k > 0; k--) {
            try {
                tie(r);
            } catch (IllegalArgumentException | IllegalStateException e) {
                last = "refused: " + e.getMessage();
            }
        }
    }

    /** Decides what is done often in this world, and what never. */
    void chooseKinds(SplittableRandom r) {
        for (int k = 0; k < KINDS; k++) {
            weights[k] = r.nextInt(4) == 0 ? 0 : 1 + r.nextInt(6);
        }
        weights[CLEAR] = r.nextInt(12) == 0 ? 1 : 0;
        weights[THREADS] = 0;
    }

    /** Makes an edit; the same seed on the same world does the same. */
    Kind make(long seed, boolean isWithin) {
        SplittableRandom r = new SplittableRandom(seed);
        int sum = 0;
        for (int weight : weights) {
            sum += weight;
        }
        int kind = 0;
        for (int k = r.nextInt(sum); k >= weights[kind]; kind++) {
            k -= weights[kind];
        }
        last = "edit " + kind;
        try {
            return make(kind, r, isWithin);
        } catch (IllegalArgumentException | IllegalStateException e) {
            last += ", refused: " + e.getMessage();
            return Kind.REFUSED;
        }
    }

    private Kind make(int kind, SplittableRandom r, boolean isWithin) {
        List<Body> all = engine.bodies();
        List<Constraint> ties = engine.allConstraints();
        Body a = all.isEmpty() ? null : any(all, r);
        Body b = all.isEmpty() ? null : any(all, r);
        double u = r.nextDouble();
        double v = signed(r);
        double w = signed(r);
        double z = signed(r);
        boolean isOfBody = kind > 3 && kind < 18;
        if (a == null && isOfBody) {
            return Kind.REFUSED;
        }
        if (world.hasMore && a != null && r.nextInt(4) == 0) {
            more(r, a, v, w, z);
            return Kind.DONE;
        }
        boolean isBetweenSteps = kind == 16 || kind == CLEAR || kind >= 34 && kind <= 36 || kind == 38;
        if (isWithin && isBetweenSteps) {
            return Kind.DONE;
        }
        if (kind <= 3) {
            comeAndGo(kind, r, a, isWithin);
        } else if (kind <= 12) {
            write(kind, r, a, b, u, v, w, z);
        } else if (kind <= 20 || kind == 38) {
            tie(kind, r, ties, u, v, w, isWithin);
        } else if (kind == 21) {
            change(r, u, v, w);
        } else if (kind == 35 || kind == 36) {
            ask(r, a, ties);
            return Kind.QUERY;
        } else if (kind == 37) {
            BadEdits.make(world, r, a, ties);
            throw new AssertionError("a bad call was not refused: " + last);
        } else {
            set(kind, r, a, u);
        }
        return Kind.DONE;
    }

    private void more(SplittableRandom r, Body a, double v, double w, double z) {
        double speed = world.length / world.time;
        if (a instanceof KinematicBody moved && r.nextInt(4) > 0) {
            boolean stops = r.nextInt(3) == 0;
            last += ", target of " + a;
            moved.setTargetVelocity(stops ? 0 : v * speed, stops ? 0 : w * speed, stops ? 0 : z / world.time);
        } else {
            last += ", shape of " + a;
            a.setShape(world.shape(r));
        }
    }

    static <X> X any(List<X> list, SplittableRandom r) {
        return list.get(r.nextInt(list.size()));
    }

    private void comeAndGo(int kind, SplittableRandom r, Body a, boolean isWithin) {
        if (kind == 0) {
            world.addBody(r, true);
        } else if (kind == 1) {
            world.addBody(r, r.nextInt(4) > 0);
        } else if (kind == 2 && a != null) {
            engine.remove(a);
            if (!isWithin && out.size() < 8) {
                out.add(a);
            }
        } else if (kind == 3 && !out.isEmpty()) {
            engine.add(out.remove(r.nextInt(out.size())));
        }
    }

    private void write(int kind, SplittableRandom r, Body a, Body b, double u, double v, double w, double z) {
        double length = world.length;
        double speed = length / world.time;
        boolean stays = (kind == 4 || kind == 5) && a.isFixed() && r.nextInt(3) > 0;
        if (stays) {
            return;
        }
        switch (kind) {
            case 4 -> {
                double way = r.nextInt(3) == 0 ? world.half : r.nextInt(2) == 0 ? 1e-3 : 0.3;
                boolean isAnywhere = way == world.half;
                a.setPosition((isAnywhere ? 0 : a.getX()) + way * v * length, (isAnywhere ? 0 : a.getY()) + way * w * length);
            }
            case 5 -> a.setAngle(a.getAngle() + (u < 0.5 ? 0.01 : 3) * v);
            case 6 -> a.setVelocity(4 * v * speed, 4 * w * speed);
            case 7 -> a.setAngularVelocity(5 * v / world.time);
            case 8 -> {
                if (u < 0.6) {
                    a.setMass(world.mass * StrictMath.pow(10, v));
                } else {
                    a.setMass(world.mass * (0.5 + u), world.mass * length * length * (0.1 + u));
                }
            }
            case 9 -> {
                switch (r.nextInt(4)) {
                    case 0 -> a.setRestitution(r.nextInt(3) * 0.5);
                    case 1 -> a.setFriction(u < 0.3 ? 0 : 2 * u);
                    case 2 -> a.setBeltSpeed(u < 0.5 ? 0 : v * speed);
                    default -> a.setSurfaceFriction(0.3 * u, 0.3 * u + 0.1);
                }
            }
            case 10 -> a.setCollisionGroup(1L << r.nextInt(3), u < 0.5 ? -1 : r.nextInt(8));
            case 11 -> engine.setCollisions(a, b, u < 0.5);
            default -> push(r, a, v, w, z);
        }
    }

    private void push(SplittableRandom r, Body a, double v, double w, double z) {
        double force = 20 * world.force();
        double impulse = world.mass * world.length / world.time;
        switch (r.nextInt(4)) {
            case 0 -> a.addForce(v * force, w * force);
            case 1 -> a.addForceAt(v * force, w * force, a.getX() + z * world.length, a.getY());
            case 2 -> a.addTorque(0.5 * v * force * world.length);
            default -> a.addImpulseAt(v * impulse, w * impulse, a.getX() + 0.3 * z * world.length, a.getY());
        }
    }

    private void tie(SplittableRandom r) {
        List<Body> all = engine.bodies();
        if (!all.isEmpty() && engine.allConstraints().size() <= 14) {
            drawn.draw(r);
            drawn.add(this::add);
        }
    }

    private void tie(int kind, SplittableRandom r, List<Constraint> ties, double u, double v, double w, boolean isWithin) {
        switch (kind) {
            case 13, 14 -> tie(r);
            case 15 -> {
                if (!ties.isEmpty()) {
                    Constraint c = any(ties, r);
                    engine.remove(c);
                    if (cut.size() < 6) {
                        cut.add(c);
                    }
                }
            }
            case 16 -> {
                List<Constraint> those = new ArrayList<>();
                for (int k = 1 + r.nextInt(2); k > 0; k--) {
                    Constraint one = engine.allConstraints().size() > 14 ? null : drawn.draw(r);
                    if (one != null) {
                        those.add(one);
                    }
                }
                last += " " + those;
                engine.assemble(those.toArray(new Constraint[0]));
            }
            case 17 -> {
                if (!cut.isEmpty()) {
                    Constraint c = cut.get(r.nextInt(cut.size()));
                    if (isWithin || u < 0.3) {
                        engine.add(c);
                    } else {
                        engine.assemble(c);
                    }
                }
            }
            case 38 -> {
                for (Constraint c : ties) {
                    if (u < 0.3 && engine.contains(c)) {
                        engine.remove(c);
                    }
                }
            }
            default -> {
                if (!ties.isEmpty()) {
                    drawn.set(any(ties, r), u, v, w);
                }
            }
        }
    }

    /** Adds, removes or changes a force. */
    private void change(SplittableRandom r, double u, double v, double w) {
        generators.removeIf(g -> !engine.allForceGenerators().contains(g));
        if (!generators.isEmpty() && u < 0.4) {
            ForceGenerator gone = any(generators, r);
            engine.remove(gone);
            generators.remove(gone);
            return;
        }
        if (!generators.isEmpty() && u < 0.7 && any(generators, r) instanceof Spring spring) {
            spring.setLength(spring.getLength() * (1 + 0.3 * v));
            spring.setStiffness(spring.getStiffness() * (1 + 0.5 * w));
            spring.setDamping(spring.getDamping() * (0.5 + u));
            return;
        }
        double acceleration = world.acceleration();
        switch (r.nextInt(4)) {
            case 0 -> add(new Gravity(5 * v * acceleration, 5 * w * acceleration));
            case 1 -> add(new SurfaceFriction(5 * u * acceleration));
            case 2 -> add(new ViscousFriction(u / world.time));
            default -> add(new EditedWorld.Pull(u / (world.time * world.time), 0.3 * u / world.time, v > 0));
        }
    }

    private void set(int kind, SplittableRandom r, Body a, double u) {
        double time = world.time;
        switch (kind) {
            case 22 -> engine.setIntegrator(world.method(r));
            case 23 -> engine.setTimeStep(u < 0.1 ? 0 : time / (20 + r.nextInt(220)));
            case 25 -> engine.setTimeStepping(u < 0.5 ? 0 : 1 + r.nextInt(6));
            case 26 -> engine.setSleepAllowed(u < 0.7);
            case 27 -> {
                int which = r.nextInt(3);
                engine.setBroadPhase(which == 0 ? new BruteForce() : which == 1 ? new CellGrid() : new SortAndSweep());
            }
            case 28 -> {
                boolean isOn = u < 0.3;
                if (r.nextInt(3) == 0 || !isOn) {
                    engine.setAudited(isOn);
                }
            }
            case 29 -> engine.setPairRules(any(List.of(PairRule.values()), r), any(List.of(PairRule.values()), r));
            case 30 -> {
                if (r.nextInt(2) == 0) {
                    engine.setConstraintSolver(new DirectSolver());
                } else {
                    engine.setStabilization(Stabilization.projection());
                }
            }
            case 31 -> setListeners(u < 0.5);
            case CLEAR -> clear(u < 0.7);
            case 33 -> engine.setWorkLimit(u < 0.4 ? 300_000_000L : (long) (100 + 20000 * u));
            case 34 -> engine.separate();
            default -> {
                if (engine.bodies().size() > 4 && !a.isFixed()) {
                    replace(a, r);
                }
            }
        }
    }

    private void setListeners(boolean areOfCollisions) {
        if (areOfCollisions) {
            if (world.listens) {
                engine.removeListener(world);
            } else {
                engine.addListener(world);
            }
            world.listens = !world.listens;
        } else {
            if (world.tells) {
                engine.removeContactListener(world);
            } else {
                engine.addContactListener(world);
            }
            world.tells = !world.tells;
        }
    }

    /** Gives a body another shape: it is another body. */
    private void replace(Body a, SplittableRandom r) {
        Body other = new Body(world.shape(r));
        other.at(a.getX(), a.getY(), a.getAngle()).moving(a.getVelocityX(), a.getVelocityY(), a.getAngularVelocity());
        world.rub(other).setMass(world.mass);
        engine.remove(a);
        engine.add(other);
    }

    /** Removes everything, and may add it again. */
    private void clear(boolean isAddedAgain) {
        List<Body> all = engine.bodies();
        List<Constraint> ties = engine.allConstraints();
        List<ForceGenerator> forces = engine.allForceGenerators();
        all.forEach(engine::remove);
        engine.allForceGenerators().forEach(engine::remove);
        if (!engine.allConstraints().isEmpty()) {
            throw new AssertionError("constraints without bodies: " + engine.allConstraints());
        }
        if (!isAddedAgain) {
            return;
        }
        all.forEach(engine::add);
        forces.forEach(engine::add);
        for (Constraint c : ties) {
            try {
                engine.add(c);
            } catch (IllegalArgumentException | IllegalStateException e) {
                last += ", not again: " + e.getMessage();
            }
        }
    }

    /** Asks for something, which must leave no trace. */
    private void ask(SplittableRandom r, Body a, List<Constraint> ties) {
        int what = r.nextInt(10);
        last += ", question " + what;
        switch (what) {
            case 0 -> engine.contacts();
            case 1 -> {
                if (!ties.isEmpty()) {
                    assertFinite(any(ties, r));
                }
            }
            case 2 -> engine.overlaps();
            case 3 -> {
                if (a != null) {
                    engine.contacts(a);
                    engine.isAsleep(a);
                    a.kineticEnergy();
                }
            }
            case 4 -> {
                double x = signed(r) * world.half * world.length;
                engine.queries().within(x, signed(r) * world.half * world.length, 2 * world.length, null);
                engine.getRedundantEquations();
                engine.getDeepestPenetration();
                engine.kineticEnergy();
            }
            case 5 -> Checkpoint.bytes(world);
            case 6 -> QueryCheck.check(engine, r.nextLong(), world.half, world.length);
            case 7 -> {
                if (a != null) {
                    engine.contains(a);
                    a.worldX(0, world.length);
                    a.state().x();
                    a.state().v();
                }
            }
            case 8 -> ties.forEach(this::assertFinite);
            default -> {
                ties.forEach(c -> String.valueOf(c instanceof Wheel wheel ? wheel.getSlip() : c));
                engine.contacts().forEach(Object::toString);
                engine.allForceGenerators().forEach(ForceGenerator::energy);
            }
        }
    }

    private void assertFinite(Constraint c) {
        Reaction reaction = engine.getReaction(c);
        if (!Double.isFinite(reaction.forceX() + reaction.forceY() + reaction.torque())) {
            throw new AssertionError("the reaction of " + c + " is " + reaction);
        }
    }
}
