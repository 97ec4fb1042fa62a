// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.shape.Rectangle;
import sim.portrayal.Inspector;
import sim.portrayal.LocationWrapper;
import sim.portrayal.SimpleInspector;
import sim.util.Properties;

/** What MASON's inspectors find in a body, and what they change. */
class InspectedBodyTest {
    private final Body body = new Body(new Rectangle(2, 1)).at(3, 4, 0.5).moving(6, 7, 0.25);
    private final Properties properties = Properties.getProperties(new InspectedBody(body));

    private int index(String name) {
        for (int k = 0; k < properties.numProperties(); k++) {
            if (properties.getName(k).equals(name)) {
                return k;
            }
        }
        throw new AssertionError("no property " + name);
    }

    @Test
    void masonFindsTheProperties() {
        List<String> writable = new ArrayList<>();
        List<String> readable = new ArrayList<>();
        for (int k = 0; k < properties.numProperties(); k++) {
            (properties.isReadWrite(k) ? writable : readable).add(properties.getName(k));
        }
        assertThat(writable)
                .containsExactlyInAnyOrder(
                        "X", "Y", "Angle", "VelocityX", "VelocityY", "AngularVelocity", "Mass", "Restitution",
                        "Friction", "BeltSpeed", "SurfaceFriction", "SurfaceStaticFriction");
        assertThat(readable).containsExactlyInAnyOrder("Shape", "Fixed", "Inertia", "KineticEnergy");
        assertThat(properties.getValue(index("VelocityY"))).isEqualTo(7.0);
        assertThat(properties.getDomain(index("Restitution"))).isInstanceOf(sim.util.Interval.class);
    }

    /** An inspector of an engine asks for all that it finds: nothing of it may throw, or the console is full of traces. */
    @Test
    void anEngineIsInspectedWithoutAnException() {
        PhysicsEngine engine = new PhysicsEngine();
        assertThat(readable(engine)).contains("Time", "Steps", "Impacts").doesNotContain("StepReport", "RunReport");
        engine.setAudited(true);
        assertThat(readable(engine)).contains("StepReport", "RunReport");
    }

    /** The properties that have a value. */
    private static List<String> readable(Object object) {
        List<String> names = new ArrayList<>();
        Properties all = Properties.getProperties(object);
        for (int k = 0; k < all.numProperties(); k++) {
            if (!all.isHidden(k)) {
                assertThat(all.getValue(k)).as(all.getName(k)).isNotNull();
                names.add(all.getName(k));
            }
        }
        return names;
    }

    @Test
    void eachValueIsChangedAlone() {
        String[] names = {"X", "Y", "Angle", "VelocityX", "VelocityY", "AngularVelocity", "Restitution", "Friction"};
        for (int k = 0; k < names.length; k++) {
            properties.setValue(index(names[k]), 0.1 + 0.05 * k);
        }
        for (int k = 0; k < names.length; k++) {
            assertThat(properties.getValue(index(names[k]))).as(names[k]).isEqualTo(0.1 + 0.05 * k);
        }
        double ratio = body.getInertia() / body.getMass();
        properties.setValue(index("Mass"), 16.0);
        assertThat(body.getMass()).isEqualTo(16);
        assertThat(body.getInertia()).isEqualTo(16 * ratio);
    }

    @Test
    void theStaticCoefficientIsNeverBelowTheKineticOne() {
        InspectedBody view = new InspectedBody(body);
        view.setSurfaceFriction(0.3);
        assertThat(body.getSurfaceStaticFriction()).isEqualTo(0.3);
        view.setSurfaceStaticFriction(0.5);
        view.setSurfaceFriction(0.2);
        assertThat(body.getSurfaceStaticFriction()).isEqualTo(0.5);
        assertThatThrownBy(() -> view.setSurfaceStaticFriction(0.1)).hasMessageContaining("0.1");
        assertThat(body.getSurfaceStaticFriction()).isEqualTo(0.5);
    }

    @Test
    void theInspectorOfAPortrayedBodyShowsThem() {
        BodyPortrayal2D portrayal = new BodyPortrayal2D(Color.RED);
        Inspector inspector = portrayal.getInspector(new LocationWrapper(body, null, null), null);
        assertThat(inspector).isInstanceOf(SimpleInspector.class);
        assertThat(inspector.isVolatile()).isTrue();
    }
}
