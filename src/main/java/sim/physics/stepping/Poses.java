// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;
import sim.physics.internal.Trig;
import sim.physics.motion.Body;
import sim.physics.motion.State;
import sim.physics.shape.Shape;

/** Where the bodies are at the start of a step, and their hulls. */
final class Poses implements Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;
    private final Map<Shape, Hull> shared = new HashMap<>();
    private Hull[] hulls = {};

    /** [cos θ, sin θ] per body. */
    double[] turns = {};

    /** The movable bodies, in ascending order. */
    final IntList movable = new IntList();

    /** Those of them that their authors move. */
    final IntList steered = new IntList();

    /** Those of them that do not sleep. */
    final IntList awake = new IntList();

    Poses(State state) {
        this.state = state;
    }

    void ensure(int bodies) {
        if (hulls.length < bodies) {
            int length = Growth.length(hulls.length, bodies);
            hulls = Arrays.copyOf(hulls, length);
            turns = Arrays.copyOf(turns, 2 * length);
        }
    }

    boolean knows(int body) {
        return body < hulls.length && hulls[body] != null;
    }

    Hull hull(int body) {
        return hulls[body];
    }

    /** Takes a body in. */
    void add(int index) {
        ensure(index + 1);
        Body body = state.body(index);
        hulls[index] = shared.computeIfAbsent(body.getShape(), Hull::new);
        hulls[index].users++;
        enter(index);
    }

    /** Takes note of a body that was written. A kinematic one may have begun to move, or have come to a stand. */
    void written(int index) {
        if (state.touched().isTurned(index)) {
            leave(index);
            enter(index);
        }
        turn(index);
    }

    private void enter(int index) {
        if (!state.body(index).isImmobile()) {
            movable.insert(index);
            if (!state.body(index).isDynamic()) {
                steered.insert(index);
            }
        }
    }

    private void leave(int index) {
        if (movable.contains(index)) {
            movable.takeOut(index);
        }
        if (steered.contains(index)) {
            steered.takeOut(index);
        }
    }

    /** Whether no force moves a body: it is fixed, stands, or moves as its author says. */
    boolean isGround(int body) {
        return state.w().values()[State.BLOCK * body] == 0 || steered.size > 0 && !state.body(body).isDynamic();
    }

    void remove(int index) {
        Hull hull = hulls[index];
        hull.users--;
        if (hull.users == 0) {
            shared.remove(hull.shape);
        }
        hulls[index] = null;
        leave(index);
    }

    /** Turns a body's frame to where it is now. */
    void turn(int body) {
        if (hulls[body].count > 1) {
            Trig.sinCos(state.x()[State.BLOCK * body + State.THETA], turns, 2 * body);
        }
    }
}
