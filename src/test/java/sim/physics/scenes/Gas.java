// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.scenes;

import sim.physics.scenes.SceneData.Box;
import sim.physics.scenes.SceneData.Kind;

/**
 * Elastic gases without friction, the scenes on which speed is compared. Equal arguments give equal bits on every JVM;
 * no bodies overlap or touch at the start.
 */
public final class Gas {
    /**
     * The share of the area that Figure 1 of the write-up has covered: 50 circles of radius 5 and 50 rectangles 5 × 10,
     * total area 6426.99, in the square from 3 to 197, 0.17077.
     */
    public static final double FIGURE_1_FRACTION = (50 * Math.PI * 25 + 50 * 50) / (194.0 * 194.0);

    /** Tries for one body before the scene counts as full. */
    private static final int TRIES = 20_000;

    private static final double WALL = 6;

    private Gas() {}

    /**
     * Scene S3 of the comparison of peers: a checkerboard of disks r = 0.5 and boxes 1 × 0.7854, both of area 0.7854, on
     * a jittered grid, random angles, each velocity component uniform in [-5, 5], spin in [-2, 2], dt = 1/60, walls 5
     * thick. Total area 0.7854 n, a fifth of the inner square, whose side is sqrt(n 0.7854/0.2) and whose centre is the
     * origin.
     *
     * @param n number of bodies
     * @param seed of the random numbers
     * @return the scene
     */
    public static SceneData s3(int n, long seed) {
        checkBodies(n);
        double boxHeight = 0.7854;
        double side = Math.sqrt(n * 0.7854 / 0.2);
        int cells = (int) Math.ceil(Math.sqrt(n));
        double pitch = side / cells;
        double boxRadius = 0.5 * Math.sqrt(1 + boxHeight * boxHeight);
        // neighbours are a disk and a box; 0.9: they do not touch
        double jitter = 0.9 * Math.min((pitch - 0.5 - boxRadius) / 2, pitch / 2 - boxRadius);
        SplitMix64 random = new SplitMix64(seed);
        SceneBuilder scene = new SceneBuilder("s3(" + n + ", " + seed + ")", n);
        for (int k = 0; k < n; k++) {
            int row = k / cells;
            int column = k % cells;
            double[] pose = {
                (column + 0.5) * pitch - side / 2 + random.between(-jitter, jitter),
                (row + 0.5) * pitch - side / 2 + random.between(-jitter, jitter),
                random.between(-Math.PI, Math.PI)
            };
            double[] velocity = {random.between(-5, 5), random.between(-5, 5), random.between(-2, 2)};
            boolean disk = (row + column) % 2 == 0;
            scene.add(disk ? Kind.CIRCLE : Kind.RECTANGLE, disk ? 0.5 : 1, disk ? 0 : boxHeight, pose, velocity);
        }
        return scene.build(new Box(0, 0, side, side), 5, 1.0 / 60);
    }

    /**
     * Figure 1 of the write-up with any number of bodies: alternately circles r = 5 and rectangles 5 × 10, not turned and
     * not spinning, velocities as in the original's demo (those of rectangles doubled), dt = 1, walls 6 thick. Total
     * area 128.54 per pair. The inner square's lower corner is (3, 3); with {@link #FIGURE_1_FRACTION} and 100 bodies it
     * is that of the figure, 3 … 197, and with 0.17 it is 3 … 197.44.
     *
     * @param n number of bodies
     * @param areaFraction the share of the inner square to cover, at most about 0.4
     * @param seed of the random numbers
     * @return the scene
     * @throws IllegalStateException if the bodies do not fit; the message says how many do
     */
    public static SceneData figure1(int n, double areaFraction, long seed) {
        checkBodies(n);
        if (!(areaFraction > 0 && areaFraction < 1)) {
            throw new IllegalArgumentException("areaFraction is " + areaFraction + ": it must lie between 0 and 1");
        }
        double area = (n + 1) / 2 * (Math.PI * 25) + n / 2 * 50.0;
        double side = Math.sqrt(area / areaFraction);
        Box inner = new Box(3 + side / 2, 3 + side / 2, side, side);
        return boxesAndCircles("figure1(" + n + ", " + areaFraction + ", " + seed + ")", n, 5, inner, seed);
    }

    /**
     * The original's collisions demo with its defaults: 5 circles r = 7 and 5 rectangles 7 × 14 (masses 153.94 and 98,
     * total area 1259.7) in the square 13 … 187, a share of 0.0416; velocities as in {@link #figure1}. Positions are
     * uniform, without the demo's overlaps.
     *
     * @param seed of the random numbers
     * @return the scene
     */
    public static SceneData demo(long seed) {
        return boxesAndCircles("demo(" + seed + ")", 10, 7, new Box(100, 100, 174, 174), seed);
    }

    /**
     * Regular triangles, squares … octagons in turn, all of circumradius 5, at the density of Figure 1, velocities as in
     * {@link #figure1} without doubling, random angles, spins in [-0.1, 0.1], dt = 1. Total area 346.0 per six bodies.
     *
     * @param n number of bodies
     * @param seed of the random numbers
     * @return the scene
     */
    public static SceneData polygons(int n, long seed) {
        checkBodies(n);
        double area = 0;
        for (int k = 0; k < n; k++) {
            int vertices = 3 + k % 6;
            area += 12.5 * vertices * StrictMath.sin(2 * Math.PI / vertices);
        }
        // the placing asks for room for the circumscribed circles, which is enough
        double side = Math.max(Math.sqrt(area / FIGURE_1_FRACTION), 10.5);
        Box inner = new Box(3 + side / 2, 3 + side / 2, side, side);
        SplitMix64 random = new SplitMix64(seed);
        SplitMix64 places = random.split();
        Placement placement = new Placement(inner, n);
        SceneBuilder scene = new SceneBuilder("polygons(" + n + ", " + seed + ")", n);
        for (int k = 0; k < n; k++) {
            double[] pose = placement.circle(5, places, TRIES);
            pose[2] = random.between(-Math.PI, Math.PI);
            double[] velocity = velocity(random, 1);
            velocity[2] = random.between(-0.1, 0.1);
            scene.add(Kind.POLYGON, 5, 3 + k % 6, pose, velocity);
        }
        return scene.build(inner, WALL, 1);
    }

    private static SceneData boxesAndCircles(String name, int n, double size, Box inner, long seed) {
        SplitMix64 random = new SplitMix64(seed);
        SplitMix64 places = random.split();
        Placement placement = new Placement(inner, n);
        SceneBuilder scene = new SceneBuilder(name, n);
        for (int k = 0; k < n; k++) {
            if (k % 2 == 0) {
                scene.add(Kind.CIRCLE, size, 0, placement.circle(size, places, TRIES), velocity(random, 1));
            } else {
                double[] pose = placement.box(size, 2 * size, places, TRIES);
                scene.add(Kind.RECTANGLE, size, 2 * size, pose, velocity(random, 2));
            }
        }
        return scene.build(inner, WALL, 1);
    }

    /** The demo's velocities: magnitudes in [0, 1), signs (+,+) 0.25, (+,-) 0.375, (-,+) 0.28125, (-,-) 0.09375. */
    private static double[] velocity(SplitMix64 random, double factor) {
        double vx = factor * random.nextDouble();
        double vy = factor * random.nextDouble();
        double sign = random.nextDouble();
        boolean right = sign < 0.625;
        boolean up = sign < 0.25 || sign >= 0.625 && sign < 0.90625;
        return new double[] {right ? vx : -vx, up ? vy : -vy, 0};
    }

    private static void checkBodies(int n) {
        if (n < 1) {
            throw new IllegalArgumentException("n is " + n + ": a gas has at least one body");
        }
    }
}
