// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.pair;

import demos.SceneWithUI;
import sim.display.Console;
import sim.engine.SimState;

/** Pinned pair in MASON's console. */
public final class PairWithUI extends SceneWithUI {
    public PairWithUI() {
        this(new Pair(System.currentTimeMillis()));
    }

    public PairWithUI(SimState state) {
        super(state);
    }

    public static String getName() {
        return "Pinned pair";
    }

    public static Object getInfo() {
        return "<h2>Pinned pair</h2><p>Two bars that are pinned together, a disc on the pin and a box bounce between four walls.</p>";
    }

    public static void main(String[] args) {
        new Console(new PairWithUI()).setVisible(true);
    }
}
