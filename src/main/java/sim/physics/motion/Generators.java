// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;

/**
 * The force generators of an engine: uniform fields and surface friction, known in closed form, and all others. Each body has
 * a list of those that act on it, in the order in which they were added, so that an evaluation costs no more than the forces
 * that there are: it is made when the body, or a generator that may act on it, is admitted.
 */
final class Generators implements Serializable {
    private static final long serialVersionUID = 3L;

    private static final Entry[] NONE = {};

    private static final Comparator<Entry> BY_ORDER = Comparator.comparingLong(entry -> entry.order);

    /** A generator, and what it said when it was added or, of what may change, when it was asked last. */
    static final class Entry implements Serializable {
        private static final long serialVersionUID = 1L;

        final ForceGenerator generator;

        /** Its place in the order of adding. */
        final long order;

        /** The only bodies that it acts on; null: it is asked. */
        final List<Body> bodies;

        /** The bodies that it couples, if it couples any; null: those that it acts on. */
        final List<Body> couples;

        boolean isCoupled;

        /** Whether only the stepping thread may ask it, as it said last. */
        private boolean isSequential;

        /** Whether time stepping solves for it, so that it is no force. */
        boolean isRow;

        /** The last sum that it was counted in; a body that it couples. */
        private transient long counted;

        /** Of a spring: its pull, and the asking that it is of; null until time stepping asks. */
        private transient double[] pull;

        private transient long pulled;

        transient int first;

        Entry(ForceGenerator generator, long order) {
            this.generator = generator;
            this.order = order;
            bodies = copy(generator.getBodies());
            couples = copy(generator.getCoupledBodies());
            isCoupled = generator.isCoupled();
        }

        private static List<Body> copy(List<Body> bodies) {
            return bodies == null ? null : new ArrayList<>(bodies);
        }
    }

    /** How often time stepping has asked for the forces on all bodies: a spring between two of them is evaluated once each time. */
    long askings;

    /** In the order of adding. */
    private final List<Entry> all = new ArrayList<>();

    /** Those that need the integrator; and of them those that are asked about every body. */
    private final List<Entry> driving = new ArrayList<>();

    private final List<Entry> asked = new ArrayList<>();

    /** By body those of {@link #driving} that act on it; null if that is not known. */
    private Entry[][] acting = {};

    private final ArrayList<Entry> found = new ArrayList<>();

    /** The same as {@link #all}; and those of them that are not asked, by the bodies that they act on. Null if not known. */
    private transient Map<ForceGenerator, Entry> known;

    private transient Map<Body, List<Entry>> listed;

    private long orders;

    private transient long sums;

    /** Sum of the uniform fields. */
    double gravityX;

    double gravityY;

    /** Null if there is none. */
    SurfaceFriction surface;

    /** Whether some generator couples bodies, be they tied together or not. */
    boolean coupled;

    /** Whether several threads may ask for the forces on different bodies. */
    boolean concurrent = true;

    /** How many generators couple bodies, and how many only the stepping thread may ask. */
    private int couplings;

    private int sequentials;

    /** Whether it has changed which bodies the generators couple. */
    boolean isCouplingNew;

    /** Whether there are any of {@link #driving}, or bodies on which those act that have been removed since. */
    private boolean drives;

    Generators() {
        // none yet
    }

    List<ForceGenerator> copy() {
        List<ForceGenerator> copy = new ArrayList<>(all.size());
        all.forEach(entry -> copy.add(entry.generator));
        return copy;
    }

    boolean add(ForceGenerator generator) {
        Objects.requireNonNull(generator, "generator");
        index();
        if (known.containsKey(generator)) {
            return false;
        }
        Entry entry = new Entry(generator, orders); // first: an author's code may throw
        known.put(generator, entry);
        all.add(entry);
        orders++;
        if (generator instanceof Gravity field) {
            gravityX += field.getX();
            gravityY += field.getY();
            return true;
        }
        driving.add(entry);
        drives = true;
        sortOut(entry);
        if (entry.bodies == null) {
            asked.add(entry);
        } else {
            list(entry);
        }
        return true;
    }

    boolean remove(ForceGenerator generator) {
        index();
        Entry entry = known.remove(generator);
        if (entry == null) {
            return false;
        }
        takeOut(all, entry);
        if (entry.generator instanceof Gravity) {
            gravityX = 0;
            gravityY = 0;
            for (Entry e : all) {
                gravityX += e.generator instanceof Gravity field ? field.getX() : 0;
                gravityY += e.generator instanceof Gravity field ? field.getY() : 0;
            }
        } else {
            takeOut(driving, entry);
            asked.remove(entry);
            unlist(entry);
        }
        isCouplingNew |= coupled;
        if (entry.generator instanceof SurfaceFriction) {
            sortOut(); // there may be another one
        } else if (!(entry.generator instanceof Gravity)) {
            count(entry, -1);
        }
        return true;
    }

    private static void takeOut(List<Entry> ordered, Entry entry) {
        ordered.remove(Collections.binarySearch(ordered, entry, BY_ORDER));
    }

    /** The bodies at the ends of a body's springs, which are removed if it leaves. */
    List<Body> springEnds(Body body, boolean leaves) {
        List<Entry> named = driving.isEmpty() ? null : naming(body);
        if (named == null) {
            return List.of();
        }
        List<Body> ends = new ArrayList<>();
        for (Entry entry : new ArrayList<>(named)) {
            if (entry.generator instanceof Spring) {
                ends.addAll(entry.bodies);
                if (leaves) {
                    remove(entry.generator);
                }
            }
        }
        return ends;
    }

    /** The only bodies that a generator acts on, as it said when it was added; null if it is asked, or is not there. */
    List<Body> bodies(ForceGenerator generator) {
        index();
        Entry entry = known.get(generator);
        return entry == null || entry.generator instanceof Gravity ? null : entry.bodies;
    }

    private void sortOut() {
        couplings = 0;
        sequentials = 0;
        coupled = false;
        concurrent = true;
        surface = null;
        for (int k = 0; k < driving.size(); k++) {
            sortOut(driving.get(k));
        }
    }

    private void sortOut(Entry entry) {
        entry.isSequential = !entry.generator.isConcurrent() || entry.isCoupled;
        isCouplingNew |= entry.isCoupled;
        surface = entry.generator instanceof SurfaceFriction s ? s : surface;
        count(entry, 1);
    }

    private void count(Entry entry, int change) {
        couplings += entry.isCoupled ? change : 0;
        sequentials += entry.isSequential ? change : 0;
        coupled = couplings > 0;
        concurrent = sequentials == 0;
    }

    /** Asks all generators again whether they couple bodies. */
    void askAgain() {
        boolean isNew = false;
        for (int k = 0; k < driving.size(); k++) {
            Entry entry = driving.get(k);
            boolean was = entry.isCoupled;
            entry.isCoupled = entry.generator.isCoupled();
            isNew |= entry.isCoupled != was;
        }
        if (isNew) {
            isCouplingNew = true;
            sortOut();
        }
    }

    private void index() {
        if (known == null) {
            known = new HashMap<>();
            all.forEach(entry -> known.put(entry.generator, entry));
        }
    }

    private void list(Entry entry) {
        if (listed == null) {
            return;
        }
        for (Body body : entry.bodies) {
            List<Entry> those = listed.computeIfAbsent(body, b -> new ArrayList<>(2));
            if (those.isEmpty() || those.get(those.size() - 1) != entry) {
                those.add(entry);
            }
        }
    }

    private void unlist(Entry entry) {
        for (int k = 0; listed != null && entry.bodies != null && k < entry.bodies.size(); k++) {
            List<Entry> those = listed.get(entry.bodies.get(k));
            if (those != null && those.remove(entry) && those.isEmpty()) {
                listed.remove(entry.bodies.get(k));
            }
        }
    }

    /** The generators that name a body, or null. */
    private List<Entry> naming(Body body) {
        if (listed == null) {
            listed = new IdentityHashMap<>();
            for (int k = 0; k < driving.size(); k++) {
                if (driving.get(k).bodies != null) {
                    list(driving.get(k));
                }
            }
        }
        return listed.isEmpty() ? null : listed.get(body);
    }

    /** All that couple bodies, in the order of adding, and others. */
    List<Entry> driving() {
        return driving;
    }

    /** Those that act on a body, or on others that feel where it is. */
    Entry[] acting(Body body) {
        int index = body.index();
        if (index >= acting.length || acting[index] == null) {
            review(body);
        }
        return acting[index];
    }

    /** Finds out which generators act on a body that has been written, or that some have been added for. */
    void review(Body body) {
        int index = body.index();
        if (index >= acting.length) {
            acting = Arrays.copyOf(acting, Growth.length(acting.length, index + 1));
        }
        Entry[] old = acting[index];
        List<Entry> named = body.isFixed() ? null : naming(body);
        int n = 0;
        for (int k = 0; k < asked.size() && !body.isFixed(); k++) {
            while (named != null && n < named.size() && named.get(n).order < asked.get(k).order) {
                find(named.get(n++), body);
            }
            find(asked.get(k), body);
        }
        while (named != null && n < named.size()) {
            find(named.get(n++), body);
        }
        boolean isSame = old != null && old.length == found.size();
        for (int k = 0; isSame && k < old.length; k++) {
            isSame = old[k] == found.get(k);
        }
        if (!isSame) {
            acting[index] = found.toArray(NONE);
            isCouplingNew |= coupled;
        }
        found.clear();
    }

    /** A body that forces do not move is asked about only where others feel where it is: it moves together with these. */
    private void find(Entry entry, Body body) {
        if ((entry.isCoupled || body.isDynamic()) && entry.generator.actsOn(body)) {
            found.add(entry);
        }
    }

    /** A body leaves: nothing acts on it any more. */
    void leave(int index) {
        if (index < acting.length && acting[index] != null) {
            isCouplingNew |= coupled && acting[index].length > 0;
            acting[index] = NONE;
        }
    }

    /** A body has left. */
    void forget(int index) {
        leave(index);
        if (index < acting.length) {
            acting[index] = null;
        }
    }

    /** The accelerations of uniform fields alone. */
    void fall(IntList bodies, double[] a) {
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            a[b] = gravityX;
            a[b + 1] = gravityY;
            a[b + 2] = 0;
        }
    }

    /** The accelerations of all forces; the force vector takes those of generators, and what was applied. */
    void accelerate(State state, IntList bodies, double t, Forces forces, double[] a) {
        accelerate(state, bodies, t, forces, a, null, 0);
    }

    /**
     * The same without one generator, and without what time stepping solves for.
     *
     * @param asking a number that was not used before, by which a spring between two of the bodies is evaluated once; 0: each body asks anew
     */
    void accelerate(State state, IntList bodies, double t, Forces forces, double[] a, ForceGenerator without, long asking) {
        double[] f = state.f();
        double[] w = state.w().values();
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            Body body = state.body(bodies.values[k]);
            f[b] = body.appliedX();
            f[b + 1] = body.appliedY();
            f[b + 2] = body.appliedTorque();
            addForces(body, t, forces, without, asking);
            a[b] = gravityX + w[b] * f[b]; // (5), (7)
            a[b + 1] = gravityY + w[b + 1] * f[b + 1];
            a[b + 2] = w[b + 2] * f[b + 2]; // (6), (8)
        }
    }

    /** Whether there is any generator that may act. */
    boolean isAny() {
        return drives || gravityX != 0 || gravityY != 0;
    }

    /** Whether there is a generator other than a uniform field, or was one until the last change. */
    boolean drive() {
        return drives;
    }

    /** All bodies that changes concern have been reviewed. */
    void settle() {
        drives = !driving.isEmpty();
    }

    /** Whether a generator other than a uniform field acts on a body. */
    boolean drive(Body body) {
        return drives && acting(body).length > 0;
    }

    /** Whether something other than uniform fields and one generator acts on a body. */
    boolean drivesOtherThan(ForceGenerator one, Body body) {
        boolean found = false;
        for (Entry entry : acting(body)) {
            found |= entry.generator != one;
        }
        return found;
    }

    /** Whether the forces on the bodies of a group depend on their state alone. */
    boolean areAutonomous(State state, IntList group) {
        for (int k = 0; k < group.size; k++) {
            for (Entry entry : acting(state.body(group.values[k]))) {
                if (!entry.generator.isAutonomous()) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Whether static friction holds a body at rest. */
    boolean holds(Body body) {
        if (surface == null || body.isPushed() || drivesOtherThan(surface, body)) {
            return false;
        }
        double mass = body.getMass();
        return surface.actsOn(body) && surface.holds(body, mass * gravityX, mass * gravityY, 0);
    }

    /** Adds the forces on a body, but for those of uniform fields. */
    private void addForces(Body body, double time, Forces forces, ForceGenerator without, long asking) {
        if (!body.isDynamic()) {
            return;
        }
        forces.ask(body);
        for (Entry entry : acting(body)) {
            if (entry.generator != without && !entry.isRow) {
                if (asking > 0 && entry.generator instanceof Spring spring) {
                    pull(entry, spring, body, forces, asking);
                } else {
                    entry.generator.addForce(body, time, forces);
                }
            }
        }
        forces.ask(null);
    }

    private static void pull(Entry entry, Spring spring, Body body, Forces forces, long asking) {
        if (entry.pulled != asking || entry.pull == null) {
            entry.pull = entry.pull == null ? new double[Spring.PULL] : entry.pull;
            spring.find(entry.pull);
            entry.pulled = asking;
        }
        spring.give(entry.pull, body, forces);
    }

    /** The energy that is stored in generators which act on a body of a group. */
    double storedEnergy(State state, IntList group) {
        double sum = 0;
        sums++;
        for (int k = 0; k < group.size; k++) {
            for (Entry entry : acting(state.body(group.values[k]))) {
                sum += entry.counted == sums ? 0 : entry.generator.energy();
                entry.counted = sums;
            }
        }
        return sum;
    }

    /** The energy that is stored in all generators. */
    double storedEnergy() {
        double sum = 0;
        for (int k = 0; k < driving.size(); k++) {
            sum += driving.get(k).generator.energy();
        }
        return sum;
    }
}
