// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors

/**
 * Time stepping: contacts, joints and friction are solved once a substep for velocities, instead of event by event. Nothing here is
 * for authors.
 */
package sim.physics.stepping;
