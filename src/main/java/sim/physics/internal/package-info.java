// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors

/** What several chapters share: checks of arguments, sine and cosine, lists. Not a part of the API. */
package sim.physics.internal;
