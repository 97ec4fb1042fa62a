// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.util.Arrays;
import sim.physics.collision.broad.Boxes;
import sim.physics.internal.Agenda;
import sim.physics.internal.IntList;
import sim.physics.internal.Team;

/** New boxes of bodies at the start of a step, which several threads make ahead of the broad phase. */
final class SharedBoxes implements Team.Work {
    private final CollisionDetection detection;
    private final Team team;

    /** The room in the boxes that the bodies are in, and in those to come. */
    private final Room present;

    private final Room next;
    private final Boxes ahead = new Boxes();
    private IntList bodies;
    private long[] dates = {};
    private boolean[] isNew = {};
    private boolean mayStay;
    private long step;
    private double h;

    SharedBoxes(CollisionDetection detection, Room present, Team team) {
        this.detection = detection;
        this.team = team;
        this.present = present;
        next = present.with(ahead);
    }

    /** Makes new boxes for bodies that leave theirs. */
    void renew(IntList leaving, int size, long step, double h) {
        mayStay = false;
        make(leaving, size, step, h);
    }

    /** Makes new boxes for driven bodies with new paths that do not stay in theirs. */
    void enter(IntList driven, int size, long step, double h) {
        mayStay = true;
        make(driven, size, step, h);
    }

    private void make(IntList those, int size, long step, double h) {
        bodies = those;
        this.step = step;
        this.h = h;
        ahead.ensure(size);
        if (dates.length < those.size) {
            dates = Arrays.copyOf(dates, 2 * those.size);
            isNew = Arrays.copyOf(isNew, dates.length);
        }
        if (team.run(this, those.size) >= 0) {
            Team.rethrow(team.failure());
        }
        bodies = null;
    }

    @Override
    public void work(int worker, int item) {
        int body = bodies.values[item];
        double end = detection.end(body);
        boolean stays = mayStay && present.holds(body, 0, end);
        long date = stays ? Agenda.NEVER : mayStay ? present.leavingDate(body, 0, step, h) : step;
        isNew[item] = date <= step;
        if (date <= step) {
            date = next.enclose(body, 0, end, step, h);
        }
        dates[item] = date;
    }

    /** Whether there is a new box for the k-th body. */
    boolean isNew(int k) {
        return isNew[k];
    }

    /** The box that was made for a body. */
    void put(int body, Boxes boxes) {
        System.arraycopy(ahead.data(), Boxes.STRIDE * body, boxes.data(), Boxes.STRIDE * body, Boxes.STRIDE);
    }

    /** When the k-th body leaves its box. */
    long date(int k) {
        return dates[k];
    }
}
