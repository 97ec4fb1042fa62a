// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;

import java.awt.Color;
import java.util.stream.Stream;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.collision.broad.BroadPhase;
import sim.physics.collision.broad.BruteForce;
import sim.physics.collision.broad.CellGrid;
import sim.physics.collision.broad.SortAndSweep;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.ConstraintException;
import sim.physics.constraint.Curve;
import sim.physics.constraint.Equations;
import sim.physics.constraint.GearJoint;
import sim.physics.constraint.Limit;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.PulleyJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.constraint.SlotJoint;
import sim.physics.constraint.Stabilization;
import sim.physics.constraint.WireJoint;
import sim.physics.mason.EnginePortrayal2D;
import sim.physics.mason.Picture;
import sim.physics.matrix.BiConjugateGradient;
import sim.physics.matrix.DenseMatrix;
import sim.physics.matrix.DiagonalMatrix;
import sim.physics.motion.Body;
import sim.physics.motion.Euler;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.motion.Rattle;
import sim.physics.motion.RungeKutta4;
import sim.physics.motion.Spring;
import sim.physics.motion.SurfaceFriction;
import sim.physics.motion.SymplecticEuler;
import sim.physics.query.Queries;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.response.ContactListener;
import sim.physics.shape.Circle;
import sim.physics.shape.Compound;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Bad input gets an exception at the call that made it, and leaves the engine as it was. */
class RefusalTest {
    private PhysicsEngine engine;
    private Body body;
    private Body wall;

    @BeforeEach
    void setUp() {
        engine = new PhysicsEngine();
        body = engine.add(new Body(new Circle(1)).at(3, 4).moving(1, 2));
        wall = engine.add(Body.fixed(new Rectangle(1, 10)).at(9, 0));
    }

    private void refused(String message, ThrowingCallable call) {
        long before = Scenes.hash(engine);
        assertThatIllegalArgumentException().isThrownBy(call).withMessageContaining(message);
        assertThat(Scenes.hash(engine)).isEqualTo(before);
    }

    private void illegal(String message, ThrowingCallable call) {
        long before = Scenes.hash(engine);
        assertThatIllegalStateException().isThrownBy(call).withMessageContaining(message);
        assertThat(Scenes.hash(engine)).isEqualTo(before);
        assertThat(engine.bodies()).containsExactly(body, wall);
    }

    @Test
    void whatIsNotFinite() {
        double nan = Double.NaN;
        refused("x is NaN", () -> body.setPosition(nan, 0));
        refused("y is Infinity", () -> body.setPosition(0, Double.POSITIVE_INFINITY));
        refused("angle is NaN", () -> body.setAngle(nan));
        refused("angle is NaN", () -> body.at(1, 1, nan));
        refused("vy is NaN", () -> body.setVelocity(0, nan));
        refused("angular velocity is NaN", () -> body.moving(1, 1, nan));
        refused("fx is NaN", () -> body.addForce(nan, 0));
        refused("torque is NaN", () -> body.addTorque(nan));
        refused("px is NaN", () -> body.addForceAt(1, 1, nan, 0));
        refused("radius is NaN", () -> new Circle(nan));
        refused("width is Infinity", () -> new Rectangle(Double.POSITIVE_INFINITY, 1));
        refused("gx is NaN", () -> new Gravity(nan, 0));
        refused("y of vertex 1 is NaN", () -> new Polygon(0, 0, 1, nan, 1, 1));
        refused("x is NaN", () -> body.getShape().contains(nan, 0));
        refused("y is NaN", () -> wall.getShape().contains(0, nan)); // it was said to be inside
        refused("y is Infinity", () -> new Compound(Compound.box(0, 0, 1, 1), Compound.disc(2, 0, 1)).contains(0, Double.POSITIVE_INFINITY));
    }

    /** Of the four or eight coordinates of a joint the one that is wrong is named. */
    @Test
    void whichPointOfAJointIsNotFinite() {
        double nan = Double.NaN;
        refused("ax is NaN", () -> PinJoint.bodyPoints(body, nan, 0, wall, 0, 0));
        refused("by is NaN", () -> PinJoint.bodyPoints(body, 0, 0, wall, 0, nan));
        refused("bx is NaN", () -> RodJoint.bodyPoints(body, 0, 0, wall, nan, 0));
        refused("ay is NaN", () -> RodJoint.worldPoints(body, 0, nan, wall, 1, 0));
        refused("bx is NaN", () -> RodJoint.bodyPoints(body, 0, 0, wall, nan, 0, 1));
        refused("bx is NaN", () -> PulleyJoint.bodyPoints(body, 0, 0, 1, 1, wall, nan, 0, 1, 0, 1, 1));
        refused("ay is NaN", () -> PulleyJoint.worldPoints(body, 0, nan, 0, 1, wall, 0, 0, 1, 1, 1));
        refused("ay is NaN", () -> new WireJoint(body, 0, nan, Curve.circle(0, 0, 1)));
        refused("dy is NaN", () -> new SliderJoint(body, null, 0, 0, 1, nan));
        refused("dx is Infinity", () -> Curve.line(0, 0, Double.POSITIVE_INFINITY, 0));
        refused("direction is (0.0, 0.0)", () -> new SlotJoint(body, null, 0, 0, 0, 0));
        refused("direction is (0.0, 0.0)", () -> Curve.line(0, 0, 0, 0));
    }

    /** With a ratio of 0 the second body would have no part in the joint. */
    @Test
    void aGearWithoutARatio() {
        refused("ratio is 0.0: it must not be 0", () -> new GearJoint(body, wall, 0));
        refused("ratio is -0.0: it must not be 0", () -> new GearJoint(body, null, -0.0));
        refused("ratio is NaN", () -> new GearJoint(body, wall, Double.NaN));
    }

    /** Of an author's own making: a coefficient that is no number made bodies that are nowhere, without a word. */
    @Test
    void constraintsWithoutUsableEquations() {
        Body other = new Body(new Circle(1));
        record Own(Body getBodyA, Body getBodyB, double coefficient) implements Constraint {
            @Override
            public Body getBodyA() {
                return getBodyA;
            }

            @Override
            public Body getBodyB() {
                return getBodyB;
            }

            @Override
            public int getRows() {
                return 1;
            }

            @Override
            public void evaluate(Equations equations) {
                equations.set(0, 0, 0);
                equations.setA(0, 0, coefficient, 0);
            }
        }
        refused("its row 0 of J is [0.0, NaN, 0.0]", () -> engine.add(new Own(body, null, Double.NaN)));
        refused("its row 0 of J is [0.0, Infinity, 0.0]", () -> engine.add(new Own(wall, body, Double.POSITIVE_INFINITY)));
        refused("with its squares over the masses", () -> engine.add(new Own(body, null, 1e300)));
        refused("with its squares over the masses", () -> engine.add(new GearJoint(wall, body, 1e160)));
        refused("its row 0 of J is [0.0, NaN, 0.0]", () -> engine.assemble(new GearJoint(body, null, 1), new Own(body, null, Double.NaN)));
        refused("it needs two different bodies", () -> engine.add(new Own(body, body, 1)));
        illegal("it is not in this engine", () -> engine.add(new Own(other, body, 1)));
        assertThat(engine.allConstraints()).isEmpty();
        engine.add(new Own(body, wall, 1));
        engine.step();
        assertThat(body.getVelocityY()).isZero();
    }

    /** What gets no number later than that is refused in the step, as forces are, and the bodies stay where they are. */
    @ParameterizedTest
    @CsvSource({"0, 0, NaN", "0, 2, Infinity", "0, 3, NaN", "4, 0, NaN", "4, 2, Infinity", "4, 3, NaN"})
    void equationsThatGetNoNumbers(int substeps, int which, double value) {
        for (boolean isStop : new boolean[] {false, true}) {
            setUp();
            double[] late = {0, 0, 1, 0, 0, 0};
            WireJoint wire = new WireJoint(body, (x, y, f) -> {
                System.arraycopy(late, 0, f, 0, 6);
                f[0] += y - 4;
            });
            engine.setTimeStepping(substeps);
            engine.add(new Gravity(0, -1));
            body.moving(1, 0, 0.5);
            Constraint tie = engine.add(isStop ? new Limit(wire, -1, 1, 0) : wire);
            engine.step();
            late[which] = value;
            assertThatIllegalArgumentException().isThrownBy(engine::step).withMessageContaining("its row 0 must be finite, but C is");
            engine.remove(tie);
            engine.step();
            assertThat(body.getX() + body.getY() + body.getVelocityX() + body.getVelocityY() + body.getAngularVelocity()).isFinite();
        }
    }

    @Test
    void aListenerThatDoesNotDecide() {
        engine.addListener(new CollisionListener() {
            @Override
            public Decision colliding(Contact contact) {
                return null;
            }

            @Override
            public String toString() {
                return "Idler";
            }
        });
        wall.setPosition(5, 4);
        body.moving(4, 0);
        for (int substeps : new int[] {0, 4}) {
            engine.setTimeStepping(substeps);
            assertThatNullPointerException().isThrownBy(engine::step).withMessageContaining("decision is null: listener Idler must say");
        }
    }

    /** The engine's vectors are for authors to read and write; who is in them the engine says. */
    @Test
    void bodiesThatAreNotInAState() {
        Body stranger = new Body(new Circle(1));
        Body other = new PhysicsEngine().add(new Body(new Circle(1)));
        illegal("it is not in this state", () -> body.state().remove(stranger));
        illegal("it is not in this state", () -> body.state().remove(other));
        illegal("it is not in this state", () -> stranger.state().remove(stranger));
        illegal("this state, as it is in it already", () -> body.state().add(body));
        illegal("this state from another one", () -> body.state().add(other));
        illegal("the state of another body alone", () -> stranger.state().add(new Body(new Circle(1))));
    }

    @Test
    void whatIsOutOfRange() {
        refused("mass is 0.0", () -> body.setMass(0));
        refused("mass is -1.0", () -> body.setMass(-1));
        refused("inertia is 0.0", () -> body.setMass(1, 0));
        refused("1 / mass", () -> body.setMass(1e-310));
        refused("restitution is 1.1", () -> body.setRestitution(1.1));
        refused("restitution is -0.1", () -> body.setRestitution(-0.1));
        refused("friction is -1.0", () -> body.setFriction(-1));
        refused("kinetic surface friction is -1.0", () -> body.setSurfaceFriction(-1));
        refused("static surface friction is 0.1", () -> body.setSurfaceFriction(0.2, 0.1));
        refused("gravity is 0.0", () -> new SurfaceFriction(0));
        refused("radius is 0.0", () -> new Circle(0));
        refused("time step is -0.1", () -> engine.setTimeStep(-0.1));
        refused("time step is NaN", () -> engine.setTimeStep(Double.NaN));
        refused("fixed", () -> wall.setVelocity(1, 0));
        refused("fixed", () -> wall.setMass(1));
    }

    @Test
    void whatOverflowsChangesNeitherPartOfABody() {
        refused("torque is", () -> body.addForceAt(0, 1e300, 1e300, 0));
        refused("angular velocity is", () -> body.addImpulseAt(1, 1e300, 1e300, 0));
        engine.step();
        assertThat(body.getVelocityX()).isEqualTo(1); // no force is left over
        assertThat(body.getVelocityY()).isEqualTo(2);
    }

    @Test
    void whatIsAskedWrongly() {
        Queries queries = engine.queries();
        refused("highX is -1.0: it must not be less than lowX, 0.0", () -> queries.inBox(0, 0, -1, 1, null));
        refused("highY is NaN", () -> queries.inBox(0, 0, 1, Double.NaN, null));
        refused("count is -1", () -> queries.nearest(0, 0, -1, null));
        refused("distance is -1.0", () -> queries.within(0, 0, -1, null));
        refused("range is -1.0", () -> queries.rayCast(0, 0, 1, 0, -1, null));
        refused("direction is (0.0, 0.0)", () -> queries.rayCast(0, 0, 0, 0, 1, null));
        refused("halfAngle is 4.0", () -> queries.visible(0, 0, 0, 4, 1, null));
        refused("x is NaN", () -> queries.fan(Double.NaN, 0, 0, 1, 1, null, new double[0]));
        refused("to - from is Infinity", () -> queries.fan(0, 0, -1e308, 1e308, 1, null, new double[3]));
    }

    @Test
    void intervalsGainsAndPictures() {
        refused("interval is 0.0", () -> new Repeating(engine, 0, 0));
        refused("interval is NaN", () -> new Repeating(engine, 0, Double.NaN));
        refused("position gain is NaN", () -> new Stabilization(true, Double.NaN, 0));
        refused("velocity gain is -1.0", () -> Stabilization.feedback(0, -1));
        refused("x is NaN", () -> new Picture(Double.NaN, 0, 1, 1, 1, Color.BLACK, b -> null));
        refused("scale is 0.0", () -> new Picture(0, 0, 1, 1, 0, Color.BLACK, b -> null));
        refused("height is -1.0", () -> new Picture(0, 0, 1, -1, 1, Color.BLACK, b -> null));
    }

    @Test
    void nothingAtAll() {
        Queries queries = engine.queries();
        missing("body", () -> engine.add((Body) null));
        missing("body", () -> engine.remove((Body) null));
        missing("generator", () -> engine.add((ForceGenerator) null));
        missing("constraint", () -> engine.add((Constraint) null));
        missing("constraints", () -> engine.assemble((Constraint[]) null));
        missing("constraint", () -> engine.assemble((Constraint) null));
        missing("integrator", () -> engine.setIntegrator(null));
        missing("solver", () -> engine.setConstraintSolver(null));
        missing("solver", () -> engine.setImpulseSolver(null));
        missing("stabilization", () -> engine.setStabilization(null));
        missing("listener", () -> engine.addListener(null));
        missing("listener", () -> engine.addContactListener(null));
        missing("broadPhase", () -> engine.setBroadPhase(null));
        missing("schedule", () -> engine.scheduleOn(null));
        missing("shape", () -> new Body(null));
        missing("xy", () -> new Polygon((double[]) null));
        missing("only the second body", () -> new PinJoint(null, body, 0, 0));
        missing("target", () -> new Repeating(null, 0, 1));
        missing("body", () -> queries.distance(null, 0, 0));
        missing("into", () -> queries.within(0, 0, 1, null, null));
        missing("into", () -> queries.nearest(0, 0, 1, null, null));
        missing("into", () -> queries.inBox(0, 0, 1, 1, null, null));
        missing("into", () -> queries.rayCast(0, 0, 1, 0, 1, null, null));
        missing("distances", () -> queries.fan(0, 0, 0, 1, 1, null, null));
        missing("shape", () -> queries.shapeCast((Shape) null, 0, 0, 0, 1, 0, 1, null));
        missing("into", () -> queries.shapeCast(new Circle(1), 0, 0, 0, 1, 0, 1, null, null));
        Picture picture = new Picture(0, 0, 1, 1, 1, Color.BLACK, b -> null);
        missing("engine", () -> picture.draw(null));
        missing("layers", () -> picture.draw(engine, (EnginePortrayal2D[]) null));
        missing("file", () -> picture.write(engine, null));
        missing("values", () -> new DenseMatrix(1, 1, (double[]) null));
        missing("x", () -> new DenseMatrix(1, 1).times(null, new double[1]));
        missing("y", () -> new DiagonalMatrix(1).transposeTimes(new double[1], null));
        missing("b", () -> new BiConjugateGradient().solve(new DenseMatrix(1, 1, 2), null, new double[1]));
    }

    private void missing(String name, ThrowingCallable call) {
        long before = Scenes.hash(engine);
        assertThatNullPointerException().isThrownBy(call).withMessageContaining(name).withMessageNotContaining("invoke");
        assertThat(Scenes.hash(engine)).isEqualTo(before);
        assertThat(engine.allConstraints()).isEmpty();
    }

    @Test
    void polygonsThatAreNotStrictlyConvex() {
        refused("vertex 1 is (1.0, 0.0)", () -> new Polygon(0, 0, 1, 0, 2, 0, 1, 1));
        refused("vertex 2 is (0.5, 0.5): the polygon is not convex", () -> new Polygon(0, 0, 2, 0, 0.5, 0.5, 0, 2));
        refused("vertex 0", () -> new Polygon(0, 0, 0, 0, 1, 0, 0, 1));
        refused("4 coordinates", () -> new Polygon(0, 0, 1, 1));
        double[] star = new double[10];
        for (int k = 0; k < 5; k++) {
            star[2 * k] = Math.cos(4 * Math.PI * k / 5);
            star[2 * k + 1] = Math.sin(4 * Math.PI * k / 5);
        }
        refused("crosses itself", () -> new Polygon(star));
    }

    @Test
    void bodiesInTheWrongPlace() {
        illegal("this engine", () -> engine.add(body));
        PhysicsEngine other = new PhysicsEngine();
        illegal("another engine", () -> other.add(body));
        Body stranger = new Body(new Circle(1));
        illegal("not in this engine", () -> engine.remove(stranger));
        illegal("not in this engine", () -> engine.setCollisions(body, stranger, false));
        illegal("not in this engine", () -> engine.remove(new Gravity(0, 1)));
        Gravity gravity = new Gravity(0, 0);
        engine.add(gravity);
        illegal("already", () -> engine.add(gravity));
    }

    @Test
    void aListenerThatIsThere() {
        record Counter(int[] told) implements CollisionListener, ContactListener {
            @Override
            public void collided(Contact contact) {
                told[0]++;
            }
        }
        Counter one = new Counter(new int[1]);
        Counter equal = new Counter(one.told);
        engine.addListener(one);
        engine.addContactListener(one);
        illegal("it was added already", () -> engine.addListener(one));
        illegal("it was added already", () -> engine.addContactListener(one));
        engine.addListener(equal); // another one: who it is counts, as for bodies
        engine.addContactListener(equal);
        engine.removeListener(equal);
        engine.removeContactListener(equal);
        illegal("it is not in this engine", () -> engine.removeListener(equal));
        illegal("it is not in this engine", () -> engine.removeContactListener(equal));
        wall.setPosition(5, 4);
        body.moving(4, 0);
        engine.step();
        assertThat(one.told[0]).isEqualTo(1); // it was told as often as it was added
    }

    /** Two engines with one broad phase ran out of their arrays, or of memory. */
    @ParameterizedTest
    @MethodSource("broadPhases")
    void aBroadPhaseThatIsInUse(BroadPhase broadPhase) {
        engine.setBroadPhase(broadPhase);
        illegal("that an engine uses or has used", () -> new PhysicsEngine().setBroadPhase(broadPhase));
        illegal("that an engine uses or has used", () -> engine.setBroadPhase(broadPhase));
        engine.setBroadPhase(new BruteForce());
        illegal("that an engine uses or has used", () -> engine.setBroadPhase(broadPhase));
        engine.step();
    }

    static Stream<BroadPhase> broadPhases() {
        return Stream.of(new BruteForce(), new CellGrid(), new SortAndSweep());
    }

    @Test
    void whatIsAddedIsGivenBack() {
        Gravity gravity = engine.add(new Gravity(0, -1));
        Spring spring = engine.add(new Spring(body, 0, 0, wall, 0, 0, 1, 1, 0));
        assertThat(engine.allForceGenerators()).containsExactly(gravity, spring);
    }

    @Test
    void aPairOfOneBody() {
        refused("b is Body[Circle[radius 1.0] at (3.0, 4.0)", () -> engine.setCollisions(body, body, false));
        refused("b is Body[Rectangle", () -> engine.setCollisions(wall, wall, true));
    }

    @Test
    void whatIsMissingIsNamed() {
        assertThatThrownBy(() -> engine.setCollisions(null, body, false)).isInstanceOf(NullPointerException.class).hasMessage("a");
        assertThatThrownBy(() -> engine.setCollisions(body, null, false)).isInstanceOf(NullPointerException.class).hasMessage("b");
        illegal("b is Body[Circle[radius 1.0] at (0.0, 0.0)", () -> engine.setCollisions(body, new Body(new Circle(1)), false));
        assertThatThrownBy(() -> engine.assemble((Constraint[]) null)).isInstanceOf(NullPointerException.class).hasMessage("constraints");
        PinJoint pin = new PinJoint(body, 3, 4);
        assertThatThrownBy(() -> engine.assemble(pin, null)).isInstanceOf(NullPointerException.class).hasMessage("constraints[1]");
        assertThat(engine.contains(pin)).isFalse();
    }

    /** Two thousand million substeps would be a step that seems to hang. */
    @Test
    void moreSubstepsThanAStepMayHave() {
        refused("substeps are 10001", () -> engine.setTimeStepping(10_001));
        refused("substeps are 2147483647", () -> engine.setTimeStepping(Integer.MAX_VALUE));
        assertThat(engine.getTimeStepping()).isZero();
        engine.setTimeStepping(10_000);
        engine.step();
    }

    @Test
    void messagesAreGrammatical() {
        refused("an impulse was given to a fixed body", () -> wall.addImpulseAt(1, 0, 0, 0));
        refused("an angular velocity was given to a fixed body", () -> wall.setAngularVelocity(1));
        refused("a velocity was given to a fixed body", () -> wall.setVelocity(1, 0));
        refused("a force was given to a fixed body", () -> wall.addForce(1, 0));
        refused("a torque was given to a fixed body", () -> wall.addTorque(1));
        refused("a mass was given to a fixed body", () -> wall.setMass(1));
    }

    /** A pin's six numbers are points of bodies, a rod's are of the world: who takes one for the other is told where they are. */
    @Test
    void pointsOfTheWorldThatAreTakenForThoseOfBodies() {
        Body other = engine.add(new Body(new Circle(1)).at(5, 4));
        refused("its points are at (7.0, 8.0) and (9.0, 8.0) in the world",
                () -> engine.add(PinJoint.bodyPoints(body, 4, 4, other, 4, 4)));
    }

    @Test
    void aStepOfZeroChangesNothing() {
        engine.step();
        engine.setTimeStep(0);
        long before = Scenes.hash(engine);
        for (int k = 0; k < 10; k++) {
            engine.step();
        }
        assertThat(Scenes.hash(engine)).isEqualTo(before);
        assertThat(engine.getTime()).isEqualTo(1);
    }

    @Test
    void aStepWithinAStep() {
        engine.addListener(new CollisionListener() {
            private static final long serialVersionUID = 1L;

            @Override
            public void collided(Contact contact) {
                engine.step();
            }
        });
        body.moving(4, 0);
        assertThatIllegalStateException()
                .isThrownBy(() -> {
                    for (int k = 0; k < 5; k++) {
                        engine.step();
                    }
                })
                .withMessageContaining("within its own step");
    }

    @Test
    void aForceOfAGeneratorThatIsNotFiniteIsRefusedWhereItIsGiven() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.add(new Body(new Circle(1)).at(0, 5));
        engine.add(Body.fixed(new Rectangle(50, 1)).at(0, 3.5)); // a step in which they meet did not end
        ForceGenerator endless = (body, time, forces) -> forces.add(body, time > 1.5 ? Double.POSITIVE_INFINITY : 1, 0);
        engine.add(endless);
        engine.step();
        assertThatThrownBy(engine::step)
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith("fx is Infinity: it must be finite; it acts on Body[Circle[radius 1.0] at (0.63")
                .hasMessageNotContaining("without bound");
        engine.remove(endless);
        engine.add((ForceGenerator) (body, time, forces) -> forces.addTorque(body, Double.NaN));
        assertThatThrownBy(engine::step).hasMessageStartingWith("torque is NaN: it must be finite; it acts on Body[");
    }

    /** It was lost, or given to whichever body had the same number. */
    @ParameterizedTest
    @ValueSource(strings = {"another", "fixed", "elsewhere", "nowhere"})
    void aForceOnABodyThatAGeneratorIsNotAskedAboutIsRefused(String which) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.add(new Body(new Circle(1)));
        Body other = which.equals("fixed") ? Body.fixed(new Circle(2)) : new Body(new Circle(2));
        (which.equals("elsewhere") ? new PhysicsEngine() : engine).add(other.at(5, 0));
        ForceGenerator pair = (body, time, forces) -> {
            forces.add(body, 1, 0);
            forces.addAt(body == other || which.equals("nowhere") ? null : other, -1, 0, 5, 0);
        };
        engine.add(pair);
        assertThatThrownBy(engine::step)
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith("a force was added to " + (which.equals("nowhere") ? "null" : "Body[Circle[radius 2.0]"))
                .hasMessageContaining("but the one that is asked about is Body[Circle[radius 1.0]");
        engine.remove(pair);
        engine.step();
    }

    @ParameterizedTest
    @MethodSource("methodsOfFixedStep")
    void aMotionThatGrowsWithoutBoundIsSaidToNeedAShorterStep(Integrator method) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setIntegrator(method);
        engine.setTimeStep(1);
        Body ball = engine.add(new Body(new Circle(1)).at(1, 0));
        engine.add(new Spring(ball, 0, 0, null, 0, 0, 0, 100, 0)); // six periods a step
        assertThatIllegalArgumentException()
                .isThrownBy(() -> {
                    for (int k = 0; k < 1000; k++) {
                        engine.step();
                    }
                })
                .withMessageContaining("it acts on Body[")
                .withMessageContaining("the time step may be too long");
        assertThat(ball.getX()).isFinite();
        assertThat(ball.getVelocityX()).isFinite();
    }

    static Stream<Integrator> methodsOfFixedStep() {
        return Stream.of(new Euler(), new SymplecticEuler(), new RungeKutta4(), new Rattle(2), new Rattle(4), new Rattle(6));
    }

    /** Joints and a spring that couples them to another body, in steps that are much too long. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void jointsInAStepThatIsMuchTooLong(boolean isSymplectic) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setIntegrator(isSymplectic ? new SymplecticEuler() : new Euler());
        Body one = engine.add(new Body(new Circle(1)).at(0, 0).moving(1, 0));
        Body two = engine.add(new Body(new Circle(1)).at(5, 0));
        Body loose = engine.add(new Body(new Circle(1)).at(50, 0).moving(-1, 0));
        engine.add(new RodJoint(one, 0, 0, two, 5, 0));
        engine.add(new RodJoint(two, 5, 0, null, 5, 5));
        engine.add(new Spring(one, 0, 0, loose, 0.5, 0, 2, 1000, 0));
        try {
            for (int k = 0; k < 3; k++) {
                engine.step();
            }
        } catch (ConstraintException e) {
            assertThat(e).hasMessageContaining("the time step may be much too long");
        }
        assertThat(loose.getX()).isFinite();
    }
}
