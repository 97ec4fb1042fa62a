// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
/**
 * The engine and its step: {@link sim.physics.PhysicsEngine} moves bodies, finds their collisions and responds to them, in this
 * order as in the write-up. All public classes here are for authors.
 *
 * <p>Each chapter of the write-up is a package. What it has for authors its summary says. Classes that are public beside those are
 * so for other packages of the engine, and no API: they may change without notice, and so may what methods of API classes take
 * or return of them.
 */
package sim.physics;
