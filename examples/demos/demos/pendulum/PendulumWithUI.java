// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.pendulum;

import demos.SceneWithUI;
import sim.display.Console;
import sim.engine.SimState;

/** Pendulum in MASON's console. */
public final class PendulumWithUI extends SceneWithUI {
    public PendulumWithUI() {
        this(new Pendulum(System.currentTimeMillis()));
    }

    public PendulumWithUI(SimState state) {
        super(state);
    }

    public static String getName() {
        return "Pendulum";
    }

    public static Object getInfo() {
        return "<h2>Pendulum</h2><p>A bar swings on a pin. With Runge and Kutta it ends its swing where it began, with Euler higher.</p>";
    }

    public static void main(String[] args) {
        new Console(new PendulumWithUI()).setVisible(true);
    }
}
