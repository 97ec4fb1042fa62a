// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors

/** Code that several packages share: checks of arguments, sine and cosine, lists. Nothing here is for authors. */
package sim.physics.internal;
