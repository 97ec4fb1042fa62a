// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
/**
 * The write-up's chapter <i>Collision Response</i>, (16)–(24) and (47)–(54): what impacts do, and when contacts begin to last.
 *
 * <p>For authors: {@link sim.physics.response.CollisionListener} with {@link sim.physics.response.Contact},
 * {@link sim.physics.response.ContactListener} with {@link sim.physics.response.LastingContact},
 * {@link sim.physics.response.PairRule}, and each {@link sim.physics.response.ImpulseSolver} of an
 * {@link sim.physics.response.Impact}: {@link sim.physics.response.TwoBodyImpulse},
 * {@link sim.physics.response.BorderedImpulse}.
 */
package sim.physics.response;
