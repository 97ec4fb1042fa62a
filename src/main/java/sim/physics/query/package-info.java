// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
/** Questions about where bodies are: rays, shapes that move, overlaps, neighbours, fields of view. All public classes here are for authors. */
package sim.physics.query;
