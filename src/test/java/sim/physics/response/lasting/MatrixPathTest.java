// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * The conditions of contact, friction and motors hold at the end of each path, for random rows of bodies that are as often as not
 * asked for the same twice.
 */
class MatrixPathTest {
    private static final int PROBLEMS = 200;

    /** Points with normal and tangential rows, then motors, on a number of freedoms. */
    private static final class Rows extends HeapRows {
        private static final long serialVersionUID = 1L;

        Rows(Random random, int points, int motors, int freedoms, double mu) {
            rows = 2 * points + motors;
            bearer = new int[rows];
            friction = new double[rows];
            least = new double[rows];
            most = new double[rows];
            bound = new double[rows];
            without = new double[rows];
            impulse = new double[rows];
            velocity = new double[rows];
            double[][] jacobian = new double[rows][freedoms];
            double[] free = random.doubles(freedoms, -1, 1).toArray();
            for (int i = 0; i < rows; i++) {
                boolean isMotor = i >= 2 * points;
                boolean isTangent = !isMotor && i % 2 == 1;
                bearer[i] = isTangent ? i - 1 : -1;
                friction[i] = isTangent ? mu : 0;
                least[i] = isMotor ? -random.nextDouble() : 0;
                most[i] = isMotor ? random.nextDouble() : Double.POSITIVE_INFINITY;
                for (int k = 0; k < 6; k++) {
                    jacobian[i][random.nextInt(freedoms)] = random.nextGaussian();
                }
                without[i] = dot(jacobian[i], free);
                bound[i] = isMotor ? random.nextGaussian() : 0; // all contacts can be closed at once: by no motion
            }
            replies = new double[rows * rows];
            for (int i = 0; i < rows; i++) {
                for (int j = 0; j < rows; j++) {
                    replies[j * rows + i] = dot(jacobian[i], jacobian[j]);
                }
            }
        }

        @Override
        void grow(int n) {
            // nothing
        }

        private static double dot(double[] a, double[] b) {
            double sum = 0;
            for (int k = 0; k < a.length; k++) {
                sum += a[k] * b[k];
            }
            return sum;
        }

        /** By how much a velocity misses what the impulse demands, or an impulse its bounds. */
        double error() {
            evaluate();
            double worst = 0;
            for (int i = 0; i < rows; i++) {
                double low = lower(i);
                double high = upper(i);
                double wanted = Math.max(low, Math.min(high, impulse[i] - (velocity[i] - bound[i]) / own(i)));
                worst = Math.max(worst, Math.abs(wanted - impulse[i]) * own(i));
            }
            return worst;
        }
    }

    @ParameterizedTest
    @CsvSource({"1, 0, 3, 0.5", "4, 0, 9, 0.5", "8, 4, 12, 0.8", "20, 6, 24, 0.8", "40, 10, 60, 1.5", "12, 0, 12, 0", "15, 0, 18, 5"})
    void eachPathEndsWhereTheConditionsHold(int points, int motors, int freedoms, double mu) {
        Random random = new Random(points);
        for (int k = 0; k < PROBLEMS; k++) {
            Rows rows = new Rows(random, points, motors, freedoms, mu);
            MatrixPath path = new MatrixPath();
            double[] sides = new double[rows.rows];
            assertThat(path.follow(rows, sides)).as("problem %d", k).isTrue();
            assertThat(rows.error()).as("problem %d", k).isLessThan(1e-5);
            refine(path, rows, sides);
            assertThat(rows.error()).as("problem %d", k).isLessThan(1e-9);
        }
    }

    @Test
    void ofTwoMotorsOnOneCoordinateTheStrongerHasItsSpeedHoweverStrongTheyAre() {
        for (double strength = 1; strength < 1e10; strength *= 10) {
            Rows rows = new Rows(new Random(1), 0, 2, 1, 0);
            Arrays.fill(rows.replies, 1);
            Arrays.fill(rows.without, 0);
            rows.bound = new double[] {5, -3};
            rows.least = new double[] {-strength, -2 * strength};
            rows.most = new double[] {strength, 2 * strength};
            MatrixPath path = new MatrixPath();
            double[] sides = new double[2];
            assertThat(path.follow(rows, sides)).isTrue();
            refine(path, rows, sides);
            assertThat(rows.impulse[0]).isEqualTo(strength);
            assertThat(rows.velocity[0]).isCloseTo(Math.max(-3, -strength), within(1e-6 * strength));
        }
    }

    @ParameterizedTest
    @CsvSource({"8, 4, 12, 0.8", "20, 6, 24, 0.8"})
    void fromTheEndOfOnePathAnotherLeadsToOtherVelocities(int points, int motors, int freedoms, double mu) {
        Random random = new Random(points);
        int resumed = 0;
        for (int k = 0; k < PROBLEMS; k++) {
            Rows rows = new Rows(random, points, motors, freedoms, mu);
            MatrixPath path = new MatrixPath();
            double[] sides = new double[rows.rows];
            assertThat(path.resume(rows, sides)).isFalse();
            assertThat(path.follow(rows, sides)).isTrue();
            double[] other = new Rows(random, points, motors, freedoms, mu).without;
            Arrays.setAll(rows.without, i -> rows.without[i] + 0.1 * rows.velocity[i] * other[i]);
            if (path.resume(rows, sides)) {
                refine(path, rows, sides);
                assertThat(rows.error()).as("problem %d", k).isLessThan(1e-9);
                resumed++;
            }
        }
        assertThat(resumed).isGreaterThan(PROBLEMS / 2);
    }

    private static void refine(MatrixPath path, Rows rows, double[] sides) {
        for (int pass = 0; pass < 10 && rows.error() > 1e-12; pass++) {
            path.refine(sides);
        }
    }
}
