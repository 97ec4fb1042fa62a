// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** All scenes of the report. */
final class Suite {
    private Suite() {}

    /** In the order of their numbers; the long ones in full length only if asked for. */
    static List<ReportScene> all(boolean full) {
        List<ReportScene> all = new ArrayList<>(JointScenes.all(full));
        all.addAll(ShiftedScenes.all());
        all.addAll(OtherScenes.all(full));
        all.addAll(ContactScenes.all(full));
        all.sort(Comparator.comparing(scene -> scene.id.substring(0, 3)));
        return all;
    }
}
