// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.State;
import sim.physics.response.LastingContact;
import sim.physics.response.MeanPush;

/** What contacts have done in parts of a step before its last one, where it is made in parts: by events first, or in several by time stepping. */
final class EarlierPushes implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Values per contact: its impulse along normals and along tangents, that on the second body, and its place. */
    private static final int STRIDE = 6;

    private static final int TANGENT = 1;
    private static final int X = 2;
    private static final int Y = 3;
    private static final int PLACE = 4;

    private final State state;
    private final MeanPush mean = new MeanPush();

    /** Two per contact. */
    private final List<Body> bodies = new ArrayList<>();

    /** By first body and second one: the number of their contact. A part of a pile has thousands. */
    private final Map<Body, Map<Body, Integer>> numbers = new IdentityHashMap<>();

    private double[] data = {};

    EarlierPushes(State state) {
        this.state = state;
    }

    /** A step begins. */
    void clear() {
        bodies.clear();
        numbers.clear();
    }

    boolean isEmpty() {
        return bodies.isEmpty();
    }

    /** Adds what contacts have done with their mean forces in a time. */
    void add(List<LastingContact> contacts, double time) {
        for (LastingContact c : contacts) {
            int o = place(c.a(), c.b());
            double normal = time * c.normalForce();
            double all = data[o] + normal;
            double part = all > 0 ? normal / all : 1;
            data[o] = all;
            data[o + TANGENT] += time * c.tangentForce();
            data[o + X] += time * c.forceX(c.b());
            data[o + Y] += time * c.forceY(c.b());
            data[o + PLACE] += part * (c.x() - data[o + PLACE]);
            data[o + PLACE + 1] += part * (c.y() - data[o + PLACE + 1]);
        }
    }

    /** Where a contact's values are; new ones are 0. */
    private int place(Body a, Body b) {
        int k = find(a, b);
        if (k < 0) {
            k = bodies.size() / 2;
            bodies.add(a);
            bodies.add(b);
            numbers.computeIfAbsent(a, body -> new IdentityHashMap<>()).put(b, k);
            data = data.length < STRIDE * k + STRIDE ? Arrays.copyOf(data, 2 * STRIDE * (k + 1)) : data;
            Arrays.fill(data, STRIDE * k, STRIDE * k + STRIDE, 0);
        }
        return STRIDE * k;
    }

    private int find(Body a, Body b) {
        Map<Body, Integer> ofA = numbers.get(a);
        return ofA == null ? -1 : ofA.getOrDefault(b, -1);
    }

    /**
     * Makes contacts' mean forces in the last part of a step those in all of it, and adds contacts that were in the others only.
     *
     * @param pairs numbers of the contacts' pairs; −1 is added for those that are added
     * @param part length of the last part
     * @param step length of the step
     */
    void merge(IntList pairs, List<LastingContact> contacts, double part, double step) {
        boolean[] isMet = new boolean[bodies.size() / 2];
        for (int k = 0; k < contacts.size(); k++) {
            LastingContact c = contacts.get(k);
            int at = find(c.a(), c.b());
            boolean isFirst = at >= 0 && !isMet[at]; // parts of compounds are several contacts of the same two
            if (isFirst) {
                isMet[at] = true;
            }
            contacts.set(k, isFirst ? sum(at, c, part, step) : spread(c, part / step));
        }
        for (int k = 0; k < isMet.length; k++) {
            boolean areThere = bodies.get(2 * k).state() == state && bodies.get(2 * k + 1).state() == state;
            if (!isMet[k] && areThere && data[STRIDE * k] > 0) {
                pairs.add(-1);
                contacts.add(sum(k, null, 0, step));
            }
        }
    }

    private static LastingContact spread(LastingContact c, double by) {
        return new LastingContact(
                c.a(), c.b(), c.x(), c.y(), c.normalX(), c.normalY(), by * c.normalForce(), by * c.tangentForce());
    }

    /** What a contact has done in earlier parts, and in the last one if it was there, as a mean over the step. */
    private LastingContact sum(int k, LastingContact last, double part, double step) {
        int o = STRIDE * k;
        Body b = bodies.get(2 * k + 1);
        double now = last == null ? 0 : part * last.normalForce();
        double normal = data[o] + now;
        double rubbed = data[o + TANGENT] + (last == null ? 0 : part * last.tangentForce());
        double x = data[o + X] + (last == null ? 0 : part * last.forceX(b));
        double y = data[o + Y] + (last == null ? 0 : part * last.forceY(b));
        double share = last == null ? 0 : now / normal;
        double px = data[o + PLACE] + (last == null ? 0 : share * (last.x() - data[o + PLACE]));
        double py = data[o + PLACE + 1] + (last == null ? 0 : share * (last.y() - data[o + PLACE + 1]));
        double size = Math.sqrt(x * x + y * y);
        double nx = size > 0 ? x / size : last == null ? 0 : last.normalX();
        double ny = size > 0 ? y / size : last == null ? 0 : last.normalY();
        mean.find(nx, ny, normal, rubbed, x - (normal * nx - rubbed * ny), y - (normal * ny + rubbed * nx));
        return new LastingContact(
                bodies.get(2 * k), b, px, py, mean.nx, mean.ny, mean.normal / step, mean.tangential / step);
    }
}
