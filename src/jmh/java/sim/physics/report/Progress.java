// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

/** A progress bar on the terminal, with the time that is left as far as what is done lets it be told. */
final class Progress {
    private static final int WIDTH = 30;
    private static final double NANO = 1e-9;

    /** Part of the whole from which on what was done tells how long the rest takes. */
    private static final double TELLING = 0.01;

    private final long begun = System.nanoTime();

    /** What the scenes take, in any unit, and all of them. */
    private final double[] expected;

    private double whole;
    private int scene;

    /** What the scenes before take. */
    private double before;

    Progress(double[] expected) {
        this.expected = expected;
        for (double one : expected) {
            whole += one;
        }
    }

    /**
     * Shows what is being done.
     *
     * @param part how much of the scene at hand is done, 0 … 1
     */
    void show(String what, double part) {
        double share = scene < expected.length ? (before + part * expected[scene]) / whole : 1;
        double seconds = (System.nanoTime() - begun) * NANO;
        int filled = (int) (WIDTH * share);
        String bar = "#".repeat(filled) + ".".repeat(WIDTH - filled);
        System.err.printf("\r[%s] %2d/%d %4.0f s, left %s  %-45s", bar, scene, expected.length, seconds, left(share, seconds), what);
    }

    static String left(double share, double seconds) {
        return share < TELLING ? "?" : String.format(java.util.Locale.ROOT, "%4.0f s", seconds * (1 - share) / share);
    }

    void next() {
        before += expected[scene];
        scene++;
    }

    void end() {
        show("done", 0);
        System.err.println();
    }
}
