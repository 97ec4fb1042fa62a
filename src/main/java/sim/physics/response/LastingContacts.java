// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import sim.physics.collision.CollisionDetection;
import sim.physics.collision.PairMarks;
import sim.physics.collision.broad.Pairs;
import sim.physics.collision.narrow.Distance;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.State;
import sim.physics.response.lasting.ContactLedger;
import sim.physics.response.lasting.Heaps;
import sim.physics.response.lasting.RestingContacts;

/** Says which bodies rest or lie on one another when a step is over, and tells those who want to know; else does nothing. */
public final class LastingContacts implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Gap up to which what bears nothing touches, relative to the smaller body: a little more than heaps keep. */
    private static final double CLOSED = 2e-4;

    private final State state;
    private final CollisionDetection detection;
    private final RestingContacts resting;
    private final Heaps heaps;
    private final ContactLedger ledger;
    private final List<ContactListener> listeners = new ArrayList<>();

    /** Contacts at the end of the last step, and by pair its number in that list, plus 1; empty while nobody listens. */
    private final List<Body> bodies = new ArrayList<>();

    private int[] places = {};

    /** Bodies that have left since; they may come again, and lie where they did, but their contacts are others. */
    private final List<Body> left = new ArrayList<>();

    private final MeanPush mean = new MeanPush();

    /** Null until it is needed. */
    private transient Distance distance;

    LastingContacts(
            State state, CollisionDetection detection, RestingContacts resting, Heaps heaps, ContactLedger ledger) {
        this.state = state;
        this.detection = detection;
        this.resting = resting;
        this.heaps = heaps;
        this.ledger = ledger;
    }

    /**
     * Adds one who is told of lasting contacts.
     *
     * @param listener not null
     * @return false if it was added already
     */
    public boolean add(ContactListener listener) {
        return find(listeners, Objects.requireNonNull(listener, "listener")) < 0 && listeners.add(listener);
    }

    /**
     * Removes one who is told of lasting contacts.
     *
     * @param listener any
     * @return false if it was not there
     */
    public boolean remove(ContactListener listener) {
        int k = find(listeners, listener);
        return k >= 0 && listeners.remove(k) == listener;
    }

    /** {@return whether somebody is told of lasting contacts} */
    boolean areHeard() {
        return !listeners.isEmpty();
    }

    /** Where a listener is in a list, −1 if it is not: itself, and not one that is equal. */
    static int find(List<?> listeners, Object one) {
        int k = listeners.size() - 1;
        while (k >= 0 && listeners.get(k) != one) {
            k--;
        }
        return k;
    }

    /**
     * The contacts at the end of the last step, then those that have ended within it.
     *
     * @return a new list, in the order of bodies, and of ends
     */
    public List<LastingContact> all() {
        return contacts(find());
    }

    private List<LastingContact> contacts(IntList pages) {
        List<LastingContact> all = new ArrayList<>(pages.size);
        for (int k = 0; k < pages.size; k++) {
            all.add(contact(pages.values[k]));
        }
        return all;
    }

    /**
     * The contacts of a body at the end of the last step.
     *
     * @param body index
     * @return a new list
     */
    public List<LastingContact> of(int body) {
        List<LastingContact> all = new ArrayList<>();
        Pairs pairs = detection.pairs();
        for (int k = 0; detection.knows(body) && k < pairs.countOf(body); k++) {
            if (lasts(pairs.of(body, k))) {
                all.add(contact(ledger.page(pairs.of(body, k))));
            }
        }
        IntList ended = new IntList();
        ledger.addEnded(ended);
        for (int k = 0; k < ended.size; k++) {
            if (ledger.body(ended.values[k], 0) == body || ledger.body(ended.values[k], 1) == body) {
                all.add(contact(ended.values[k]));
            }
        }
        return all;
    }

    private boolean lasts(int pair) {
        PairMarks marks = detection.marks();
        boolean isLoose = !marks.isHeld(pair) && marks.isLasting(pair);
        return (marks.isHeld(pair) || isLoose && (force(pair) > 0 || isClosed(pair))) && !marks.isIgnored(pair);
    }

    private double force(int pair) {
        int page = ledger.page(pair);
        return ledger.meanForce(page, 0, false) + ledger.meanForce(page, 1, false);
    }

    /** A pair of a heap lasts until it has parted by a hundredth of its size, so that it need not be found anew when it closes soon. */
    private boolean isClosed(int pair) {
        int a = detection.pairs().first(pair);
        int b = detection.pairs().second(pair);
        distance = distance == null ? new Distance() : distance;
        return distance.between(state.body(a), state.body(b)) <= CLOSED * heaps.size(a, b);
    }

    /** The pages of pairs that last, each once, of the body with the smaller index, but for a fixed one; then of those that have ended. */
    private IntList find() {
        IntList members = new IntList();
        for (IntList some : new IntList[] {resting.members(), heaps.members()}) {
            for (int k = 0; k < some.size; k++) {
                if (detection.knows(some.values[k])) {
                    members.add(some.values[k]);
                }
            }
        }
        members.sort();
        IntList found = new IntList();
        Pairs pairs = detection.pairs();
        for (int k = 0; k < members.size; k++) {
            int body = members.values[k];
            boolean isNew = k == 0 || body != members.values[k - 1];
            for (int m = 0; isNew && m < pairs.countOf(body); m++) {
                int other = pairs.other(pairs.of(body, m), body);
                if (lasts(pairs.of(body, m)) && (other > body || state.body(other).isImmobile())) {
                    found.add(ledger.page(pairs.of(body, m)));
                }
            }
        }
        ledger.addEnded(found);
        return found;
    }

    private LastingContact contact(int page) {
        Body a = state.body(ledger.body(page, 0));
        Body b = state.body(ledger.body(page, 1));
        double first = ledger.meanForce(page, 0, false);
        double second = ledger.meanForce(page, 1, false);
        double share = first + second > 0 ? second / (first + second) : 0;
        Body near = a.isImmobile() ? b : a;
        double x = near.getX() + (1 - share) * ledger.place(page, 0, 0) + share * ledger.place(page, 1, 0);
        double y = near.getY() + (1 - share) * ledger.place(page, 0, 1) + share * ledger.place(page, 1, 1);
        double friction = ledger.meanForce(page, 0, true) + ledger.meanForce(page, 1, true);
        mean.find(ledger.normal(page, 0), ledger.normal(page, 1), first + second, friction, ledger.lack(page, 0), ledger.lack(page, 1));
        return new LastingContact(a, b, x, y, mean.nx, mean.ny, mean.normal, mean.tangential);
    }

    /**
     * Takes note that a body leaves the engine.
     *
     * @param body any
     */
    public void leave(Body body) {
        if (!listeners.isEmpty()) {
            left.add(body);
        }
    }

    /** Tells the listeners, if there are any, what has begun, lasts, and has ended with the step that is over. */
    public void tell() {
        if (listeners.isEmpty()) {
            tell(null, null);
            return;
        }
        IntList pages = find();
        IntList found = new IntList();
        for (int k = 0; k < pages.size; k++) {
            found.add(ledger.pair(pages.values[k]));
        }
        tell(found, contacts(pages));
    }

    /**
     * The same of contacts that somebody else has found.
     *
     * @param found the numbers of their pairs; −1 for one that has ended, whose number another one has
     * @param contacts these pairs' contacts; both are not looked at if nobody listens
     */
    void tell(IntList found, List<LastingContact> contacts) {
        if (listeners.isEmpty()) {
            bodies.clear();
            left.clear();
            return;
        }
        Set<Body> gone = Collections.newSetFromMap(new IdentityHashMap<>());
        gone.addAll(left);
        left.clear();
        List<Body> before = new ArrayList<>(bodies);
        int[] placesBefore = places.clone();
        bodies.clear();
        Arrays.fill(places, 0);
        boolean[] lasted = new boolean[found.size];
        boolean[] goesOn = new boolean[before.size() / 2];
        for (int k = 0; k < found.size; k++) {
            int pair = found.values[k];
            LastingContact contact = contacts.get(k);
            int place = pair >= 0 && pair < placesBefore.length ? placesBefore[pair] - 1 : -1;
            lasted[k] = place >= 0
                    && 2 * place < before.size()
                    && before.get(2 * place) == contact.a()
                    && before.get(2 * place + 1) == contact.b()
                    && !gone.contains(contact.a())
                    && !gone.contains(contact.b());
            if (lasted[k]) {
                goesOn[place] = true;
            }
            if (pair >= places.length) {
                places = Arrays.copyOf(places, Math.max(2 * places.length, pair + 1));
            }
            if (pair >= 0) {
                places[pair] = k + 1;
            }
            bodies.add(contact.a());
            bodies.add(contact.b());
        }
        for (ContactListener listener : new ArrayList<>(listeners)) {
            for (int k = 0; k < goesOn.length; k++) {
                if (!goesOn[k]) {
                    listener.ended(before.get(2 * k), before.get(2 * k + 1));
                }
            }
            for (int k = 0; k < contacts.size(); k++) {
                if (lasted[k]) {
                    listener.lasts(contacts.get(k));
                } else {
                    listener.began(contacts.get(k));
                }
            }
        }
    }
}
