// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** mvn -Pbench test -Dtest=MethodGuideTest. */
class MethodGuideTest {
    private static final ReportScene SCENE = JointScenes.rodPendulum();
    private static final Curve RK4 = own("RK4");
    private static final Curve DOP853 = own("DOP853");
    private static final Curve PEER = new Curve("a peer", "default", null, 1);

    private static Curve own(String name) {
        OwnMethod method = OwnMethod.ALL.stream().filter(m -> m.name().equals(name)).findFirst().orElseThrow();
        return new Curve(Curve.OURS, name, method, 4);
    }

    private static Point point(double setting, double error, double cpu) {
        Point point = new Point(setting);
        point.error = error;
        point.cpu = cpu;
        return point;
    }

    private static Map<Curve, List<Point>> curves() {
        Map<Curve, List<Point>> curves = new LinkedHashMap<>();
        curves.put(RK4, List.of(point(30, 1e-2, 1), point(60, 1e-4, 2), point(120, 1e-5, 4), point(240, 2e-7, 8)));
        curves.put(DOP853, List.of(point(1e-3, 1e-2, 2), point(1e-4, 1e-7, 3), point(1e-5, 1e-5, 5), point(1e-6, 1e-8, 6)));
        curves.put(PEER, List.of(point(1, 1e-14, 0.1)));
        return curves;
    }

    @Test
    void theCheapestOfOurMethodsIsTaken() {
        MethodGuide.Choice choice = MethodGuide.cheapest(curves(), 1e-3);
        assertThat(choice.curve()).isEqualTo(RK4);
        assertThat(choice.point().setting).isEqualTo(60);
        assertThat(MethodGuide.cheapest(curves(), 1e-12)).isNull();
    }

    /** The tolerance of 1e-4 does better than it should: that of 1e-5 does not reach 1e-6. */
    @Test
    void aSettingThatIsGoodByChanceIsNotTaken() {
        MethodGuide.Choice choice = MethodGuide.cheapest(curves(), 1e-6);
        assertThat(choice.curve()).isEqualTo(DOP853);
        assertThat(choice.point().setting).isEqualTo(1e-6);
    }

    @Test
    void theSectionNamesMethodSettingAndTime() {
        MethodGuide guide = new MethodGuide();
        guide.add(SCENE, curves());
        assertThat(guide.section()).contains(
                "| W02: rod pendulum, 10 s | RK4, step 0.017 s: 2.0e+00 | DOP853, tolerance 1e-06: 6.0e+00 | none | none |");
    }

    @Test
    void whereNoIntegratorIsNeededAnyStepDoes() {
        ReportScene hard = OtherScenes.rodBounce();
        Map<Curve, List<Point>> curves = new LinkedHashMap<>();
        curves.put(new Curve(Curve.OURS, "exact paths", OwnMethod.EXACT_PATHS, 1), List.of(point(60, 1e-14, 0.5)));
        MethodGuide guide = new MethodGuide();
        guide.add(hard, curves);
        assertThat(guide.section()).contains("exact paths, any step: 5.0e-01");
    }
}
