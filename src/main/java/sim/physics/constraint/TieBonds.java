// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import sim.physics.internal.Softness;
import sim.physics.motion.State;

/** The bonds of {@link TieTrees}: a joint each, with the motor of its angle if it is a pin, from the tips of trees to their roots. */
final class TieBonds implements Serializable {
    private static final long serialVersionUID = 2L;

    private static final int BLOCK = State.BLOCK;
    private static final int ROWS = Equations.ROWS;

    /** How far a joint may have opened, relative to its smaller body, before it is closed. */
    private static final double PARTED = 1e-8;

    /** What counts of a motor as all that it can give. */
    private static final double ALL = 1 - 1e-9;

    /** Of a bond: blocks of child and parent, −1 for what cannot move; place of the pin and of the other constraint, −1 for none; the bond of the parent, −1 for none; and what cannot move, −1 for the world. */
    private static final int ENDS = 6;

    private static final int PARENT = 1;
    private static final int PIN = 2;
    private static final int TIE = 3;
    private static final int UP = 4;
    private static final int GROUND = 5;

    private final State state;
    private final TieEquations equations;
    private final PinImpulses pins;

    private int[] bonds = {};
    private double[] data = {};

    /** By bond: the size of the smaller one of its bodies that can move, or the length of a rod between their middles. */
    private double[] sizes = {};

    TieBonds(State state, TieEquations equations, PinImpulses pins) {
        this.state = state;
        this.equations = equations;
        this.pins = pins;
    }

    /** Makes room for so many. */
    void clear(int count) {
        bonds = new int[ENDS * count];
        data = new double[TreeRows.STRIDE * count];
        sizes = new double[count];
        joints = count;
        this.count = count;
    }

    /** The body of a bond. */
    int child(int k) {
        return bonds[ENDS * k];
    }

    /** The other body of a bond, −1 for what cannot move. */
    int parent(int k) {
        return bonds[ENDS * k + PARENT];
    }

    /** The place of the pin of a bond, −1 for none. */
    int pin(int k) {
        return bonds[ENDS * k + PIN];
    }

    /** That of its other constraint, −1 for none. */
    int tie(int k) {
        return bonds[ENDS * k + TIE];
    }

    /** The values of bonds, as {@link TreeRows} lays them out. */
    double[] data() {
        return data;
    }

    /** The rows of a bond, with those of motors that may not act. */
    int rows(int k) {
        return (pin(k) >= 0 || tie(k) == CONTACT ? 2 : 0) + (tie(k) >= 0 ? equations.rows[tie(k)] : 0);
    }

    /** Marks the bodies of bonds. */
    void mark(int from, int to, boolean[] marks) {
        for (int k = from; k < to; k++) {
            marks[child(k) / BLOCK] = true;
        }
    }

    /** Whether joints hold their bodies where they are, by the number of their rows; bodies that only rods between middles hold may turn. */
    boolean isStructure(int from, int to) {
        Set<Integer> bodies = new HashSet<>();
        Set<Integer> turning = new HashSet<>();
        int rows = 0;
        boolean isHeld = false;
        for (int k = from; k < to; k++) {
            Set<Integer> those = isCentral(k) ? bodies : turning;
            those.add(child(k));
            those.add(parent(k));
            int own = pin(k) >= 0 ? 2 : rows(k);
            rows += own;
            isHeld |= own > 0 && parent(k) < 0;
        }
        bodies.removeAll(turning);
        bodies.remove(-1);
        turning.remove(-1);
        return isHeld && rows >= BLOCK * turning.size() + 2 * bodies.size();
    }

    private boolean isCentral(int k) {
        return tie(k) >= 0 && equations.ties[tie(k)] instanceof RodJoint rod && rod.isCentral();
    }

    /** The size of a bond, which tells whether it is wide open; of a contact, that of its smaller body. */
    double extent(int k) {
        return k < joints ? sizes[k] : smaller(child(k), parent(k));
    }

    private double smaller(int child, int parent) {
        return Math.min(size(child), parent < 0 ? Double.POSITIVE_INFINITY : size(parent));
    }

    /** Whether a row of a bond is one between angles. */
    boolean isAngle(int k, int row) {
        int ofTie = pin(k) >= 0 ? row - 2 : row;
        return ofTie >= 0 && tie(k) >= 0 && equations.ties[tie(k)].isAngle(ofTie);
    }

    /** A point of a contact in place of a constraint. */
    static final int CONTACT = -2;

    /** How many bonds are of joints, and how many there are. */
    private int joints;

    private int count;

    /** Forgets contacts. */
    void clearContacts() {
        count = joints;
    }

    /** Takes a point of a contact: two rows that a body has with another one, −1 for what cannot move; returns its place. */
    int addContact(int child, int parent) {
        if (ENDS * (count + 1) > bonds.length) {
            bonds = Arrays.copyOf(bonds, 2 * ENDS * (count + 1));
            data = Arrays.copyOf(data, 2 * TreeRows.STRIDE * (count + 1));
        }
        int o = ENDS * count;
        bonds[o] = child;
        bonds[o + PARENT] = parent;
        bonds[o + PIN] = -1;
        bonds[o + TIE] = CONTACT;
        bonds[o + UP] = -1;
        bonds[o + GROUND] = -1;
        Arrays.fill(data, TreeRows.STRIDE * count, TreeRows.STRIDE * (count + 1), 0);
        return count++;
    }

    /** Takes a tree, with its root at the last of its places. */
    void put(List<TieForest.Bond> tree, int last) {
        Map<Integer, Integer> places = new HashMap<>();
        for (int k = last, n = 0; n < tree.size(); n++, k--) {
            TieForest.Bond bond = tree.get(n);
            int o = ENDS * k;
            bonds[o] = bond.child;
            bonds[o + PARENT] = bond.parent;
            bonds[o + PIN] = bond.pin;
            bonds[o + TIE] = bond.tie;
            bonds[o + UP] = places.getOrDefault(bond.parent, -1);
            bonds[o + GROUND] = bond.ground;
            sizes[k] = smaller(bond.child, bond.parent);
            sizes[k] = isCentral(k) ? Math.max(sizes[k], equations.ties[bond.tie].getSize()) : sizes[k];
            places.put(bond.child, k);
        }
    }

    /** Takes J of bonds, what they are to get, and what they have got. */
    void read(int from, int to, double[] impulse, boolean placesOnly, Softness softness, double h) {
        for (int k = from; k < to; k++) {
            read(k, impulse, placesOnly, softness, h);
        }
    }

    private void read(int k, double[] impulse, boolean placesOnly, Softness softness, double h) {
        int o = TreeRows.STRIDE * k;
        int child = bonds[ENDS * k];
        int pin = bonds[ENDS * k + PIN];
        int tie = bonds[ENDS * k + TIE];
        int row = 0;
        Arrays.fill(data, o, o + TreeRows.READ, 0);
        if (pin >= 0) {
            read(pin, child, softness, o);
            row = 2;
        }
        if (tie < 0) {
            return;
        }
        if (isMotor(tie)) {
            if (!placesOnly && isMet(tie, impulse, h)) {
                copy(tie, 0, child, o, row);
                double bend = softness.rate() > 0 ? equations.bend[ROWS * tie] : 0;
                data[o + TreeRows.ASKED + row] = ((Motor) equations.ties[tie]).getSpeed() - equations.speed(tie, 0, state.v()) - bend;
                data[o + TreeRows.GIVEN + row] = impulse[ROWS * tie];
            }
            return;
        }
        for (int r = 0; r < equations.rows[tie]; r++) {
            copy(tie, r, child, o, r);
            double bend = softness.rate() > 0 ? equations.bend[ROWS * tie + r] : 0;
            data[o + TreeRows.ASKED + r] = -equations.speed(tie, r, state.v()) - bend - softness.rate() * equations.c[ROWS * tie + r];
            data[o + TreeRows.GIVEN + r] = impulse[ROWS * tie + r];
        }
    }

    private void read(int pin, int child, Softness softness, int o) {
        int end = pins.isFirst(pin, child) ? 0 : 1;
        double sign = 1 - 2 * end;
        double[] d = data;
        d[o] = 1;
        d[o + 2] = -pins.arm(pin, end, 1);
        d[o + 4] = 1;
        d[o + 5] = pins.arm(pin, end, 0);
        d[o + TreeRows.PARENT] = -1;
        d[o + TreeRows.PARENT + 2] = pins.arm(pin, 1 - end, 1);
        d[o + TreeRows.PARENT + 4] = -1;
        d[o + TreeRows.PARENT + 5] = -pins.arm(pin, 1 - end, 0);
        boolean bends = softness.rate() > 0;
        for (int m = 0; m < 2; m++) {
            d[o + TreeRows.ASKED + m] = -sign * (pins.speed(pin, 1 - m, m, bends) + softness.rate() * pins.open(pin, m));
            d[o + TreeRows.GIVEN + m] = sign * pins.impulse(pin, m);
        }
    }

    private void copy(int tie, int from, int child, int o, int row) {
        boolean isFirst = equations.blocks[2 * tie] == child;
        int first = TieEquations.J * tie + BLOCK * from;
        int second = first + BLOCK * ROWS;
        for (int m = 0; m < BLOCK; m++) {
            data[o + TreeRows.CHILD + BLOCK * row + m] = equations.j[(isFirst ? first : second) + m];
            data[o + TreeRows.PARENT + BLOCK * row + m] = equations.j[(isFirst ? second : first) + m];
        }
    }

    /** A steered body gets what its joint gives it, though nothing was asked of that. */
    private void push(int k, double[] w) {
        int ground = bonds[ENDS * k + GROUND];
        if (ground >= 0 && w[ground] > 0) {
            TreeRows.push(data, TreeRows.STRIDE * k, state.v(), w, ground);
        }
    }

    /** Takes note of what a bond has given. */
    private void book(int k, double[] impulse) {
        int o = TreeRows.STRIDE * k + TreeRows.GIVEN;
        int pin = bonds[ENDS * k + PIN];
        int tie = bonds[ENDS * k + TIE];
        if (pin >= 0) {
            double sign = pins.isFirst(pin, bonds[ENDS * k]) ? 1 : -1;
            pins.book(pin, sign * data[o], sign * data[o + 1]);
        }
        int rows = tie < 0 ? 0 : equations.rows[tie];
        int first = pin >= 0 ? 2 : 0;
        for (int r = first; r < first + rows; r++) {
            impulse[ROWS * tie + r - first] += data[o + r];
            int side = equations.blocks[2 * tie] == bonds[ENDS * k] ? TreeRows.CHILD : TreeRows.PARENT;
            for (int m = 0; m < BLOCK; m++) {
                equations.given[BLOCK * tie + m] += data[TreeRows.STRIDE * k + side + BLOCK * r + m] * data[o + r];
            }
        }
    }

    /** Adds energies: of what the rows of a bond are off, of what their impulses give, and of all that they have to do with. */
    void measure(int k, double[] off) {
        int parent = bonds[ENDS * k + PARENT];
        int other = parent < 0 ? bonds[ENDS * k + GROUND] : parent;
        TreeRows.measure(data, TreeRows.STRIDE * k, state.v(), state.w().values(), bonds[ENDS * k], other, off);
    }

    /** Takes note of the places that bodies are to have when they have moved: so much of what they are off is left. */
    void leave(int from, int to, double part) {
        for (int k = from; k < to; k++) {
            int o = TreeRows.STRIDE * k + TreeRows.LEFT;
            Arrays.fill(data, o, o + ROWS, 0);
            readPlaces(k, o);
            for (int r = o; r < o + ROWS; r++) {
                data[r] *= part;
            }
        }
    }

    /** Eliminates the bonds of a tree, of which J is read. */
    void factor(int from, int to) {
        double[] d = data;
        for (int k = from; k < to; k++) {
            TreeRows.begin(d, TreeRows.STRIDE * k, state.w().values(), bonds[ENDS * k]);
        }
        for (int k = from; k < to; k++) {
            TreeRows.eliminate(d, TreeRows.STRIDE * k);
            if (bonds[ENDS * k + UP] >= 0) {
                TreeRows.hang(d, TreeRows.STRIDE * k, TreeRows.STRIDE * bonds[ENDS * k + UP]);
            }
        }
    }

    /** Gives the bodies of a tree what its rows ask for. */
    void give(int from, int to, double[] impulse) {
        double[] d = data;
        for (int k = from; k < to; k++) {
            TreeRows.ask(d, TreeRows.STRIDE * k);
        }
        for (int k = from; k < to; k++) {
            TreeRows.lean(d, TreeRows.STRIDE * k, up(k));
        }
        for (int k = to - 1; k >= from; k--) {
            TreeRows.solve(d, TreeRows.STRIDE * k, up(k), state.v(), bonds[ENDS * k]);
            push(k, state.w().values());
            book(k, impulse);
        }
    }

    /** Takes note of what bonds have given, which was not given by {@link #give}. */
    void book(int from, int to, double[] impulse) {
        for (int k = from; k < to; k++) {
            push(k, state.w().values());
            book(k, impulse);
        }
    }

    private int up(int k) {
        int up = bonds[ENDS * k + UP];
        return up < 0 ? -1 : TreeRows.STRIDE * up;
    }

    /** Whether bodies have moved off the places that they were to have; what they are off is what is asked for then. */
    boolean haveParted(int from, int to, double h) {
        boolean yes = false;
        for (int k = from; k < to; k++) {
            int o = TreeRows.STRIDE * k;
            Arrays.fill(data, o + TreeRows.ASKED, o + TreeRows.GIVEN, 0);
            readPlaces(k, o + TreeRows.ASKED);
            for (int r = 0; r < ROWS; r++) {
                double off = data[o + TreeRows.ASKED + r] - data[o + TreeRows.LEFT + r];
                yes |= off != 0 && Math.abs(off) > PARTED * size(k, r);
                data[o + TreeRows.ASKED + r] = -off / h;
            }
        }
        return yes;
    }

    /** Takes C of the joint of a bond. */
    private void readPlaces(int k, int at) {
        int pin = bonds[ENDS * k + PIN];
        int tie = bonds[ENDS * k + TIE];
        if (pin >= 0) {
            double sign = pins.isFirst(pin, bonds[ENDS * k]) ? 1 : -1;
            data[at] = sign * pins.open(pin, 0);
            data[at + 1] = sign * pins.open(pin, 1);
        } else if (tie >= 0) {
            System.arraycopy(equations.c, ROWS * tie, data, at, equations.rows[tie]);
        }
    }

    /** Moves the bodies by what was given last, and marks them. */
    void move(int from, int to, double h, boolean[] marks) {
        double[] x = state.x();
        for (int k = from; k < to; k++) {
            int body = bonds[ENDS * k];
            for (int m = 0; m < BLOCK; m++) {
                x[body + m] += h * TreeRows.change(data, TreeRows.STRIDE * k, m);
            }
            marks[body / BLOCK] = true;
        }
    }

    /** Lets motors give no more than they can; whether there are some that did. */
    boolean slip(int from, int to, double[] impulse, double h) {
        boolean any = false;
        for (int k = from; k < to; k++) {
            int tie = bonds[ENDS * k + TIE];
            if (isMotor(tie) && Math.abs(impulse[ROWS * tie]) > most(tie, h)) {
                any = true;
                double given = impulse[ROWS * tie];
                impulse[ROWS * tie] = Math.copySign(most(tie, h), given);
                equations.push(tie, 0, impulse[ROWS * tie] - given);
            }
        }
        return any;
    }

    private boolean isMotor(int tie) {
        return tie >= 0 && equations.kinds[tie] == TieEquations.Kind.MOTOR;
    }

    private double most(int tie, double h) {
        return ((Motor) equations.ties[tie]).getLimit() * h;
    }

    private boolean isMet(int motor, double[] impulse, double h) {
        return Math.abs(impulse[ROWS * motor]) < ALL * most(motor, h);
    }

    /** Whether no motor would have to give more than it can, or does give that. */
    boolean areMotorsMet(int from, int to, double[] impulse, double h) {
        boolean areMet = true;
        for (int k = from; k < to && areMet; k++) {
            int tie = bonds[ENDS * k + TIE];
            areMet = !isMotor(tie) || isMet(tie, impulse, h);
        }
        return areMet;
    }

    /** Whether bodies turn so slowly that what is right before and after a move says something of the way between. */
    boolean areSlow(int from, int to, double spin) {
        boolean areSlow = true;
        for (int k = from; k < to && areSlow; k++) {
            areSlow = Math.abs(state.v()[bonds[ENDS * k] + State.THETA]) < spin;
        }
        return areSlow;
    }

    /** How far a joint is open at most, relative to its smaller body. */
    double widest(int from, int to) {
        double widest = 0;
        for (int k = from; k < to; k++) {
            int o = TreeRows.STRIDE * k + TreeRows.ASKED;
            Arrays.fill(data, o, o + ROWS, 0);
            readPlaces(k, o);
            for (int r = 0; r < ROWS; r++) {
                widest = data[o + r] == 0 ? widest : Math.max(widest, Math.abs(data[o + r]) / size(k, r));
            }
        }
        return widest;
    }

    /** The size of a body. */
    double size(int body) {
        return state.body(body / BLOCK).getShape().boundingRadius();
    }

    private double size(int k, int row) {
        return isAngle(k, row) ? 1 : sizes[k];
    }
}
