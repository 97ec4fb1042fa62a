// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.bead;

import demos.SceneWithUI;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import sim.display.Console;
import sim.display.Controller;
import sim.engine.SimState;
import sim.portrayal.DrawInfo2D;
import sim.portrayal.FieldPortrayal2D;

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

    /** The wire, from one corner of the world to the other. */
    private static final class Wire extends FieldPortrayal2D {
        @Override
        public void draw(Object object, Graphics2D graphics, DrawInfo2D info) {
            double right = info.draw.x + info.draw.width;
            double bottom = info.draw.y + info.draw.height;
            graphics.setPaint(Color.DARK_GRAY);
            graphics.draw(new Line2D.Double(info.draw.x, info.draw.y, right, bottom));
        }
    }

    @Override
    public void init(Controller controller) {
        super.init(controller);
        display.attach(new Wire(), "Wire");
    }

    public static void main(String[] args) {
        new Console(new BeadWithUI()).setVisible(true);
    }
}
