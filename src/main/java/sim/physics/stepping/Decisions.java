// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.State;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.response.ContactLaws;
import sim.physics.response.ContactListener;
import sim.physics.response.LastingContact;

/**
 * What listeners are asked before a step of time stepping, and told after it: between steps, so that they may change anything.
 */
public final class Decisions implements NearPairs.Ending {
    private static final long serialVersionUID = 1L;

    private final State state;
    private final ContactLaws laws;
    private final ContactRows rows;
    private NearPairs near;

    /** Pairs that are about to touch, and what listeners are asked about them. */
    private final IntList asked = new IntList();

    private final List<Contact> questions = new ArrayList<>();

    /** Pairs of which listeners of lasting contacts have been told. */
    private final IntList told = new IntList();

    private final List<Body> ended = new ArrayList<>();
    /** How many of the contacts that last now lasted before. */
    private int lasted;

    private double time;
    private double h;
    private long impacts;

    Decisions(State state, ContactLaws laws, ContactRows rows) {
        this.state = state;
        this.laws = laws;
        this.rows = rows;
    }

    void setPairs(NearPairs near) {
        this.near = near;
    }

    void begin(double now, double step) {
        time = now;
        h = step;
        asked.clear();
        questions.clear();
    }

    /** Whether a pair is not to be solved before listeners are asked; those that will touch in the step are noted. */
    boolean isOpen(int row) {
        int pair = rows.pair(row);
        if (!laws.areHeard() || near.is(pair, NearPairs.DECIDED)) {
            return false;
        }
        if (rows.touches(row, h)) {
            asked.add(pair);
            questions.add(contact(row, 0));
        }
        return true;
    }

    private Contact contact(int row, double impulse) {
        int b = State.BLOCK * rows.second(row);
        double approach = rows.approach(row, 0);
        double x = rows.armX(row, 0);
        double y = rows.armY(row, 0);
        if (rows.pointCount(row) == 2) {
            approach = Math.max(approach, rows.approach(row, 1));
            x = 0.5 * (x + rows.armX(row, 1));
            y = 0.5 * (y + rows.armY(row, 1));
        }
        return new Contact(
                state.body(rows.first(row)), state.body(rows.second(row)), time,
                state.x()[b] + x, state.x()[b + 1] + y, rows.normalX(row), rows.normalY(row), Math.max(0, approach), impulse);
    }

    /** {@return whether listeners are to be asked} */
    public boolean areOpen() {
        return asked.size > 0;
    }

    /** Asks the listeners about all pairs that are about to touch; they may change anything. The step must begin anew then. */
    public void ask() {
        List<Contact> those = new ArrayList<>(questions);
        int[] pairs = Arrays.copyOf(asked.values, asked.size);
        for (int k = 0; k < pairs.length; k++) {
            Contact contact = those.get(k);
            if (!isStill(pairs[k], contact)) {
                continue; // a listener has removed one of the two
            }
            CollisionListener.Decision decision = laws.ask(contact);
            if (isStill(pairs[k], contact)) {
                int sticky = decision == CollisionListener.Decision.STICK ? NearPairs.STICKY : 0;
                int ignored = decision == CollisionListener.Decision.IGNORE ? NearPairs.IGNORED : 0;
                near.flags[pairs[k]] |= NearPairs.DECIDED | sticky | ignored;
            }
        }
    }

    private boolean isStill(int pair, Contact contact) {
        return !near.is(pair, NearPairs.FORBIDDEN)
                && state.body(near.pairs().first(pair)) == contact.a()
                && state.body(near.pairs().second(pair)) == contact.b();
    }

    /** Takes note of what has begun to press, and tells the listeners of it, and of what lasts, when the step is over. */
    public void tell() {
        boolean isHeard = laws.areHeard();
        List<Contact> begun = isHeard ? new ArrayList<>() : null;
        for (int row = 0; row < rows.count; row++) {
            int pair = rows.pair(row);
            double impulse = rows.impulse(row);
            if (impulse > 0 && !near.is(pair, NearPairs.TOUCHED)) {
                impacts++;
                if (isHeard) {
                    begun.add(contact(row, impulse));
                }
            }
            int flags = near.flags[pair];
            boolean parts = impulse == 0 || rows.hasBounced(row);
            near.flags[pair] = parts ? flags & (NearPairs.TOLD | NearPairs.IGNORED) : flags | NearPairs.TOUCHED;
        }
        List<ContactListener> lasting = laws.lasting();
        List<LastingContact> contacts = lasting.isEmpty() ? null : notes();
        for (int k = 0; isHeard && k < begun.size(); k++) {
            laws.tell(begun.get(k));
        }
        if (contacts != null) {
            tellLasting(new ArrayList<>(lasting), contacts);
        } else {
            ended.clear();
        }
    }

    /** The contacts that last, those that lasted before first; and notes which have ended. */
    private List<LastingContact> notes() {
        List<LastingContact> contacts = new ArrayList<>();
        List<LastingContact> begun = new ArrayList<>();
        IntList now = new IntList();
        IntList before = new IntList();
        for (int k = 0; k < told.size; k++) {
            if (near.is(told.values[k], NearPairs.TOLD)) {
                before.add(told.values[k]);
            }
        }
        for (int row = 0; row < rows.count; row++) {
            if (lasts(row)) {
                int pair = rows.pair(row);
                now.add(pair);
                (near.is(pair, NearPairs.TOLD) ? contacts : begun).add(lasting(row));
            }
        }
        for (int k = 0; k < before.size; k++) {
            int pair = before.values[k];
            if (!now.contains(pair)) {
                near.flags[pair] &= ~NearPairs.TOLD;
                ended(near.pairs().first(pair), near.pairs().second(pair));
            }
        }
        lasted = contacts.size();
        told.clear();
        for (int k = 0; k < now.size; k++) {
            near.flags[now.values[k]] |= NearPairs.TOLD;
            told.add(now.values[k]);
        }
        contacts.addAll(begun);
        return contacts;
    }

    private void tellLasting(List<ContactListener> listeners, List<LastingContact> contacts) {
        List<Body> over = new ArrayList<>(ended);
        int old = lasted;
        ended.clear();
        for (ContactListener listener : listeners) {
            for (int k = 0; k < over.size(); k += 2) {
                listener.ended(over.get(k), over.get(k + 1));
            }
            for (int k = 0; k < contacts.size(); k++) {
                if (k < old) {
                    listener.lasts(contacts.get(k));
                } else {
                    listener.began(contacts.get(k));
                }
            }
        }
    }

    @Override
    public void ended(int a, int b) {
        ended.add(state.body(a));
        ended.add(state.body(b));
    }

    private boolean lasts(int row) {
        return rows.impulse(row) > 0 && !rows.hasBounced(row);
    }

    List<LastingContact> contacts(Body body) {
        List<LastingContact> all = new ArrayList<>();
        for (int row = 0; row < rows.count; row++) {
            Body a = state.body(rows.first(row));
            Body b = state.body(rows.second(row));
            if (a != null && b != null && lasts(row) && (body == null || a == body || b == body)) {
                all.add(lasting(row));
            }
        }
        return all;
    }

    private LastingContact lasting(int row) {
        Body a = state.body(rows.first(row));
        Body b = state.body(rows.second(row));
        double normal = 0;
        double tangent = 0;
        double x = 0;
        double y = 0;
        for (int k = 0; k < rows.pointCount(row); k++) {
            double one = rows.normalSum(row, k);
            normal += one;
            tangent += rows.tangentSum(row, k);
            x += one * rows.armX(row, k);
            y += one * rows.armY(row, k);
        }
        return new LastingContact(
                a, b, b.getX() + x / normal, b.getY() + y / normal, rows.normalX(row), rows.normalY(row), normal / h, tangent / h);
    }

    /** {@return number of pairs that have begun to press on one another} */
    public long impacts() {
        return impacts;
    }
}
