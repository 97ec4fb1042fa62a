// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.IntList;

/**
 * The explicit method of Dormand and Prince of order 8, whose steps are chosen by embedded formulas of orders 5 and 3. This is
 * the code DOP853 of Hairer, Nørsett and Wanner, <i>Solving Ordinary Differential Equations I</i>, 2nd edition, II.5 and II.10.
 * Use it for 5 to 10 correct digits where the forces are smooth.
 *
 * <p>The positions of a stage are found from the accelerations alone: with velocities v0 + h Σ aᵢⱼ ẍⱼ they are x0 + h (cᵢ v0 + h
 * Σ āᵢⱼ ẍⱼ), where Ā = A A.
 */
public final class DormandPrince853 extends AdaptiveIntegrator {
    private static final long serialVersionUID = 1L;

    static final int STAGES = 12;

    // spotless:off
    private static final double[] NODE = {
        0.0, 0.526001519587677318785587544488e-01, 0.789002279381515978178381316732e-01,
        0.118350341907227396726757197510, 0.281649658092772603273242802490, 0.333333333333333333333333333333,
        0.25, 0.307692307692307692307692307692, 0.651282051282051282051282051282,
        0.6, 0.857142857142857142857142857142, 1.0
    };

    private static final double[][] STAGE = {
        {},
        {5.26001519587677318785587544488e-2},
        {1.97250569845378994544595329183e-2, 5.91751709536136983633785987549e-2},
        {2.95875854768068491816892993775e-2, 0, 8.87627564304205475450678981324e-2},
        {
            2.41365134159266685502369798665e-1, 0, -8.84549479328286085344864962717e-1,
            9.24834003261792003115737966543e-1
        },
        {
            3.7037037037037037037037037037e-2, 0, 0, 1.70828608729473871279604482173e-1,
            1.25467687566822425016691814123e-1
        },
        {
            3.7109375e-2, 0, 0, 1.70252211019544039314978060272e-1, 6.02165389804559606850219397283e-2,
            -1.7578125e-2
        },
        {
            3.70920001185047927108779319836e-2, 0, 0, 1.70383925712239993810214054705e-1,
            1.07262030446373284651809199168e-1, -1.53194377486244017527936158236e-2,
            8.27378916381402288758473766002e-3
        },
        {
            6.24110958716075717114429577812e-1, 0, 0, -3.36089262944694129406857109825,
            -8.68219346841726006818189891453e-1, 2.75920996994467083049415600797e1,
            2.01540675504778934086186788979e1, -4.34898841810699588477366255144e1
        },
        {
            4.77662536438264365890433908527e-1, 0, 0, -2.48811461997166764192642586468,
            -5.90290826836842996371446475743e-1, 2.12300514481811942347288949897e1,
            1.52792336328824235832596922938e1, -3.32882109689848629194453265587e1,
            -2.03312017085086261358222928593e-2
        },
        {
            -9.3714243008598732571704021658e-1, 0, 0, 5.18637242884406370830023853209,
            1.09143734899672957818500254654, -8.14978701074692612513997267357, -1.85200656599969598641566180701e1,
            2.27394870993505042818970056734e1, 2.49360555267965238987089396762, -3.0467644718982195003823669022
        },
        {
            2.27331014751653820792359768449, 0, 0, -1.05344954667372501984066689879e1,
            -2.00087205822486249909675718444, -1.79589318631187989172765950534e1,
            2.79488845294199600508499808837e1, -2.85899827713502369474065508674, -8.87285693353062954433549289258,
            1.23605671757943030647266201528e1, 6.43392746015763530355970484046e-1
        },
    };

    private static final double[] WEIGHT = {
        5.42937341165687622380535766363e-2, 0, 0, 0, 0, 4.45031289275240888144113950566,
        1.89151789931450038304281599044, -5.8012039600105847814672114227, 3.1116436695781989440891606237e-1,
        -1.52160949662516078556178806805e-1, 2.01365400804030348374776537501e-1,
        4.47106157277725905176885569043e-2
    };

    /** Differences to a formula of fifth order, and of third. */
    private static final double[] FIFTH = {
        0.01312004499419488073250102996, 0, 0, 0, 0, -1.225156446376204440720569753,
        -0.4957589496572501915214079952, 1.664377182454986536961530415, -0.3503288487499736816886487290,
        0.3341791187130174790297318841, 0.08192320648511571246570742613, -0.02235530786388629525884427845
    };

    private static final double[] THIRD = {
        -0.1898007540724076157147023288757, 0, 0, 0, 0, 4.45031289275240888144113950566,
        1.89151789931450038304281599044, -5.8012039600105847814672114227, -0.422682321323791962932445679177,
        -0.152160949662516078556178806805, 0.201365400804030348374776537501, 0.0226517921983608258118062039631
    };
    // spotless:on

    /** The rows of A, the weights and the differences times A. */
    private static final double[][] STAGE_X = new double[STAGES][];

    private static final double[] WEIGHT_X = timesA(WEIGHT);
    private static final double[] FIFTH_X = timesA(FIFTH);
    private static final double[] THIRD_X = timesA(THIRD);

    static {
        for (int s = 0; s < STAGES; s++) {
            STAGE_X[s] = timesA(STAGE[s]);
        }
    }

    /**
     * Part of the step that the estimate would allow. It scatters, and a step that is rejected costs as much as one that is
     * not: on the scenes of the report evaluations at equal error are the fewest at 0.65 to 0.75, a tenth less than at 0.9.
     */
    private static final double SAFETY = 0.7;

    /** The error that steps leave, over the estimate: where the method is used in earnest, in the mean of our scenes. */
    private static final double CALIBRATION = 0.16;

    /** The same in the angles of a tree of pins. */
    private static final double TIED_CALIBRATION = 0.1;

    /** And with dense output there. */
    private static final double TIED_OPEN_CALIBRATION = 0.16;

    /** What errors of angles count there, and for how many steps those of velocities do at most. */
    private static final double TIED_PLACES = 2;

    private static final double TIED_LONGEST = 4;

    /** The same where dense output is read, whose error is of an order less. */
    private static final double OPEN_CALIBRATION = 0.27;

    /** The most steps for which an error of a velocity counts: more than one only where the motion takes longer to change. */
    private static final double LONGEST = 1.5;

    /** It damps vibrations up to 5.8 of their frequency times the step. */
    private static final double REACH = 4.5;

    private static final double SHARE_OF_STOP = 0.9;

    private static final double LEAST = 0.02;
    private static final double MOST = 6;

    /**
     * Creates the method.
     *
     * @param tolerance error of a position that one step may make, length
     * @throws IllegalArgumentException if the tolerance is not a finite number greater than 0
     */
    public DormandPrince853(double tolerance) {
        super(tolerance);
    }

    private static double[] timesA(double[] row) {
        double[] product = new double[STAGES];
        for (int j = 0; j < row.length; j++) {
            for (int l = 0; l < j; l++) {
                product[l] += row[j] * STAGE[j][l];
            }
        }
        return product;
    }

    /** The row of a stage; that of the last but one is the step's end. */
    static double[] row(int stage) {
        return stage == STAGES ? WEIGHT : STAGE[stage];
    }

    @Override
    boolean takesTiedCoordinates(IntList bodies, Path path) {
        return true;
    }

    @Override
    double reach(IntList bodies, Path path) {
        return REACH;
    }

    @Override
    double shareOfStop() {
        return SHARE_OF_STOP;
    }

    @Override
    boolean makeDense(
            EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path, DenseOutput out) {
        DormandPrinceOutput.make(t, h, path.stages, out);
        return true;
    }

    @Override
    boolean attempt(EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path) {
        Stages s = path.stages;
        s.ensureWork(STAGES);
        for (int m = 0; m < s.size; m++) {
            s.work[STAGES * m] = s.a0[m];
        }
        for (int stage = 1; stage < STAGES; stage++) {
            if (!place(s, h, NODE[stage], STAGE_X[stage], STAGE[stage], stage)) {
                s.factor = LEAST;
                return false;
            }
            s.coordinates.accelerate(s.x, s.v, t + NODE[stage] * h, s.a);
            take(s.a, s.size, s.work, stage);
        }
        if (path.stiffness != null) {
            path.stiffness.keep(bodies, s);
        }
        double error = error(s, h);
        double eighth = Math.sqrt(Math.sqrt(Math.sqrt(error)));
        s.factor = error == 0 ? MOST : Math.max(LEAST, Math.min(MOST, SAFETY / eighth));
        if (!(error <= 1)) {
            s.factor = error < Double.POSITIVE_INFINITY ? s.factor : LEAST;
            return false;
        }
        s.maker = this;
        place(s, h, 1, WEIGHT_X, WEIGHT, STAGES);
        s.coordinates.put(s.x, s.v);
        return true;
    }

    /** Where a stage is, or the end of the step; false if it is nowhere, so that no force must be asked for there. */
    private static boolean place(Stages s, double h, double node, double[] rowX, double[] rowV, int count) {
        double[] work = s.work;
        double[] x = s.x;
        double[] v = s.v;
        double off = 0;
        for (int m = 0, size = s.size; m < size; m++) {
            double sumX = 0;
            double sumV = 0;
            for (int j = 0, o = STAGES * m; j < count; j++) {
                double a = work[o + j];
                sumX += rowX[j] * a;
                sumV += rowV[j] * a;
            }
            x[m] = s.x0[m] + h * (node * s.v0[m] + h * sumX);
            v[m] = s.v0[m] + h * sumV;
            off += (x[m] - x[m]) + (v[m] - v[m]);
        }
        return off == 0; // NaN if something is not finite
    }

    private static void take(double[] a, int size, double[] work, int stage) {
        for (int m = 0; m < size; m++) {
            work[STAGES * m + stage] = a[m];
        }
    }

    /** The estimate of the error, in units of what is allowed: of positions, and of velocities times the step. */
    private static double error(Stages s, double h) {
        boolean inAngles = s.isTied(); // of a tree of pins: what an angle's error does to velocities is not what its rate's does
        double unit = inAngles ? Math.abs(h) : 1;
        double longest = inAngles ? TIED_LONGEST : LONGEST;
        double time = Math.max(s.haste, Math.min(longest, s.time / Math.abs(h))) * unit;
        double places = unit * unit * (inAngles ? TIED_PLACES : 1);
        double[] work = s.work;
        double[] x3 = s.x; // has been used
        double[] v3 = s.v;
        for (int m = 0, size = s.size; m < size; m++) {
            double sumX5 = 0;
            double sumV5 = 0;
            double sumX3 = 0;
            double sumV3 = 0;
            for (int j = 0, o = STAGES * m; j < STAGES; j++) {
                double a = work[o + j];
                sumX5 += FIFTH_X[j] * a;
                sumV5 += FIFTH[j] * a;
                sumX3 += THIRD_X[j] * a;
                sumV3 += THIRD[j] * a;
            }
            s.offX[m] = places * sumX5;
            s.offV[m] = unit * sumV5;
            x3[m] = places * sumX3;
            v3[m] = unit * sumV3;
        }
        double third = s.norm(x3, v3, time);
        double fifth = s.norm(s.offX, s.offV, time);
        double left = s.left(s.offX, s.offV, time);
        double both = fifth * fifth + 0.01 * third * third;
        return both == 0 ? 0 : calibration(s) * (inAngles ? 1 : h * h) * left * fifth / Math.sqrt(both);
    }

    private static double calibration(Stages s) {
        if (s.isTied()) {
            return s.isOpen ? TIED_OPEN_CALIBRATION : TIED_CALIBRATION;
        }
        return s.isOpen ? OPEN_CALIBRATION : CALIBRATION;
    }

    @Override
    public int order() {
        return 8;
    }

    @Override
    public String toString() {
        return "DormandPrince853(" + getTolerance() + ")";
    }
}
