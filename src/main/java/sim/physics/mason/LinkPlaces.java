// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.GearJoint;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.PulleyJoint;
import sim.physics.constraint.Wheel;
import sim.physics.constraint.WireJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Link;
import sim.util.Double2D;

/** Where joints, motors, stops and springs of an engine are in the world: at a point of their first body. */
final class LinkPlaces {
    private final PhysicsEngine engine;

    /** The pins of each body; null until a motor or a stop asks for one. */
    private Map<Body, List<PinJoint>> pins;

    LinkPlaces(PhysicsEngine engine) {
        this.engine = engine;
    }

    /** The two bodies that a generator acts between, the second of them perhaps null; or null if it has no two ends. */
    static Body[] ends(ForceGenerator generator) {
        if (generator instanceof Link link) {
            return new Body[] {link.getBodyA(), link.getBodyB()};
        }
        List<Body> bodies = generator.getBodies();
        boolean areTwo = bodies != null && bodies.size() == 2 && bodies.get(0) != null && bodies.get(1) != null;
        return areTwo ? bodies.toArray(new Body[0]) : null;
    }

    /** What a motor or a stop acts on; else the object itself. */
    static Object subject(Object object) {
        return object instanceof Motor motor ? motor.getCoordinate() : object instanceof Limit limit ? limit.getCoordinate() : object;
    }

    Double2D of(Object object) {
        Object subject = subject(object);
        if (subject instanceof Link link) {
            return first(link);
        }
        if (subject instanceof WireJoint wire) {
            return at(wire.getBodyA(), wire.getAnchorAX(), wire.getAnchorAY());
        }
        if (subject instanceof PulleyJoint pulley) {
            return at(pulley.getBodyA(), pulley.getAnchorAX(), pulley.getAnchorAY());
        }
        if (subject instanceof Wheel wheel) {
            return at(wheel.getBodyA(), wheel.getAnchorAX(), wheel.getAnchorAY());
        }
        if (subject instanceof GearJoint gear && subject != object) {
            PinJoint pin = pin(gear.getBodyA(), gear.getBodyB());
            return pin == null ? centre(gear.getBodyA()) : first(pin);
        }
        return centre(subject instanceof Constraint c ? c.getBodyA() : ends((ForceGenerator) subject)[0]);
    }

    static Double2D first(Link link) {
        return at(link.getBodyA(), link.getAnchorAX(), link.getAnchorAY());
    }

    static Double2D second(Link link) {
        return at(link.getBodyB(), link.getAnchorBX(), link.getAnchorBY());
    }

    /** A point of a body, or of the world, in the world. */
    static Double2D at(Body body, double x, double y) {
        return body == null ? new Double2D(x, y) : new Double2D(body.worldX(x, y), body.worldY(x, y));
    }

    static Double2D centre(Body body) {
        return new Double2D(body.getX(), body.getY());
    }

    /** A pin between two bodies, or null. */
    private PinJoint pin(Body a, Body b) {
        if (pins == null) {
            pins = new IdentityHashMap<>();
            for (Constraint c : engine.allConstraints()) {
                if (c instanceof PinJoint pin) {
                    pins.computeIfAbsent(pin.getBodyA(), k -> new ArrayList<>()).add(pin);
                    if (pin.getBodyB() != null) {
                        pins.computeIfAbsent(pin.getBodyB(), k -> new ArrayList<>()).add(pin);
                    }
                }
            }
        }
        for (PinJoint pin : pins.getOrDefault(a, List.of())) {
            if (pin.getBodyA() == a && pin.getBodyB() == b || pin.getBodyA() == b && pin.getBodyB() == a) {
                return pin;
            }
        }
        return null;
    }
}
