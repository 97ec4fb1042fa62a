// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.robots;

import demos.Scene;
import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import sim.physics.motion.Body;
import sim.physics.motion.ViscousFriction;
import sim.physics.shape.Rectangle;

/**
 * The write-up's <i>robots</i>: grey robots fetch blue cans and carry them to the top of the screen; when all are there they
 * return to where they were (Figure 2).
 */
public class Robots extends Scene {
    private static final long serialVersionUID = 1L;

    private static final int MAX_TRIES = 100_000;

    public final List<Collector> robots = new ArrayList<>();
    public final List<Can> cans = new ArrayList<>();

    private int numberOfRobots = 2;
    private int numberOfCans = 4;

    public Robots(long seed) {
        super(seed);
    }

    @Override
    protected void build() {
        physics.add(new ViscousFriction(0.1));
        physics.add(new Robot.Drive());
        physics.addListener(new Collector.Grip());
        robots.clear();
        cans.clear();
        wall(193, 6, 100, 0);
        wall(193, 6, 100, 200);
        wall(6, 200, 0, 100);
        wall(6, 200, 200, 100);
        for (int k = 0; k < numberOfRobots; k++) {
            Collector robot = new Collector(physics, cans);
            place(robot, 20, 180, 50, 180, 15);
            robot.assemble();
            robots.add(robot);
            repeat(robot, 0);
        }
        for (int k = 0; k < numberOfCans; k++) {
            Can can = new Can();
            place(can, 10, 190, 60, 190, 2);
            cans.add(physics.add(can));
        }
    }

    @Override
    public Color ground() {
        return Color.BLACK;
    }

    @Override
    public Color colour(Body body) {
        return body.isFixed() ? Color.WHITE : body instanceof Can ? Color.BLUE : Color.GRAY;
    }

    private void wall(double width, double height, double x, double y) {
        physics.add(Body.fixed(new Rectangle(width, height)).at(x, y));
    }

    /** Puts a body where nothing is. */
    private void place(Body body, double left, double right, double top, double bottom, double radius) {
        for (int tries = 0; tries < MAX_TRIES; tries++) {
            double x = left + random.nextDouble() * (right - left);
            double y = top + random.nextDouble() * (bottom - top);
            if (isFree(x, y, radius)) {
                body.setPosition(x, y);
                return;
            }
        }
        throw new IllegalStateException(numberOfRobots + " robots and " + numberOfCans + " cans were asked for: only "
                + robots.size() + " robots and " + cans.size() + " cans fit");
    }

    private boolean isFree(double x, double y, double radius) {
        for (Collector robot : robots) {
            if (robot.distance(x, y) < radius + 15) {
                return false;
            }
        }
        for (Can can : cans) {
            double dx = can.getX() - x;
            double dy = can.getY() - y;
            if (dx * dx + dy * dy < (radius + 2) * (radius + 2)) {
                return false;
            }
        }
        return true;
    }

    /** Whether all cans are at home and all robots too. */
    public boolean isDone() {
        for (Can can : cans) {
            if (!can.isHome()) {
                return false;
            }
        }
        for (Collector robot : robots) {
            if (!robot.isHome()) {
                return false;
            }
        }
        return true;
    }

    /** Cans at the top that nobody holds. */
    public int getCansAtHome() {
        int count = 0;
        for (Can can : cans) {
            count += can.isHome() ? 1 : 0;
        }
        return count;
    }

    public int getRobots() {
        return numberOfRobots;
    }

    /** Takes effect at the next start. */
    public void setRobots(int number) {
        numberOfRobots = notNegative("robots", number);
    }

    public int getCans() {
        return numberOfCans;
    }

    /** Takes effect at the next start. */
    public void setCans(int number) {
        numberOfCans = notNegative("cans", number);
    }

    private static int notNegative(String name, int number) {
        if (number < 0) {
            throw new IllegalArgumentException(name + " is " + number + ": it must not be negative");
        }
        return number;
    }

    public static void main(String[] args) {
        doLoop(Robots.class, args);
        System.exit(0);
    }
}
