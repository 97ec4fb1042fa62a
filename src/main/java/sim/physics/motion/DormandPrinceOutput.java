// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

/**
 * Dense output of order 7 of {@link DormandPrince853}, which takes the accelerations at its end and at three more stages:
 * Hairer, Nørsett and Wanner, <i>Solving Ordinary Differential Equations I</i>, 2nd edition, II.6 and II.10.
 */
final class DormandPrinceOutput {
    /** Stages of the step, and those with the others. */
    private static final int STAGES = DormandPrince853.STAGES;

    private static final int ALL = STAGES + 4;

    /** Coefficients of a coordinate, and how many of them are the method's own. */
    private static final int TERMS = 7;

    private static final int OWN = 4;

    // spotless:off
    private static final double[] NODE = {0.1, 0.2, 7.0 / 9};

    private static final double[][] STAGE = {
        {
            5.61675022830479523392909219681e-2, 0, 0, 0, 0, 0, 2.53500210216624811088794765333e-1,
            -2.46239037470802489917441475441e-1, -1.24191423263816360469010140626e-1,
            1.5329179827876569731206322685e-1, 8.20105229563468988491666602057e-3,
            7.56789766054569976138603589584e-3, -8.298e-3
        },
        {
            3.18346481635021405060768473261e-2, 0, 0, 0, 0, 2.83009096723667755288322961402e-2,
            5.35419883074385676223797384372e-2, -5.49237485713909884646569340306e-2, 0, 0,
            -1.08347328697249322858509316994e-4, 3.82571090835658412954920192323e-4,
            -3.40465008687404560802977114492e-4, 1.41312443674632500278074618366e-1
        },
        {
            -4.28896301583791923408573538692e-1, 0, 0, 0, 0, -4.69762141536116384314449447206,
            7.68342119606259904184240953878, 4.06898981839711007970213554331, 3.56727187455281109270669543021e-1,
            0, 0, 0, -1.39902416515901462129418009734e-3, 2.9475147891527723389556272149,
            -9.15095847217987001081870187138
        },
    };

    private static final double[][] OUTPUT = {
        {
            -8.4289382761090128651353491142, 0, 0, 0, 0, 0.56671495351937776962531783590,
            -3.0689499459498916912797304727, 2.3846676565120698287728149680, 2.1170345824450282767155149946,
            -0.87139158377797299206789907490, 2.2404374302607882758541771650, 0.63157877876946881815570249290,
            -0.088990336451333310820698117400, 18.148505520854727256656404962, -9.1946323924783554000451984436,
            -4.4360363875948939664310572000
        },
        {
            10.427508642579134603413151009, 0, 0, 0, 0, 242.28349177525818288430175319,
            165.20045171727028198505394887, -374.54675472269020279518312152, -22.113666853125306036270938578,
            7.7334326684722638389603898808, -30.674084731089398182061213626, -9.3321305264302278729567221706,
            15.697238121770843886131091075, -31.139403219565177677282850411, -9.3529243588444783865713862664,
            35.816841486394083752465898540
        },
        {
            19.985053242002433820987653617, 0, 0, 0, 0, -387.03730874935176555105901742,
            -189.17813819516756882830838328, 527.80815920542364900561016686, -11.573902539959630126141871134,
            6.8812326946963000169666922661, -1.0006050966910838403183860980, 0.77771377980534432092869265740,
            -2.7782057523535084065932004339, -60.196695231264120758267380846, 84.320405506677161018159903784,
            11.992291136182789328035130030
        },
        {
            -25.693933462703749003312586129, 0, 0, 0, 0, -154.18974869023643374053993627,
            -231.52937917604549567536039109, 357.63911791061412378285349910, 93.405324183624310003907691704,
            -37.458323136451633156875139351, 104.09964950896230045147246184, 29.840293426660503123344363579,
            -43.533456590011143754432175058, 96.324553959188282948394950600, -39.177261675615439165231486172,
            -149.72683625798562581422125276
        },
    };
    // spotless:on

    /** The rows times all rows: places from accelerations. */
    private static final double[][] STAGE_X = new double[STAGE.length][];

    private static final double[][] OUTPUT_X = new double[OUTPUT.length][];

    static {
        for (int s = 0; s < STAGE.length; s++) {
            STAGE_X[s] = timesA(STAGE[s]);
        }
        for (int s = 0; s < OUTPUT.length; s++) {
            OUTPUT_X[s] = timesA(OUTPUT[s]);
        }
    }

    private DormandPrinceOutput() {
        // nothing but what follows
    }

    private static double[] timesA(double[] row) {
        double[] product = new double[ALL];
        for (int j = 0; j < row.length; j++) {
            double[] a = j <= STAGES ? DormandPrince853.row(j) : STAGE[j - STAGES - 1];
            for (int l = 0; l < a.length; l++) {
                product[l] += row[j] * a[l];
            }
        }
        return product;
    }

    /** Makes the dense output of a step, of which the stages are kept and whose end the state vectors hold. */
    static void make(double t, double h, Stages s, DenseOutput out) {
        s.ensureMore(ALL - STAGES);
        out.begin(s, h, TERMS);
        s.coordinates.accelerate(s.endX, s.endV, t + h, s.a);
        take(s, 0);
        for (int m = 0; m < s.size; m++) {
            out.join(m, s.endX[m], s.endV[m], s.a0[m], s.more[(ALL - STAGES) * m]);
        }
        for (int stage = 0; stage < STAGE.length; stage++) {
            for (int m = 0; m < s.size; m++) {
                s.x[m] = s.x0[m] + h * (NODE[stage] * s.v0[m] + h * sum(s, m, STAGE_X[stage], STAGES + 1 + stage));
                s.v[m] = s.v0[m] + h * sum(s, m, STAGE[stage], STAGES + 1 + stage);
            }
            s.coordinates.accelerate(s.x, s.v, t + NODE[stage] * h, s.a);
            take(s, stage + 1);
        }
        for (int m = 0; m < s.size; m++) {
            for (int k = 0; k < OWN; k++) {
                out.x[TERMS * m + TERMS - OWN + k] = h * h * sum(s, m, OUTPUT_X[k], ALL);
                out.v[TERMS * m + TERMS - OWN + k] = h * sum(s, m, OUTPUT[k], ALL);
            }
        }
        s.putEnd();
    }

    private static double sum(Stages s, int m, double[] row, int count) {
        double sum = 0;
        for (int j = 0; j < STAGES; j++) {
            sum += row[j] * s.work[STAGES * m + j];
        }
        for (int j = STAGES; j < count; j++) {
            sum += row[j] * s.more[(ALL - STAGES) * m + j - STAGES];
        }
        return sum;
    }

    private static void take(Stages s, int stage) {
        for (int m = 0; m < s.size; m++) {
            s.more[(ALL - STAGES) * m + stage] = s.a[m];
        }
    }
}
