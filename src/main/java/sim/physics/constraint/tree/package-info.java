// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors

/**
 * Trees of pins, which move in their angles: {@link sim.physics.constraint.tree.TreeStep} is the way in, and
 * {@link sim.physics.constraint.tree.TreeHost} what a tree asks of the island whose pins it is. Of joints, solvers and projection nothing is
 * known here.
 */
package sim.physics.constraint.tree;
