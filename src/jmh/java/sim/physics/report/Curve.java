// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.ArrayList;
import java.util.List;

/**
 * A curve of a diagram: an engine with a method or a set of options.
 *
 * @param engine its name
 * @param method or options
 * @param own the method, if it is this engine
 * @param order how steeply to refine: 1 by four, else by two
 */
record Curve(String engine, String method, OwnMethod own, int order) {
    static final String OURS = "ours";

    static List<Curve> all(ReportScene scene, PythonPeers python) {
        List<Curve> curves = new ArrayList<>();
        if (scene.methods != null) {
            for (OwnMethod method : scene.methods) {
                curves.add(new Curve(OURS, method.name(), method, 1));
            }
        } else if (scene.smooth) {
            for (OwnMethod method : OwnMethod.ALL) {
                boolean applies = !method.conservative() || scene.conservative;
                // dense systems of hundreds of unknowns: not what an implicit method is for
                boolean large = scene.model.parts.size() > 40 && (method.name().equals("Radau IIA"));
                if (applies && !large) {
                    curves.add(new Curve(OURS, method.name(), method, method.name().endsWith("Euler") || method == OwnMethod.TIME_STEPPING ? 1 : 4));
                }
            }
        } else {
            curves.add(new Curve(OURS, OwnMethod.EXACT_PATHS.name(), OwnMethod.EXACT_PATHS, 1));
            curves.add(new Curve(OURS, OwnMethod.TIME_STEPPING.name(), OwnMethod.TIME_STEPPING, 1));
        }
        for (String engine : new String[] {"dyn4j", "JBox2D", "Box2D (libGDX)", "MuJoCo", "pymunk"}) {
            boolean there = !isPython(engine) || python.has(engine);
            if (there && scene.cannot.apply(engine) == null) {
                boolean mujoco = engine.equals("MuJoCo");
                curves.add(new Curve(engine, mujoco ? "Euler" : "default", null, 1));
                curves.add(new Curve(engine, mujoco ? "RK4, stiff loops" : "tuned", null, mujoco ? 4 : 1));
            }
        }
        return curves;
    }

    static boolean isPython(String engine) {
        return engine.equals("MuJoCo") || engine.equals("pymunk");
    }

    boolean isOwn() {
        return own != null;
    }

    boolean isAdaptive() {
        return own != null && own.adaptive();
    }

    boolean isTuned() {
        return !method.equals("default") && !method.equals("Euler");
    }

    String name() {
        return engine + " " + method;
    }

    /** Settings from coarse to fine: tolerances, or steps from one instant to the next. */
    double[] settings(ReportScene scene) {
        if (isAdaptive()) {
            double[] tolerances = new double[14];
            for (int k = 0; k < tolerances.length; k++) {
                tolerances[k] = Double.parseDouble("1e-" + (k + 3));
            }
            return tolerances;
        }
        double[] steps = new double[order == 1 ? 10 : 16];
        for (int k = 0; k < steps.length; k++) {
            steps[k] = scene.coarse * Math.pow(order == 1 ? 4 : 2, k);
        }
        return steps;
    }

    World world(ReportScene scene, double setting, boolean count) {
        double dt = scene.duration / scene.samples / (isAdaptive() ? 1 : setting);
        Model model = scene.model;
        return switch (engine) {
            case OURS -> new OwnWorld(model, own.maker().apply(isAdaptive() ? setting : 0), dt, count, own == OwnMethod.TIME_STEPPING ? OwnMethod.SUBSTEPS : 0);
            case "dyn4j" -> new Dyn4jWorld(model, dt, isTuned());
            case "JBox2D" -> new JBox2DWorld(model, dt, isTuned());
            default -> new GdxWorld(model, dt, isTuned());
        };
    }

    int steps(double setting) {
        return isAdaptive() ? 1 : (int) setting;
    }
}
