// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every scene is built by every engine of the JVM, and a coarse point of it is run: mvn -Pbench test -Dtest=ReportTest. */
class ReportTest {
    static Stream<ReportScene> scenes() {
        return Suite.all(false).stream();
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void eachEngineRunsACoarsePoint(ReportScene scene) {
        double[] start = scene.model.start();
        assertThat(scene.model.gap(start)).isLessThan(1e-15 * (1 + scene.model.parts.size()));
        assertThat(scene.model.penetration(start)).isLessThan(1e-15);
        double[][] reference = scene.expected == null ? null : scene.expected.get();
        double best = Double.POSITIVE_INFINITY;
        for (Curve curve : Curve.all(scene, new PythonPeers("no such interpreter"))) {
            if (curve.isOwn() && (curve.method().startsWith("Rattle") || curve.method().endsWith("Euler"))) {
                continue;
            }
            double setting = curve.settings(scene)[curve.isAdaptive() ? 4 : 1];
            double error = error(scene, curve, setting, reference, start.length);
            // a step that is too long for a stiff spring ends in NaN or is refused; any other is not
            assertThat(Double.isNaN(error)).as(curve.name()).isEqualTo(scene.id.equals("W22-stiff") && curve.method().equals("RK4"));
            best = curve.isOwn() && error < best ? error : best;
        }
        assertThat(best).isLessThan(1e-3);
    }

    private static double error(ReportScene scene, Curve curve, double setting, double[][] reference, int numbers) {
        double[][] states = new double[scene.samples][numbers];
        try (World world = curve.world(scene, setting, true)) {
            for (double[] state : states) {
                for (int k = 0; k < curve.steps(setting); k++) {
                    world.step();
                }
                world.read(state);
            }
        } catch (IllegalArgumentException grown) {
            return Double.NaN; // a force without bound
        }
        return scene.error(states, reference);
    }

    /** Joints to the world need a body in some engines: nothing meets it, and nothing meets a part that does not collide. */
    @Test
    void whatDoesNotCollideIsNotMet() {
        Model model = new Model(0);
        int ball = model.add(Model.Kind.DISC, new double[] {0.5}, 1, 0.125, true, 1, -1, 0, 0, 2, 0, 0);
        model.rod(0.5, 0, 0);
        ReportScene scene = new ReportScene("test", "a ball that flies through", model, 1, 1, 10);
        scene.smooth = false;
        scene.point(ball, 0, 0);
        for (Curve curve : Curve.all(scene, new PythonPeers("no such interpreter"))) {
            assertThat(error(scene, curve, 40, new double[][] {{1, 0}}, 2 * Model.BLOCK)).as(curve.name()).isLessThan(1e-5);
        }
    }

    @Test
    void penetrationsAndGapsAreThoseOfTheShapes() {
        Model model = new Model(0);
        model.wall(0, 0, 2, 2);
        model.add(Model.Kind.DISC, new double[] {0.5}, 1, 1, true, 1, 1.4, 0.3);
        model.add(Model.Kind.BOX, new double[] {1, 1}, 1, 1, true, 1, 0, 1.25);
        model.pins.add(new Model.Pin(1, -1, 1.4, 0.3));
        double[] state = model.start();
        assertThat(model.penetration(state)).isCloseTo(0.25, within(1e-15));
        state[Model.BLOCK] = 1.45;
        state[2 * Model.BLOCK + 1] = 9;
        assertThat(model.penetration(state)).isCloseTo(0.05, within(1e-15));
        assertThat(model.gap(state)).isCloseTo(0.05, within(1e-15));
        state[Model.BLOCK] = 1.4;
        state[Model.BLOCK + 1] = 1.4;
        assertThat(model.penetration(state)).isZero();
    }

    @Test
    void timesAtFixedErrorAreInterpolatedOnTheLogarithms() {
        List<Point> curve = List.of(point(1e-2, 1), point(1e-4, 100));
        assertThat(Profile.time(curve, 1e-3)).isCloseTo(10, within(1e-12));
        assertThat(Profile.time(curve, 1e-1)).isEqualTo(1);
        assertThat(Profile.time(curve, 1e-5)).isInfinite();
    }

    private static Point point(double error, double cpu) {
        Point point = new Point(1);
        point.error = error;
        point.cpu = cpu;
        point.counts = Map.of();
        return point;
    }
}
