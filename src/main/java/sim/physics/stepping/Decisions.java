// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import sim.physics.internal.IntList;
import sim.physics.internal.Length;
import sim.physics.motion.Body;
import sim.physics.motion.State;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.response.ContactLaws;
import sim.physics.response.LastingContact;
import sim.physics.response.MeanPush;

/**
 * What listeners are asked when a step of time stepping begins, when they may change bodies, joints and filters, and told when it is
 * over, when they may change anything.
 */
public final class Decisions implements Serializable {
    private static final long serialVersionUID = 2L;

    private final State state;
    private final ContactLaws laws;
    private final ContactRows rows;
    private NearPairs near;

    /** What sleeping bodies bear. */
    private ContactRows kept;

    /** Pairs that are about to touch, and what listeners are asked about them. */
    private final IntList asked = new IntList();

    /** Null until the first step; they are no part of what is saved. */
    private transient List<Contact> questions;

    /** Of which pairs a listener has given a body another shape, so that they begin anew, and what it has answered: until the step has begun anew. */
    private transient List<Contact> forgotten;

    private final IntList answers = new IntList();
    private boolean isAnswered;

    /** Pairs that touch only if a third body strikes one of the two; those that one may reach, and whether these are being looked at. */
    private final ThirdParties thirds;

    private final IntList reached = new IntList();
    private boolean isReached;

    /** What a pair did in the step. */
    private final MeanPush mean = new MeanPush();

    /** What contacts did in the step before the part of it that is being made, if that is not all of it. */
    private final EarlierPushes earlier;

    private double length;
    private double time;
    private double h;
    private long impacts;

    Decisions(State state, ContactLaws laws, ContactRows rows) {
        this.state = state;
        this.laws = laws;
        this.rows = rows;
        this.thirds = new ThirdParties(state, rows);
        this.earlier = new EarlierPushes(state);
    }

    void setPairs(NearPairs near, ContactRows kept) {
        this.near = near;
        this.kept = kept;
    }

    /**
     * Begins a step that may be made in parts.
     *
     * @param step its length
     */
    public void beginStep(double step) {
        length = step;
        earlier.clear();
    }

    /**
     * Takes note of what contacts did in the step before time stepping took over.
     *
     * @param contacts with their mean forces over the whole step
     */
    public void takeOver(List<LastingContact> contacts) {
        earlier.add(contacts, length);
    }

    void begin(double now, double step) {
        time = now;
        h = step;
        asked.clear();
        if (questions == null) {
            questions = new ArrayList<>();
            forgotten = new ArrayList<>();
        }
        questions.clear();
        if (!isAnswered) {
            forgotten.clear();
            answers.clear();
        }
        isAnswered = false;
        isReached = false;
        thirds.begin();
    }

    /** Whether a pair is not to be solved before listeners are asked; those that will touch in the step are noted. */
    boolean isOpen(int row) {
        if (!laws.areHeard()) {
            return false;
        }
        int pair = rows.pair(row);
        boolean isOpen = !near.is(pair, NearPairs.DECIDED);
        boolean touches = rows.touches(row, h);
        if (touches) {
            thirds.strike(row, h, isOpen);
        }
        if (isOpen && (touches || isReached)) {
            asked.add(pair);
            questions.add(contact(row));
        }
        if (!isReached) {
            thirds.wait(row, h, isOpen && !touches);
        }
        return isOpen;
    }

    /** {@return the pairs that are to be looked at once more, as a third body may bring them together: listeners are asked about them, too} */
    IntList reached() {
        thirds.find(reached);
        isReached = true;
        return reached;
    }

    private Contact contact(int row) {
        int b = State.BLOCK * rows.second(row);
        double x = rows.armX(row, 0);
        double y = rows.armY(row, 0);
        if (rows.pointCount(row) == 2) {
            x = 0.5 * (x + rows.armX(row, 1));
            y = 0.5 * (y + rows.armY(row, 1));
        }
        findMean(rows, row);
        double impulse = Length.of(mean.normal, mean.tangential);
        return new Contact(
                state.body(rows.first(row)), state.body(rows.second(row)), time,
                state.x()[b] + x, state.x()[b + 1] + y, mean.nx, mean.ny, Math.max(0, approach(row)), impulse);
    }

    /** How fast the two bodies of a row come towards one another, at the faster one of its points. */
    private double approach(int row) {
        double first = rows.approach(row, 0);
        return rows.pointCount(row) == 2 ? Math.max(first, rows.approach(row, 1)) : first;
    }

    /** {@return whether listeners are to be asked} */
    public boolean areOpen() {
        return asked.size > 0;
    }

    /** Asks the listeners about all pairs that are about to touch; the step must begin anew then. */
    public void ask() {
        for (int k = 0; k < asked.size; k++) {
            int pair = asked.values[k];
            Contact contact = questions.get(k);
            if (!isStill(pair, contact)) {
                continue; // a listener has removed one of the two
            }
            CollisionListener.Decision decision = laws.ask(contact);
            if (isStill(pair, contact)) {
                int sticky = decision == CollisionListener.Decision.STICK ? NearPairs.STICKY : 0;
                int ignored = decision == CollisionListener.Decision.IGNORE ? NearPairs.IGNORED : 0;
                near.flags[pair] |= NearPairs.DECIDED | sticky | ignored;
            }
        }
        for (int k = 0; k < asked.size; k++) {
            Contact contact = questions.get(k);
            if (isStill(asked.values[k], contact) && (isReshaped(contact.a()) || isReshaped(contact.b()))) {
                forgotten.add(contact); // it is another pair when the step begins anew
                answers.add(near.flags[asked.values[k]] & (NearPairs.DECIDED | NearPairs.STICKY | NearPairs.IGNORED));
            }
        }
        isAnswered = true;
    }

    private boolean isReshaped(Body body) {
        return state.isTouched(body.index()) && state.touched().isReshaped(body.index());
    }

    /** Gives a pair the answer about its bodies, if one of them was given another shape when listeners were asked. */
    void recall(int pair) {
        for (int k = 0; k < answers.size; k++) {
            Body a = forgotten.get(k).a();
            Body first = state.body(near.pairs().first(pair));
            Body second = state.body(near.pairs().second(pair));
            if (first == a && second == forgotten.get(k).b() || second == a && first == forgotten.get(k).b()) {
                near.flags[pair] |= answers.values[k];
            }
        }
    }

    private boolean isStill(int pair, Contact contact) {
        return areThere(contact)
                && !near.is(pair, NearPairs.FORBIDDEN)
                && state.body(near.pairs().first(pair)) == contact.a()
                && state.body(near.pairs().second(pair)) == contact.b();
    }

    /**
     * Takes note of what has begun to press, and tells the listeners of it; and of what lasts, when the step is over.
     *
     * @param isOver whether it is, or else a part of it
     */
    public void tell(boolean isOver) {
        List<Contact> begun = begun();
        for (int k = 0; begun != null && k < begun.size(); k++) {
            if (areThere(begun.get(k))) { // or a listener has removed one of the two
                laws.tell(begun.get(k));
            }
        }
        if (isOver) {
            tellLasting();
        }
    }

    /** Takes note of what presses in a part of the step that is over, which is not the last one. */
    public void keepPart() {
        List<LastingContact> contacts = new ArrayList<>();
        gather(rows, new IntList(), contacts);
        gather(kept, new IntList(), contacts);
        earlier.add(contacts, h);
    }

    /** Takes note of what presses; what has begun to do so or has bounced, null if nobody wants to know. */
    private List<Contact> begun() {
        List<Contact> begun = laws.areHeard() ? new ArrayList<>() : null;
        for (int row = 0; row < rows.count; row++) {
            int pair = rows.pair(row);
            double impulse = rows.impulse(row);
            boolean isImpact = !near.is(pair, NearPairs.TOUCHED) || rows.hasBounced(row); // what lay and bounces off lasts no more
            if (impulse > 0 && isImpact) {
                impacts++;
                if (begun != null) {
                    begun.add(contact(row));
                }
            }
            boolean parts = impulse == 0 || rows.hasBounced(row);
            near.flags[pair] = parts ? near.flags[pair] & NearPairs.IGNORED : near.flags[pair] | NearPairs.TOUCHED;
        }
        return begun;
    }

    private boolean areThere(Contact contact) {
        return contact.a().state() == state && contact.b().state() == state;
    }

    private void tellLasting() {
        if (!laws.areLastingHeard()) {
            laws.tellLasting(null, null);
            return;
        }
        IntList pairs = new IntList();
        List<LastingContact> contacts = new ArrayList<>();
        gather(pairs, contacts);
        laws.tellLasting(pairs, contacts);
    }

    /** Gathers the contacts that last, and their pairs, with what they did in all of the step. */
    private void gather(IntList pairs, List<LastingContact> contacts) {
        gather(rows, pairs, contacts);
        gather(kept, pairs, contacts);
        if (!earlier.isEmpty()) {
            earlier.merge(pairs, contacts, h, length);
        }
    }

    /** Gathers those of some rows. */
    private void gather(ContactRows rows, IntList pairs, List<LastingContact> contacts) {
        for (int row = 0; row < rows.count; row++) {
            if (lasts(rows, row)) {
                pairs.add(rows.pair(row));
                contacts.add(lasting(rows, row));
            }
        }
    }

    /** Gathers those of a body. */
    private void gather(ContactRows rows, int body, List<LastingContact> contacts) {
        for (int row = rows.byBody.first(body); row >= 0; row = rows.byBody.next(row, body)) {
            if (lasts(rows, row)) {
                contacts.add(lasting(rows, row));
            }
        }
    }

    /** Whether two bodies press on one another at the end of the last step; one that was removed since, or its successor, does not. */
    private boolean lasts(ContactRows rows, int row) {
        return rows.impulse(row) > 0 && !rows.hasBounced(row) && !near.is(rows.pair(row), NearPairs.FORBIDDEN);
    }

    List<LastingContact> contacts(Body body) {
        List<LastingContact> all = new ArrayList<>();
        if (body == null || !earlier.isEmpty()) {
            gather(new IntList(), all);
            all.removeIf(c -> body != null && c.a() != body && c.b() != body);
        } else {
            gather(rows, body.index(), all);
            gather(kept, body.index(), all);
        }
        return all;
    }

    private LastingContact lasting(ContactRows rows, int row) {
        Body a = state.body(rows.first(row));
        Body b = state.body(rows.second(row));
        double normal = 0;
        double x = 0;
        double y = 0;
        for (int k = 0; k < rows.pointCount(row); k++) {
            double one = rows.of(row, k, ContactRows.NORMAL_SUM);
            normal += one;
            x += one * rows.armX(row, k);
            y += one * rows.armY(row, k);
        }
        findMean(rows, row);
        return new LastingContact(
                a, b, b.getX() + x / normal, b.getY() + y / normal, mean.nx, mean.ny, mean.normal / h, mean.tangential / h);
    }

    /** {@return number of pairs that have begun to press on one another} */
    public long impacts() {
        return impacts;
    }

    /** What a pair did in the step, in the mean. */
    private void findMean(ContactRows rows, int k) {
        double moreX = rows.turned[ContactRows.TURNED * k];
        double moreY = rows.turned[ContactRows.TURNED * k + 1];
        mean.find(rows.normalX(k), rows.normalY(k), rows.impulse(k), rows.rubbed(k), moreX, moreY);
    }
}
