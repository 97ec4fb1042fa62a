// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import sim.physics.motion.Body;
import sim.physics.motion.State;
import sim.physics.query.Queries;
import sim.physics.query.RayHit;
import sim.physics.query.Ways;
import sim.physics.scenes.Gas;
import sim.physics.scenes.SceneData;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/**
 * Times questions about where bodies are, in the gas of half circles and half rectangles that covers a fifth of the area,
 * with its four walls: by the cells and by a look at all bodies, interleaved, on the same questions. Printed are the
 * medians over the rounds of the thread's CPU time a question, and the ratio's; then the time to lay the grid once, and
 * that of some rays after all bodies have moved. Both ways must give the same sum of answers.
 *
 * <pre>
 * QueryRun rounds n ...
 * QueryRun 9 100 1000 10000 100000
 * </pre>
 */
public final class QueryRun {
    private static final int QUESTIONS = 4096;

    /** Bodies that a way looks at in one round, about; cells look at few. */
    private static final double WORK = 2e7;

    private final State state = new State();
    private final double[] at = new double[4 * QUESTIONS];
    private final RayHit hit = new RayHit();
    private final Shape swept = new Rectangle(1, 0.5);
    private final List<Body> found = new ArrayList<>();
    private final double side;
    private final int n;

    private QueryRun(int n) {
        this.n = n;
        SceneData scene = Gas.s3(n, 1);
        side = scene.inner().width();
        for (int i = 0; i < n; i++) {
            boolean circle = scene.kind()[i] == SceneData.Kind.CIRCLE;
            double size = scene.sizeA()[i];
            state.add(new Body(circle ? new Circle(size) : new Rectangle(size, scene.sizeB()[i]))
                    .at(scene.x()[i], scene.y()[i], scene.theta()[i]));
        }
        for (SceneData.Box wall : scene.walls()) {
            state.add(Body.fixed(new Rectangle(wall.width(), wall.height())).at(wall.x(), wall.y()));
        }
        SplittableRandom random = new SplittableRandom(7);
        for (int k = 0; k < QUESTIONS; k++) {
            double angle = random.nextDouble(-Math.PI, Math.PI);
            at[4 * k] = random.nextDouble(-side / 2, side / 2);
            at[4 * k + 1] = random.nextDouble(-side / 2, side / 2);
            at[4 * k + 2] = Math.cos(angle);
            at[4 * k + 3] = Math.sin(angle);
        }
    }

    /** What is asked. */
    private enum Question {
        RAY,
        SHORT_RAY,
        ALL_ON_RAY,
        WITHIN,
        NEAREST,
        BOX,
        SWEEP,
        SHORT_SWEEP
    }

    /** One question; the sum of the answers to many says whether two ways agree. */
    private double ask(Queries ask, Question what, int k) {
        double x = at[4 * k];
        double y = at[4 * k + 1];
        double dx = at[4 * k + 2];
        double dy = at[4 * k + 3];
        found.clear();
        switch (what) {
            case RAY -> ask.rayCast(x, y, dx, dy, Double.POSITIVE_INFINITY, null, hit);
            case SHORT_RAY -> ask.rayCast(x, y, dx, dy, 3, null, hit);
            case ALL_ON_RAY -> {
                return ask.rayCastAll(x, y, dx, dy, Double.POSITIVE_INFINITY, null).size();
            }
            case WITHIN -> ask.within(x, y, 3, null, found);
            case NEAREST -> ask.nearest(x, y, 4, null, found);
            case BOX -> ask.inBox(x, y, x + 3, y + 3, null, found);
            case SWEEP -> ask.shapeCast(swept, x, y, k, dx, dy, Double.POSITIVE_INFINITY, null, hit);
            case SHORT_SWEEP -> ask.shapeCast(swept, x, y, k, dx, dy, 3, null, hit);
        }
        return what == Question.WITHIN || what == Question.NEAREST || what == Question.BOX ? found.size() : hit.distance();
    }

    /** Nanoseconds a question. */
    private double time(Queries ask, Question what, int questions, double[] sum) {
        sum[0] = 0;
        long start = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
        for (int k = 0; k < questions; k++) {
            double answer = ask(ask, what, k & QUESTIONS - 1);
            sum[0] += k < QUESTIONS / 16 ? answer : 0;
        }
        return (ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - start) / (double) questions;
    }

    private void compare(Question what, int rounds) {
        Queries[] ways = {Ways.cells(state), Ways.all(state)};
        int many = Math.max(QUESTIONS / 16, (int) (WORK / n));
        double[][] nanos = new double[3][rounds];
        for (int round = -3; round < rounds; round++) {
            double[] sums = new double[2];
            double[] sum = new double[1];
            double[] t = new double[2];
            for (int k = 0; k < 2; k++) {
                int way = k ^ round & 1;
                t[way] = time(ways[way], what, way == 0 ? 200_000 : many, sum);
                sums[way] = sum[0];
            }
            if (sums[0] != sums[1]) {
                throw new IllegalStateException(what + ": cells " + sums[0] + ", all " + sums[1]);
            }
            for (int way = 0; way < 2 && round >= 0; way++) {
                nanos[way][round] = t[way];
                nanos[2][round] = t[1] / t[0];
            }
        }
        System.out.printf(Locale.ROOT, "%7d %-10s cells %9.0f ns   all %9.0f ns   %7.1f x%n",
                n, what.name().toLowerCase(Locale.ROOT), median(nanos[0]), median(nanos[1]), median(nanos[2]));
    }

    private void lay(int rounds) {
        Queries cells = Ways.cells(state);
        double[] nanos = new double[rounds];
        int times = Math.max(10, 2_000_000 / n);
        for (int round = -3; round < rounds; round++) {
            long start = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
            for (int k = 0; k < times; k++) {
                state.placedAll();
                cells.rayCast(0, 0, 1, 0, 0, null, hit);
            }
            nanos[Math.max(0, round)] = (ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - start) / (double) times;
        }
        System.out.printf(Locale.ROOT, "%7d laying %.1f us, %.0f ns a body%n", n, median(nanos) / 1000, median(nanos) / n);
    }

    /** Time of some rays after all bodies have moved, with what they cause. */
    private void afterChange(int rays, int rounds) {
        Queries[] ways = {new Queries(state), Ways.cells(state), Ways.all(state)};
        double[][] nanos = new double[3][rounds];
        int times = Math.max(20, (int) (WORK / n / (rays + 10)));
        for (int round = -3; round < rounds; round++) {
            for (int way = 0; way < 3; way++) {
                int question = 0;
                long start = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
                for (int k = 0; k < times; k++) {
                    state.placedAll();
                    for (int m = 0; m < rays; m++) {
                        ask(ways[way], Question.RAY, question++ & QUESTIONS - 1);
                    }
                }
                nanos[way][Math.max(0, round)] =
                        (ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - start) / (double) times / 1000;
            }
        }
        System.out.printf(Locale.ROOT, "%7d %5d rays after a change: usual %9.2f us   cells %9.2f us   all %9.2f us%n",
                n, rays, median(nanos[0]), median(nanos[1]), median(nanos[2]));
    }

    private static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }

    /**
     * Runs the comparison.
     *
     * @param args rounds, numbers of bodies
     */
    public static void main(String[] args) {
        for (int k = 1; k < args.length; k++) {
            QueryRun run = new QueryRun(Integer.parseInt(args[k]));
            for (Question what : Question.values()) {
                run.compare(what, Integer.parseInt(args[0]));
            }
            run.lay(Integer.parseInt(args[0]));
            for (int rays : new int[] {1, 4, 7, 8, 16, 64, 256}) {
                run.afterChange(rays, Integer.parseInt(args[0]));
            }
        }
    }
}
