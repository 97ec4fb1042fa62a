// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
/**
 * The write-up's chapter <i>Motion</i>, (1)–(15): the state of bodies, the forces on them, and the methods by which these move them.
 *
 * <p>For authors: {@link sim.physics.motion.Body}; forces, which are {@link sim.physics.motion.Gravity},
 * {@link sim.physics.motion.Spring}, {@link sim.physics.motion.SurfaceFriction}, {@link sim.physics.motion.ViscousFriction}, or
 * their own by {@link sim.physics.motion.ForceGenerator}, {@link sim.physics.motion.Forces} and {@link sim.physics.motion.Link};
 * each {@link sim.physics.motion.Integrator}: {@link sim.physics.motion.Euler}, {@link sim.physics.motion.SymplecticEuler},
 * {@link sim.physics.motion.RungeKutta4}, {@link sim.physics.motion.Rattle}, and with steps that it chooses each
 * {@link sim.physics.motion.AdaptiveIntegrator}: {@link sim.physics.motion.DormandPrince853},
 * {@link sim.physics.motion.GraggBulirschStoer}, {@link sim.physics.motion.RadauIIA}, {@link sim.physics.motion.Automatic}. The
 * write-up's vectors are in {@link sim.physics.motion.State}.
 */
package sim.physics.motion;
