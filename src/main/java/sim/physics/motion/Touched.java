// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Growth;

/** Which blocks of a {@link State} their bodies' setters have written since the last step, in the order of writing. */
public final class Touched implements Serializable {
    private static final long serialVersionUID = 1L;

    /** After how many steps in which no body was written the room to note them is given back. */
    private static final int QUIET = 100;

    /** Bits: a force was applied at least; anything was written; where it is or how it moves may be another; TURNED is below. */
    private static final byte PUSHED = 1;

    /** Values kept of a block that was set. */
    private static final int KEPT = 2 * State.BLOCK;

    private static final byte WRITTEN = 2;
    static final byte MOVED = 4;

    /** Nothing moves the body any more, or something does again; or it has another shape. */
    static final byte TURNED = 8;

    static final byte RESHAPED = 16;

    /** It was put elsewhere, or made to move otherwise, and it is known from where. */
    private static final byte SET = 32;

    private int[] list = {};
    private byte[] how;
    private int count;
    private int quiet;

    /** Blocks that were set, and their places and velocities before. */
    private int[] set = {};

    private double[] before = {};
    private int setCount;

    /** By block: which of these it is, if it is one. */
    private int[] placing = {};

    /** Whether anything has been told to stick: what it does is decided anew where it is set, also to what it is. */
    private boolean sticks;

    /** Those that were kept. */
    private transient Touched kept;

    /** How often something was noted in all. */
    transient long writes;

    /** Null until somebody follows it, so that a scene which nobody asks about pays nothing. */
    private transient PlaceLog places;

    Touched(int capacity) {
        how = new byte[capacity];
    }

    /** Makes room for bodies, or gives it back. */
    void resize(int capacity) {
        how = Arrays.copyOf(how, capacity);
    }

    boolean has(int index) {
        return how[index] != 0;
    }

    boolean isOnlyPushed(int index) {
        return how[index] == PUSHED;
    }

    /**
     * {@return whether a body may be elsewhere, or move otherwise: not only its properties are written}
     *
     * @param index the block
     */
    public boolean isMoved(int index) {
        return (how[index] & (MOVED | SET)) != 0;
    }

    /**
     * {@return whether what ties a body may be another, too, so that it matters not where it was}
     *
     * @param index the block
     */
    public boolean isRetied(int index) {
        return (how[index] & MOVED) != 0;
    }

    /**
     * {@return whether a kinematic body has begun to move, or has come to a stand, or a body has another shape}
     *
     * @param index the block
     */
    public boolean isTurned(int index) {
        return (how[index] & (TURNED | RESHAPED)) != 0;
    }

    /**
     * {@return whether a body has another shape}
     *
     * @param index the block
     */
    public boolean isReshaped(int index) {
        return (how[index] & RESHAPED) != 0;
    }

    /**
     * Notes that a block that has been noted is to be brought elsewhere, or to move otherwise.
     *
     * @param index the block
     */
    public void move(int index) {
        note(index, MOVED);
    }

    /** Notes more of a block that has been noted. */
    void note(int index, int change) {
        how[index] |= (byte) change;
    }

    /** Notes that a block that has been noted is set, before that is done. */
    void set(int index, double[] x, double[] v) {
        if ((how[index] & SET) == 0) {
            if (setCount == set.length) {
                set = Arrays.copyOf(set, Growth.length(setCount, 4));
                before = Arrays.copyOf(before, KEPT * set.length);
            }
            System.arraycopy(x, State.BLOCK * index, before, KEPT * setCount, State.BLOCK);
            System.arraycopy(v, State.BLOCK * index, before, KEPT * setCount + State.BLOCK, State.BLOCK);
            placing = placing.length < how.length ? Arrays.copyOf(placing, how.length) : placing;
            placing[index] = setCount;
            set[setCount++] = index;
            note(index, SET);
        }
    }

    /** Takes note that something is told to stick, in the middle of a step. */
    public void stick() {
        sticks = true;
    }

    boolean sticks() {
        return sticks;
    }

    /** Forgets where blocks were that have been set: all that ties them is to be closed. */
    public void forgetBefore() {
        for (int k = 0; k < setCount; k++) {
            move(set[k]);
        }
    }

    /**
     * {@return a place, or a velocity, that a block had before it was set; that of now if it was not}
     *
     * @param index the block
     * @param c the coordinate
     * @param now places or velocities
     * @param isVelocity which of the two
     */
    public double before(int index, int c, double[] now, boolean isVelocity) {
        int k = index < placing.length ? placing[index] : setCount;
        boolean is = k < setCount && set[k] == index;
        return is ? before[KEPT * k + (isVelocity ? State.BLOCK + c : c)] : now[State.BLOCK * index + c];
    }

    int count() {
        return count;
    }

    int get(int k) {
        return list[k];
    }

    /** Brings them into the order of blocks, so that in what order they were written does not matter. */
    public void sort() {
        for (int k = 1; k < count; k++) {
            if (list[k] < list[k - 1]) {
                Arrays.sort(list, 0, count);
                return;
            }
        }
    }

    /** Notes that a block is written, or that a force is applied only. */
    void note(int index, boolean isForce) {
        writes++;
        if (how[index] == 0) {
            if (count == list.length) {
                list = Arrays.copyOf(list, Math.max(4, Math.min(Growth.length(count, 4), how.length)));
            }
            list[count++] = index;
            how[index] = PUSHED;
        }
        note(index, isForce ? 0 : WRITTEN);
    }

    PlaceLog places() {
        places = places == null ? new PlaceLog() : places;
        return places;
    }

    /** Notes that a position is written, between steps. */
    void place(int index) {
        writes++;
        if (places != null) {
            places.note(index);
        }
    }

    /** Notes that any positions may be written, between steps. */
    void placeAll() {
        writes++;
        if (places != null) {
            places.noteAll();
        }
    }

    /** Keeps the notes of the moment. */
    void keep() {
        kept = kept == null ? new Touched(0) : kept;
        kept.take(this);
    }

    /** Puts those back that were kept. */
    void putBack() {
        take(kept);
    }

    private void take(Touched other) {
        count = other.count;
        list = list.length < count ? Arrays.copyOf(other.list, count) : list;
        System.arraycopy(other.list, 0, list, 0, count);
        how = how.length == other.how.length ? how : new byte[other.how.length];
        System.arraycopy(other.how, 0, how, 0, how.length);
        quiet = other.quiet;
        setCount = other.setCount;
        set = set.length < setCount ? new int[setCount] : set;
        before = before.length < KEPT * setCount ? new double[KEPT * set.length] : before;
        System.arraycopy(other.set, 0, set, 0, setCount);
        placing = other.placing.clone();
        System.arraycopy(other.before, 0, before, 0, KEPT * setCount);
        writes++;
    }

    /** Forgets them. */
    void clear() {
        quiet = count == 0 ? quiet + 1 : 0;
        if (quiet == QUIET && list.length > State.LARGE) {
            list = new int[State.LARGE]; // all bodies are written before the first step, and seldom ever after
        }
        for (int k = 0; k < count; k++) {
            how[list[k]] = 0;
        }
        count = 0;
        setCount = 0;
        if (set.length > State.LARGE) {
            set = new int[0];
            before = new double[0];
            placing = new int[0];
        }
    }
}
