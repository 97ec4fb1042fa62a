// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors

/** Code that several packages share: checks of arguments, sine and cosine, lists. It is not part of the API. */
package sim.physics.internal;
