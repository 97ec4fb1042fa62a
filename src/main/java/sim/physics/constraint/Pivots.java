// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;

/**
 * What the small pivots of a factorization say: which rows depend on others, and how near the pose is to one in which they
 * do. A pivot is small or not as a part of its diagonal value, which is as φ² where φ is the distance from such a pose.
 */
final class Pivots implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Pivots below this are noise. */
    static final double NOISE = 1e-14;

    /** Pivots below this are known to few digits only, if they are not redundant. */
    private static final double NEAR = 1e-6;

    /** Pivots below this are those of a pose that is within sight of a singular one. */
    private static final double WEAK = 1e-3;

    /** The same of a pose near enough for what stages deviate from the constraints to be felt. */
    private static final double BESIDE = 1e-2;

    /** The diagonal values before the elimination. */
    final double[] size;

    /** The rows that depended on others in the last factorization; and those that do so always, null if none are known. */
    private final boolean[] isRedundant;

    private boolean[] isLasting;
    private int lasting;

    /** The diagonal values of the rows that are always redundant. */
    private double[] whole = {};

    private int redundant;
    private int near;
    private int weak;
    private int beside;
    private int strays;
    private double noise;

    /** What rows get of what they ask for, by their pivots, or those of the same rows with other masses; null if all of it. */
    private double[] shares;

    private double half;
    private Pivots judge;

    Pivots(int rows) {
        size = new double[rows];
        isRedundant = new boolean[rows];
    }

    /**
     * A factorization begins.
     *
     * @param least pivots below this part of their diagonal are redundant
     * @return pivots not above this part of theirs are to be asked about here
     */
    double start(double least) {
        noise = least;
        if (redundant > 0) {
            Arrays.fill(isRedundant, false);
        }
        redundant = 0;
        near = 0;
        weak = 0;
        beside = 0;
        strays = 0;
        return judge == null ? Math.max(least, BESIDE) : Double.POSITIVE_INFINITY;
    }

    /** Makes the pivots of rows that are always redundant small, whatever they are. */
    void setAside() {
        for (int k = 0; lasting > 0 && k < isLasting.length; k++) {
            if (isLasting[k]) {
                whole[k] = size[k];
                size[k] = Double.POSITIVE_INFINITY;
            }
        }
    }

    /**
     * Takes note of what rows are to get of what they ask for: next to nothing, if they depend on others, and nearly all otherwise.
     *
     * @param part rows with a pivot of this part of their diagonal get half
     */
    void judge(double part) {
        half = part;
        shares = shares == null ? new double[size.length] : shares;
        Arrays.fill(shares, 1);
    }

    /** Gives rows the shares that others have noted, as what follows was found with them; all of it if these are null. */
    void obey(Pivots others) {
        judge = others;
    }

    /** The inverse of a small pivot; 0 if it is redundant. */
    double invert(double pivot, int k) {
        double share = 1;
        if (half > 0) {
            double part = pivot / size[k];
            share = part > NOISE ? part * part / (part * part + half * half) : 0;
            shares[k] = share;
        } else if (judge != null) {
            share = judge.shares[k];
        }
        if (!(pivot > Math.max(noise, BESIDE) * size[k])) {
            beside++;
        }
        if (!(pivot > Math.max(noise, WEAK) * size[k])) {
            weak++;
        }
        if (!(pivot > Math.max(noise, NEAR) * size[k])) {
            near++;
        }
        if (pivot > noise * size[k]) {
            return share / pivot;
        }
        if (lasting > 0 && size[k] == Double.POSITIVE_INFINITY && pivot > NEAR * whole[k]) {
            strays++;
        }
        redundant++;
        isRedundant[k] = true;
        return 0;
    }

    /** Number of rows that depend on others. */
    int redundant() {
        return redundant;
    }

    /** Number of pivots that are redundant or nearly so. */
    int near() {
        return near;
    }

    /** Whether some pivot is redundant, or within sight of being so. */
    boolean isWeak() {
        return weak > 0;
    }

    /** Whether some that is not so always is. */
    boolean isWeakHere() {
        return weak > lasting;
    }

    /** Whether some pivot that is not redundant always is so, or on the way to being so. */
    boolean isBeside() {
        return beside > lasting;
    }

    /** Number of rows that are known to depend on others always. */
    int lasting() {
        return lasting;
    }

    /** Number of those that did not depend on others in the last factorization. */
    int strays() {
        return strays;
    }

    boolean isLasting(int k) {
        return lasting > 0 && isLasting[k];
    }

    /** Notes that the rows that are redundant now are so always, and need no multiplier: the others imply them. */
    void keepRedundant() {
        isLasting = isRedundant.clone();
        whole = new double[isLasting.length];
        lasting = redundant;
    }

    /** Forgets which rows are always redundant. */
    void forgetRedundant() {
        isLasting = null;
        lasting = 0;
    }
}
