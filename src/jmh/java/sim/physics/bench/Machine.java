// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Random;
import java.util.function.Consumer;

/** Machines on the ground, and what their controllers do. */
final class Machine {
    /** Radius of a wheel, m. */
    static final double RADIUS = 0.4;

    /** Speed that the motors of wheels ask for, rad/s. */
    static final double SPIN = -8;

    static final Map<String, Consumer<Machine>> ALL = new LinkedHashMap<>();

    static {
        ALL.put("car", Machine::car);
        ALL.put("springs", Machine::springs);
        ALL.put("bumps", Machine::bumps);
        ALL.put("tank", Machine::tank);
        ALL.put("walker", Machine::walker);
        ALL.put("ragdoll", Machine::ragdoll);
        ALL.put("gripper", Machine::gripper);
        ALL.put("stack", m -> m.stack(10));
        ALL.put("pyramid", m -> m.pyramid(10));
        ALL.put("boxes", m -> m.pile(40, 0));
        ALL.put("mixed", m -> m.pile(40, 0.5));
        ALL.put("discs", m -> m.pile(40, 1));
        ALL.put("hooks", m -> m.hooks(40));
        ALL.put("ragdolls", m -> m.ragdolls(24));
        ALL.put("heap", m -> m.pile(200, 0.5));
    }

    private final MachineWorld world;

    /** The body whose place and velocity tell how it went. */
    int main;

    private int[] hinges = {};
    private int taken = -1;

    Machine(String name, MachineWorld world) {
        this.world = world;
        ALL.get(name).accept(this);
    }

    /** Bodies that fall into a bin, in any number. */
    Machine(int bodies, MachineWorld world) {
        this.world = world;
        pile(bodies, 0.5);
    }

    /** What the controller does before a step. */
    void control(int step) {
        for (int k = 0; k < hinges.length; k++) {
            world.drive(hinges[k], 1.5 * StrictMath.sin(step * 0.05 + k * 1.7));
        }
        if (step == 120 && taken >= 0) {
            world.remove(taken);
        }
    }

    private void ground(double friction) {
        world.box(400, 2, 0, -1, friction, true);
    }

    private void wheel(double x, double torque) {
        int wheel = world.disc(RADIUS, x, RADIUS, 0.9);
        world.pin(main, wheel, x, RADIUS);
        world.motor(wheel, SPIN, torque);
    }

    private void car() {
        ground(0.9);
        main = world.box(3, 0.5, 0, 0.8, 0.9, false);
        wheel(-1, 6);
        wheel(1, 6);
    }

    private void springs() {
        ground(0.9);
        main = world.box(3, 0.5, 0, 1.3, 0.9, false);
        for (int x = -1; x <= 1; x += 2) {
            int wheel = world.disc(RADIUS, x, RADIUS, 0.9);
            world.suspend(main, wheel, x, RADIUS, 0.04, 400, 20);
            world.motor(wheel, SPIN, 5);
        }
    }

    private void bumps() {
        car();
        for (int k = 0; k < 12; k++) {
            world.box(0.6, 0.1, 4 + 2.2 * k, 0.05, 0.9, true);
        }
    }

    private void tank() {
        ground(0.9);
        main = world.box(6, 0.5, 0, 0.8, 0.9, false);
        for (int k = 0; k < 6; k++) {
            wheel(k - 2.5, 3);
        }
    }

    private int limb(double width, double height, double x, double y, double friction, int on, double hinge) {
        int limb = world.box(width, height, x, y, friction, false);
        world.pin(on, limb, x, hinge);
        return limb;
    }

    /** Two legs of two links, with motors at hips and knees and stops at the knees. */
    private void walker() {
        ground(0.9);
        main = world.box(1, 0.6, 0, 2.3, 0.9, false);
        hinges = new int[4];
        for (int side = 0; side < 2; side++) {
            double x = 0.6 * side - 0.3;
            int thigh = limb(0.2, 1, x, 1.5, 0.9, main, 2);
            int shin = limb(0.2, 1, x, 0.5, 0.9, thigh, 1);
            world.motor(thigh, 0, 40);
            world.motor(shin, 0, 30);
            world.stops(shin, -1, 1);
            hinges[2 * side] = thigh;
            hinges[2 * side + 1] = shin;
        }
    }

    /** A trunk with arms and legs that is thrown and lies. */
    private void ragdoll() {
        ground(0.6);
        figure(0, 0);
        world.launch(2, 0);
    }

    /** A trunk with arms and legs that stands. */
    private void figure(double at, double foot) {
        main = world.box(0.5, 1, at, foot + 3, 0.6, false);
        for (int side = -1; side <= 1; side += 2) {
            double shoulder = at + side * 0.35;
            int arm = world.box(0.15, 0.8, shoulder, foot + 3, 0.6, false);
            world.pin(main, arm, shoulder, foot + 3.4);
            world.stops(arm, -1.5, 1.5);
            double hip = at + side * 0.15;
            int thigh = limb(0.2, 1, hip, foot + 2, 0.6, main, foot + 2.5);
            world.stops(thigh, -0.8, 0.8);
            int shin = limb(0.2, 1, hip, foot + 1, 0.6, thigh, foot + 1.5);
            world.stops(shin, -1.2, 1.2);
        }
    }

    /** Such figures that fall into a bin. */
    private void ragdolls(int n) {
        int columns = (int) StrictMath.ceil(StrictMath.sqrt(2 * n));
        double width = 1.5 * columns;
        bin(width, 4 * width);
        Random random = new Random(7);
        for (int k = 0; k < n; k++) {
            figure(1.5 * (k % columns + 0.5) + 0.2 * random.nextDouble(), 0.5 + 3.5 * (k / columns));
        }
    }

    /** A floor between two walls. */
    private void bin(double width, double height) {
        world.box(Math.max(400, 4 * width), 2, 0, -1, 0.5, true);
        world.box(1, height, -0.5, height / 2, 0.5, true);
        world.box(1, height, width + 0.5, height / 2, 0.5, true);
    }

    /** Two fingers that press a box between them, one braked, and bear it when its support is taken away after 2 s. */
    private void gripper() {
        ground(0.6);
        int base = world.box(1.6, 0.4, 0, 4, 0.6, true);
        taken = world.box(0.5, 0.8, 0, 0.4, 0.6, true);
        main = world.box(0.8, 0.8, 0, 1.2, 0.9, false);
        int left = limb(0.2, 2.7, -0.51, 2.35, 0.9, base, 3.7);
        int right = limb(0.2, 2.7, 0.51, 2.35, 0.9, base, 3.7);
        world.motor(left, 0.3, 100);
        world.stops(left, -0.5, 0.004);
        world.motor(right, -0.3, 40);
    }

    /** Boxes on one another. */
    private void stack(int n) {
        ground(0.6);
        for (int k = 0; k < n; k++) {
            main = world.box(1, 1, 0.02 * (k % 2), k + 0.5, 0.6, false);
        }
    }

    /** Rows of boxes, each on two of the row below. */
    private void pyramid(int rows) {
        ground(0.6);
        for (int row = 0; row < rows; row++) {
            for (int k = 0; k < rows - row; k++) {
                main = world.box(1, 1, 1.1 * k + 0.55 * row, row + 0.5, 0.6, false);
            }
        }
    }

    /** L-shapes that fall into a bin, each one body of two boxes. */
    private void hooks(int n) {
        double[][] hook = {{0.175, -0.325, 1, 0.3}, {-0.175, 0.325, 0.3, 1}};
        world.box(100, 2, 0, -1, 0.5, true);
        world.box(1, 40, -6, 20, 0.5, true);
        world.box(1, 40, 6, 20, 0.5, true);
        Random random = new Random(7);
        for (int k = 0; k < n; k++) {
            main = world.boxes(hook, -4.4 + 1.6 * (k % 6) + 0.2 * random.nextDouble(), 1 + 1.6 * (k / 6), 0.5);
        }
    }

    /** Bodies of different size that fall into a bin; a share of them are discs. */
    private void pile(int n, double discs) {
        int columns = (int) StrictMath.ceil(StrictMath.sqrt(n));
        double width = 1.25 * columns;
        bin(width, 4 * width);
        Random random = new Random(7);
        for (int k = 0; k < n; k++) {
            double x = 1.25 * (k % columns + 0.5) + 0.05 * random.nextDouble();
            double y = 1.25 * (k / columns + 0.5) + 0.05 * random.nextDouble();
            double size = 0.5 + 0.5 * random.nextDouble();
            boolean round = (k * 7 % 10) < 10 * discs;
            main = round ? world.disc(size / 2, x, y, 0.5) : world.box(size, 0.5 + 0.3 * random.nextDouble(), x, y, 0.5, false);
        }
    }
}
