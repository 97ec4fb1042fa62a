// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors

/**
 * Trees of pins, which move in their angles. {@link sim.physics.constraint.tree.TreeStep} is the way in.
 * {@link sim.physics.constraint.tree.TreeHost} is what a tree asks of the island to which its pins belong. This package knows
 * nothing of joints, solvers and projection. Nothing here is for authors.
 */
package sim.physics.constraint.tree;
