// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.doors;

import demos.SceneWithUI;
import sim.display.Console;
import sim.engine.SimState;

/** Doors in MASON's console. */
public final class DoorsWithUI extends SceneWithUI {
    public DoorsWithUI() {
        this(new Doors(System.currentTimeMillis()));
    }

    public DoorsWithUI(SimState state) {
        super(state);
    }

    public static String getName() {
        return "Doors";
    }

    public static Object getInfo() {
        return "<h2>Doors</h2><p>Balls knock two doors open, which hinges hold to their frames.</p>";
    }

    public static void main(String[] args) {
        new Console(new DoorsWithUI()).setVisible(true);
    }
}
