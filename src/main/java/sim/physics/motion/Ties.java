// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import sim.physics.internal.IntList;
import sim.physics.matrix.BlockSparseMatrix;

/** What ties bodies together, as their motion sees it. Bodies that are tied to one another form an <i>island</i>. */
public interface Ties extends Serializable {
    /**
     * Makes one for another thread, which is asked about some islands while this one is asked about others; the islands are
     * the same.
     *
     * @return to be matched before it is asked
     */
    Ties helper();

    /**
     * Takes over what may have changed.
     *
     * @param first where this one comes from by {@link #helper}
     */
    void match(Ties first);

    /**
     * Whether a thread of its own may advance an island: no code of an author has part in it.
     *
     * @param island all bodies of an island
     * @return false if not
     */
    boolean mayBeShared(IntList island);

    /**
     * Whether something ties a body.
     *
     * @param body index
     * @return false for fixed bodies
     */
    boolean isTied(int body);

    /**
     * Whether two bodies are tied to each other so that they do not collide.
     *
     * @param a a body
     * @param b another one
     * @return true if a tie has both
     */
    boolean areTied(Body a, Body b);

    /**
     * The movable bodies that a body is tied to, directly or through others, itself included.
     *
     * @param body index of a tied body
     * @return indices in ascending order; live
     */
    IntList island(int body);

    /**
     * Takes from small changes of places or velocities what the ties do not let pass: what is left when the bodies are
     * brought back onto them.
     *
     * @param bodies all bodies of an island, or of several and others, where accelerations were evaluated last
     * @param change [x, y, θ] per body of the state
     * @return false if nothing brings the bodies back, or nobody knows how; then nothing has changed
     */
    boolean pass(IntList bodies, double[] change);

    /**
     * How far a body goes until a tie has turned its way by about a radian, beside what the bodies turn themselves.
     *
     * @param bodies all bodies of an island, or of several and others, where the state vectors have them
     * @return the least length of those that can be told; infinite if there is none
     */
    double bend(IntList bodies);

    /**
     * Adds what the ties' forces do to the accelerations of some bodies, at the positions and velocities of the state
     * vectors.
     *
     * @param bodies all bodies of an island, or of several and others
     * @param a accelerations that the bodies would have without the ties, [x″, y″, θ″] per body of the state
     * @param counts whether that is an effort: not if somebody asks between steps
     */
    void accelerate(IntList bodies, double[] a, boolean counts);

    /**
     * Takes what the ties of some bodies have cost so far: their equations are solved many times where they depend on one another.
     *
     * @param bodies all bodies of an island, or of several and others
     * @return units of {@link sim.physics.internal.Work} since the last call
     */
    long takeEffort(IntList bodies);

    /**
     * Takes note of the positions and velocities of the state vectors at the start of a step.
     *
     * @param bodies all bodies of an island, or of several and others
     * @param isFree whether no force but that of the ties may act in the step
     */
    void begin(IntList bodies, boolean isFree);

    /**
     * Moves some bodies of the state vectors under a uniform field, exactly, if they are one rigid body that moves freely.
     *
     * @param bodies all bodies of an island, or of several and others
     * @param gx acceleration of the field
     * @param gy acceleration of the field
     * @param h time, of either sign; 0 to ask only
     * @param a gets the accelerations at the start, with those of the ties, [x″, y″, θ″] per body of the state
     * @return false if they are not; then nothing has changed
     */
    boolean fly(IntList bodies, double gx, double gy, double h, double[] a);

    /**
     * Makes a step of RK4 under a uniform field and projects, at once, if there is a quick way to do so.
     *
     * @param bodies all bodies of an island, or of several and others
     * @param gx acceleration of the field
     * @param gy acceleration of the field
     * @param h step, of either sign
     * @return false if there is no such way; then nothing has changed
     */
    boolean advance(IntList bodies, double gx, double gy, double h);

    /**
     * The same under any forces that act on each body by itself.
     *
     * @param bodies all bodies of an island, or of several and others
     * @param loads the forces, evaluated at the stages; what it throws leaves the state vectors at one of them
     * @param areEven whether they are the same over the whole step
     * @param a gets the accelerations at the start, with those of the ties, [x″, y″, θ″] per body of the state
     * @param t simulated time of the start
     * @param h step, of either sign
     * @return false if there is no such way; then nothing has changed
     */
    boolean advance(IntList bodies, Loads loads, boolean areEven, double[] a, double t, double h);

    /**
     * Coordinates in which some bodies move as if nothing tied them.
     *
     * @param bodies all bodies of an island, or of several and others
     * @return those of the state vectors, to be begun; valid until the next call; null if there are none
     */
    TiedCoordinates coordinates(IntList bodies);

    /**
     * Moves some bodies of the state vectors by the least amount, and changes their velocities by the least amount, that
     * the ties ask for.
     *
     * @param bodies all bodies of an island, or of several and others
     * @return false if that is more than a reasonable step would ask for
     */
    boolean project(IntList bodies);

    /**
     * The same, however much that is.
     *
     * @param bodies all bodies of an island, or of several and others
     * @return false if it is not possible from there or gives the bodies more energy than they can have; then it is left to
     *     {@link #creep}, from the start of the step
     * @throws IllegalStateException if there is no way at all, and the pose is none that would explain it
     */
    boolean force(IntList bodies);

    /**
     * What there is to say of bodies that no part of a step is short enough for.
     *
     * @param bodies all bodies of an island, or of several and others
     * @return to be thrown
     */
    IllegalStateException tooLong(IntList bodies);

    /**
     * How often a step of an island may be halved before it is left to {@link #creep}.
     *
     * @param bodies all bodies of an island, or of several and others
     * @param most times as long as {@link #project} has always gone well
     * @param fromRest whether the bodies stood at its start, and it has been halved a few times: near a singular pose more is in vain
     * @return −1 if the last steps were too long however short, so that the next one is left to it at once
     */
    int halvings(IntList bodies, int most, boolean fromRest);

    /**
     * Takes note of evaluations of the accelerations that were made for next to no way. Where there are too many in one step of the
     * engine, near a pose that lets nothing pass, the group is left to {@link #creep} from now on.
     *
     * @param bodies all bodies of an island, or of several and others, where accelerations were asked for last, or near to it
     * @param step number of the engine's step
     * @param evaluations how many
     * @param isTorn whether that was too much for the ties again and again: then rows that seem to follow from others always do not
     * @return how many may be made yet, 0 if it is left to that; {@link Integer#MAX_VALUE} if no such pose is near
     */
    int tire(IntList bodies, double step, int evaluations, boolean isTorn);

    /**
     * Whether such evaluations were made in a step of the engine.
     *
     * @param bodies all bodies of an island, or of several and others
     * @param step number of the engine's step
     * @return false if none were noted
     */
    boolean isTired(IntList bodies, double step);

    /**
     * Advances islands for which steps are too long however short they are: to the nearest place to where they would be
     * without their ties.
     *
     * @param bodies all bodies of an island, or of several and others, which are left where they are, at the start of the step
     * @param h time, of either sign
     * @throws IllegalStateException if there is no way at all, and the pose is none that would explain it
     */
    void creep(IntList bodies, double h);

    /**
     * Brings an island to positions and velocities that its ties allow, however far they are.
     *
     * @param island all bodies of an island, or of several and others
     * @param reach how far it is looked for them
     * @throws IllegalStateException if there are none; then all is as before
     */
    void assemble(IntList island, Reach reach);

    /**
     * Prepares for {@link #reply} and {@link #settle} at the positions of the state vectors.
     *
     * @param island all bodies of an island
     */
    void prepareImpact(IntList island);

    /**
     * The rows of J of an island.
     *
     * @param island all bodies of an island, prepared
     * @return with columns for all bodies of the state; some rows may be empty
     */
    BlockSparseMatrix jacobian(IntList island);

    /**
     * What an impulse on one body does to the velocities of its island, (47)–(54).
     *
     * @param body index of a tied body
     * @param px impulse
     * @param py impulse
     * @param turn angular impulse
     * @param velocities takes the changes in the blocks of the island
     */
    void reply(int body, double px, double py, double turn, double[] velocities);

    /**
     * What impulses on bodies of an island do to the velocities of all of it.
     *
     * @param body index of one of them
     * @param velocities in the blocks of the island: the changes if nothing tied the bodies, and the changes afterwards
     */
    void reply(int body, double[] velocities);

    /**
     * Changes the velocities of the state vectors by the least amount that the ties ask for.
     *
     * @param bodies all bodies of an island, or of several and others, prepared or evaluated for accelerations
     */
    void settle(IntList bodies);

    /**
     * Keeps the rows of J at the positions of the state vectors.
     *
     * @param bodies all bodies of an island, or of several and others
     */
    void hold(IntList bodies);

    /**
     * Moves bodies by W Jᵀ δ, with the rows that were kept, to where the ties want them, and changes their velocities by
     * W Jᵀ δ / h.
     *
     * @param bodies all bodies of an island, or of several and others
     * @param h step
     */
    void close(IntList bodies, double h);

    /**
     * The ties of an island that act at some times only, motors and stops.
     *
     * @param island all bodies of an island
     * @return live; empty if all ties act always
     */
    SwitchedTies switched(IntList island);

    /**
     * Whether a group has such ties which decide by themselves when they act.
     *
     * @param bodies all bodies of an island, or of several and others
     * @return false if all ties act always, or push with forces that were found elsewhere
     */
    boolean isSwitched(IntList bodies);

    /**
     * Whether a group's ties depend on its state alone, act always, and are kept by {@link #project}, so that a step may be
     * followed piece by piece.
     *
     * @param bodies all bodies of an island, or of several and others
     * @return false if an author's code has part in them
     */
    boolean isAutonomous(IntList bodies);

    /**
     * Decides which of the ties of {@link #isSwitched} act from now on, and gives the bodies the velocities that those
     * ask for.
     *
     * @param bodies all bodies of an island, or of several and others
     * @param time the engine's step: what does not leave a stop in it is at rest there
     * @return whether velocities may have changed
     */
    boolean decide(IntList bodies, double time);

    /**
     * Lets ties that were overloaded in the last evaluation of accelerations act no longer, and notes which of the others are
     * within reach; or lets those act that are.
     *
     * @param bodies all bodies of an island, or of several and others
     * @param hold true for the latter
     */
    void confirm(IntList bodies, boolean hold);

    /**
     * Changes one of the ties that act, or act no longer, against what their forces and the accelerations ask for.
     *
     * @param bodies all bodies of an island, or of several and others
     * @param a accelerations, as just found
     * @return false if there is none, and nothing has changed
     */
    boolean reconsider(IntList bodies, double[] a);

    /**
     * A value that turns negative when it must be decided anew which ties act, in units of what counts as reached.
     *
     * @param bodies all bodies of an island, or of several and others
     * @param near whether to watch the ties that were within reach when it was last settled which act, or the others
     * @return infinite if there is nothing to watch
     */
    double watch(IntList bodies, boolean near);

    /**
     * The time until a stop is reached at the speeds of now, for the ties of {@link #watch}.
     *
     * @param bodies all bodies of an island, or of several and others, just watched
     * @param near which ties
     * @param a accelerations there, null if they are not known
     * @param seen takes what was watched of each tie
     * @return the least; negative where a stop has been passed, NaN if that cannot be said
     */
    double toGo(IntList bodies, boolean near, double[] a, Watched seen);

    /**
     * An estimate of how long the ties that push will do so, at the accelerations that they cause.
     *
     * @param bodies all bodies of an island, or of several and others
     * @param a accelerations, as just found
     * @return infinite if nothing pushes
     */
    double push(IntList bodies, double[] a);

    /**
     * Sets whether the forces of ties that act at some times only are kept within their bounds.
     *
     * @param bodies all bodies of an island, or of several and others
     * @param yes false to see what forces would be without
     * @return whether one of those that act has been out of its bounds since this was last called
     */
    boolean limit(IntList bodies, boolean yes);

    /**
     * By how much the forces of such ties, as the last accelerations need them, are within their bounds.
     *
     * @param bodies all bodies of an island, or of several and others
     * @return the least, in units of what counts as reached; infinite if none acts, negative if one is beyond
     */
    double spare(IntList bodies);

    /**
     * Other ties of the same bodies by the same constraints, with a workspace of their own.
     *
     * @return solved by elimination and kept by projection, whatever these are
     */
    Ties twin();

    /**
     * Says whether a twin is out of date.
     *
     * @return another number than before if constraints, or what they hold in the world, have changed
     */
    long version();

    /**
     * Says whether bodies have been tied or untied.
     *
     * @return another number than before if islands were formed anew
     */
    long grouping();

    /**
     * Copies what the ties of {@link #isSwitched} remember.
     *
     * @param bodies all bodies of an island, or of several and others
     * @param kept takes it, or has it
     * @param restore whether to take it from there
     * @return the same array, or a larger one
     */
    double[] switches(IntList bodies, double[] kept, boolean restore);
}
