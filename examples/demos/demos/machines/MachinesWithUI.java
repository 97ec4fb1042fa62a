// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.machines;

import demos.SceneWithUI;
import sim.display.Console;
import sim.engine.SimState;

/** Machines in MASON's console. */
public final class MachinesWithUI extends SceneWithUI {
    public MachinesWithUI() {
        this(new Machines(System.currentTimeMillis()));
    }

    public MachinesWithUI(SimState state) {
        super(state);
    }

    public static String getName() {
        return "Machines";
    }

    public static Object getInfo() {
        return "<h2>Machines</h2><p>A car on springs drives to and fro through a pyramid of boxes, ragdolls fall over pegs.</p>";
    }

    public static void main(String[] args) {
        new Console(new MachinesWithUI()).setVisible(true);
    }
}
