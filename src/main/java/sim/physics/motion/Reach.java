// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

/** How far it is looked for places that ties allow, where Newton's method finds none. */
public enum Reach {
    /** Not at all. */
    NEWTON,

    /** As far as the way leads down from where the bodies are. */
    DOWNHILL,

    /** From other places, too. */
    ANYWHERE
}
