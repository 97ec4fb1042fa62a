// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos;

import demos.bead.Bead;
import demos.bead.BeadWithUI;
import demos.collisions.Collisions;
import demos.collisions.CollisionsWithUI;
import demos.doors.Doors;
import demos.doors.DoorsWithUI;
import demos.machines.Machines;
import demos.machines.MachinesWithUI;
import demos.mill.Mill;
import demos.mill.MillWithUI;
import demos.pair.Pair;
import demos.pair.PairWithUI;
import demos.pendulum.Pendulum;
import demos.pendulum.PendulumWithUI;
import demos.robots.Robots;
import demos.robots.RobotsWithUI;
import java.io.File;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.LongFunction;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import sim.display.Console;
import sim.display.GUIState;
import sim.engine.MakesSimState;
import sim.engine.SimState;
import sim.physics.mason.Picture;
import sim.util.Properties;

/**
 * Runs a demo by its name.
 *
 * <pre>
 *   NAME [-for STEPS] [-seed SEED] [-p name=value …] [-png FILE]    runs headless and sums up
 *   NAME -gui                                                       opens MASON's console
 *   NAME -mason [MASON's own options] [-p name=value …]             runs MASON's command-line loop
 * </pre>
 *
 * <p>Names are collisions, robots, pendulum, bead, doors, pair, machines and mill.
 */
public final class Demos {
    private Demos() {}

    /** Runs the demo that the arguments name. */
    public static void main(String[] args) throws IOException {
        Thread.setDefaultUncaughtExceptionHandler((thread, problem) -> {
            problem.printStackTrace();
            Runtime.getRuntime().halt(1);
        });
        List<String> rest = new ArrayList<>(Arrays.asList(args.length == 0 ? new String[] {"collisions"} : args));
        Demo demo = demo(rest.remove(0));
        if (rest.remove("-gui")) {
            new Console(demo.display.get()).setVisible(true);
        } else if (rest.remove("-mason")) {
            SimState.doLoop(new Maker(demo), rest.toArray(new String[0]));
        } else {
            run(demo, rest);
        }
    }

    /** A demo: its name, its model and its display. */
    private record Demo(String name, LongFunction<Scene> model, Supplier<GUIState> display) {}

    private static final List<Demo> ALL = List.of(
            new Demo("collisions", Collisions::new, CollisionsWithUI::new),
            new Demo("robots", Robots::new, RobotsWithUI::new),
            new Demo("pendulum", Pendulum::new, PendulumWithUI::new),
            new Demo("bead", Bead::new, BeadWithUI::new),
            new Demo("doors", Doors::new, DoorsWithUI::new),
            new Demo("pair", Pair::new, PairWithUI::new),
            new Demo("machines", Machines::new, MachinesWithUI::new),
            new Demo("mill", Mill::new, MillWithUI::new));

    private static Demo demo(String name) {
        for (Demo demo : ALL) {
            if (demo.name.equals(name)) {
                return demo;
            }
        }
        throw new IllegalArgumentException("demo is " + name + ": there are "
                + ALL.stream().map(Demo::name).collect(Collectors.joining(", ")));
    }

    /** Makes the model and sets what {@code -p name=value} asks for, with every version of MASON. */
    private record Maker(Demo demo) implements MakesSimState {
        @Override
        public SimState newInstance(long seed, String[] args) {
            Scene model = demo.model.apply(seed);
            setParameters(model, Arrays.asList(args));
            return model;
        }

        @Override
        public Class<?> simulationClass() {
            return demo.model.apply(0).getClass();
        }
    }

    private static void run(Demo demo, List<String> args) throws IOException {
        long steps = Long.parseLong(option(args, "-for", "10000"));
        long seed = Long.parseLong(option(args, "-seed", "1"));
        File file = new File(option(args, "-png", "target/" + demo.name + ".png"));
        Scene model = demo.model.apply(seed);
        setParameters(model, args);
        model.start();
        double energy = model.physics.kineticEnergy();
        long begun = System.nanoTime();
        long k = 0;
        while (k < steps && !isDone(model) && model.schedule.step(model)) {
            if (System.console() != null && k % Math.max(1, steps / 50) == 0) {
                System.err.print("\r" + 100 * k / steps + " %");
            }
            k++;
        }
        double seconds = 1e-9 * (System.nanoTime() - begun);
        if (System.console() != null) {
            System.err.print("\r      \r");
        }
        draw(model, file);
        print("steps", model.physics.getSteps());
        print("bodies", model.physics.bodies().size());
        print("joints", model.physics.allConstraints().size());
        print("impacts", model.physics.getImpacts());
        if (model.physics.getTimeStepping() > 0) {
            print("asleep", model.physics.bodies().stream().filter(model.physics::isAsleep).count());
        }
        print("energy at start", energy);
        print("energy at end", model.physics.kineticEnergy());
        if (energy != 0) {
            print("change of energy", model.physics.kineticEnergy() / energy - 1);
        }
        if (model instanceof Robots robots) {
            print("cans at home", robots.getCansAtHome() + " of " + robots.getCans());
            print("all done", robots.isDone());
        }
        print("deepest penetration", model.physics.getDeepestPenetration());
        print("steps per second", Math.round(k / seconds));
        print("picture", file.getPath());
        model.finish();
    }

    private static boolean isDone(Scene model) {
        return model instanceof Robots robots && robots.isDone();
    }

    private static void print(String name, Object value) {
        System.out.printf(Locale.ROOT, "%-20s %s%n", name, value);
    }

    private static void draw(Scene model, File file) throws IOException {
        if (file.getAbsoluteFile().getParentFile() != null) {
            file.getAbsoluteFile().getParentFile().mkdirs();
        }
        new Picture(0, 0, Scene.WORLD, Scene.WORLD, 4, model.ground(), model::colour).write(model.physics, file);
    }

    private static String option(List<String> args, String name, String otherwise) {
        int k = args.indexOf(name);
        if (k < 0) {
            return otherwise;
        }
        if (k + 1 == args.size()) {
            throw new IllegalArgumentException(name + " is the last argument: it needs a value");
        }
        return args.get(k + 1);
    }

    private static void setParameters(SimState model, List<String> args) {
        for (int k = 0; k + 1 < args.size(); k++) {
            if (args.get(k).equals("-p")) {
                setParameter(model, args.get(k + 1));
            }
        }
    }

    private static void setParameter(SimState model, String assignment) {
        int equals = assignment.indexOf('=');
        Properties properties = Properties.getProperties(model);
        for (int k = 0; equals > 0 && k < properties.numProperties(); k++) {
            if (properties.getName(k).equalsIgnoreCase(assignment.substring(0, equals)) && properties.isReadWrite(k)) {
                properties.setValue(k, assignment.substring(equals + 1));
                return;
            }
        }
        throw new IllegalArgumentException("-p " + assignment + ": there is no such parameter of the demo");
    }
}
