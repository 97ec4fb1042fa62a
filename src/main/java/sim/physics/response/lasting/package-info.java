// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors

/**
 * Contacts that last: bodies that rest on fixed ones ({@link sim.physics.response.lasting.RestingContacts}), and heaps of
 * bodies that lie on one another ({@link sim.physics.response.lasting.Heaps}). Of impacts nothing is known here; what touches
 * is loaded by {@link sim.physics.response.lasting.ContactPoints}.
 */
package sim.physics.response.lasting;
