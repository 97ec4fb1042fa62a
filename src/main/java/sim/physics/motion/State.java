// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Growth;
import sim.physics.matrix.DiagonalMatrix;

/**
 * The state of all bodies in shared vectors, as the write-up's chapter <i>State Representation</i> has it.
 *
 * <pre>
 *   body            0             1             2
 *   block      +---+---+-----+---+---+-----+---+---+-----+
 *   x          | x | y |  θ  | x | y |  θ  | x | y |  θ  | ...   length, length, rad
 *   v          | x'| y'|  θ' | x'| y'|  θ' |                     length/time, length/time, rad/time
 *   f          | fx| fy|  τ  |                                   force, force, torque
 *   w          |1/m|1/m| 1/I |                                   the diagonal of W
 *              +---+---+-----+
 * </pre>
 *
 * <p>A body that is not part of an engine owns a state of one block; {@code PhysicsEngine.add} copies the block into the engine's
 * state and {@code remove} copies it back, so a {@link Body} is always a view on exactly one block. A block that a removed body leaves
 * is empty (all zero, no body) until the next body takes it. What nothing moves has W = 0.
 *
 * <p>The vectors hold the values at the end of the last step. Inside a step the engine works on {@link Trajectories} and writes the
 * vectors when the step ends, or when they are asked for after it.
 */
public final class State implements Serializable {
    private static final long serialVersionUID = 2L;

    /** Offset of the x coordinate in a block. */
    public static final int X = 0;
    /** Offset of the y coordinate in a block. */
    public static final int Y = 1;
    /** Offset of the orientation in a block. */
    public static final int THETA = 2;
    /** Length of a block. */
    public static final int BLOCK = 3;

    /** Bodies for whose number room is not given back. */
    static final int LARGE = 1024;

    /** Positions and orientations, 3n. */
    private double[] x;
    /** Velocities and angular velocities, 3n. */
    private double[] v;
    /** Forces and torques of the present evaluation, 3n; empty until somebody asks. */
    private double[] f = {};
    /** Inverse masses and moments of inertia, 3n. */
    private DiagonalMatrix w;

    private Body[] bodies;
    private int size;
    /** Empty blocks below {@code size}, a stack. */
    private int[] free = {};
    private int freeCount;
    final Touched touched;
    /** Null but while listeners are called. */
    private Presence presence;
    /** Null but in such a call. */
    private transient Glance glance;
    /** Whether a step is being made. */
    private transient boolean stepping;

    private Surface surface = Surface.SMOOTH;
    /** Whether bodies have had different surfaces; else nobody need look at the views for them. */
    private boolean mixed;
    /** Null before the first body. */
    private transient RecentShapes shapes;
    /** Whether a body ever had a collision group. */
    private boolean grouped;
    /** Null unless a method asks for it. */
    private Carry carry;
    /** Whether positions change without notice, as they do within a step. */
    private transient boolean unsettled;
    /** Whether the vectors are to be written, and by whom, when somebody asks for them. */
    private boolean lagging;
    private Trajectories motions;
    /** Whether this is the state of one body that belongs to no engine. */
    private final boolean own;

    /** Makes an empty state. */
    public State() {
        this(8, false);
    }

    /** {@return the state of a body of its own, empty, for one block} */
    static State own() {
        return new State(1, true);
    }

    private State(int capacity, boolean own) {
        this.own = own;
        x = new double[BLOCK * capacity];
        v = new double[BLOCK * capacity];
        w = new DiagonalMatrix(BLOCK * capacity);
        bodies = new Body[capacity];
        touched = new Touched(capacity);
    }

    /**
     * The position vector x itself, not a copy; longer than {@code BLOCK * size()}. Who writes it between steps must call
     * {@link #placed(int)} or {@link #placedAll()}. To be asked for anew after each step.
     *
     * @return x, [x, y, θ] per body, length and rad
     */
    public double[] x() {
        if (lagging) {
            settle(true);
        }
        return x;
    }

    /** {@return the velocity vector ẋ itself, not a copy, [x', y', θ'] per body, length/time and rad/time; as {@link #x()}} */
    public double[] v() {
        if (lagging) {
            settle(true);
        }
        return v;
    }

    /**
     * Lets the vectors be written when they are asked for.
     *
     * @param those where all bodies are at the end of the step that is over
     */
    public void lag(Trajectories those) {
        if (motions != those) { // a reference that is written costs more than one that is compared
            motions = those;
        }
        lagging = true;
    }

    /**
     * Ends that: writes the vectors, or leaves them as they are.
     *
     * @param isAsked false if nobody asks before they are written again
     */
    public void settle(boolean isAsked) {
        boolean is = lagging && isAsked;
        lagging = false;
        if (is) {
            motions.publish(motions.h(), this);
        }
    }

    /** {@return the force vector F itself, [fx, fy, τ] per body, scratch of the evaluation of forces: nothing outlasts a growth} */
    public double[] f() {
        f = f.length < x.length ? Arrays.copyOf(f, x.length) : f;
        return f;
    }

    /** {@return the mass inverse matrix W, diagonal [1/m, 1/m, 1/I] per body, zero for a fixed body} */
    public DiagonalMatrix w() {
        return w;
    }

    /** {@return what rounding has left of the vectors; null until a method asks for it} */
    public Carry carry() {
        return carry;
    }

    /** The same, made if there is none. */
    Carry ensureCarry() {
        carry = carry == null ? new Carry() : carry;
        return carry;
    }

    /** {@return whether this state holds one body that belongs to no engine} */
    public boolean isOwn() {
        return own;
    }

    /** {@return number of blocks, empty ones included} */
    public int size() {
        return size;
    }

    /** {@return number of bodies} */
    public int bodyCount() {
        return size - freeCount;
    }

    /**
     * {@return the body of a block, or null if it is empty}
     *
     * @param index block number, 0 … size() − 1
     */
    public Body body(int index) {
        return bodies[index];
    }

    /**
     * Takes a block for a body and copies the body's values into it. To put a body into an engine, call the engine's {@code add}.
     *
     * @param body a body that has a state of its own
     * @return the index of its block
     * @throws IllegalStateException if the body is in a state already, or this state is that of another body alone
     */
    public int add(Body body) {
        State old = body.leaves(this);
        settle(true); // while the bodies are those of the last step
        int index = freeCount > 0 ? free[--freeCount] : size++;
        if (index >= bodies.length) {
            grow(Math.max(8, Growth.length(index, index + 1)));
        }
        int from = BLOCK * body.index();
        System.arraycopy(old.x, from, x, BLOCK * index, BLOCK);
        System.arraycopy(old.v, from, v, BLOCK * index, BLOCK);
        System.arraycopy(old.w.values(), from, w.values(), BLOCK * index, BLOCK);
        bodies[index] = body;
        body.bind(this, index);
        if (!own) {
            share(body);
            grouped |= old.grouped;
        }
        touch(index);
        placed(index);
        return index;
    }

    /** The surface that was set last: bodies made alike come one after the other. */
    Surface lastSurface() {
        return surface;
    }

    /** Notes that surface. */
    Surface share(Surface last) {
        mixed |= last != surface && bodyCount() > 1;
        surface = last;
        return last;
    }

    /**
     * {@return the coefficient of restitution of a body, 0 … 1}
     *
     * @param index the block
     */
    public double restitution(int index) {
        return mixed ? bodies[index].getRestitution() : surface.restitution;
    }

    /**
     * {@return whether forces have been applied to a body for the next step}
     *
     * @param index the block
     */
    public boolean isPushed(int index) {
        return bodies[index].isPushed();
    }

    /**
     * {@return the coefficient of friction of a body, not negative}
     *
     * @param index the block
     */
    public double friction(int index) {
        return mixed ? bodies[index].getFriction() : surface.friction;
    }

    /**
     * {@return how fast the surface of a body moves along its boundary, counter-clockwise}
     *
     * @param index the block
     */
    public double beltSpeed(int index) {
        return mixed ? bodies[index].getBeltSpeed() : surface.speed;
    }

    private void share(Body body) {
        Surface own = body.surface();
        body.share(share(surface.with(own.restitution, own.friction, own.speed, own)));
        shapes = shapes == null ? new RecentShapes() : shapes;
        body.share(shapes.share(body.getShape()));
    }

    /**
     * Gives a body a state of its own again and empties its block. To take a body out of an engine, call the engine's {@code remove}.
     *
     * @param body a body of this state
     * @throws IllegalStateException if the body is not in this state
     */
    public void remove(Body body) {
        int index = body.indexIn(this);
        State own = own();
        own.grouped = grouped;
        own.size = 1;
        own.bodies[0] = body;
        own.surface = body.surface();
        int from = BLOCK * index;
        System.arraycopy(x(), from, own.x, 0, BLOCK);
        System.arraycopy(v, from, own.v, 0, BLOCK);
        System.arraycopy(w.values(), from, own.w.values(), 0, BLOCK);
        body.bind(own, 0);
        for (double[] vector : new double[][] {x, v, f.length > from ? f : x, w.values()}) {
            Arrays.fill(vector, from, from + BLOCK, 0);
        }
        bodies[index] = null;
        placed(index);
        free = freeCount < free.length ? free : Arrays.copyOf(free, Math.max(4, 2 * freeCount));
        free[freeCount++] = index;
    }

    /**
     * Sets who brings bodies to the present instant before they are written.
     *
     * @param presence null between steps, when the vectors hold where all bodies are, and but for calls of listeners within them
     * @param isStepping whether a step is being made
     */
    public void setPresence(Presence presence, boolean isStepping) {
        this.presence = presence;
        stepping = isStepping;
    }

    /**
     * Begins or ends a call of a listener, who may read where bodies are.
     *
     * @param glance null when the call is over
     */
    public void setGlance(Glance glance) {
        this.glance = glance;
    }

    /** {@return who says where a body is; null if the vectors do} */
    Glance glance(int index) {
        return glance == null || touched.has(index) ? null : glance;
    }

    /** {@return whether a step is being made, and a listener is called that may write} */
    public boolean isOpenWithin() {
        return presence != null;
    }

    /** Refuses what authors want to change while a step is being made, unless they are called to listen. */
    public void requireOpen() {
        if (stepping && presence == null) {
            throw new IllegalStateException(
                    "a force, a constraint or a curve has changed something in a step: only listeners may, and agents between steps");
        }
    }

    /**
     * Notes that what forces do to a body may change, though all of its block stays: a surface, say. Brings it to the present first.
     *
     * @param index the block
     */
    public void stir(int index) {
        if (presence != null && !touched.has(index)) {
            presence.bring(index);
        }
        touched.note(index, true);
    }

    /**
     * Notes that a body is written by its author.
     *
     * @param index the block
     * @param moves whether it may be elsewhere then, or move otherwise: not for its other properties
     */
    public void write(int index, boolean moves) {
        requireOpen();
        touch(index);
        touched.note(index, moves ? Touched.MOVED : 0);
    }

    /**
     * Notes that a body is about to be written by its setters; brings it to the present instant first.
     *
     * @param index the block
     */
    public void touch(int index) {
        if (presence != null && !touched.has(index)) {
            presence.bring(index);
        }
        touched.note(index, false);
    }

    /**
     * Notes that forces are about to be applied to a body for the next step; within a step that is like any writing.
     *
     * @param index the block
     */
    void push(int index) {
        requireOpen();
        if (presence != null) {
            touch(index);
        } else {
            touched.note(index, true);
        }
    }

    /**
     * {@return whether forces on a body are others, by what was applied between steps or by {@link #stir}, and nothing was written}
     *
     * @param index the block
     */
    public boolean isOnlyPushed(int index) {
        return touched.isOnlyPushed(index);
    }

    /**
     * {@return whether {@link #touch(int)} was called for a body since the last call of {@link #clearTouched()}}
     *
     * @param index the block
     */
    public boolean isTouched(int index) {
        return touched.has(index);
    }

    /** {@return which blocks were written since then, and how} */
    public Touched touched() {
        return touched;
    }

    /** {@return how many blocks were written by their bodies' setters since the last call of {@link #clearTouched()}} */
    public int touchedCount() {
        return touched.count();
    }

    /** {@return how often blocks were written or pushed in all} */
    public long writes() {
        return touched.writes;
    }

    /**
     * {@return the index of a block that was written, which may have been emptied since}
     *
     * @param k 0 … touchedCount() − 1
     */
    public int touched(int k) {
        return touched.get(k);
    }

    /** Gives back the room for more bodies: called once, when the bodies of a scene are complete, it seems. */
    public void trim() {
        if (size < bodies.length && size > LARGE) {
            grow(size);
        }
    }

    /** Forgets which blocks were written. */
    public void clearTouched() {
        touched.clear();
    }

    /** {@return what tells which blocks were placed: notes from the first call on, one for all callers} */
    public PlaceLog placeLog() {
        return touched.places();
    }

    /**
     * Notes that a block's position is written, between steps.
     *
     * @param index the block
     */
    public void placed(int index) {
        touched.place(index);
    }

    /** Notes that any positions may be written, between steps. */
    public void placedAll() {
        touched.placeAll();
    }

    /** Notes that a step begins, or ends, within which positions change without notice. */
    void setUnsettled(boolean unsettled) {
        this.unsettled = unsettled;
        placedAll();
    }

    /** Notes that a body has a collision group. */
    void group() {
        grouped = true;
    }

    /** {@return whether a body may have a collision group of its own} */
    public boolean isGrouped() {
        return grouped;
    }

    /** {@return whether positions may change without notice: within a step, and after one that failed until the next is over} */
    public boolean isUnsettled() {
        return unsettled;
    }

    private void grow(int capacity) {
        x = Arrays.copyOf(x, BLOCK * capacity);
        v = Arrays.copyOf(v, BLOCK * capacity);
        f = f.length == 0 ? f : Arrays.copyOf(f, BLOCK * capacity);
        DiagonalMatrix larger = new DiagonalMatrix(BLOCK * capacity);
        System.arraycopy(w.values(), 0, larger.values(), 0, Math.min(w.rows(), larger.rows()));
        w = larger;
        bodies = Arrays.copyOf(bodies, capacity);
        touched.resize(capacity);
    }
}
