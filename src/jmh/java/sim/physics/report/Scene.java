// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.List;

/**
 * A scene with a known outcome.
 *
 * @param id of hard-cases' suite, in file names
 * @param title in words
 * @param seconds simulated
 * @param error what is measured, with its unit
 * @param contenders who runs it
 */
record Scene(String id, String title, double seconds, String error, List<Contender> contenders) {}
