// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
/**
 * How MASON shows an engine: portrayals of bodies, joints and contacts, what inspectors list of them, a mirror of the bodies in a
 * field, and pictures without a display. All public classes here are for authors.
 */
package sim.physics.mason;
