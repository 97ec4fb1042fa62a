// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

import java.io.Serializable;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import sim.physics.collision.broad.Boxes;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;
import sim.physics.internal.Trig;
import sim.physics.motion.Trajectories;
import sim.physics.shape.Shape;

/**
 * The shapes of all bodies as numbers for the kernels. Equal shapes are stored once, and shapes of several parts part by part.
 *
 * <pre>
 *   base + 0  vertices n     1  rounding radius     2  bounding radius     3  core radius     4  number of bodies that have it
 *   base + 5  1 for a circle that is a whole body
 *   base + 6 + 6k   x, y of vertex k · nx, ny outward normal of edge k (to vertex k + 1) · h = vertex · normal · length
 * </pre>
 *
 * <p>The core of a shape is its polygon of vertices; the shape is all that is within the rounding radius of the core.
 * A circle's core is a point. The core radius is that of the farthest vertex.
 */
public final class ShapeTable implements Serializable {
    private static final long serialVersionUID = 2L;

    static final int COUNT = 0;
    static final int ROUNDING = 1;
    static final int BOUNDING = 2;
    static final int CORE = 3;
    static final int USERS = 4;
    static final int ROUND = 5;
    static final int FIRST = 6;
    static final int VERTEX = 6;
    static final int NX = 2;
    static final int NY = 3;
    static final int H = 4;
    static final int LENGTH = 5;

    private double[] data = new double[64];
    private int used;
    private int[] baseOf = new int[8];

    /** By body the bases of its parts; null for most bodies, and until one has several. */
    private int[][] partsOf;
    private final Map<Shape, Integer> known = new HashMap<>();

    /** The same the other way round. */
    private final Map<Integer, Shape> shapes = new HashMap<>();

    /** Places of shapes that nobody has any more, by their number of vertices. */
    private final Map<Integer, IntList> free = new HashMap<>();

    /** Makes an empty table. */
    public ShapeTable() {
        // shapes come with the bodies
    }

    double[] data() {
        return data;
    }

    int base(int body) {
        return baseOf[body];
    }

    /** Where a part of a body's shape begins. */
    int base(int body, int part) {
        return part == 0 ? baseOf[body] : partsOf[body][part];
    }

    boolean isCircle(int body) {
        return data[baseOf[body] + ROUND] == 1;
    }

    /** Whether a shape is a disc whose centre goes round with the body that it is a part of. */
    boolean goesRound(int base) {
        return data[base + COUNT] == 1 && data[base + ROUND] == 0;
    }

    /** The radius by which a shape reaches beyond its vertices. */
    double rounding(int body) {
        return data[baseOf[body] + ROUNDING];
    }

    /** The edge of a polygon whose line a point of the polygon's frame is highest above. */
    int facingEdge(int base, double x, double y) {
        int facing = 0;
        double most = Double.NEGATIVE_INFINITY;
        int n = (int) data[base + COUNT];
        for (int k = 0, e = base + FIRST; k < n; k++, e += VERTEX) {
            double height = data[e + NX] * x + data[e + NY] * y - data[e + H];
            if (height > most) {
                most = height;
                facing = k;
            }
        }
        return facing;
    }

    /** The vertex of a shape that is least far in a direction of the shape's frame. */
    int lowestVertex(int base, double x, double y) {
        int lowest = 0;
        double least = Double.POSITIVE_INFINITY;
        int n = (int) data[base + COUNT];
        for (int k = 0, v = base + FIRST; k < n; k++, v += VERTEX) {
            double depth = x * data[v] + y * data[v + 1];
            if (depth < least) {
                least = depth;
                lowest = k;
            }
        }
        return lowest;
    }

    /** Whether a vertex's neighbours lie no less far than a depth in a direction of the shape's frame. */
    boolean isLowest(int base, int vertex, double x, double y, double depth) {
        int n = (int) data[base + COUNT];
        int after = base + FIRST + VERTEX * (vertex + 1 == n ? 0 : vertex + 1);
        int before = base + FIRST + VERTEX * (vertex == 0 ? n - 1 : vertex - 1);
        return n == 1 || x * data[after] + y * data[after + 1] >= depth && x * data[before] + y * data[before + 1] >= depth;
    }

    /**
     * Notes the shape of a body.
     *
     * @param body index
     * @param shape its shape
     */
    public void set(int body, Shape shape) {
        if (body >= baseOf.length) {
            baseOf = Arrays.copyOf(baseOf, Growth.length(baseOf.length, body + 1));
        }
        if (partsOf != null && body < partsOf.length) {
            partsOf[body] = null;
        }
        if (shape.partCount() == 1) {
            baseOf[body] = use(shape, shape.vertexCount() == 1);
            return;
        }
        int[] bases = new int[shape.partCount()];
        for (int k = 0; k < bases.length; k++) {
            bases[k] = use(shape.part(k), false);
        }
        baseOf[body] = bases[0];
        partsOf = Arrays.copyOf(partsOf == null ? new int[0][] : partsOf, baseOf.length);
        partsOf[body] = bases;
    }

    private int use(Shape shape, boolean isRound) {
        Integer base = known.get(shape);
        if (base == null) {
            base = append(shape, isRound);
            known.put(shape, base);
            shapes.put(base, shape);
        }
        data[base + USERS]++;
        return base;
    }

    /**
     * Forgets the shape of a body, and gives its place away if nobody else has it.
     *
     * @param body index
     */
    public void remove(int body) {
        boolean isWhole = partsOf == null || body >= partsOf.length || partsOf[body] == null;
        for (int k = 0, parts = isWhole ? 1 : partsOf[body].length; k < parts; k++) {
            int base = base(body, k);
            if (--data[base + USERS] == 0) {
                Shape part = shapes.remove(base);
                known.remove(part);
                free.computeIfAbsent(part.vertexCount(), n -> new IntList()).add(base);
            }
        }
    }

    /** Where to put a shape: where one of as many vertices was, or at the end. */
    private int place(int n) {
        IntList places = free.get(n);
        if (places != null && places.size > 0) {
            return places.values[--places.size];
        }
        int base = used;
        used += FIRST + VERTEX * n;
        if (used > data.length) {
            data = Arrays.copyOf(data, Math.max(2 * data.length, used));
        }
        return base;
    }

    private int append(Shape shape, boolean isRound) {
        int n = shape.vertexCount();
        int base = place(n);
        data[base + COUNT] = n;
        data[base + ROUND] = isRound ? 1 : 0;
        data[base + ROUNDING] = shape.radius();
        data[base + BOUNDING] = shape.boundingRadius();
        double core = 0;
        for (int k = 0; k < n; k++) {
            int o = base + FIRST + VERTEX * k;
            double x = shape.vertexX(k);
            double y = shape.vertexY(k);
            double ex = shape.vertexX((k + 1) % n) - x;
            double ey = shape.vertexY((k + 1) % n) - y;
            double length = Math.sqrt(ex * ex + ey * ey);
            data[o] = x;
            data[o + 1] = y;
            data[o + NX] = n > 1 ? ey / length : 0;
            data[o + NY] = n > 1 ? -ex / length : 0;
            data[o + H] = x * data[o + NX] + y * data[o + NY];
            data[o + LENGTH] = length;
            core = Math.max(core, Math.sqrt(x * x + y * y));
        }
        data[base + CORE] = core;
        return base;
    }

    /**
     * Fits a box around a body that stands still.
     *
     * @param body index
     * @param trajectories the motions
     * @param at where the body's motion begins in that array
     * @param boxes takes the box
     */
    public void encloseFixed(int body, double[] trajectories, int at, Boxes boxes) {
        double cos = Trig.cos(trajectories[at + Trajectories.THETA0]);
        double sin = Trig.sin(trajectories[at + Trajectories.THETA0]);
        int count = partsOf == null || body >= partsOf.length || partsOf[body] == null ? 1 : partsOf[body].length;
        double minX = Double.POSITIVE_INFINITY;
        double minY = Double.POSITIVE_INFINITY;
        double maxX = Double.NEGATIVE_INFINITY;
        double maxY = Double.NEGATIVE_INFINITY;
        for (int part = 0; part < count; part++) {
            int base = base(body, part);
            double r = data[base + ROUNDING];
            for (int k = 0, o = base + FIRST; k < data[base + COUNT]; k++, o += VERTEX) {
                double x = cos * data[o] - sin * data[o + 1];
                double y = sin * data[o] + cos * data[o + 1];
                minX = Math.min(minX, x - r);
                minY = Math.min(minY, y - r);
                maxX = Math.max(maxX, x + r);
                maxY = Math.max(maxY, y + r);
            }
        }
        double x = trajectories[at];
        double y = trajectories[at + 1];
        boxes.set(body, x + minX, y + minY, x + maxX, y + maxY);
    }
}
