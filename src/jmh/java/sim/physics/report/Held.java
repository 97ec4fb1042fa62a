// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.function.DoubleFunction;

/**
 * What makes the steps of a run shorter than its tolerance does, so that its error is smaller than was asked for and yet no
 * tolerance or estimate would have saved anything. Work is counted in evaluations of the forces, exactly.
 */
final class Held {
    /** Part of the work below which another run is a cheaper one. */
    private static final double CHEAPER = 0.9;

    /** From one tolerance to the next coarser one that is tried, and the coarsest of all. */
    private static final double COARSER = Math.pow(10, 0.25);

    private static final double COARSEST = 0.1;

    private final ReportScene scene;
    private final Curve curve;
    private final double[][] reference;

    /** By what. */
    enum By {
        /** The tolerance. */
        NOTHING,
        /**
         * No coarser tolerance that can be relied on would have met this one with a tenth fewer evaluations: going to coarser
         * ones in quarters of a decade, errors are larger than this one asks for before that much is saved.
         */
        COARSEST,
        /**
         * The steps of an explicit method are longer than the time in which a part of the motion dies away, so that they go by
         * its stability, and errors in that part, which are what is estimated, are forgotten at once.
         */
        STABILITY,
        /** The engine's steps: with a single one for the whole scene the method takes a tenth fewer evaluations. */
        OUTPUT
    }

    Held(ReportScene scene, Curve curve) {
        this.scene = scene;
        this.curve = curve;
        reference = scene.expected == null ? null : scene.expected.get();
    }

    /** What holds a run whose error is smaller than its tolerance asks for. */
    By by(Point point, double grown) {
        DoubleFunction<Point> run = tolerance -> Measurement.untimed(scene, curve, tolerance, reference);
        if (isCoarsest(point, run, point.setting * grown / scene.unit)) {
            return By.COARSEST;
        }
        if (step(point, curve, scene.duration) * decay(scene.model) > 1) {
            return By.STABILITY;
        }
        return work(point) * CHEAPER > alone(point.setting) ? By.OUTPUT : By.NOTHING;
    }

    /**
     * Whether no coarser setting can be relied on for an error as small as asked for and is cheaper.
     *
     * @param run of a setting; null if that is too coarse for the method
     */
    static boolean isCoarsest(Point point, DoubleFunction<Point> run, double asked) {
        for (double setting = COARSER * point.setting; setting <= COARSEST; setting *= COARSER) {
            Point coarser = run.apply(setting);
            if (coarser == null || coarser.error > asked) {
                return true;
            }
            if (work(coarser) < CHEAPER * work(point)) {
                return false;
            }
        }
        return true;
    }

    static long work(Point point) {
        return point.counts.getOrDefault("forces", 0L);
    }

    /** The mean step of a method that is explicit and has the same number of stages in each; else 0. */
    static double step(Point point, Curve curve, double duration) {
        return curve.method().equals("DOP853") ? 12 * duration / work(point) : 0;
    }

    /** The rate at which what dies away fastest does, 1/s: the root of s² + (c / m) s + k / m, or its real part. */
    static double decay(Model model) {
        double most = 0;
        for (Model.Elastic spring : model.springs) {
            double mass = model.parts.get(spring.a()).mass();
            double half = 0.5 * spring.damping() / mass;
            most = Math.max(most, half + Math.sqrt(Math.max(0, half * half - spring.stiffness() / mass)));
        }
        return most;
    }

    /** Evaluations with a single step of the engine. */
    private double alone(double tolerance) {
        if (scene.samples == 1) {
            return Double.POSITIVE_INFINITY;
        }
        try (World world = new OwnWorld(scene.model, curve.own().maker().apply(tolerance), scene.duration, true)) {
            world.step();
            return world.counts().get("forces");
        }
    }
}
