// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.robots;

import demos.SceneWithUI;
import sim.display.Console;
import sim.engine.SimState;

/** Robots in MASON's console. */
public final class RobotsWithUI extends SceneWithUI {
    public RobotsWithUI() {
        this(new Robots(System.currentTimeMillis()));
    }

    public RobotsWithUI(SimState state) {
        super(state);
    }

    public static String getName() {
        return "Robots";
    }

    public static Object getInfo() {
        return "<h2>Robots</h2><p>Grey robots fetch blue cans, carry them to the top and return to where they were.</p>";
    }

    public static void main(String[] args) {
        new Console(new RobotsWithUI()).setVisible(true);
    }
}
