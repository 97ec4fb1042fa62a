// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
/**
 * The write-up's chapters <i>Robots</i> and <i>Constrained Dynamics</i>, (25)–(46): joints, motors and stops, the islands of bodies
 * that they tie together, and the forces that keep them closed.
 *
 * <p>For authors: each {@link sim.physics.constraint.Joint}, which are {@link sim.physics.constraint.PinJoint},
 * {@link sim.physics.constraint.WeldJoint}, {@link sim.physics.constraint.RodJoint}, {@link sim.physics.constraint.PulleyJoint},
 * {@link sim.physics.constraint.GearJoint}, {@link sim.physics.constraint.Rail} as {@link sim.physics.constraint.SliderJoint} and
 * {@link sim.physics.constraint.SlotJoint}, and {@link sim.physics.constraint.WireJoint} along a
 * {@link sim.physics.constraint.Curve}; {@link sim.physics.constraint.Wheel}, {@link sim.physics.constraint.Motor} and
 * {@link sim.physics.constraint.Limit}; any other {@link sim.physics.constraint.Constraint}, by its
 * {@link sim.physics.constraint.Equations}; each {@link sim.physics.constraint.ConstraintSolver}, which are
 * {@link sim.physics.constraint.DirectSolver} and {@link sim.physics.constraint.GlobalSolver}; and
 * {@link sim.physics.constraint.Stabilization}, {@link sim.physics.constraint.Reaction} and
 * {@link sim.physics.constraint.ConstraintException}.
 */
package sim.physics.constraint;
