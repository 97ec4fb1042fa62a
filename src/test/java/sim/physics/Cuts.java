// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import sim.physics.constraint.Constraint;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;

/** Takes a constraint away when something is hit. */
public final class Cuts implements CollisionListener {
    private static final long serialVersionUID = 1L;

    private final PhysicsEngine engine;
    private final Constraint pin;

    public Cuts(PhysicsEngine engine, Constraint pin) {
        this.engine = engine;
        this.pin = pin;
    }

    @Override
    public void collided(Contact contact) {
        if (engine.contains(pin)) {
            engine.remove(pin);
        }
    }
}
