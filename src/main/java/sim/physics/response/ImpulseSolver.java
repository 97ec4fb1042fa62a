// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;

/** Solves the equations (16)–(24) for the impulse at one collision point of two free bodies. */
public sealed interface ImpulseSolver extends Serializable permits TwoBodyImpulse, BorderedImpulse {
    /**
     * Finds the impulse.
     *
     * @param impact what is known of the impact; its impulse is set
     */
    void solve(Impact impact);
}
