// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.scenes;

/**
 * A small splittable random number generator with the same numbers on every JVM: SplitMix64 of Steele, Lea and Flood,
 * "Fast splittable pseudorandom number generators" (OOPSLA 2014), with its fixed increment.
 *
 * <p>The scenes do not use {@code java.util.SplittableRandom}, because its Javadoc does not fix the algorithm.
 */
final class SplitMix64 {
    private static final long GOLDEN_GAMMA = 0x9E3779B97F4A7C15L;

    private long state;

    /** Makes a generator; equal seeds give equal numbers. */
    SplitMix64(long seed) {
        state = seed;
    }

    /** The next 64 bits. */
    long nextLong() {
        state += GOLDEN_GAMMA;
        long z = state;
        z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
        z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
        return z ^ (z >>> 31);
    }

    /** Uniform in [0, 1), a multiple of 2^-53. */
    double nextDouble() {
        return (nextLong() >>> 11) * 0x1p-53;
    }

    /** Uniform in [low, high). */
    double between(double low, double high) {
        return low + (high - low) * nextDouble();
    }

    /** Makes a generator of its own stream, so that drawing more numbers there changes none here. */
    SplitMix64 split() {
        return new SplitMix64(nextLong());
    }
}
