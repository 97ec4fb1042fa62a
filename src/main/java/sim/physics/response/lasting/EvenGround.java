// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import sim.physics.collision.narrow.Manifold;

/**
 * A circle that rests on straight edges of what is fixed: however far it slides, rolls or spins there, normals and levers stay
 * what they are, and so do the forces that were found, up to the ends of the edges.
 */
final class EvenGround implements Serializable {
    private static final long serialVersionUID = 1L;

    /** How far beyond the end of an edge a body is to be found, relative to its radius: there it is seen that the normal turns. */
    private static final double BEYOND = 1e-6;

    /** Distance from the ends of the edges, length; not positive if the ground is not even. */
    private double room;

    private double speed;

    /** Begins a cluster of some bodies: more than one lie on one another, too. */
    void begin(int bodies) {
        room = bodies == 1 ? Double.POSITIVE_INFINITY : 0;
    }

    /** Takes in where the body touches something fixed. */
    void add(Manifold m, boolean isFirst) {
        boolean isRound = isFirst ? m.roundA : m.roundB;
        room = isRound && m.count == 1 ? Math.min(room, m.room) : 0;
    }

    /** Takes the body's velocity. */
    void move(double vx, double vy) {
        speed = Math.sqrt(vx * vx + vy * vy);
    }

    /** For how long a body of a radius with an acceleration surely stays on the edges; 0 if nothing can be said. */
    double time(double ax, double ay, double radius) {
        if (!(room > 0 && room < Double.POSITIVE_INFINITY)) {
            return 0;
        }
        double way = room + BEYOND * radius;
        double most = Math.sqrt(speed * speed + 2 * way * Math.sqrt(ax * ax + ay * ay));
        return 2 * way / (speed + most);
    }
}
