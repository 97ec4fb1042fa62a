// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.scenes;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import sim.physics.scenes.SceneData.Box;
import sim.physics.scenes.SceneData.Kind;

/** Collects the bodies of a {@link SceneData} one by one. */
final class SceneBuilder {
    private final String name;
    private final Kind[] kind;
    private final double[][] columns;
    private int count;

    /** Makes room for a number of bodies. */
    SceneBuilder(String name, int bodies) {
        this.name = name;
        kind = new Kind[bodies];
        columns = new double[9][bodies];
    }

    /** Adds a body whose mass is its area. */
    void add(Kind what, double sizeA, double sizeB, double[] pose, double[] velocity) {
        kind[count] = what;
        double[] values = {sizeA, sizeB, pose[0], pose[1], pose[2], velocity[0], velocity[1], velocity[2]};
        for (int c = 0; c < values.length; c++) {
            columns[c][count] = values[c];
        }
        count++;
    }

    /** The scene, between four walls around a space. */
    SceneData build(Box inner, double wallThickness, double dt) {
        double[][] c = columns;
        SceneData scene = new SceneData(
                name, kind, c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8], walls(inner, wallThickness), inner, 1, dt);
        Arrays.setAll(scene.mass(), scene::area);
        return scene;
    }

    /** Walls from centre line to centre line, as the original's demo has them; the inner corners are closed. */
    private static List<Box> walls(Box inner, double t) {
        double width = inner.width() + t;
        double height = inner.height() + t;
        List<Box> walls = new ArrayList<>();
        walls.add(new Box(inner.x(), inner.y() - height / 2, width, t));
        walls.add(new Box(inner.x(), inner.y() + height / 2, width, t));
        walls.add(new Box(inner.x() - width / 2, inner.y(), t, height));
        walls.add(new Box(inner.x() + width / 2, inner.y(), t, height));
        return walls;
    }
}
