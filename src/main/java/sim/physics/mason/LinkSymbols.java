// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import java.awt.geom.Rectangle2D;
import sim.physics.constraint.Equations;
import sim.physics.constraint.GearJoint;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.PulleyJoint;
import sim.physics.constraint.Rail;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.constraint.Wheel;
import sim.physics.constraint.WireJoint;
import sim.physics.internal.Trig;
import sim.physics.motion.Body;
import sim.physics.motion.Link;
import sim.physics.motion.Spring;
import sim.portrayal.DrawInfo2D;
import sim.util.Double2D;

/** Which symbols joints, motors, stops and springs have. */
final class LinkSymbols {
    private static final int COILS = 7;

    /** Part of a rope's length at which it is taut. */
    private static final double TAUT = 0.9999;

    final Sketch sketch;
    private final double s;
    private final DrawInfo2D info;
    private final Double2D place;

    LinkSymbols(double size, DrawInfo2D info, Double2D place) {
        sketch = new Sketch(size);
        s = size;
        this.info = info;
        this.place = place;
    }

    /** Adds the symbol of an object that acts between two bodies; the second may be null for the world. */
    void add(Object object, Body a, Body b) {
        if (object instanceof Motor motor) {
            motor(motor);
        } else if (object instanceof Limit limit) {
            limit(limit, a, b);
        } else if (object instanceof PinJoint) {
            sketch.ring(place.x, place.y, s).disc(place.x, place.y, 0.35 * s);
        } else if (object instanceof WeldJoint) {
            sketch.box(place.x, place.y, Trig.cos(a.getAngle()), Trig.sin(a.getAngle()), 0.8 * s, 0.8 * s, true);
        } else if (object instanceof Rail rail) {
            rail(rail, b);
        } else if (object instanceof WireJoint wire) {
            wire(wire);
        } else if (object instanceof Wheel wheel) {
            tyre(direction(wheel));
        } else if (object instanceof GearJoint gear) {
            gear(gear, a, b);
        } else if (object instanceof PulleyJoint pulley) {
            pulley(pulley);
        } else if (object instanceof Spring spring) {
            spring(LinkPlaces.first(spring), LinkPlaces.second(spring));
        } else if (object instanceof Link link) {
            rod(LinkPlaces.second(link));
        } else {
            Double2D other = b == null ? place : LinkPlaces.centre(b);
            sketch.dashed(place.x, place.y, other.x, other.y).disc(place.x, place.y, 0.5 * s).disc(other.x, other.y, 0.5 * s);
        }
    }

    private void rod(Double2D end) {
        sketch.line(place.x, place.y, end.x, end.y).disc(place.x, place.y, 0.6 * s).disc(end.x, end.y, 0.6 * s);
    }

    /** A line that sags to both sides of the straight one alike, as the world has no below. */
    private void rope(Double2D end, double length) {
        double dx = end.x - place.x;
        double dy = end.y - place.y;
        double distance = Math.sqrt(dx * dx + dy * dy);
        sketch.disc(place.x, place.y, 0.6 * s).disc(end.x, end.y, 0.6 * s);
        if (distance >= TAUT * length || distance == 0 || Double.isInfinite(length)) {
            sketch.line(place.x, place.y, end.x, end.y);
            return;
        }
        double bow = 0.25 * Math.min(Math.sqrt(6 * distance * (length - distance)), length) / distance; // a flat parabola's
        double mx = place.x + 0.5 * dx;
        double my = place.y + 0.5 * dy;
        sketch.curve(place.x, place.y, place.x + 0.25 * dx - bow * dy, place.y + 0.25 * dy + bow * dx, mx, my);
        sketch.curve(mx, my, mx + 0.25 * dx + bow * dy, my + 0.25 * dy - bow * dx, end.x, end.y);
    }

    private void spring(Double2D from, Double2D to) {
        double dx = (to.x - from.x) / (COILS + 1);
        double dy = (to.y - from.y) / (COILS + 1);
        double step = Math.sqrt(dx * dx + dy * dy);
        double across = step > 0 ? s / step : 0;
        double[] xy = new double[2 * (2 * COILS + 2)];
        int at = 0;
        xy[at++] = from.x;
        xy[at++] = from.y;
        for (int k = 0; k < 2 * COILS; k++) {
            double side = k % 2 == 0 ? across : -across;
            double along = 0.5 + (k + 0.5) / 2;
            xy[at++] = from.x + along * dx - side * dy;
            xy[at++] = from.y + along * dy + side * dx;
        }
        xy[at++] = to.x;
        xy[at] = to.y;
        sketch.line(xy).disc(from.x, from.y, 0.5 * s).disc(to.x, to.y, 0.5 * s);
    }

    /** The rail's direction in the world. */
    private static Double2D direction(Rail rail) {
        Body b = rail.getBodyB();
        double cos = b == null ? 1 : Trig.cos(b.getAngle());
        double sin = b == null ? 0 : Trig.sin(b.getAngle());
        double x = rail.getDirectionX();
        double y = rail.getDirectionY();
        return new Double2D(cos * x - sin * y, sin * x + cos * y);
    }

    private static Double2D direction(Wheel wheel) {
        double angle = wheel.getBodyA().getAngle() + wheel.getSteering();
        return new Double2D(Trig.cos(angle), Trig.sin(angle));
    }

    private void tyre(Double2D d) {
        sketch.box(place.x, place.y, d.x, d.y, 1.2 * s, 0.5 * s, true);
    }

    private void rail(Rail rail, Body b) {
        Double2D start = LinkPlaces.at(b, rail.getAnchorBX(), rail.getAnchorBY());
        Double2D d = direction(rail);
        double travel = rail.getTravel();
        double low = Math.min(0, travel) - 3 * s;
        double high = Math.max(0, travel) + 3 * s;
        sketch.line(start.x + low * d.x, start.y + low * d.y, start.x + high * d.x, start.y + high * d.y);
        if (rail instanceof SliderJoint) {
            sketch.box(place.x, place.y, d.x, d.y, 1.4 * s, 0.8 * s, false);
        } else {
            sketch.ring(place.x, place.y, 0.8 * s);
        }
    }

    private void wire(WireJoint wire) {
        Rectangle2D.Double clip = info.clip;
        double wide = Math.abs(clip.width / info.draw.width);
        double high = Math.abs(clip.height / info.draw.height);
        double reach = Math.max(Math.abs(clip.getCenterX() - info.draw.x) / Math.abs(info.draw.width) + wide,
                Math.abs(clip.getCenterY() - info.draw.y) / Math.abs(info.draw.height) + high);
        reach = Math.max(reach, 100 * s); // also when it is looked for in a few pixels
        for (double[] piece : WirePath.through(wire.getWire(), place.x, place.y, reach / 200, 2 * reach)) {
            sketch.line(piece);
        }
        sketch.ring(place.x, place.y, s);
    }

    private void gear(GearJoint gear, Body a, Body b) {
        double ratio = Math.abs(gear.getRatio());
        double first = b == null || !(ratio > 0) ? 2 * s : 2 * s / Math.max(1, ratio);
        wheel(a, first);
        if (b != null) {
            wheel(b, Math.max(0.2 * s, Math.min(2 * s, first * ratio)));
            sketch.dashed(a.getX(), a.getY(), b.getX(), b.getY());
        }
    }

    /** The way of the rope, drawn straight also where it is slack. */
    private void pulley(PulleyJoint pulley) {
        Double2D end = LinkPlaces.at(pulley.getBodyB(), pulley.getAnchorBX(), pulley.getAnchorBY());
        double ax = pulley.getPulleyAX();
        double ay = pulley.getPulleyAY();
        double bx = pulley.getPulleyBX();
        double by = pulley.getPulleyBY();
        sketch.line(place.x, place.y, ax, ay, bx, by, end.x, end.y).ring(ax, ay, s).ring(bx, by, s);
        sketch.disc(place.x, place.y, 0.6 * s).disc(end.x, end.y, 0.6 * s);
    }

    private void wheel(Body body, double r) {
        double x = body.getX();
        double y = body.getY();
        sketch.ring(x, y, r).line(x, y, x + r * Trig.cos(body.getAngle()), y + r * Trig.sin(body.getAngle()));
    }

    private void motor(Motor motor) {
        double sign = Math.signum(motor.getSpeed());
        if (motor.getCoordinate() instanceof Rail rail) {
            Double2D d = direction(rail);
            double x = place.x - 1.8 * s * d.y;
            double y = place.y + 1.8 * s * d.x;
            sketch.arrow(x - 2 * s * sign * d.x, y - 2 * s * sign * d.y, x + 2 * s * sign * d.x, y + 2 * s * sign * d.y);
            if (sign == 0) {
                sketch.line(x - 2 * s * d.x, y - 2 * s * d.y, x + 2 * s * d.x, y + 2 * s * d.y);
            }
        } else if (motor.getCoordinate() instanceof GearJoint) {
            double from = sign < 0 ? 2.2 : -2.2;
            sketch.arc(place.x, place.y, 1.8 * s, from, -from, sign != 0);
        } else if (motor.getCoordinate() instanceof Wheel wheel) {
            Double2D d = direction(wheel);
            tyre(d);
            if (sign != 0) {
                double length = 2.5 * s * sign;
                sketch.arrow(place.x, place.y, place.x + length * d.x, place.y + length * d.y);
            }
        } else {
            sketch.disc(place.x, place.y, s);
        }
    }

    private void limit(Limit limit, Body a, Body b) {
        if (limit.getCoordinate() instanceof RodJoint rod) {
            rope(LinkPlaces.second(rod), rod.getLength() + limit.getUpper());
        } else if (limit.getCoordinate() instanceof PulleyJoint pulley) {
            pulley(pulley);
        } else if (limit.getCoordinate() instanceof Rail rail) {
            ends(rail, limit, b);
        } else if (limit.getCoordinate() instanceof GearJoint gear) {
            stops(gear, limit, a);
        } else {
            sketch.disc(place.x, place.y, s);
        }
    }

    private void ends(Rail rail, Limit limit, Body b) {
        Double2D start = LinkPlaces.at(b, rail.getAnchorBX(), rail.getAnchorBY());
        Double2D d = direction(rail);
        for (double bound : new double[] {limit.getLower(), limit.getUpper()}) {
            double x = start.x + bound * d.x;
            double y = start.y + bound * d.y;
            if (!Double.isInfinite(bound)) {
                sketch.line(x - 1.5 * s * d.y, y + 1.5 * s * d.x, x + 1.5 * s * d.y, y - 1.5 * s * d.x).dashed(place.x, place.y, x, y);
            }
        }
    }

    /** The arc over which the first body may turn, as seen from its centre, or from its x axis if it turns about that. */
    private void stops(GearJoint gear, Limit limit, Body a) {
        Equations now = new Equations();
        gear.evaluate(now);
        double dx = a.getX() - place.x;
        double dy = a.getY() - place.y;
        boolean isCentre = dx * dx + dy * dy < s * s * 1e-6;
        double towards = isCentre ? a.getAngle() : StrictMath.atan2(dy, dx);
        double r = 2.6 * s;
        double least = Math.max(limit.getLower() - now.value(0), -Math.PI);
        double most = Math.min(limit.getUpper() - now.value(0), Math.PI);
        if (least <= most) {
            sketch.arc(place.x, place.y, r, towards + least, towards + most, false);
        }
        for (double bound : new double[] {limit.getLower(), limit.getUpper()}) {
            double angle = towards + bound - now.value(0);
            if (!Double.isInfinite(bound)) {
                double cos = Trig.cos(angle);
                double sin = Trig.sin(angle);
                sketch.line(place.x + 0.7 * r * cos, place.y + 0.7 * r * sin, place.x + 1.3 * r * cos, place.y + 1.3 * r * sin);
            }
        }
    }
}
