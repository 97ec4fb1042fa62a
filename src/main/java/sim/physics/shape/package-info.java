// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors

/**
 * Shapes of bodies: circles, rectangles and convex polygons, and compounds of them, with their areas, centroids and moments of
 * inertia. All are immutable. No argument may be null, and null is never returned. All public classes here are for authors.
 */
package sim.physics.shape;
