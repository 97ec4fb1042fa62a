// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors

/**
 * Lasting contacts: bodies that rest on fixed ones ({@link sim.physics.response.lasting.RestingContacts}), and heaps of bodies
 * that lie on one another ({@link sim.physics.response.lasting.Heaps}). This package knows nothing of impacts.
 * {@link sim.physics.response.lasting.ContactPoints} loads what touches. Nothing here is for authors.
 */
package sim.physics.response.lasting;
