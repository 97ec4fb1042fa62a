// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

/**
 * The write-up's own way to the time of a collision: bodies are looked at when the step is over, and if they have
 * penetrated, the instant is searched back in time by bisection. It misses bodies that pass through one another within
 * a step, and is there for comparison and for crowds where that does not matter.
 */
final class Bisection {
    private static final int HALVINGS = 60;

    private final Pose pose;
    private final ClosestFeatures features;

    /** Whether the bodies touch and approach at the instant that {@link #search} returned. */
    boolean touching;

    Bisection(Pose pose, ClosestFeatures features) {
        this.pose = pose;
        this.features = features;
    }

    /** Offset of the contact if they touch, else the end of the step. */
    double search(double start, double end) {
        touching = false;
        if (gap(end) > 0) {
            return end;
        }
        if (gap(start) <= 0) {
            touching = approach() < 0;
            return touching ? start : end;
        }
        double apart = start;
        double together = end;
        for (int k = 0; k < HALVINGS && apart < together; k++) {
            double middle = 0.5 * (apart + together);
            if (gap(middle) > 0) {
                apart = middle;
            } else {
                together = middle;
            }
        }
        gap(apart);
        touching = approach() < 0;
        return touching ? apart : end;
    }

    private double gap(double tau) {
        pose.moveTo(tau);
        pose.turn();
        features.find(ClosestFeatures.NO_FEATURES);
        return features.gap;
    }

    /** Velocity of the closest point of B relative to that of A along the normal, (16) with (22). */
    private double approach() {
        boolean edgeOfA = (features.featureA & 1) != 0;
        Pose.Placed holder = edgeOfA ? pose.b : pose.a;
        int vertex = (edgeOfA ? features.featureB : features.featureA) >> 1;
        double x = holder.vx[vertex];
        double y = holder.vy[vertex];
        double vx = pose.ux - pose.b.omega * (y - pose.py) + pose.a.omega * y;
        double vy = pose.uy + pose.b.omega * (x - pose.px) - pose.a.omega * x;
        return vx * features.nx + vy * features.ny;
    }
}
