// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static sim.physics.stepping.ContactRows.APPROACH;
import static sim.physics.stepping.ContactRows.BEFORE;
import static sim.physics.stepping.ContactRows.BOUNCE;
import static sim.physics.stepping.ContactRows.BOUNCED;
import static sim.physics.stepping.ContactRows.FORCED;
import static sim.physics.stepping.ContactRows.FRICTION;
import static sim.physics.stepping.ContactRows.INTS;
import static sim.physics.stepping.ContactRows.LAST;
import static sim.physics.stepping.ContactRows.LOAD;
import static sim.physics.stepping.ContactRows.NORMAL;
import static sim.physics.stepping.ContactRows.NORMAL_MASS;
import static sim.physics.stepping.ContactRows.NORMAL_SUM;
import static sim.physics.stepping.ContactRows.NOW;
import static sim.physics.stepping.ContactRows.OPENING;
import static sim.physics.stepping.ContactRows.PAIR;
import static sim.physics.stepping.ContactRows.PRESSED;
import static sim.physics.stepping.ContactRows.REGAIN;
import static sim.physics.stepping.ContactRows.RESTORED;
import static sim.physics.stepping.ContactRows.RUBBING;
import static sim.physics.stepping.ContactRows.STRIDE;
import static sim.physics.stepping.ContactRows.TANGENT;
import static sim.physics.stepping.ContactRows.TANGENT_SUM;
import static sim.physics.stepping.ContactRows.WEIGHT;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.constraint.StopRows;
import sim.physics.internal.Freshness;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;
import sim.physics.internal.OpenGroups;
import sim.physics.motion.State;

/**
 * What has met in a substep, at its end: its gap is used up. First, what has met is compressed in turn until it approaches no more. One point that
 * bounces alone, among all that touch or are tied to one another, then parts at the speed of Newton's law, and rubs on the way: the impulse by events ({@link sim.physics.response.TwoBodyImpulse}). Of several, each gives back a part of what it has
 * taken (Poisson), and rubs once more. What does not bounce is compressed, too, where joints have part in it: solved once a substep, they are far off.
 */
final class Impacts implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Points of a group up to which it is solved to the end though nothing in it bounces, and to rounding if something does. */
    static final int FEW = 24;

    /** Gap that is none, of the depth that may be regained in a step. */
    private static final double CLOSED = 1e-3;

    /** Turns in which what is given back rubs. */
    private static final int RUBS = 32;

    /** What a point gives back that gives nothing back, but takes part. */
    static final double PLASTIC = Double.MIN_VALUE;

    private final State state;
    private final ContactRows rows;
    private final Groups groups;
    private final MetGroups facts;
    private final StruckPoints struck;
    private final Compression compression;
    private final FreeImpacts free;
    private final PinnedPairs pinned;
    private final Flights flights;

    /** The points that have met: row and first value of each; only they give something back. */
    private final IntList met = new IntList();

    /** Of the step: the rows whose gaps before each substep count, those that may have met after it, and those that may strike what joints tie. */
    private final IntList watched = new IntList();

    private final IntList meeting = new IntList();
    private final IntList striking = new IntList();

    /** By point that has met: how much what it gives back may rub, and how much it has. */
    private double[] limits = {};

    private double substep;

    /** By body: the number of pairs in which it presses. */
    private int[] touched = {};

    Impacts(State state, ContactRows rows, Groups groups, MetGroups facts, FreeImpacts free, Flights flights, ContactSolver contacts) {
        this.state = state;
        this.rows = rows;
        this.groups = groups;
        this.facts = facts;
        struck = contacts.struck();
        pinned = contacts.pinned();
        compression = new Compression(state, rows, groups, struck, pinned);
        this.free = free;
        this.flights = flights;
    }

    /** Begins a step in which something may strike, and of which the groups are known: of most rows of a pile there is nothing to be asked in it. */
    void begin() {
        facts.begin();
        flights.begin(facts.areTied);
        met.clear();
        watched.clear();
        meeting.clear();
        striking.clear();
        for (int k = 0; k < rows.count; k++) {
            list(k);
        }
    }

    private void list(int k) {
        boolean isOfOne = groups.has(k, rows);
        if (rows.mayStrike(k) || isOfOne && isPlastic(k) && !isTied(k)) {
            watched.add(k);
            for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
                rows.points[p + OPENING] = rows.points[p + APPROACH];
            }
        }
        if (mayMeet(k)) {
            meeting.add(k);
        }
        if (isOfOne && isTied(k) && rows.comesToStrike(k)) {
            striking.add(k);
        }
    }

    /** Notes the gaps of what may strike, and of what may have part in that, before a substep begins. */
    void approach() {
        for (int n = 0; n < watched.size; n++) {
            int k = watched.values[n];
            for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
                rows.points[p + BEFORE] = rows.points[p + NOW];
            }
        }
    }

    /** Notes the groups of tied bodies that something presses which comes to strike; false if none. */
    boolean findStruck() {
        facts.open();
        boolean any = false;
        for (int n = 0; n < striking.size; n++) {
            int k = striking.values[n];
            if (rows.sum(k, NORMAL) > 0) {
                facts.counts[groups.of(k, rows)]++;
                any = true;
            }
        }
        return any;
    }

    /**
     * Notes which points have met, and which stops were struck; false if none.
     *
     * @param h the step, in which forces make what is no bounce
     * @param d the substep
     * @param before velocities with all that forces give in it, and nothing else
     */
    boolean find(double h, double d, double[] before, StopRows stops) {
        substep = d;
        facts.open();
        if (presses()) {
            count();
            strike(h, d, before);
        }
        stops.find(h, groups.slots, facts.counts, facts.giveBack);
        facts.dropLarge();
        stops.drop(groups.slots, facts.counts);
        forget();
        if (facts.areSome()) {
            collect(h);
        }
        return met.size > 0 || stops.haveMet();
    }

    /** Whether some pair presses that may have met, or has pressed within the substep. */
    private boolean presses() {
        boolean yes = false;
        for (int n = 0; n < meeting.size; n++) {
            int k = meeting.values[n];
            for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
                yes |= rows.points[p + NORMAL] > 0 || rows.points[p + RESTORED] == Flights.TAKEN_BACK;
            }
        }
        return yes;
    }

    /** Counts the points that strike, by group. */
    private void strike(double h, double d, double[] before) {
        for (int n = 0; n < meeting.size; n++) {
            int k = meeting.values[n];
            for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
                rows.points[p + OPENING] = rows.opening(k, p, before) - d * rows.points[p + FORCED];
                boolean presses = rows.points[p + NORMAL] > 0;
                boolean meets = presses ? isImpact(k, p, h) || flights.isHop(k, p, h, d) : flights.isUndone(k, p);
                rows.points[p + RESTORED] = meets ? Math.max(PLASTIC, rows.normals[PAIR * k + BOUNCE]) : 0;
                if (meets) {
                    facts.strike(groups.of(k, rows), -rows.points[p + OPENING], h * rows.normals[PAIR * k + WEIGHT], rows.mayBounce(k));
                }
            }
        }
        facts.dropSlow();
    }

    /** Forgets, where nothing has met in this substep, what had part in what met in the one before. */
    private void forget() {
        for (int n = 0; n < meeting.size; n++) {
            int k = meeting.values[n];
            for (int p = rows.begin(k); !hasMet(k) && p < rows.end(k); p += STRIDE) {
                rows.points[p + RESTORED] = 0;
            }
        }
        for (int m = 0; m < met.size; m += 2) {
            rows.points[met.values[m + 1] + RESTORED] = hasMet(met.values[m]) ? rows.points[met.values[m + 1] + RESTORED] : 0;
        }
        met.clear();
        groups.struck.clear();
    }

    /** Lists the points that have met; what else is closed there has part in that. */
    private void collect(double h) {
        for (int k = 0; k < rows.count; k++) {
            if (hasMet(k)) {
                groups.struck.add(k);
            }
        }
        for (int n = 0; n < groups.struck.size; n++) {
            int k = groups.struck.values[n];
            for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
                double restored = rows.points[p + RESTORED];
                boolean takesPart = isTied(k) && rows.points[p + NORMAL] > 0 || isPlastic(k) && isClosed(k, p, h);
                rows.points[p + RESTORED] = takesPart ? Math.max(PLASTIC, restored) : restored;
                if (rows.points[p + RESTORED] > 0) {
                    facts.parts[groups.of(k, rows)]++;
                    met.add(k);
                    met.add(p);
                }
            }
        }
    }

    /** Forgets the points that have not met where their bodies fly freely, and leaves those to {@link Reflections} that are theirs. */
    void dropMissed() {
        int kept = 0;
        for (int m = 0; m < met.size; m += 2) {
            int k = met.values[m];
            int p = met.values[m + 1];
            rows.pairs[INTS * k + BOUNCED] |= rows.points[p + RESTORED] > PLASTIC ? 1 : 0;
            if (rows.points[p + RESTORED] > 0 && !facts.areReflected[groups.of(k, rows)]) {
                met.values[kept++] = k;
                met.values[kept++] = p;
            }
        }
        met.size = kept;
    }

    /** Whether there is something to be done about a pair: it may bounce, or strikes what joints tie. */
    private boolean mayMeet(int k) {
        return rows.mayBounce(k) || rows.isFast(k) && groups.has(k, rows) && (isTied(k) || isPlastic(k));
    }

    /** Whether a pair is of a small group in which nothing bounces. */
    private boolean isPlastic(int k) {
        return facts.isPlastic(groups.of(k, rows));
    }

    private boolean isClosed(int k, int p, double h) {
        return rows.points[p + NORMAL] > 0 || rows.points[p + NOW] <= closed(rows, k, h);
    }

    private boolean isTied(int k) {
        return facts.areTied[groups.of(k, rows)];
    }

    /** Whether a pair is of a group in which something has met. */
    private boolean hasMet(int k) {
        return groups.has(k, rows) && facts.counts[groups.of(k, rows)] > 0;
    }

    /** Marks the bodies of groups in which something has met, or takes the marks back. */
    void mark(boolean[] marks, boolean as) {
        for (int k = 0; k < groups.bodies; k++) {
            int body = groups.blocks[k] / State.BLOCK;
            marks[body] = as && facts.counts[groups.slots[body]] > 0;
        }
    }

    /** What lies bounces only if it is faster than forces make it in two steps; what has pressed may have been pressed by others, which weigh something. */
    private boolean isImpact(int k, int p, double h) {
        boolean hasPressed = rows.pairs[INTS * k + PRESSED] != 0;
        boolean lies = touched[rows.first(k)] > 1 || touched[rows.second(k)] > 1;
        double apart = lies ? rows.normals[PAIR * k + LOAD] : Math.max(0, -rows.points[p + FORCED]);
        double pull = h * (hasPressed ? rows.normals[PAIR * k + WEIGHT] : apart);
        boolean isDriven = rows.mayBounce(k) || rows.points[p + OPENING] <= CLOSED * rows.normals[PAIR * k + REGAIN]; // by others that strike, if it does not come nearer itself
        return rows.points[p + OPENING] < -2 * pull || !hasPressed && pull == 0 && isDriven;
    }

    /** Counts the pairs in which each body presses. */
    private void count() {
        if (touched.length < state.size()) {
            touched = new int[groups.slots.length];
        }
        Arrays.fill(touched, 0, state.size(), 0);
        flights.clear();
        for (int k = 0; k < rows.count; k++) {
            if (rows.sum(k, NORMAL) > 0) {
                touched[rows.first(k)]++;
                touched[rows.second(k)]++;
            }
        }
    }

    /**
     * Without friction the two laws say the same, and Poisson's keeps the energy also where turns among joints do not reach their end. Of several points
     * among joints, Newton's would give energy: what has passed a wave on would have to part from where that came from as fast as it met it.
     */
    private boolean isAlone(int k) {
        int group = groups.of(k, rows);
        boolean isOneOfTied = isTied(k) && facts.parts[group] > 1;
        return facts.isLoaded(group) && !isOneOfTied || facts.counts[group] == 1 && (rows.normals[PAIR * k + FRICTION] > 0 || !isTied(k));
    }

    /** Ends a substep. */
    void end() {
        for (int m = 1; m < met.size; m += 2) {
            end(rows.points, met.values[m]);
        }
    }

    /** Ends it for a point: what an impact gave is no guess for the next one; what bears something may bear as much as before. */
    static void end(double[] points, int p) {
        boolean bears = points[p + RESTORED] == PLASTIC && points[p + NORMAL] > 0;
        double normal = bears ? Math.min(points[p + NORMAL], points[p + LAST]) : 0;
        double tangent = bears && points[p + LAST] > 0 ? points[p + RUBBING] * normal / points[p + LAST] : 0;
        points[p + NORMAL_SUM] += points[p + NORMAL] - normal;
        points[p + TANGENT_SUM] += points[p + TANGENT] - tangent;
        points[p + NORMAL] = normal;
        points[p + TANGENT] = tangent;
    }

    /** Opens the groups in which something has met. */
    void open(OpenGroups turns) {
        turns.begin(groups.count);
        for (int g = 0; g < groups.count; g++) {
            if (facts.counts[g] > 0) {
                turns.open(g);
            }
        }
    }

    /** Begins to compress what has met, of the groups in which something has. */
    void beginCompression(OpenGroups turns) {
        open(turns);
        compression.begin(met);
    }

    /** Which bodies have changed since points, joints and stops were solved. */
    Freshness fresh() {
        return compression.fresh();
    }

    /** Whether joints tie bodies of a group in which something has met. */
    boolean areJoined() {
        return facts.areSomeJoined();
    }

    /** Ends the turns of large groups in which nothing gives anything back. */
    void closeLarge(OpenGroups turns) {
        facts.closeLarge(turns);
    }

    /** Compresses what has met once more in turn. */
    void compress(OpenGroups turns) {
        compression.compress(met, turns, facts.counts, facts.areJoined);
    }

    /** Begins to let what bounces alone part, of the groups in which something gives back: all others have been compressed, and that is all. */
    void beginParting(OpenGroups turns) {
        turns.begin(groups.count);
        for (int g = 0; g < groups.count; g++) {
            if (facts.counts[g] > 0 && facts.giveBack[g]) {
                turns.open(g);
            }
        }
        compression.beginParting();
        for (int m = 0; m < met.size; m += 2) {
            int k = met.values[m];
            int p = met.values[m + 1];
            if (turns.isOpen(groups.of(k, rows)) && isAlone(k)) {
                double forced = free.has(k) ? 0 : time(p) * rows.points[p + FORCED];
                double speed = Math.max(0, -rows.points[p + OPENING] - forced);
                compression.add(m / 2, rows.points[p + RESTORED] * speed);
            }
        }
    }

    /** Lets it part once more in turn. */
    void part(OpenGroups turns) {
        compression.part(met, turns, facts.counts, facts.areJoined, facts.areTied);
    }

    /** How long a point took to use its gap up. */
    private double time(int p) {
        return time(rows.points, p, substep);
    }

    /** Whether a point has met, or was so near that a wave goes through it. */
    static boolean touches(ContactRows rows, int k, int p, double h) {
        return rows.points[p + RESTORED] > 0 || rows.mayStrike(k) && rows.points[p + BEFORE] <= closed(rows, k, h);
    }

    /** The gap of a pair that is none. */
    static double closed(ContactRows rows, int k, double h) {
        return CLOSED * h * rows.normals[PAIR * k + REGAIN];
    }

    /** The same, of a substep's points. */
    static double time(double[] points, int p, double substep) {
        double approach = -points[p + OPENING];
        double gap = Math.max(0, points[p + BEFORE]);
        return gap < substep * approach ? gap / approach : substep;
    }

    /** Gives what compression has taken of several once more, in part: first along normals, and then what rubs. */
    void restore(OpenGroups turns) {
        if (limits.length < met.size) {
            limits = new double[Growth.length(limits.length, met.size)];
        }
        Arrays.fill(limits, 0, met.size, 0);
        for (int m = 0; m < met.size; m += 2) {
            int k = met.values[m];
            int p = met.values[m + 1];
            if (!isAlone(k) || isTied(k)) {
                limits[m] = rows.normals[PAIR * k + FRICTION] * restore(k, p);
            }
        }
        open(turns);
        boolean goesOn = true;
        for (int turn = 0; goesOn && turn < RUBS; turn++) {
            for (int m = 0; m < met.size; m += 2) {
                int group = groups.of(met.values[m], rows);
                if (limits[m] > 0 && turns.isOpen(group)) {
                    turns.change(group, rub(met.values[m], met.values[m + 1], m));
                }
            }
            goesOn = turns.goOn();
        }
    }

    /** Gives a part of what a point has taken once more. What forces alone give in the step does not bounce, nor what it has borne before. */
    private double restore(int k, int p) {
        double[] points = rows.points;
        boolean passesOn = passesOn(k, p);
        double pull = free.has(k) ? 0 : (substep - time(p)) * Math.max(0, -points[p + FORCED]) * points[p + NORMAL_MASS];
        double borne = passesOn ? Math.max(pull, points[p + LAST]) : pull;
        double part = passesOn ? rows.normals[PAIR * k + BOUNCE] : points[p + RESTORED];
        double by = part > PLASTIC ? part * Math.max(0, points[p + NORMAL] - borne) : 0;
        by = Math.max(0, by + turned(k, p));
        points[p + NORMAL] += by;
        pinned.give(k, p, by, 0);
        return by;
    }

    /**
     * What one point among joints gives in addition, as its normal has turned since it took: the two impulses are to give back what they took along the
     * way between their directions, and not along the normal of now.
     */
    private double turned(int k, int p) {
        double opening = rows.points[p + OPENING];
        boolean isOne = isTied(k) && facts.parts[groups.of(k, rows)] == 1 && rows.points[p + RESTORED] > PLASTIC;
        int o = ContactRows.TURNED * k + 2;
        return isOne && opening < 0 ? rows.speed(k, p, state.v(), rows.turned[o], rows.turned[o + 1]) / opening : 0;
    }

    /**
     * Whether a point among joints lies and passes on what others strike. It gives its part, too: that all do keeps the energy, and if only those do that have
     * struck, what bounces away is what all had that lay behind it.
     */
    private boolean passesOn(int k, int p) {
        return rows.points[p + RESTORED] == PLASTIC && rows.mayBounce(k) && isTied(k) && facts.giveBack[groups.of(k, rows)];
    }

    /** What restitution gives rubs as what compression has taken, within a bound of its own; whether something has changed. */
    private boolean rub(int k, int p, int m) {
        double old = limits[m + 1];
        double wanted = old - pinned.stopping(k, p);
        limits[m + 1] = Math.max(-limits[m], Math.min(limits[m], wanted));
        double by = limits[m + 1] - old;
        rows.points[p + TANGENT] += by;
        pinned.give(k, p, 0, by);
        return Math.abs(by) > Compression.settled(facts.counts[groups.of(k, rows)]) * limits[m];
    }
}
