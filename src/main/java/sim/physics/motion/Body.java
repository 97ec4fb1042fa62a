// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Objects;
import sim.physics.internal.Check;
import sim.physics.internal.Trig;
import sim.physics.shape.Shape;

/**
 * A rigid body. It has a shape, a mass, and a view of its block of the state vectors.
 *
 * <p>The position of a body is that of its centre of mass, which is the origin of the shape's own coordinates. Angles are in rad,
 * from the x axis to the y axis. Units are your own: nothing in the engine depends on their size. You may subclass Body (an agent
 * that <i>is</i> a body), or let an agent hold one.
 *
 * <p>You may set every property between steps; the next step starts from what was set. A new body has the mass of its area
 * (density 1), restitution 1 and no friction, and collides with everything.
 */
public class Body implements Serializable {
    private static final long serialVersionUID = 3L;

    /** Faster ones have energies that are no numbers, and pass through what is in their way. */
    static final double FASTEST = 1e150;

    private Shape shape;
    private final boolean fixed;

    /** Whether nothing moves the body now. */
    private boolean immobile;

    private State state;
    private int index;

    private double mass;
    private double inertia;
    private Surface surface = Surface.SMOOTH;

    /** Null until the body has some. */
    private Particulars particulars;

    /**
     * Creates a movable body of density 1, at rest at the origin.
     *
     * @param shape shape of the body
     */
    public Body(Shape shape) {
        this(shape, false);
    }

    private Body(Shape shape, boolean fixed) {
        this.shape = Objects.requireNonNull(shape, "shape");
        this.fixed = fixed;
        immobile = fixed;
        this.state = State.own();
        state.add(this);
        if (fixed) {
            mass = Double.POSITIVE_INFINITY;
            inertia = Double.POSITIVE_INFINITY;
        } else {
            setMass(shape.area());
        }
    }

    /**
     * Returns a new body that nothing moves, such as a wall or an anchor.
     *
     * @param shape shape of the body
     * @return a fixed body at the origin
     */
    public static Body fixed(Shape shape) {
        return new Body(shape, true);
    }

    /**
     * Places the body.
     *
     * @param x x of the centre of mass, length
     * @param y y of the centre of mass, length
     * @return this body
     */
    public final Body at(double x, double y) {
        setPosition(x, y);
        return this;
    }

    /**
     * Places and turns the body.
     *
     * @param x x of the centre of mass, length
     * @param y y of the centre of mass, length
     * @param angle orientation, rad
     * @return this body
     */
    public final Body at(double x, double y, double angle) {
        Check.finite("angle", angle);
        setPosition(x, y);
        setAngle(angle);
        return this;
    }

    /**
     * Sets the velocity.
     *
     * @param vx x component of the velocity, length/time
     * @param vy y component of the velocity, length/time
     * @return this body
     */
    public final Body moving(double vx, double vy) {
        setVelocity(vx, vy);
        return this;
    }

    /**
     * Sets the velocity and the angular velocity.
     *
     * @param vx x component of the velocity, length/time
     * @param vy y component of the velocity, length/time
     * @param omega angular velocity, rad/time
     * @return this body
     */
    public final Body moving(double vx, double vy, double omega) {
        speed("angular velocity", omega);
        requireMovable("an angular velocity", omega != 0); // before anything is written
        setVelocity(vx, vy);
        setAngularVelocity(omega);
        return this;
    }

    /**
     * Returns the shape, in coordinates whose origin is the centre of mass. It may be another object than the body was made with:
     * bodies of an engine may share one of several equal shapes.
     *
     * @return never null
     */
    public final Shape getShape() {
        return shape;
    }

    /**
     * Gives the body another shape, about the centre of mass that it has: it grows, shrinks, or breaks. It keeps its mass, place, angle,
     * velocities, joints and springs. The moment of inertia becomes that of a body of uniform density.
     *
     * <p>To keep the density, multiply the mass by the ratio of the areas ({@link #setMass(double)}). A body that overlaps others from
     * then on is one that was put there.
     *
     * @param shape the new shape
     * @throws IllegalArgumentException if the moment of inertia, or its inverse, would be no finite number greater than 0
     */
    public final void setShape(Shape shape) {
        Objects.requireNonNull(shape, "shape");
        if (shape.equals(this.shape) && (!isDynamic() || inertia == mass * shape.unitInertia())) {
            state.requireOpen();
            return;
        }
        if (isDynamic()) {
            setMass(mass, mass * shape.unitInertia());
        }
        state.write(index, false);
        this.shape = shape;
        if (particulars != null) {
            particulars.patch = null;
        }
        state.touched.note(index, Touched.RESHAPED);
        state.placed(index);
    }

    /**
     * Returns whether this body is one that nothing moves.
     *
     * @return true for a body made by {@link #fixed(Shape)}
     */
    public final boolean isFixed() {
        return fixed;
    }

    /** {@return whether nothing moves the body now: it is fixed, or kinematic and has come to a stand} */
    public final boolean isImmobile() {
        return immobile;
    }

    private double place(int c) {
        Glance now = state.glance(index);
        return now == null ? state.x()[State.BLOCK * index + c] : now.x(index, c);
    }

    final double speed(int c) {
        Glance now = state.glance(index);
        return now == null ? state.v()[State.BLOCK * index + c] : now.v(index, c);
    }

    /** Whether what is to be set is so already, and nothing is to be done: what lies on the body, or is tied to it, goes on as it does. */
    private boolean holds(boolean isSame, boolean isVelocity) {
        state.requireOpen();
        boolean isRead = !state.isOpenWithin() || state.isTouched(index) || state.glance(index) != null; // else it may be elsewhere by now
        return isSame && isRead && !state.touched.sticks() && goesOn(isVelocity);
    }

    /** Notes that the body is put elsewhere, or made to move otherwise, and from where. */
    private void set() {
        state.requireOpen();
        state.touch(index);
        if (!state.isOwn()) {
            state.touched.set(index, state.x(), state.v());
        }
    }

    /**
     * Returns the x coordinate of the centre of mass.
     *
     * @return x, length
     */
    public final double getX() {
        return place(State.X);
    }

    /**
     * Returns the y coordinate of the centre of mass.
     *
     * @return y, length
     */
    public final double getY() {
        return place(State.Y);
    }

    /**
     * Returns the orientation. The angle does not wrap: after one turn it is greater by 2π.
     *
     * @return θ, rad
     */
    public final double getAngle() {
        return place(State.THETA);
    }

    /**
     * Returns the x component of the velocity of the centre of mass.
     *
     * @return ẋ, length/time
     */
    public final double getVelocityX() {
        return speed(State.X);
    }

    /**
     * Returns the y component of the velocity of the centre of mass.
     *
     * @return ẏ, length/time
     */
    public final double getVelocityY() {
        return speed(State.Y);
    }

    /**
     * Returns the angular velocity.
     *
     * @return θ̇, rad/time
     */
    public final double getAngularVelocity() {
        return speed(State.THETA);
    }

    /**
     * Returns the x coordinate, in the world, of a point of the body, such as a wheel, a sensor or the tip of an arm.
     *
     * @param px x of the point, in the coordinates of the body
     * @param py y of the point, in the coordinates of the body
     * @return x in world coordinates
     */
    public final double worldX(double px, double py) {
        Check.finite("px", px);
        Check.finite("py", py);
        return getX() + Trig.cos(getAngle()) * px - Trig.sin(getAngle()) * py;
    }

    /**
     * Returns the y coordinate, in the world, of a point of the body.
     *
     * @param px x of the point, in the coordinates of the body
     * @param py y of the point, in the coordinates of the body
     * @return y in world coordinates
     */
    public final double worldY(double px, double py) {
        Check.finite("px", px);
        Check.finite("py", py);
        return getY() + Trig.sin(getAngle()) * px + Trig.cos(getAngle()) * py;
    }

    /**
     * Returns the x coordinate, in those of the body, of a point of the world, such as one that a sensor has seen: positive if it is ahead of the
     * body. It is what {@link #worldX} is the inverse of.
     *
     * @param x x of the point, in world coordinates
     * @param y y of the point, in world coordinates
     * @return x in the coordinates of the body
     */
    public final double localX(double x, double y) {
        Check.finite("x", x);
        Check.finite("y", y);
        return Trig.cos(getAngle()) * (x - getX()) + Trig.sin(getAngle()) * (y - getY());
    }

    /**
     * Returns the y coordinate, in those of the body, of a point of the world.
     *
     * @param x x of the point, in world coordinates
     * @param y y of the point, in world coordinates
     * @return y in the coordinates of the body
     */
    public final double localY(double x, double y) {
        Check.finite("x", x);
        Check.finite("y", y);
        return Trig.cos(getAngle()) * (y - getY()) - Trig.sin(getAngle()) * (x - getX());
    }

    /**
     * Returns the x component of the velocity of a point of the body, such as a keel, a wheel or the tip of an arm: v + ω × r.
     *
     * @param px x of the point, in the coordinates of the body
     * @param py y of the point, in the coordinates of the body
     * @return x component in the world, length/time
     */
    public final double velocityX(double px, double py) {
        return getVelocityX() - getAngularVelocity() * (worldY(px, py) - getY());
    }

    /**
     * Returns the y component of the velocity of a point of the body.
     *
     * @param px x of the point, in the coordinates of the body
     * @param py y of the point, in the coordinates of the body
     * @return y component in the world, length/time
     */
    public final double velocityY(double px, double py) {
        return getVelocityY() + getAngularVelocity() * (worldX(px, py) - getX());
    }

    /**
     * Puts the body in another place. In a running simulation this teleports it: it passes through any body that was on the way,
     * and that body feels nothing of the speed. To push others on its way, use a {@link KinematicBody}, or a movable body on a rail with
     * a motor.
     *
     * @param x x of the centre of mass, length
     * @param y y of the centre of mass, length
     * @throws IllegalArgumentException for NaN or infinity
     */
    public final void setPosition(double x, double y) {
        Check.finite("x", x);
        Check.finite("y", y);
        if (holds(place(State.X) == x && place(State.Y) == y, false)) {
            return;
        }
        set();
        state.x()[State.BLOCK * index + State.X] = x;
        state.x()[State.BLOCK * index + State.Y] = y;
        state.placed(index);
        written(false);
    }

    /**
     * Turns the body to an angle.
     *
     * @param angle θ, rad
     * @throws IllegalArgumentException for NaN or infinity
     */
    public final void setAngle(double angle) {
        Check.finite("angle", angle);
        if (holds(place(State.THETA) == angle, false)) {
            return;
        }
        set();
        state.x()[State.BLOCK * index + State.THETA] = angle;
        state.placed(index);
        written(false);
    }

    /**
     * Sets the velocity of the centre of mass.
     *
     * @param vx x component of the velocity, length/time
     * @param vy y component of the velocity, length/time
     * @throws IllegalArgumentException for NaN or more than 10¹⁵⁰, or if the body is fixed and the velocity is not zero
     */
    public final void setVelocity(double vx, double vy) {
        speed("vx", vx);
        speed("vy", vy);
        requireMovable("a velocity", vx != 0 || vy != 0);
        if (holds(hasSpeed(State.X, vx) && hasSpeed(State.Y, vy), true)) {
            return;
        }
        set();
        state.v()[State.BLOCK * index + State.X] = vx;
        state.v()[State.BLOCK * index + State.Y] = vy;
        written(true);
    }

    /**
     * Sets the angular velocity.
     *
     * @param omega θ̇, rad/time
     * @throws IllegalArgumentException for NaN or more than 10¹⁵⁰, or if the body is fixed and the velocity is not zero
     */
    public final void setAngularVelocity(double omega) {
        speed("angular velocity", omega);
        requireMovable("an angular velocity", omega != 0);
        if (holds(hasSpeed(State.THETA, omega), true)) {
            return;
        }
        set();
        state.v()[State.BLOCK * index + State.THETA] = omega;
        written(true);
    }

    private static double speed(String name, double value) {
        return Check.between(name, value, -FASTEST, FASTEST);
    }

    /**
     * Returns the mass.
     *
     * @return m, infinite for a fixed and for a kinematic body
     */
    public final double getMass() {
        return mass;
    }

    /**
     * Sets the mass. The moment of inertia becomes that of a body of uniform density.
     *
     * @param mass m, greater than 0
     * @throws IllegalArgumentException if the mass is not a finite number greater than 0, or the body is fixed or kinematic
     */
    public final void setMass(double mass) {
        Check.positive("mass", mass);
        setMass(mass, mass * shape.unitInertia());
    }

    /**
     * Sets the mass and the moment of inertia.
     *
     * @param mass m, greater than 0
     * @param inertia moment of inertia I about the centre of mass, mass·length², greater than 0
     * @throws IllegalArgumentException if an argument is not a finite number greater than 0, or the body is fixed or kinematic
     */
    public final void setMass(double mass, double inertia) {
        Check.positive("mass", mass);
        Check.positive("inertia", inertia);
        Check.positive("1 / mass", 1 / mass);
        Check.positive("1 / inertia", 1 / inertia);
        requireDynamic("a mass");
        if (mass == this.mass && inertia == this.inertia) {
            state.requireOpen();
            return;
        }
        weigh(mass, inertia);
        this.mass = mass;
        this.inertia = inertia;
    }

    /** Sets with which masses the body is moved, whatever its author reads. */
    final void weigh(double mass, double inertia) {
        state.write(index, false);
        double[] w = state.w().values();
        w[State.BLOCK * index + State.X] = 1 / mass;
        w[State.BLOCK * index + State.Y] = 1 / mass;
        w[State.BLOCK * index + State.THETA] = 1 / inertia;
    }

    /** Sets whether the body moves no more, with no inverse mass, or moves from now on, with which masses. */
    final void setImmobile(boolean yes, double mass, double inertia) {
        immobile = yes;
        state.write(index, true);
        weigh(yes ? Double.POSITIVE_INFINITY : mass, yes ? Double.POSITIVE_INFINITY : inertia);
        state.touched.note(index, Touched.TURNED);
    }

    /** Lets nothing move the body but its author. */
    final void stiffen() {
        mass = Double.POSITIVE_INFINITY;
        inertia = Double.POSITIVE_INFINITY;
    }

    /**
     * Returns the moment of inertia about the centre of mass.
     *
     * @return I, mass·length², infinite for a fixed and for a kinematic body
     */
    public final double getInertia() {
        return inertia;
    }

    /**
     * Returns the coefficient of restitution, e of (17).
     *
     * @return 0 (plastic) … 1 (elastic)
     */
    public final double getRestitution() {
        return surface.restitution;
    }

    /**
     * Sets the coefficient of restitution.
     *
     * @param restitution e, 0 … 1
     * @throws IllegalArgumentException if e is outside 0 … 1
     */
    public final void setRestitution(double restitution) {
        setSurface(Check.between("restitution", restitution, 0, 1), surface.friction, surface.speed);
    }

    /**
     * Returns the coefficient of friction between this body and bodies that it hits.
     *
     * @return μ
     */
    public final double getFriction() {
        return surface.friction;
    }

    /**
     * Sets the coefficient of friction between this body and bodies that it hits.
     *
     * @param friction μ, not negative
     * @throws IllegalArgumentException if μ is negative or not finite
     */
    public final void setFriction(double friction) {
        setSurface(surface.restitution, Check.notNegative("friction", friction), surface.speed);
    }

    /**
     * Returns the speed at which the body's surface moves along its boundary, as a conveyor belt does.
     *
     * @return speed, counter-clockwise; 0 unless set
     */
    public final double getBeltSpeed() {
        return surface.speed;
    }

    /**
     * Sets the speed at which the body's surface moves along its boundary, relative to the body, as that of a conveyor belt or a
     * track does. Friction drives the bodies that touch it, so they and this body need friction. If this body can move, it gets
     * the opposite force.
     *
     * <p>As seen from the middle of the body, a surface with a positive speed moves to the left. So where y points upwards, a
     * body on top of a belt goes to −x. Where two such surfaces meet, they move past one another at the sum of both speeds, as
     * two surfaces do that run in the same sense. Like friction, the speed may be set at any time.
     *
     * @param speed length/time, counter-clockwise (from the x to the y axis)
     * @throws IllegalArgumentException if the speed is not finite
     */
    public final void setBeltSpeed(double speed) {
        setSurface(surface.restitution, surface.friction, Check.finite("belt speed", speed));
    }

    private void setSurface(double restitution, double friction, double speed) {
        state.requireOpen();
        if (friction != surface.friction || speed != surface.speed) {
            state.stir(index); // what stands still begins to slide, or slides and stops
        }
        surface = state.share(surface.with(restitution, friction, speed, state.lastSurface()));
    }

    /**
     * Returns the kinetic coefficient of friction between this body and the plane below it, see {@link SurfaceFriction}.
     *
     * @return μk
     */
    public final double getSurfaceFriction() {
        return particulars == null ? 0 : particulars.surfaceFriction;
    }

    /**
     * Returns the static coefficient of friction between this body and the plane below it.
     *
     * @return μs, at least μk
     */
    public final double getSurfaceStaticFriction() {
        return particulars == null ? 0 : particulars.surfaceStaticFriction;
    }

    /**
     * Sets both coefficients of friction between this body and the plane below it to one value.
     *
     * @param friction μk = μs, not negative
     * @throws IllegalArgumentException if the value is negative or not finite
     */
    public final void setSurfaceFriction(double friction) {
        setSurfaceFriction(friction, friction);
    }

    /**
     * Sets the coefficients of friction between this body and the plane below it.
     *
     * @param kinetic μk, not negative
     * @param atRest μs, not less than μk
     * @throws IllegalArgumentException if a coefficient is negative or not finite, or μs is less than μk
     */
    public final void setSurfaceFriction(double kinetic, double atRest) {
        Check.notNegative("kinetic surface friction", kinetic);
        Check.notNegative("static surface friction", atRest);
        if (atRest < kinetic) {
            throw new IllegalArgumentException("static surface friction is " + atRest
                    + ": it must not be less than the kinetic one, " + kinetic);
        }
        state.requireOpen();
        if (atRest != getSurfaceStaticFriction() || kinetic != getSurfaceFriction()) {
            state.write(index, false);
            particulars().surfaceFriction = kinetic;
            particulars().surfaceStaticFriction = atRest;
        }
    }

    /**
     * Returns the categories of this body, a set of bits. It is 1 at first.
     *
     * @return categories, bits
     */
    public final long getCategory() {
        return particulars == null ? 1 : particulars.category;
    }

    /**
     * Returns the categories that this body collides with, a set of bits. These are all categories at first.
     *
     * @return categories, bits
     */
    public final long getCollidesWith() {
        return particulars == null ? -1L : particulars.collidesWith;
    }

    /**
     * Sets which bodies this body can collide with. Two bodies collide if each of them has a category that the other one collides
     * with.
     *
     * @param category the categories of this body, bits
     * @param collidesWith the categories that it collides with, bits
     */
    public final void setCollisionGroup(long category, long collidesWith) {
        state.requireOpen();
        if (category != getCategory() || collidesWith != getCollidesWith()) {
            state.write(index, false);
            particulars().category = category;
            particulars().collidesWith = collidesWith;
            state.group();
        }
    }

    /**
     * Applies a force at the centre of mass during the next step. If a listener calls this within a step, the force acts for the
     * rest of that step. Forces add up, and end with the step. Those on a body that is in no engine, with torques, wait for its
     * first step in one: what was applied while it was out of an engine for long acts at once then.
     *
     * @param fx x component of the force
     * @param fy y component of the force
     * @throws IllegalArgumentException if a component is not finite, the body is fixed or kinematic, or the acceleration is beyond ±10¹⁵⁰
     */
    public final void addForce(double fx, double fy) {
        Check.finite("fx", fx);
        Check.finite("fy", fy);
        requireDynamic("a force");
        speed("fx over the mass", fx / mass);
        speed("fy over the mass", fy / mass);
        state.push(index);
        if (fx != 0 || fy != 0) {
            particulars().appliedX += fx;
            particulars().appliedY += fy;
        }
    }

    /**
     * Applies a force at a point during the next step. This is a force at the centre of mass together with the torque r⊥ · f.
     *
     * @param fx x component of the force
     * @param fy y component of the force
     * @param px x of the point, in world coordinates
     * @param py y of the point, in world coordinates
     * @throws IllegalArgumentException if an argument is not finite, the body is fixed or kinematic, or an acceleration is beyond ±10¹⁵⁰
     */
    public final void addForceAt(double fx, double fy, double px, double py) {
        Check.finite("px", px);
        Check.finite("py", py);
        Check.finite("fx", fx);
        Check.finite("fy", fy);
        double torque = Check.finite("torque", (px - getX()) * fy - (py - getY()) * fx);
        requireTorque(torque);
        addForce(fx, fy);
        addTorque(torque);
    }

    /**
     * Applies a torque during the next step.
     *
     * @param torque torque, force·length
     * @throws IllegalArgumentException if the torque is not finite, the body is fixed or kinematic, or the acceleration is beyond ±10¹⁵⁰
     */
    public final void addTorque(double torque) {
        requireTorque(torque);
        state.push(index);
        if (torque != 0) {
            particulars().appliedTorque += torque;
        }
    }

    private void requireTorque(double torque) {
        Check.finite("torque", torque);
        requireDynamic("a torque");
        speed("torque over the moment of inertia", torque / inertia);
    }

    /**
     * Applies an impulse at the centre of mass, which changes the velocity at once: a kick that does not turn the body.
     *
     * @param rx x component of the impulse, mass·length/time
     * @param ry y component of the impulse, mass·length/time
     * @throws IllegalArgumentException if a component is not finite, the body is fixed or kinematic, or a velocity would be beyond ±10¹⁵⁰
     */
    public final void addImpulse(double rx, double ry) {
        Check.finite("rx", rx);
        Check.finite("ry", ry);
        requireDynamic("an impulse");
        setVelocity(getVelocityX() + rx / mass, getVelocityY() + ry / mass);
    }

    /**
     * Applies an angular impulse, which changes the angular velocity at once.
     *
     * @param turn angular impulse, mass·length²/time
     * @throws IllegalArgumentException if it is not finite, the body is fixed or kinematic, or the angular velocity would be beyond ±10¹⁵⁰
     */
    public final void addAngularImpulse(double turn) {
        Check.finite("turn", turn);
        requireDynamic("an impulse");
        setAngularVelocity(getAngularVelocity() + turn / inertia);
    }

    /**
     * Applies an impulse at a point, which changes the velocity at once, as in (18) and (24).
     *
     * @param rx x component of the impulse, mass·length/time
     * @param ry y component of the impulse, mass·length/time
     * @param px x of the point, in world coordinates
     * @param py y of the point, in world coordinates
     * @throws IllegalArgumentException if an argument is not finite, the body is fixed or kinematic, or a velocity would be beyond ±10¹⁵⁰
     */
    public final void addImpulseAt(double rx, double ry, double px, double py) {
        Check.finite("rx", rx);
        Check.finite("ry", ry);
        Check.finite("px", px);
        Check.finite("py", py);
        requireDynamic("an impulse");
        double turn = (px - getX()) * ry - (py - getY()) * rx;
        double omega = speed("angular velocity", getAngularVelocity() + turn / inertia); // (24)
        setVelocity(getVelocityX() + rx / mass, getVelocityY() + ry / mass); // (18)
        setAngularVelocity(omega);
    }

    /**
     * Returns the kinetic energy of this body.
     *
     * @return m v²/2 + I ω²/2; 0 for a fixed or a kinematic body
     */
    public final double kineticEnergy() {
        if (!isDynamic()) {
            return 0;
        }
        double vx = getVelocityX();
        double vy = getVelocityY();
        double omega = getAngularVelocity();
        return 0.5 * (mass * (vx * vx + vy * vy) + inertia * omega * omega);
    }

    /**
     * Returns the state that holds this body's block.
     *
     * @return the engine's state, or the body's own
     */
    public final State state() {
        return state;
    }

    /**
     * Returns the number of this body's block.
     *
     * @return number, from 0
     */
    public final int index() {
        return index;
    }

    /** The state of its own that it has before it comes into another one. */
    final State leaves(State to) {
        if (!state.isOwn() || to.isOwn() && to != state) {
            throw new IllegalStateException("body is " + this + ": it cannot come into "
                    + (to.isOwn() ? "the state of another body alone" : to == state ? "this state, as it is in it already" : "this state from another one"));
        }
        return state;
    }

    /** The number of its block, if that is of a state. */
    final int indexIn(State of) {
        if (state != of || of.isOwn()) {
            throw new IllegalStateException("body is " + this + ": it is not in this state");
        }
        return index;
    }

    final void bind(State newState, int newIndex) {
        state = newState;
        index = newIndex;
        if (particulars != null) {
            particulars.forgetActed();
        }
    }

    /** Takes an equal shape in place of its own, to share it. */
    final void share(Shape equal) {
        shape = equal;
    }

    /** The patch by which this body rubs on the plane below it. */
    final SurfacePatch surfacePatch() {
        if (particulars().patch == null) {
            particulars().patch = SurfacePatch.of(shape);
        }
        return particulars().patch;
    }

    final double appliedX() {
        return particulars == null ? 0 : particulars.appliedX;
    }

    final double appliedY() {
        return particulars == null ? 0 : particulars.appliedY;
    }

    final double appliedTorque() {
        return particulars == null ? 0 : particulars.appliedTorque;
    }

    /** Applies a force and a torque in place of what was applied. */
    final void apply(double fx, double fy, double torque) {
        state.push(index);
        particulars().apply(fx, fy, torque);
    }

    final boolean isPushed() {
        return appliedX() != 0 || appliedY() != 0 || appliedTorque() != 0;
    }

    final void clearApplied() {
        if (particulars != null) {
            particulars.clearApplied();
        }
    }

    /** Applies what was applied for the last step once more, unless something has been applied since; or no longer. */
    final void recallApplied(boolean yes) {
        if (particulars != null && !(yes && state.isOnlyPushed(index))) {
            particulars.recall(yes);
        }
    }

    private Particulars particulars() {
        particulars = particulars == null ? new Particulars() : particulars;
        return particulars;
    }

    /** Puts an equal surface in the place of the body's own. */
    void share(Surface other) {
        surface = other;
    }

    Surface surface() {
        return surface;
    }

    private void requireMovable(String what, boolean changes) {
        if (fixed && changes) {
            throw new IllegalArgumentException(what + " was given to a fixed body: " + this);
        }
    }

    private void requireDynamic(String what) {
        if (!isDynamic()) {
            throw new IllegalArgumentException(what + " was given to a " + (fixed ? "fixed" : "kinematic") + " body: " + this);
        }
    }

    /** {@return whether forces, impulses and joints move this body: it is neither fixed nor kinematic} */
    public final boolean isDynamic() {
        return mass < Double.POSITIVE_INFINITY;
    }

    /** Whether that is a velocity that it has, or is to have. */
    boolean hasSpeed(int c, double value) {
        return speed(c) == value; // only a kinematic body has a course
    }

    /** Whether it goes on as it does if its author puts it where it is, or sets the velocity that it has. */
    boolean goesOn(boolean isVelocity) {
        return true;
    }

    /** The author has put the body elsewhere, or has set its velocity. */
    void written(boolean isVelocity) {
        // as above
    }

    @Override
    public String toString() {
        return getClass().getSimpleName() + "[" + shape + " at (" + getX() + ", " + getY() + "), angle " + getAngle()
                + (fixed ? ", fixed]" : "]");
    }
}
