// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos;

import demos.collisions.Collisions;
import demos.collisions.CollisionsWithUI;
import java.awt.Color;
import java.io.File;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import sim.engine.MakesSimState;
import sim.engine.SimState;
import sim.physics.mason.Picture;
import sim.util.Properties;

/**
 * Runs a demo by its name.
 *
 * <pre>
 *   collisions [-for STEPS] [-seed SEED] [-p name=value …] [-png FILE]    runs headless and sums up
 *   collisions -gui                                                       opens MASON's console
 *   collisions -mason [MASON's own options] [-p name=value …]             runs MASON's command-line loop
 * </pre>
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
        String name = rest.remove(0);
        if (!name.equals("collisions")) {
            throw new IllegalArgumentException("demo is " + name + ": there is only collisions");
        }
        if (rest.remove("-gui")) {
            CollisionsWithUI.main(new String[0]);
        } else if (rest.remove("-mason")) {
            SimState.doLoop(new MakesCollisions(), rest.toArray(new String[0]));
        } else {
            collisions(rest);
        }
    }

    /** Makes the model and sets what {@code -p name=value} asks for, with every version of MASON. */
    private static final class MakesCollisions implements MakesSimState {
        @Override
        public SimState newInstance(long seed, String[] args) {
            Collisions model = new Collisions(seed);
            setParameters(model, Arrays.asList(args));
            return model;
        }

        @Override
        public Class<?> simulationClass() {
            return Collisions.class;
        }
    }

    private static void collisions(List<String> args) throws IOException {
        long steps = Long.parseLong(option(args, "-for", "10000"));
        long seed = Long.parseLong(option(args, "-seed", "1"));
        File file = new File(option(args, "-png", "target/collisions.png"));
        Collisions model = new Collisions(seed);
        setParameters(model, args);
        model.start();
        double energy = model.physics.kineticEnergy();
        long begun = System.nanoTime();
        for (long k = 0; k < steps; k++) {
            if (!model.schedule.step(model)) {
                break;
            }
            if (System.console() != null && k % Math.max(1, steps / 50) == 0) {
                System.err.print("\r" + 100 * k / steps + " %");
            }
        }
        double seconds = 1e-9 * (System.nanoTime() - begun);
        if (System.console() != null) {
            System.err.print("\r      \r");
        }
        draw(model, file);
        print("steps", model.physics.getSteps());
        print("bodies", model.physics.bodies().size());
        print("impacts", model.physics.getImpacts());
        print("energy at start", energy);
        print("energy at end", model.physics.kineticEnergy());
        print("change of energy", energy == 0 ? 0 : model.physics.kineticEnergy() / energy - 1);
        print("deepest penetration", model.physics.getDeepestPenetration());
        print("steps per second", Math.round(steps / seconds));
        print("picture", file.getPath());
        model.finish();
    }

    private static void print(String name, Object value) {
        System.out.printf(Locale.ROOT, "%-20s %s%n", name, value);
    }

    private static void draw(Collisions model, File file) throws IOException {
        if (file.getAbsoluteFile().getParentFile() != null) {
            file.getAbsoluteFile().getParentFile().mkdirs();
        }
        double world = Collisions.WORLD;
        new Picture(0, 0, world, world, 4, new Color(0, 80, 0), body -> body.isFixed() ? Color.WHITE : Color.RED)
                .write(model.physics, file);
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
