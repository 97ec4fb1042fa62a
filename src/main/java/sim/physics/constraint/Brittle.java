// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.List;

/** Whether some joint of some group can break: each step asks, and seldom is it another answer than the one before. */
final class Brittle implements Serializable {
    private static final long serialVersionUID = 1L;

    private boolean isAny;

    /** Of which version of the islands that is known. */
    private long known = -1;

    boolean isAny(List<TiedGroup> groups, long version) {
        if (known != version) {
            isAny = false;
            for (int k = 0; k < groups.size(); k++) {
                isAny |= groups.get(k).isBreakable();
            }
            known = version;
        }
        return isAny;
    }
}
