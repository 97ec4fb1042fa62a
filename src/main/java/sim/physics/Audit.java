// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import java.util.Arrays;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.CourseObserver;
import sim.physics.motion.Motion;
import sim.physics.motion.ReferenceMotion;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;

/**
 * Keeps the books of an engine: of each body it remembers the energy at the end of its last path, so that what it has at the
 * start of the next one tells what an impact, or an author, has done. Paths of driven bodies are compared with a
 * {@link ReferenceMotion}; those of free ones are exact, and their forces constant.
 */
final class Audit implements CourseObserver {
    private static final long serialVersionUID = 1L;

    /** A path: the line of its anchor, and that of its bends. */
    private static final int BENDS = Trajectories.STRIDE;

    private static final int PATH = 2 * BENDS;

    private final State state;
    private final Trajectories trajectories;
    private final ReferenceMotion reference;

    /** By body: its energy of motion and in uniform fields at the end of its last path; NaN for an unknown body. */
    private double[] last = {};

    /** The paths of free bodies since they were noted last, as in {@link Trajectories}, and the offsets since when. */
    private double[] paths = {};

    private double[] since = {};

    private boolean isOpen;
    private boolean isByAuthor;

    /** The energy at the end of this step and of the one before. */
    private double end;

    private double before;
    private double work;
    private double impacts;
    private double authored;
    private double placeError;
    private double angleError;
    private long unresolved;
    private StepReport step = new StepReport(0, 0, 0, 0, 0, 0, 0, 0, 0);
    private StepReport run = step;
    private long steps;

    Audit(State state, Trajectories trajectories, Motion motion) {
        this.state = state;
        this.trajectories = trajectories;
        reference = new ReferenceMotion(motion, state, trajectories);
    }

    StepReport step() {
        return step;
    }

    StepReport run() {
        return run;
    }

    /** Begins a step, when all changes between steps have been let in. */
    void open() {
        int n = state.size();
        if (since.length < n) {
            since = Arrays.copyOf(since, 2 * n);
            last = Arrays.copyOf(last, 2 * n);
            paths = Arrays.copyOf(paths, 2 * n * PATH);
        }
        Arrays.fill(last, Double.NaN);
        double now = energy();
        before = steps == 0 ? now : end;
        for (int i = 0; i < n; i++) {
            if (isMovable(i)) {
                last[i] = energy(i);
                follow(i, 0);
            }
        }
        authored = now - before;
        work = 0;
        impacts = 0;
        placeError = 0;
        angleError = 0;
        unresolved = 0;
        isOpen = true;
    }

    private boolean isMovable(int body) {
        return state.body(body) != null && state.body(body).isDynamic();
    }

    /** All energy, where the state vectors have the bodies. */
    private double energy() {
        double sum = reference.storedEnergy();
        for (int i = 0; i < state.size(); i++) {
            sum += isMovable(i) ? energy(i) : 0;
        }
        return sum;
    }

    private double energy(int body) {
        int b = State.BLOCK * body;
        double[] x = state.x();
        double[] v = state.v();
        return energy(body, x[b], x[b + 1], v[b], v[b + 1], v[b + 2]);
    }

    private double energy(int body, double x, double y, double vx, double vy, double omega) {
        Body view = state.body(body);
        double motion = 0.5 * (view.getMass() * (vx * vx + vy * vy) + view.getInertia() * (omega * omega));
        return motion + reference.fieldEnergy(body, x, y);
    }

    /** Remembers the path that a body has from an instant on. */
    private void follow(int body, double tau) {
        copyPath(body, paths, PATH * body);
        since[body] = tau;
    }

    /** Copies both lines of a body's path. */
    private void copyPath(int body, double[] to, int at) {
        int o = Trajectories.STRIDE * body;
        System.arraycopy(trajectories.data(), o, to, at, Trajectories.STRIDE);
        System.arraycopy(trajectories.bends(), o & trajectories.bendMask(), to, at + BENDS, Trajectories.STRIDE);
    }

    /** A body has a path, maybe a new one, from an instant on. */
    void noted(int body, double tau) {
        if (!isOpen || !isMovable(body)) {
            return;
        }
        if (body >= since.length) {
            int known = last.length;
            since = Arrays.copyOf(since, 2 * body);
            last = Arrays.copyOf(last, 2 * body);
            Arrays.fill(last, known, last.length, Double.NaN);
            paths = Arrays.copyOf(paths, 2 * body * PATH);
        }
        begin(body, tau);
    }

    /** Ends the path of a body that it had, and begins the one that it has: what is new an impact has given it, or an author. */
    private void begin(int body, double tau) {
        close(body, tau);
        double now = energyNow(body, trajectories.isDriven(body) ? trajectories.offset(body) : tau);
        double change = Double.isNaN(last[body]) ? now : now - last[body];
        if (isByAuthor || Double.isNaN(last[body])) {
            authored += change;
        } else {
            impacts += change;
        }
        last[body] = now;
        follow(body, tau);
    }

    /** An author has written a body, or adds it, and its path is about to be made anew; until {@link #admitted}. */
    void written(int body, double tau) {
        if (isOpen && body < since.length && isMovable(body)) {
            close(body, tau);
        }
        isByAuthor = true;
    }

    void admitted(int body, double tau) {
        noted(body, tau);
        isByAuthor = false;
    }

    /** A body leaves the engine. */
    void removed(int body) {
        if (isOpen && body < since.length && !Double.isNaN(last[body])) {
            authored -= last[body];
            last[body] = Double.NaN;
        }
    }

    /** Ends the path of a free body: its forces beside uniform fields are constant, and so is their power along it. */
    private void close(int body, double tau) {
        int o = PATH * body;
        if (Double.isNaN(last[body]) || paths[o + BENDS + Trajectories.DRIVEN] != 0 || tau == since[body]) {
            return;
        }
        Body view = state.body(body);
        double fx = view.getMass() * (2 * paths[o + BENDS + Trajectories.AX] - reference.field(false));
        double fy = view.getMass() * (2 * paths[o + BENDS + Trajectories.AY] - reference.field(true));
        double torque = view.getInertia() * (2 * paths[o + BENDS + Trajectories.ATHETA]);
        work += fx * (at(body, 0, tau) - at(body, 0, since[body]))
                + fy * (at(body, 1, tau) - at(body, 1, since[body]))
                + torque * (at(body, 2, tau) - at(body, 2, since[body]));
        last[body] = energyOn(paths, PATH * body, body, tau);
        since[body] = tau;
    }

    private double at(int body, int coordinate, double tau) {
        int o = PATH * body;
        int c = o + coordinate;
        double d = duration(paths, o, tau);
        return paths[c] + d * (paths[c + Trajectories.VX] + d * (paths[c + BENDS + Trajectories.AX] + d * paths[c + BENDS + Trajectories.JX]));
    }

    private double duration(double[] m, int o, double tau) {
        double steps = (trajectories.step() - m[o + Trajectories.STEP]) * trajectories.h();
        return steps + (tau - m[o + Trajectories.OFFSET]);
    }

    private double energyNow(int body, double tau) {
        double[] path = new double[PATH];
        copyPath(body, path, 0);
        return energyOn(path, 0, body, tau);
    }

    private double energyOn(double[] m, int o, int body, double tau) {
        double d = duration(m, o, tau);
        double[] now = new double[State.BLOCK + State.BLOCK];
        for (int c = 0; c < State.BLOCK; c++) {
            double v = m[o + Trajectories.VX + c];
            double a = m[o + BENDS + Trajectories.AX + c];
            double j = m[o + BENDS + Trajectories.JX + c];
            now[c] = m[o + c] + d * (v + d * (a + d * j));
            now[State.BLOCK + c] = v + d * (2 * a + 3 * d * j);
        }
        return energy(body, now[0], now[1], now[3], now[4], now[5]);
    }

    @Override
    public void decided(IntList group) {
        reference.decided(group);
    }

    @Override
    public void covered(IntList group, double from, double to) {
        if (!isOpen || from == to) {
            return;
        }
        for (int k = 0; k < group.size; k++) {
            begin(group.values[k], from); // an impact may have turned it here, and it got no path yet
        }
        if (reference.cover(group, from, to)) {
            work += reference.work();
            placeError += reference.place();
            angleError += reference.angle();
        } else {
            unresolved++;
        }
        for (int k = 0; k < group.size; k++) {
            last[group.values[k]] = energy(group.values[k]);
        }
    }

    /** Ends a step, when the state vectors hold its end. */
    void close() {
        for (int i = 0; i < state.size(); i++) {
            if (isMovable(i) && i < since.length) {
                close(i, trajectories.h());
            }
        }
        isOpen = false;
        end = energy();
        double drift = end - before - work - impacts - authored;
        step = new StepReport(before, end, work, impacts, authored, drift, placeError, angleError, unresolved);
        run = new StepReport(
                steps == 0 ? before : run.energyBefore(),
                end,
                run.work() + work,
                run.impacts() + impacts,
                run.authored() + authored,
                run.drift() + drift,
                run.placeError() + placeError,
                run.angleError() + angleError,
                run.unresolved() + unresolved);
        steps++;
    }
}
