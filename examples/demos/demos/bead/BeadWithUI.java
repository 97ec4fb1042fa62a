// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.bead;

import demos.SceneWithUI;
import sim.display.Console;
import sim.engine.SimState;

/** Bead on a wire in MASON's console. */
public final class BeadWithUI extends SceneWithUI {
    public BeadWithUI() {
        this(new Bead(System.currentTimeMillis()));
    }

    public BeadWithUI(SimState state) {
        super(state);
    }

    public static String getName() {
        return "Bead on a wire";
    }

    public static Object getInfo() {
        return "<h2>Bead on a wire</h2><p>A force pulls a bead down; the wire lets it go along y = x only.</p>";
    }

    public static void main(String[] args) {
        new Console(new BeadWithUI()).setVisible(true);
    }
}
