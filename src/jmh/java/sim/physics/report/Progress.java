// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

/** A progress bar on the terminal. */
final class Progress {
    private static final int WIDTH = 30;

    private final long begun = System.nanoTime();
    private final int whole;
    private int done;

    Progress(int whole) {
        this.whole = whole;
    }

    void show(String what) {
        int filled = WIDTH * done / whole;
        String bar = "#".repeat(filled) + ".".repeat(WIDTH - filled);
        long seconds = (System.nanoTime() - begun) / 1_000_000_000;
        System.err.printf("\r[%s] %2d/%d %4d s  %-50s", bar, done, whole, seconds, what);
    }

    void next() {
        done++;
    }

    void end() {
        show("done");
        System.err.println();
    }
}
