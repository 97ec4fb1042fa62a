// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.io.Serializable;
import sim.physics.collision.broad.BodyNotes;
import sim.physics.collision.broad.Boxes;
import sim.physics.internal.Agenda;
import sim.physics.motion.Body;
import sim.physics.motion.Trajectories;

/** The boxes of moving bodies, with room to move on: how large they are made, and until when a body stays in its own. */
final class Room implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Room to move in a box around a body, relative to its radius; and the part of it put ahead of the body. */
    private static final double ROOM = 0.9;

    private static final double AHEAD = 0.5;

    /**
     * The same for a body that moves uniformly, which leaves its course only where it collides: room around it, and length
     * of the way ahead of it, relative to its radius. The best of those tried where a body flies one to three radii.
     */
    private static final double MARGIN = 0.3;

    private static final double WAY = 1.5;

    /**
     * The same in a crowd, where looks at pairs cost more than new boxes: the best of those tried among disks that cover 60 and 70
     * % of the area. A body is in a crowd from many pairs on until it has few, by its last box.
     */
    private static final double CROWD_MARGIN = 0.2;

    private static final double CROWD_WAY = 0.5;
    private static final int MANY = 9;
    private static final int FEW = 3;

    /** Part of the time in a box that is made use of, so that rounding does not matter. */
    private static final double ALMOST = 1 - 0x1p-40;

    private final Trajectories trajectories;
    private final Boxes boxes;

    private final BodyNotes notes;

    Room(Trajectories trajectories, Boxes boxes) {
        this(trajectories, boxes, boxes.notes());
    }

    private Room(Trajectories trajectories, Boxes boxes, BodyNotes notes) {
        this.trajectories = trajectories;
        this.boxes = boxes;
        this.notes = notes;
    }

    /** The same with other boxes. */
    Room with(Boxes others) {
        return new Room(trajectories, others, notes);
    }

    /** Takes a body in, or takes note of what it collides with. */
    void admit(int body, Body view, int bodies) {
        boxes.ensure(bodies);
        boxes.setFixed(body, view.isImmobile());
        notes.set(body, BodyNotes.ALOOF, view.getCategory() == 0 || view.getCollidesWith() == 0);
    }

    /** Whether a body can collide with nobody, so that it leaves no box, and needs none. */
    boolean isAloof(int body) {
        return notes.has(body, BodyNotes.ALOOF);
    }

    /** Takes note of how many pairs a body has in a new box. */
    void count(int body, int pairs) {
        boolean isCrowded = notes.has(body, BodyNotes.CROWDED);
        if (isCrowded ? pairs <= FEW : pairs >= MANY) {
            notes.set(body, BodyNotes.CROWDED, !isCrowded);
        }
    }

    /** The step in which a body's centre leaves the room that its box has. */
    long leavingDate(int body, double tau, long step, double h) {
        if (boxes.isFixed(body) || notes.has(body, BodyNotes.ALOOF)) {
            return Agenda.NEVER;
        }
        int o = body * Trajectories.STRIDE;
        double[] d = boxes.data();
        int b = body * Boxes.STRIDE;
        double radius = trajectories.radius(body);
        double time = trajectories.duration(body, tau);
        double t;
        if (trajectories.areStraight()) {
            double[] m = trajectories.data();
            t = leavingTime(m[o] + time * m[o + Trajectories.VX], m[o + Trajectories.VX], d[b] + radius, d[b + 2] - radius);
            t = Math.min(t, leavingTime(
                    m[o + 1] + time * m[o + Trajectories.VY], m[o + Trajectories.VY], d[b + 1] + radius, d[b + 3] - radius));
        } else {
            t = leavingTime(o, time, h, d[b] + radius, d[b + 2] - radius);
            t = Math.min(t, leavingTime(o + 1, time, h, d[b + 1] + radius, d[b + 3] - radius));
        }
        double steps = Math.floor((tau + t) / h);
        return steps < 1e15 ? step + (long) steps : Agenda.NEVER;
    }

    /** How long a coordinate that changes uniformly stays between two bounds. */
    private static double leavingTime(double x, double v, double low, double high) {
        if (v == 0) {
            return x >= low && x <= high ? Double.POSITIVE_INFINITY : 0;
        }
        // no branch by the direction, which nobody could foretell, and one division
        long back = Double.doubleToRawLongBits(v) >> 63;
        long way = Double.doubleToRawLongBits(high - x) & ~back | Double.doubleToRawLongBits(low - x) & back;
        return Double.longBitsToDouble(way) / v;
    }

    /** How long a coordinate surely stays between two bounds. */
    private double leavingTime(int o, double time, double h, double low, double high) {
        double[] m = trajectories.data();
        double[] k = trajectories.bends();
        int mask = trajectories.bendMask();
        double a = k[(o & mask) + Trajectories.AX];
        double j = k[(o & mask) + Trajectories.JX];
        double x = m[o] + time * (m[o + Trajectories.VX] + time * (a + time * j));
        double v = m[o + Trajectories.VX] + time * (2 * a + 3 * time * j);
        if (a == 0 && j == 0) {
            return leavingTime(x, v, low, high);
        }
        double bound = Math.abs(a) + 3 * Math.abs(j) * h;
        double room = Math.min(high - x, x - low);
        double speed = Math.abs(v);
        return room <= 0 ? 0 : 2 * room / (speed + Math.sqrt(speed * speed + 4 * bound * room));
    }

    /**
     * Gives a body a box that holds its path to the end of the step, with room to go on.
     *
     * @param body index
     * @param tau offset in the present step
     * @param end until when the path holds
     * @param step number of the step
     * @param h its length
     * @return the step in which it leaves the box, a later one
     */
    long enclose(int body, double tau, double end, long step, double h) {
        int o = body * Trajectories.STRIDE;
        double time = trajectories.duration(body, tau);
        double radius = trajectories.radius(body);
        double rest = end - tau;
        double vx = speed(o, time);
        double vy = speed(o + 1, time);
        boolean isCrowded = notes.has(body, BodyNotes.CROWDED);
        double ahead = Math.max(rest, (isCrowded ? CROWD_WAY : WAY) * radius / Math.sqrt(vx * vx + vy * vy));
        if (!(ahead < Double.POSITIVE_INFINITY && isUniform(o))) {
            enclose(body, o, time, rest);
            return Math.max(step + 1, leavingDate(body, tau, step, h));
        }
        double margin = (isCrowded ? CROWD_MARGIN : MARGIN) * radius;
        double half = radius + margin;
        double x = place(o, time);
        double y = place(o + 1, time);
        double wayX = ahead * vx;
        double wayY = ahead * vy;
        boxes.set(
                body,
                x - half + Math.min(0, wayX),
                y - half + Math.min(0, wayY),
                x + half + Math.max(0, wayX),
                y + half + Math.max(0, wayY));
        if (notes.has(body, BodyNotes.ALOOF)) {
            return Agenda.NEVER;
        }
        double stay = ahead + margin / Math.max(Math.abs(vx), Math.abs(vy));
        double steps = Math.floor((tau + stay * ALMOST) / h);
        return steps < 1e15 ? step + Math.max(1, (long) steps) : Agenda.NEVER;
    }

    /** The same for a body that does not move uniformly. */
    private void enclose(int body, int o, double time, double rest) {
        double radius = trajectories.radius(body);
        double vx = speed(o, time);
        double vy = speed(o + 1, time);
        double room = ROOM * radius;
        double v = Math.abs(vx) + Math.abs(vy);
        double whole = AHEAD * room / v;
        double ahead = whole < Double.POSITIVE_INFINITY ? whole : 0; // at a speed of nothing or next to nothing it goes nowhere
        double pathX = pathBound(o, time, rest);
        double pathY = pathBound(o + 1, time, rest);
        double x = place(o, time) + ahead * vx;
        double y = place(o + 1, time) + ahead * vy;
        double halfX = radius + room;
        double halfY = radius + room;
        boxes.set(
                body,
                x - halfX + Math.min(0, rest * vx) - pathX,
                y - halfY + Math.min(0, rest * vy) - pathY,
                x + halfX + Math.max(0, rest * vx) + pathX,
                y + halfY + Math.max(0, rest * vy) + pathY);
    }

    private boolean isUniform(int o) {
        double[] k = trajectories.bends();
        return trajectories.areStraight()
                || k[o + Trajectories.AX] == 0
                        && k[o + Trajectories.AY] == 0
                        && k[o + Trajectories.JX] == 0
                        && k[o + Trajectories.JY] == 0
                        && k[o + Trajectories.DRIVEN] == 0;
    }

    private double place(int o, double d) {
        double[] m = trajectories.data();
        if (trajectories.areStraight()) {
            return m[o] + d * (m[o + Trajectories.VX] + d * 0.0);
        }
        double[] k = trajectories.bends();
        int mask = trajectories.bendMask();
        return m[o] + d * (m[o + Trajectories.VX] + d * (k[(o & mask) + Trajectories.AX] + d * k[(o & mask) + Trajectories.JX]));
    }

    private double speed(int o, double d) {
        double[] m = trajectories.data();
        if (trajectories.areStraight()) {
            return m[o + Trajectories.VX] + d * 0.0; // a negative zero becomes positive, as with bends
        }
        double[] k = trajectories.bends();
        int mask = trajectories.bendMask();
        return m[o + Trajectories.VX] + d * (2 * k[(o & mask) + Trajectories.AX] + 3 * d * k[(o & mask) + Trajectories.JX]);
    }

    /** Whether a body surely stays in its box to the end of the step, or need not. */
    boolean holds(int body, double tau, double h) {
        if (notes.has(body, BodyNotes.ALOOF)) {
            return true;
        }
        double[] m = trajectories.data();
        int at = body * Trajectories.STRIDE;
        if (m[at + Trajectories.OFFSET] == tau && m[at + Trajectories.STEP] == trajectories.step()) {
            return holdsFromAnchor(body, h - tau);
        }
        double[] d = boxes.data();
        int o = body * Trajectories.STRIDE;
        int b = body * Boxes.STRIDE;
        double time = trajectories.duration(body, tau);
        double rest = h - tau;
        double radius = trajectories.radius(body);
        double x = place(o, time);
        double y = place(o + 1, time);
        double wayX = radius + rest * Math.abs(speed(o, time)) + pathBound(o, time, rest);
        double wayY = radius + rest * Math.abs(speed(o + 1, time)) + pathBound(o + 1, time, rest);
        return x - wayX >= d[b] && y - wayY >= d[b + 1] && x + wayX <= d[b + 2] && y + wayY <= d[b + 3];
    }

    /** The same where the body's anchor is at the present instant, as that of a driven body is. */
    private boolean holdsFromAnchor(int body, double rest) {
        double[] d = boxes.data();
        double[] m = trajectories.data();
        double[] k = trajectories.bends();
        int mask = trajectories.bendMask();
        int o = body * Trajectories.STRIDE;
        int b = body * Boxes.STRIDE;
        double ax = Math.abs(k[(o & mask) + Trajectories.AX]) + 3 * Math.abs(k[(o & mask) + Trajectories.JX]) * rest;
        double ay = Math.abs(k[(o & mask) + Trajectories.AY]) + 3 * Math.abs(k[(o & mask) + Trajectories.JY]) * rest;
        double radius = trajectories.radius(body);
        double wayX = radius + rest * (Math.abs(m[o + Trajectories.VX]) + ax * rest);
        double wayY = radius + rest * (Math.abs(m[o + Trajectories.VY]) + ay * rest);
        double x = m[o];
        double y = m[o + 1];
        return x - wayX >= d[b] && y - wayY >= d[b + 1] && x + wayX <= d[b + 2] && y + wayY <= d[b + 3];
    }

    /** How far the accelerations can carry a coordinate off its straight path in a time. */
    private double pathBound(int o, double d, double rest) {
        double[] k = trajectories.bends();
        int mask = trajectories.bendMask();
        double j = Math.abs(k[(o & mask) + Trajectories.JX]);
        double a = Math.abs(k[(o & mask) + Trajectories.AX]) + 3 * j * (Math.abs(d) + rest);
        return a * rest * rest;
    }
}
