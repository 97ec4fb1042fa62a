// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.util.ArrayList;
import java.util.List;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.SlotJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/** Bars with pins, and what is made of them. */
final class Frames {
    static final double G = 9.81;

    /** How flat the bars of a lift lie. */
    private static final double FLAT = 0.2;

    private Frames() {}

    /** {@return an engine of four substeps of 1/60 s, with gravity} */
    static PhysicsEngine falling() {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        engine.add(new Gravity(0, -G));
        return engine;
    }

    /** A bar between two points, of mass 1, that collides with nothing. */
    static Body bar(PhysicsEngine engine, double x0, double y0, double x1, double y1) {
        Body bar = Stepped.rough(new Body(new Rectangle(Math.hypot(x1 - x0, y1 - y0), 0.1)));
        bar.setMass(1);
        bar.setCollisionGroup(1, 0);
        return engine.add(bar.at((x0 + x1) / 2, (y0 + y1) / 2, Math.atan2(y1 - y0, x1 - x0)));
    }

    static PinJoint pin(PhysicsEngine engine, Body a, Body b, double x, double y) {
        return engine.add(new PinJoint(a, b, x, y));
    }

    /** {@return how high a lift is} */
    static double height(int stages) {
        return stages * 2 * Math.sin(FLAT);
    }

    /** {@return the platform of pairs of crossed bars on one another, as flat as 0.2 rad, which collides with what it may} */
    static Body lift(PhysicsEngine engine, int stages, double mass) {
        double width = 2 * Math.cos(FLAT);
        Body up = null;
        Body down = null;
        for (int k = 0; k < stages; k++) {
            double low = height(k);
            double high = height(k + 1);
            Body rising = bar(engine, 0, low, width, high);
            Body falling = bar(engine, width, low, 0, high);
            pin(engine, rising, falling, width / 2, (low + high) / 2);
            pin(engine, rising, down, 0, low);
            pin(engine, falling, up, width, low);
            up = rising;
            down = falling;
        }
        Body platform = Stepped.rough(engine.add(new Body(new Rectangle(2.2, 0.1)).at(width / 2, height(stages))));
        platform.setMass(mass);
        pin(engine, platform, down, 0, height(stages));
        engine.add(new SlotJoint(up, platform, width, height(stages), 1, 0));
        return platform;
    }

    /** {@return the lower bars of a girder of eight triangles, 31 bars of length and height 1, on a pin and in a slot; the first joint that is added holds it} */
    static List<Body> girder(PhysicsEngine engine) {
        List<Body> deck = new ArrayList<>();
        Body lastDown = null;
        for (int k = 0; k < 8; k++) {
            Body chord = bar(engine, k, 0, k + 1, 0);
            Body up = bar(engine, k, 0, k + 0.5, 1);
            Body down = bar(engine, k + 0.5, 1, k + 1, 0);
            pin(engine, chord, k == 0 ? null : deck.get(k - 1), k, 0);
            pin(engine, up, chord, k, 0);
            pin(engine, up, down, k + 0.5, 1);
            pin(engine, down, chord, k + 1, 0);
            if (k > 0) {
                Body top = bar(engine, k - 0.5, 1, k + 0.5, 1);
                pin(engine, top, lastDown, k - 0.5, 1);
                pin(engine, top, up, k + 0.5, 1);
            }
            deck.add(chord);
            lastDown = down;
        }
        engine.add(new SlotJoint(deck.get(7), null, 8, 0, 1, 0));
        return deck;
    }
}
