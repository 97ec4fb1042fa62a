// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.State;
import sim.physics.shape.Rectangle;

/** The forces in chains whose masses are spread over twelve decades, each component against a solve of 60 digits. */
class SpreadMassesTest {
    private static final MathContext DIGITS = new MathContext(60);
    private static final int LINKS = 10;

    private static double mass(String kind, int k, SplittableRandom random) {
        return switch (kind) {
            case "random" -> StrictMath.pow(10, random.nextDouble(-6, 6));
            case "not too random" -> StrictMath.pow(10, random.nextDouble(-4, 4));
            case "heavy tip" -> k == LINKS - 1 ? 1e9 : 1;
            case "heavy root" -> k == 0 ? 1e9 : 1;
            default -> k % 2 == 0 ? 1 : 1e9;
        };
    }

    @ParameterizedTest
    @ValueSource(strings = {"random", "heavy tip", "heavy root", "alternating"})
    void everyMultiplierIsRight(String kind) {
        SplittableRandom random = new SplittableRandom(11);
        for (int pose = 0; pose < 20; pose++) {
            State bodies = new State();
            Island chain = chain(bodies, kind, random);
            double[] u = new double[bodies.x().length];
            for (int k = 0; k < LINKS; k++) {
                u[3 * k] = random.nextDouble(-1, 1);
                u[3 * k + 1] = random.nextDouble(-10, 0);
                u[3 * k + 2] = random.nextDouble(-1, 1);
            }
            BigDecimal[] exact = exact(chain, bodies.w().values(), u);
            new DirectSolver().prepareAndCorrect(chain, bodies.w().values(), u, chain.rate);
            for (int k = 0; k < exact.length; k++) {
                double expected = exact[k].doubleValue();
                assertThat(chain.lambda[k]).as("%s, row %d", kind, k).isCloseTo(expected, within(1e-12 * Math.abs(expected)));
            }
        }
    }

    /** What a chain that moves in its angles falls with, as the exact forces have it. Errors count by what they are of the kinetic energy. */
    @ParameterizedTest
    @ValueSource(strings = {"not too random", "heavy tip", "heavy root", "alternating"})
    void anglesMoveAsTheForcesSay(String kind) {
        SplittableRandom random = new SplittableRandom(12);
        double h = 0x1p-40;
        for (int pose = 0; pose < 20; pose++) {
            State bodies = new State();
            Island chain = chain(bodies, kind, random);
            Arrays.fill(bodies.v(), 0);
            chain.evaluate(bodies);
            double[] fall = new double[bodies.x().length];
            for (int k = 0; k < LINKS; k++) {
                fall[3 * k + 1] = -9.81;
            }
            double[] expected = pulled(chain, bodies.w().values(), fall);
            assertThat(QuickStep.advance(chain, bodies, new DirectSolver(), 0, -9.81, h)).as("goes by its angles").isTrue();
            double all = 0;
            double off = 0;
            for (int k = 0; k < 3 * LINKS; k++) {
                double error = bodies.v()[k] / h - expected[k];
                all += expected[k] * expected[k] / bodies.w().values()[k];
                off += error * error / bodies.w().values()[k];
            }
            assertThat(Math.sqrt(off / all)).as("%s, pose %d", kind, pose).isLessThan(1e-11);
        }
    }

    /** u + W Jᵀ λ with the exact λ. */
    private static double[] pulled(Island chain, double[] w, double[] u) {
        BigDecimal[] lambda = exact(chain, w, u);
        double[] sum = new double[3 * LINKS];
        for (int k = 0; k < sum.length; k++) {
            BigDecimal entry = new BigDecimal(u[k]);
            for (int r = 0; r < lambda.length; r++) {
                entry = entry.add(new BigDecimal(w[k]).multiply(row(chain, r, u.length)[k]).multiply(lambda[r]));
            }
            sum[k] = entry.doubleValue();
        }
        return sum;
    }

    private static Island chain(State state, String kind, SplittableRandom random) {
        List<Constraint> pins = new ArrayList<>();
        IntList indices = new IntList();
        double x = 0;
        double y = 0;
        Body last = null;
        for (int k = 0; k < LINKS; k++) {
            double angle = random.nextDouble(-3, 3);
            double cos = StrictMath.cos(angle);
            double sin = StrictMath.sin(angle);
            Body rod = new Body(new Rectangle(1, 0.1)).at(x + cos / 2, y + sin / 2, angle);
            rod.moving(0, 0, random.nextDouble(-2, 2));
            double mass = mass(kind, k, random);
            rod.setMass(mass, mass / 12);
            indices.add(state.add(rod));
            pins.add(last == null ? new PinJoint(rod, x, y) : new PinJoint(last, rod, x, y));
            x += cos;
            y += sin;
            last = rod;
        }
        Island island = new Island(indices, pins);
        island.evaluate(state);
        island.writeRows();
        return island;
    }

    /** J W Jᵀ λ = −(J u + rate), by elimination in 60 digits from the same doubles. */
    private static BigDecimal[] exact(Island island, double[] w, double[] u) {
        int n = 2 * island.nodes;
        BigDecimal[][] rows = new BigDecimal[n][];
        for (int r = 0; r < n; r++) {
            rows[r] = row(island, r, u.length);
        }
        BigDecimal[][] a = new BigDecimal[n][n + 1];
        for (int r = 0; r < n; r++) {
            for (int c = 0; c < n; c++) {
                a[r][c] = BigDecimal.ZERO;
                for (int k = 0; k < u.length && k < w.length; k++) {
                    a[r][c] = a[r][c].add(rows[r][k].multiply(new BigDecimal(w[k])).multiply(rows[c][k]));
                }
            }
            a[r][n] = new BigDecimal(-island.rate[r]);
            for (int k = 0; k < u.length; k++) {
                a[r][n] = a[r][n].subtract(rows[r][k].multiply(new BigDecimal(u[k])));
            }
        }
        return eliminate(a, n);
    }

    private static BigDecimal[] row(Island island, int r, int columns) {
        BigDecimal[] row = new BigDecimal[columns];
        Arrays.fill(row, BigDecimal.ZERO);
        int p = r / 2;
        for (int k = 0; k < 3; k++) {
            if (island.blockA[p] >= 0) {
                row[island.blockA[p] + k] = new BigDecimal(island.j[Island.J * p + 3 * (r % 2) + k]);
            }
            if (island.blockB[p] >= 0) {
                row[island.blockB[p] + k] = new BigDecimal(island.j[Island.J * p + 6 + 3 * (r % 2) + k]);
            }
        }
        return row;
    }

    private static BigDecimal[] eliminate(BigDecimal[][] a, int n) {
        for (int c = 0; c < n; c++) {
            for (int r = c + 1; r < n; r++) {
                BigDecimal factor = a[r][c].divide(a[c][c], DIGITS);
                for (int k = c; k <= n; k++) {
                    a[r][k] = a[r][k].subtract(factor.multiply(a[c][k]), DIGITS);
                }
            }
        }
        BigDecimal[] x = new BigDecimal[n];
        for (int r = n - 1; r >= 0; r--) {
            x[r] = a[r][n];
            for (int k = r + 1; k < n; k++) {
                x[r] = x[r].subtract(a[r][k].multiply(x[k]), DIGITS);
            }
            x[r] = x[r].divide(a[r][r], DIGITS);
        }
        return x;
    }
}
