// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.mill;

import demos.SceneWithUI;
import sim.display.Console;
import sim.engine.SimState;

/** A mill in MASON's console. */
public final class MillWithUI extends SceneWithUI {
    public MillWithUI() {
        this(new Mill(System.currentTimeMillis()));
    }

    public MillWithUI(SimState state) {
        super(state);
    }

    public static String getName() {
        return "Mill";
    }

    public static Object getInfo() {
        return "<h2>Mill</h2><p>A motor turns a toothed wheel, whose teeth turn a drum. The wheel, the drum, and each of the hooks and dumbbells in it are one body"
                + " made of several convex parts.</p>";
    }

    public static void main(String[] args) {
        new Console(new MillWithUI()).setVisible(true);
    }
}
