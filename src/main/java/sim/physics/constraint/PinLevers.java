// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Growth;
import sim.physics.motion.State;

/** What pins give where something else pushes their bodies: the impulse with which the velocity of the pin stays as it is. */
public final class PinLevers implements Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;
    private final PinImpulses pins;

    /** By body the first of its ends of pins, and by end the next one of that body; −1 for none. */
    private int[] first = {};

    private int[] next = {};

    PinLevers(State state, PinImpulses pins) {
        this.state = state;
        this.pins = pins;
    }

    /**
     * Finds the pins of each body.
     *
     * @return whether there are any
     */
    public boolean find() {
        int ends = 2 * pins.awake();
        if (ends > 0) {
            first = first.length < state.size() ? new int[Growth.length(first.length, state.size())] : first;
            next = next.length < ends ? new int[ends] : next;
            Arrays.fill(first, 0, state.size(), -1);
        }
        for (int end = ends - 1; end >= 0; end--) {
            pins.setAnswering(end / 2, false);
            int body = body(end);
            if (body >= 0) {
                next[end] = first[body];
                first[body] = end;
            }
        }
        return ends > 0;
    }

    /**
     * The first end of a pin at a body.
     *
     * @param body its index
     * @return twice the pin's number, and 1 more if the body is its second one; −1 for none
     */
    public int first(int body) {
        return first[body];
    }

    /**
     * The next end at the same body.
     *
     * @param end one of that body
     * @return another one; −1 for none
     */
    public int next(int end) {
        return next[end];
    }

    /**
     * The body at an end of a pin.
     *
     * @param end twice the pin's number, and 1 more for its second body
     * @return its index; −1 for the world
     */
    public int body(int end) {
        int block = pins.block(end / 2, end & 1);
        return block < 0 ? -1 : block / State.BLOCK;
    }

    /**
     * Adds what an impulse on one of a pin's bodies does to the velocity of the pin.
     *
     * @param end that of the body
     * @param x the impulse along x
     * @param y and along y
     * @param twist its moment about the body's centre
     * @param speeds takes the velocity, from {@code at} on
     * @param at place
     */
    public void push(int end, double x, double y, double twist, double[] speeds, int at) {
        double[] w = state.w().values();
        int o = State.BLOCK * body(end);
        double sign = (end & 1) == 0 ? 1 : -1;
        double turn = w[o + 2] * twist;
        speeds[at] += sign * (w[o] * x - turn * pins.arm(end / 2, end & 1, 1));
        speeds[at + 1] += sign * (w[o + 1] * y + turn * pins.arm(end / 2, end & 1, 0));
    }

    /**
     * Finds the impulse of a pin against a velocity of it.
     *
     * @param pin its number
     * @param x the velocity along x
     * @param y and along y
     * @param impulse takes what the first body is to get, less its sign, from {@code at} on
     * @param at place
     * @return the product of the two
     */
    public double hold(int pin, double x, double y, double[] impulse, int at) {
        impulse[at] = pins.inverse(pin, 0) * x + pins.inverse(pin, 1) * y;
        impulse[at + 1] = pins.inverse(pin, 1) * x + pins.inverse(pin, 2) * y;
        return impulse[at] * x + impulse[at + 1] * y;
    }

    /**
     * How much of its impulse counts that a rigid pin would give.
     *
     * @param pin its number
     * @return that part, as pins were solved last
     */
    public double mass(int pin) {
        return pins.softness.mass(pins.yields(pin));
    }

    /**
     * What a point beside a pin will lose of its speed as soon as the pin is solved once more.
     *
     * @param pin its number
     * @param speeds what an impulse at the point gives the pin, from {@code at} on
     * @param held what the pin gives in turn, less its sign, from {@code at} on
     * @param at place
     * @return the speed
     */
    public double lost(int pin, double[] speeds, double[] held, int at) {
        double rate = pins.softness.rate();
        double speed = pins.speed(pin, held[at], held[at + 1], rate > 0);
        double place = held[at] * pins.open(pin, 0) + held[at + 1] * pins.open(pin, 1);
        double given = speeds[at] * pins.impulse(pin, 0) + speeds[at + 1] * pins.impulse(pin, 1);
        return speed + rate * place + pins.softness.impulse(pins.yields(pin)) * given;
    }

    /**
     * Finds with what impulse a pin keeps its velocity where something turns its bodies.
     *
     * @param turnA what it turns the first one by
     * @param turnB and the second one
     * @param impulse takes the impulse, less its sign, from {@code at} on
     * @return how much that turns back
     */
    double couple(int pin, double turnA, double turnB, double[] impulse, int at) {
        double x = -turnA * pins.arm(pin, 0, 1);
        double y = turnA * pins.arm(pin, 0, 0);
        if (pins.block(pin, 1) >= 0) {
            x += turnB * pins.arm(pin, 1, 1);
            y -= turnB * pins.arm(pin, 1, 0);
        }
        return hold(pin, x, y, impulse, at);
    }

    /**
     * Lets a pin bear all that it has to bear, and not give way.
     *
     * @param pin its number
     */
    public void stiffen(int pin) {
        pins.setAnswering(pin, true);
    }

    /**
     * Gives the bodies of a pin an impulse.
     *
     * @param pin its number
     * @param x what its first body gets along x
     * @param y and along y
     */
    public void give(int pin, double x, double y) {
        pins.give(pin, x, y);
    }
}
