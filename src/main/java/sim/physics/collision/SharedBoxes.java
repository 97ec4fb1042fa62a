// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.util.Arrays;
import sim.physics.collision.broad.Boxes;
import sim.physics.internal.IntList;
import sim.physics.internal.Team;
import sim.physics.motion.Trajectories;

/** New boxes of bodies that leave theirs, which several threads make ahead of the broad phase. */
final class SharedBoxes implements Team.Work {
    private final CollisionDetection detection;
    private final Team team;
    private final Boxes ahead = new Boxes();
    private final Room room;
    private IntList bodies;
    private long[] dates = {};
    private long step;
    private double h;

    SharedBoxes(CollisionDetection detection, Trajectories trajectories, Team team) {
        this.detection = detection;
        this.team = team;
        room = new Room(trajectories, ahead);
    }

    /** Makes the boxes from the start of a step on. */
    void make(IntList leaving, int count, long step, double h) {
        bodies = leaving;
        this.step = step;
        this.h = h;
        ahead.ensure(count);
        if (dates.length < leaving.size) {
            dates = Arrays.copyOf(dates, 2 * leaving.size);
        }
        if (team.run(this, leaving.size) >= 0) {
            Team.rethrow(team.failure());
        }
        bodies = null;
    }

    @Override
    public void work(int worker, int item) {
        int body = bodies.values[item];
        room.enclose(body, 0, detection.end(body));
        dates[item] = room.leavingDate(body, 0, step, h);
    }

    /** The box that was made for a body. */
    void put(int body, Boxes boxes) {
        System.arraycopy(ahead.data(), Boxes.STRIDE * body, boxes.data(), Boxes.STRIDE * body, Boxes.STRIDE);
    }

    /** When the k-th body leaves it. */
    long date(int k) {
        return dates[k];
    }
}
