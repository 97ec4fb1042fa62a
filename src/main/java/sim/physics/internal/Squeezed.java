// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

/** Says that bodies have no way out between others that nothing moves. It has no trace of calls: nothing is wrong with them. */
public final class Squeezed extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /** Says so. */
    public Squeezed() {
        super("bodies are squeezed", null, false, false);
    }
}
