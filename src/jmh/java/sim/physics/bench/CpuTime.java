// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;

/** CPU time of the thread that steps. */
final class CpuTime {
    private static final ThreadMXBean CLOCK = ManagementFactory.getThreadMXBean();

    private CpuTime() {}

    /** Nanoseconds that some steps take. */
    static long of(Runnable step, int steps) {
        long begun = CLOCK.getCurrentThreadCpuTime();
        for (int k = 0; k < steps; k++) {
            step.run();
        }
        return CLOCK.getCurrentThreadCpuTime() - begun;
    }
}
