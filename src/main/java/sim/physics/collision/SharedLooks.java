// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.util.Arrays;
import sim.physics.internal.Team;

/**
 * Looks at many pairs that several threads share, and keeps what they find until it is made use of, in the order of the
 * list and by one thread. So it does not matter who looked at which pair.
 */
final class SharedLooks implements Team.Work {
    private final CollisionDetection detection;
    private final Watch watch;
    private final Team team;
    private final PairSearch[] searches;

    private int[] pairs = new int[64];
    private double[] offsets = new double[64];
    private byte[] kinds = new byte[64];
    private int size;

    SharedLooks(CollisionDetection detection, Watch watch, PairSearch search, Team team) {
        this.detection = detection;
        this.watch = watch;
        this.team = team;
        searches = new PairSearch[team.size()];
        searches[0] = search;
        for (int k = 1; k < searches.length; k++) {
            searches[k] = search.twin();
        }
    }

    /** Adds a pair, once, to be looked at from an offset on. */
    void add(int pair, double tau) {
        if (size == pairs.length) {
            pairs = Arrays.copyOf(pairs, 2 * size);
            offsets = Arrays.copyOf(offsets, 2 * size);
            kinds = Arrays.copyOf(kinds, 2 * size);
        }
        pairs[size] = pair;
        offsets[size++] = tau;
    }

    /** Looks at all pairs that were added, and tells what was found. */
    void look() {
        for (int k = 1; k < searches.length; k++) {
            searches[k].narrowPhase().match(searches[0].narrowPhase());
        }
        int failed = team.run(this, size);
        for (int k = 1; k < searches.length; k++) {
            searches[0].narrowPhase().take(searches[k].narrowPhase());
        }
        int count = failed < 0 ? size : failed;
        size = 0;
        for (int k = 0; k < count; k++) {
            watch.plan(pairs[k], kinds[k], offsets[k]);
        }
        if (failed >= 0) {
            Team.rethrow(team.failure());
        }
    }

    @Override
    public void work(int worker, int item) {
        PairSearch search = searches[worker];
        int pair = pairs[item];
        offsets[item] = search.look(pair, offsets[item], detection.pathEnd(pair));
        kinds[item] = search.found;
    }
}
