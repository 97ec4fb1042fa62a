// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

/**
 * Which blocks of a state were placed, filled or emptied: for those who keep an index of where bodies are and must notice
 * when it is out of date. Only the last {@link #LENGTH} blocks are remembered; who has missed some takes it that all have
 * changed. Any number of readers may follow one log.
 */
public final class PlaceLog {
    /** How many blocks are remembered, a power of two. */
    public static final int LENGTH = 64;

    private final int[] blocks = new int[LENGTH];
    private long count;
    private long sweeps;

    PlaceLog() {
        // made by the state, when somebody asks for it first
    }

    void note(int block) {
        blocks[(int) count & LENGTH - 1] = block;
        count++;
    }

    void noteAll() {
        sweeps++;
    }

    /**
     * How many blocks were noted.
     *
     * @return since the log was made
     */
    public long count() {
        return count;
    }

    /**
     * How often all blocks may have changed their places at once, as in a step.
     *
     * @return since the log was made
     */
    public long sweeps() {
        return sweeps;
    }

    /**
     * A block that was noted.
     *
     * @param k number of the note, count() − LENGTH … count() − 1
     * @return the index of the block
     */
    public int block(long k) {
        return blocks[(int) k & LENGTH - 1];
    }
}
