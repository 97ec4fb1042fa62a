// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.references;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.hipparchus.complex.FieldComplex;
import org.hipparchus.dfp.Dfp;
import org.hipparchus.dfp.DfpField;
import org.hipparchus.util.FastMath;
import org.hipparchus.util.FieldSinCos;

/**
 * {@link Squeezer} by its energy. It has one freedom, the crank's angle β: all joints follow from it as points where two circles
 * meet, and β̇² M(β) / 2 is what the torque and the spring have done. No integrator of motion has a part in it. Points of the
 * plane are complex numbers.
 */
public final class SqueezerPath {
    private final DfpField field = Quadrature.digits();
    private final Dfp beta0 = number(Squeezer.BETA);
    private final FieldComplex<Dfp> a = point(number(Squeezer.XA), number(Squeezer.YA));
    private final FieldComplex<Dfp> b = point(number(Squeezer.XB), number(Squeezer.YB));
    private final FieldComplex<Dfp> spring = point(number(Squeezer.SPRING[2]), number(Squeezer.SPRING[3]));

    /** Centres of mass, and the spring's end, as each lies from its body's first joint when that points along x. */
    private final List<FieldComplex<Dfp>> arms = new ArrayList<>();

    private final FieldComplex<Dfp> springArm;
    private final List<FieldComplex<Dfp>> turned = new ArrayList<>();
    private final Dfp potential;

    /** The mechanism at its start. */
    public SqueezerPath() {
        Squeezer squeezer = new Squeezer();
        Link[] links = pose(beta0);
        for (int k = 0; k < links.length; k++) {
            arms.add(links[k].arm(point(squeezer.centre(k))));
            turned.add(links[k].direction());
        }
        springArm = links[2].arm(point(squeezer.springEnd()));
        potential = potential(links);
    }

    /**
     * Where points of the bodies are.
     *
     * @param t time
     * @param near angle β there, to 10⁻⁹ or better
     * @param arm from the centre of mass, along the x of the start
     * @return x, y for each body
     */
    public double[] points(double t, double near, double arm) {
        Link[] links = pose(exactBeta(t, near));
        double[] places = new double[2 * links.length];
        for (int k = 0; k < links.length; k++) {
            FieldComplex<Dfp> turn = links[k].direction().divide(turned.get(k));
            FieldComplex<Dfp> place = links[k].place(arms.get(k)).add(turn.multiply(number(arm)));
            places[2 * k] = place.getRealPart().toDouble();
            places[2 * k + 1] = place.getImaginaryPart().toDouble();
        }
        return places;
    }

    /**
     * The angle β.
     *
     * @param t time
     * @param near β there, to 10⁻⁹ or better
     * @return β
     */
    public double beta(double t, double near) {
        return exactBeta(t, near).toDouble();
    }

    private Dfp exactBeta(double t, double near) {
        return new Quadrature(this::slowness, beta0, true, 0.2).coordinates(new double[] {t}, new double[] {near})[0];
    }

    /** 1/β̇. */
    private Dfp slowness(Dfp beta) {
        Link[] links = pose(beta);
        Dfp mass = field.getZero();
        for (int k = 0; k < links.length; k++) {
            Dfp rate = links[k].rate();
            mass = mass.add(square(links[k].velocity(arms.get(k))).multiply(number(Squeezer.MASS[k])))
                    .add(rate.multiply(rate).multiply(number(Squeezer.INERTIA[k])));
        }
        Dfp work = beta.subtract(beta0).multiply(number(Squeezer.TORQUE)).subtract(potential(links)).add(potential);
        return mass.divide(work.multiply(2)).sqrt();
    }

    private Dfp potential(Link[] links) {
        Dfp stretch = square(links[2].place(springArm).subtract(spring)).sqrt().subtract(number(Squeezer.SPRING[1]));
        return stretch.multiply(stretch).multiply(number(Squeezer.SPRING[0])).divide(2);
    }

    /** The bodies, and how they move where β̇ = 1. */
    private Link[] pose(Dfp beta) {
        FieldSinCos<Dfp> angle = FastMath.sinCos(beta);
        Joint origin = new Joint(point(0, 0), point(0, 0));
        FieldComplex<Dfp> end = point(angle.cos(), angle.sin()).multiply(number(Squeezer.RR));
        Joint crank = new Joint(end, end.multiply(point(0, 1)));
        Joint atA = new Joint(a, point(0, 0));
        Joint atB = new Joint(b, point(0, 0));
        Joint middle = crank.meets(Squeezer.D, atB, Squeezer.SS, 1);
        Joint upper = middle.meets(Squeezer.E, atA, Squeezer.ZT, -1);
        Joint lower = middle.meets(Squeezer.ZF, atA, Squeezer.U, 1);
        return new Link[] {
            new Link(origin, crank), new Link(crank, middle), new Link(atB, middle), new Link(upper, middle),
            new Link(atA, upper), new Link(lower, middle), new Link(atA, lower)
        };
    }

    private Dfp number(double x) {
        return Quadrature.decimal(field, x);
    }

    private FieldComplex<Dfp> point(double... xy) {
        Dfp[] numbers = Arrays.stream(xy).mapToObj(this::number).toArray(Dfp[]::new);
        return point(numbers[0], numbers[1]);
    }

    private static FieldComplex<Dfp> point(Dfp x, Dfp y) {
        return new FieldComplex<>(x, y);
    }

    private static Dfp square(FieldComplex<Dfp> z) {
        return dot(z, z);
    }

    private static Dfp dot(FieldComplex<Dfp> z, FieldComplex<Dfp> w) {
        return z.getRealPart().multiply(w.getRealPart()).add(z.getImaginaryPart().multiply(w.getImaginaryPart()));
    }

    private static Dfp cross(FieldComplex<Dfp> z, FieldComplex<Dfp> w) {
        return z.getRealPart().multiply(w.getImaginaryPart()).subtract(z.getImaginaryPart().multiply(w.getRealPart()));
    }

    /** A place, and its velocity. */
    private final class Joint {
        final FieldComplex<Dfp> at;
        final FieldComplex<Dfp> moves;

        Joint(FieldComplex<Dfp> at, FieldComplex<Dfp> moves) {
            this.at = at;
            this.moves = moves;
        }

        /** The joint at these distances from this and from another one, to the left of the way from here to there, or to its right. */
        Joint meets(double here, Joint other, double there, int left) {
            FieldComplex<Dfp> way = other.at.subtract(at);
            Dfp distance = square(way);
            Dfp r = number(here).multiply(number(here));
            Dfp along = distance.add(r).subtract(number(there).multiply(number(there))).divide(distance.multiply(2));
            Dfp across = r.divide(distance).subtract(along.multiply(along)).sqrt().multiply(left);
            FieldComplex<Dfp> place = at.add(way.multiply(point(along, across)));
            // its velocity along either bar is that of the bar's other end
            FieldComplex<Dfp> p = place.subtract(at);
            FieldComplex<Dfp> q = place.subtract(other.at);
            FieldComplex<Dfp> velocity = q.multiply(dot(p, moves)).subtract(p.multiply(dot(q, other.moves)));
            return new Joint(place, velocity.multiply(point(0, -1)).divide(cross(p, q)));
        }
    }

    /** A body between two joints. */
    private final class Link {
        private final Joint first;
        private final Joint second;

        Link(Joint first, Joint second) {
            this.first = first;
            this.second = second;
        }

        FieldComplex<Dfp> direction() {
            FieldComplex<Dfp> way = second.at.subtract(first.at);
            return way.divide(square(way).sqrt());
        }

        Dfp rate() {
            FieldComplex<Dfp> way = second.at.subtract(first.at);
            return cross(way, second.moves.subtract(first.moves)).divide(square(way));
        }

        FieldComplex<Dfp> arm(FieldComplex<Dfp> place) {
            return place.subtract(first.at).divide(direction());
        }

        FieldComplex<Dfp> place(FieldComplex<Dfp> arm) {
            return first.at.add(arm.multiply(direction()));
        }

        FieldComplex<Dfp> velocity(FieldComplex<Dfp> arm) {
            return first.moves.add(arm.multiply(direction()).multiply(point(field.getZero(), rate())));
        }
    }
}
