// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Tolerances;
import sim.physics.motion.Drive;
import sim.physics.motion.Motion;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;

/**
 * Bounds the impacts that a pair has in one step. A body that bounces ever lower on a fixed one that can bear it comes
 * to rest; other pairs, which are pressed together but can bear no force between impacts, bounce on at lengths that
 * grow with their number. The energy for that is what the pair itself has lost before in the step, or what a constant
 * acceleration takes back.
 */
final class Bounces implements Serializable {
    private static final long serialVersionUID = 1L;

    /** The square of a restitution is to be finite, whatever the approach. */
    private static final double HUGE = 1e100;

    /** Impacts on a fixed body after which one that meets it faster than it left it is too near for its bounces to be told apart. */
    private static final int BLURRED = 50;

    /** Length of a bounce, relative to the step, that rounding makes where bodies are put on one another. */
    private static final double TINY = 1e-5;

    /** Bounces of a rattling pair after which they may be faster, the more there are: or a method beyond its stability made them endless. */
    private static final double PATIENCE = 256;

    /** Bounces of a rattling pair after which what presses it may be more than the forces on its bodies, the more there are. */
    private static final double FEW = 4;

    /** How many times faster these may hop in the end that only forces press, which then are known: up to a sixteenth of their size. */
    private static final double MOST_PATIENCE = 4;

    /** Impacts for which one counts of tied bodies that rub and do not bounce: they are still when it is over. */
    private static final int TURNS = 3;

    /** Time, relative to the step, in which no force brings bodies back together that have parted. */
    private static final double INSTANT = 1e-9;

    private final State state;
    private final Trajectories trajectories;
    private final Motion motion;
    private final Drive drive;

    /** The length of the step of the impact that is attended to, and its offset in the engine's. */
    private double h;

    private double now;

    /** The step of the engine in which the count of a pair began, and the offset in it; the other values hold from then on. */
    private double[] countedIn = {};

    private double[] countedFrom = {};

    private int[] counts = {};

    /** How often its bodies were not where a contact was expected. */
    private int[] missed = {};

    private int[] rests = {};

    /** Impacts under a force. */
    private int[] rattles = {};

    /** Speed at which the pair parted at its last impact, and when that was. */
    private double[] lastSpeed = {};

    private double[] lastTau = {};

    /** Energy that the pair has lost to restitution, at impacts of one point. */
    private double[] lost = {};

    Bounces(State state, Trajectories trajectories, Motion motion) {
        this.state = state;
        this.trajectories = trajectories;
        this.motion = motion;
        this.drive = new Drive(motion, trajectories);
    }

    /**
     * Takes note of two bodies and an instant; impacts are counted by the step, or for as long as one that the integrator
     * chooses. That may be another one after each impact, so it bounds no fixed spans.
     */
    void attend(int a, int b, double tau) {
        h = Math.min(motion.pace(a), motion.pace(b));
        now = tau;
    }

    /** Counts an impact of a pair. */
    void count(int pair) {
        open(pair);
        counts[pair]++;
    }

    /** Whether a pair has had few impacts in the step. */
    boolean areFew(int pair) {
        return counts[pair] <= Tolerances.LIE_AFTER;
    }

    /**
     * Ends the rattling of a pair that a force presses together: two robots that push one another, or a can between a robot
     * and a wall, would else collide ever more often. It loses speed until its bounces are short beside the bodies; from
     * then on they last as long as the force that was seen allows, longer with each of them. Free bodies are let be.
     *
     * @return whether the pair rattles; its restitution is set then
     */
    boolean dampRattle(int pair, int a, int b, Impact c) {
        if (!trajectories.isDriven(a) && !trajectories.isDriven(b)) {
            return false;
        }
        open(pair);
        int count = ++rattles[pair] - Tolerances.RATTLE_AFTER;
        double approach = -c.normalVelocity();
        if (count > 0 && approach > 0) {
            double since = Math.max(trajectories.offset(a) - lastTau[pair], Tolerances.REST * Tolerances.REST * h);
            double acceleration = (approach + Math.max(0, lastSpeed[pair])) / since; // they may have met as they parted
            acceleration = Math.min(acceleration, mostPressing(a, b, Math.max(1, count / FEW)));
            double size = Math.min(trajectories.radius(a), trajectories.radius(b));
            double longest = Math.sqrt(2 * Tolerances.RATTLE_SIZE * size / acceleration);
            double length = Math.min(Math.min(1, count * Tolerances.SHORTEST_BOUNCE) * h, longest);
            double hop = Math.min(0.5 * length * acceleration, mostHop(a, b, Tolerances.RATTLE_SIZE * size, Math.max(1, count / PATIENCE)));
            boolean isForce = trajectories.offset(a) - lastTau[pair] > INSTANT * h; // else an impact somewhere else has driven them together
            hop = isForce ? hop : Math.min(hop, regained(pair, approach, c));
            c.restitution = Math.max(Tolerances.RATTLE, Math.min(HUGE, hop / approach));
        }
        lastSpeed[pair] = c.restitution * Math.max(0, approach);
        lastTau[pair] = trajectories.offset(a);
        return count > 0;
    }

    /**
     * Whether a pair rattles on and on in a step, however fast it is to part: where a body can only turn, friction may stop it as soon
     * as it does.
     */
    boolean isEndless(int pair) {
        open(pair);
        return rattles[pair] > Tolerances.ELASTIC_LIE_AFTER;
    }

    /** The restitution of another point of a rattling pair, of which one approaches at a speed: none parts faster than that one. */
    double rattle(Impact c, double restitution, double approach) {
        double own = -c.normalVelocity();
        boolean isFaster = restitution > Tolerances.RATTLE && approach > 0 && own > approach;
        return isFaster ? Math.max(Tolerances.RATTLE, restitution * approach / own) : restitution;
    }

    /**
     * The greatest speed of a rattling pair's bounces, of which the force may have been misjudged: with it they go as high as a way by the
     * forces that there are, or where joints give forces, too, by so much in a step.
     *
     * @param patience how often that much: more where they rattle on and on
     */
    private double mostHop(int a, int b, double way, double patience) {
        if (motion.isTied(a) || motion.isTied(b)) {
            return patience * Math.max(way / h, Math.sqrt(2 * way * (pull(a) + pull(b))));
        }
        return Math.min(MOST_PATIENCE, patience) * Math.sqrt(2 * way * (drive(a) + drive(b)));
    }

    /**
     * The greatest speed at which bodies part that are pressed together: what presses tied ones is told by their paths, which end where ties,
     * as of a bridge in a line, take all of a velocity, and seem to be bent by a million times their weight.
     */
    private double mostByPressing(int a, int b) {
        double size = Math.min(trajectories.radius(a), trajectories.radius(b));
        return motion.isTied(a) || motion.isTied(b) ? Tolerances.RATTLE_SIZE * size / h : Double.POSITIVE_INFINITY;
    }

    /**
     * The greatest acceleration of a pair that is believed to be that of forces, and not of what its bodies did at other points: of what nothing ties
     * forces are known, and paths may be bent by 10¹³ times as much just after a body was struck.
     *
     * @param patience how often that much: more where they rattle on and on, as what lies on them presses, too
     */
    private double mostPressing(int a, int b, double patience) {
        return motion.isTied(a) || motion.isTied(b) ? Double.POSITIVE_INFINITY : patience * (drive(a) + drive(b));
    }

    /** The acceleration of a body by all forces. */
    private double drive(int body) {
        if (!trajectories.isDriven(body)) {
            return pull(body);
        }
        drive.find(body);
        return drive.acceleration();
    }

    /** Counts that a pair has come to rest. */
    void rest(int pair) {
        rests[pair]++;
    }

    /** Whether a pair may come to rest: not if something, a wall in a corner, ends its rest again and again. */
    boolean mayRest(int pair) {
        open(pair);
        return rests[pair] < Tolerances.RESTS;
    }

    /** Counts an expected contact that was none; true if there were too many. */
    boolean misses(int pair) {
        open(pair);
        missed[pair]++;
        return missed[pair] > Tolerances.MISSES;
    }

    private void open(int pair) {
        if (pair >= counts.length) {
            int length = Math.max(2 * counts.length, pair + 1);
            countedIn = Arrays.copyOf(countedIn, length);
            countedFrom = Arrays.copyOf(countedFrom, length);
            counts = Arrays.copyOf(counts, length);
            missed = Arrays.copyOf(missed, length);
            rests = Arrays.copyOf(rests, length);
            rattles = Arrays.copyOf(rattles, length);
            lastSpeed = Arrays.copyOf(lastSpeed, length);
            lastTau = Arrays.copyOf(lastTau, length);
            lost = Arrays.copyOf(lost, length);
        }
        boolean isOver = h < trajectories.h() && !(now - countedFrom[pair] < h);
        if (countedIn[pair] != trajectories.step() || isOver) {
            countedIn[pair] = trajectories.step();
            countedFrom[pair] = now;
            counts[pair] = 0;
            missed[pair] = 0;
            rests[pair] = 0;
            rattles[pair] = 0;
            lost[pair] = 0;
        }
    }

    /** Writes off what a pair has lost: of several points none knows what the others take back. */
    void writeOff(int pair) {
        lost[pair] = 0;
    }

    /** Notes how the two part. */
    void part(int pair, int a, Impact c) {
        lastSpeed[pair] = -c.restitution * c.normalVelocity();
        lastTau[pair] = trajectories.offset(a);
    }

    /** Notes what an impact of one point loses, or takes of what was lost before. */
    void spend(int pair, Impact c) {
        double speed = c.normalVelocity();
        double loss = 0.5 * (1 - c.restitution * c.restitution) * speed * speed / c.normalMobility();
        c.allowance = Math.max(0, -loss);
        lost[pair] = Math.max(0, lost[pair] + loss);
    }

    /**
     * Ends the bouncing of bodies that are pressed together. They come to rest on one another when their bounces have
     * become too short to matter, or too many; those that cannot, because they are round, bounce on at the shortest length, from
     * when they might have lain on: before, and without a pressing acceleration, impacts are not changed, and no speed is too
     * small to bounce. Those that an integrator drives or that meet a heap do so from their first impact on, as they would else rattle.
     *
     * @param inHeap whether one of them lies on something
     * @return whether they come to rest
     */
    boolean limit(int pair, int a, int b, Impact c, boolean canRest, boolean inHeap) {
        int count = counts[pair];
        double approachSpeed = -c.normalVelocity();
        double pressing = pressing(a, b, c);
        double again = 0;
        boolean isForced = canRest && c.restitution == 1; // elastic bodies come to rest by forces only
        if (count > Tolerances.ELASTIC_AFTER / 2 && !isForced) {
            // whatever pressed the two together since their last impact, spin for one, will do it again
            double since = Math.max(trajectories.offset(a) - lastTau[pair], Tolerances.REST * h);
            again = (approachSpeed + lastSpeed[pair]) / since;
        }
        double closing = Math.max(pressing, again);
        if (!canRest && count > Tolerances.ELASTIC_AFTER) {
            c.restitution = 1; // bodies that collapse on one another (Luding and McNamara 1998)
        }
        if (!(closing > 0) || !(approachSpeed > 0)) {
            return false;
        }
        boolean isBlurred = 2 * c.restitution * approachSpeed > (1 + c.restitution) * lastSpeed[pair];
        boolean mayBeNoise = canRest && (isBlurred || isForced && count > Tolerances.ELASTIC_AFTER);
        boolean isNoise = mayBeNoise && approachSpeed * approachSpeed < 2 * pressing * noise(a, b);
        if (c.restitution == 1 && count <= Tolerances.ELASTIC_AFTER && !isNoise) {
            return false;
        }
        double bounce = 2 * c.restitution * approachSpeed / closing;
        double shortest = Math.min(1, count * Tolerances.SHORTEST_BOUNCE) * h;
        boolean isLong = count > Tolerances.REST_AFTER || count > BLURRED && isBlurred && !isForced;
        if (canRest && (isNoise || bounce < (isLong ? shortest : Tolerances.REST * h))) {
            c.restitution = 0;
            return true;
        }
        boolean isPressed = inHeap || trajectories.isDriven(a) || trajectories.isDriven(b);
        int exact = canRest ? Tolerances.REST_AFTER : isPressed ? 0 : Tolerances.LIE_AFTER;
        if (bounce < shortest && count > exact) {
            double believed = Math.min(pressing, mostPressing(a, b, Math.max(1, count / FEW)));
            if (believed < pressing) {
                closing = Math.max(believed, again);
                if (2 * c.restitution * approachSpeed >= shortest * closing) {
                    return false; // it is no shorter than it is to be
                }
            }
            double most = Math.max(regained(pair, approachSpeed, c), Math.min(0.5 * believed * shortest, mostByPressing(a, b)));
            c.restitution = Math.min(HUGE, Math.min(0.5 * closing * shortest, most) / approachSpeed);
        }
        return false;
    }

    /**
     * Height of bounces that rounding alone makes: what is put flush, at 0.1 + 0.2 for one, is found to touch when it is deeper by the
     * tolerance of gaps, and again deeper by that at each elastic bounce from there.
     */
    private double noise(int a, int b) {
        double[] d = trajectories.data();
        int oa = a * Trajectories.STRIDE;
        int ob = b * Trajectories.STRIDE;
        double far = Math.abs(d[oa]) + Math.abs(d[oa + 1]) + Math.abs(d[ob]) + Math.abs(d[ob + 1]);
        double extent = far + trajectories.radius(a) + trajectories.radius(b);
        return 2 * Tolerances.ELASTIC_AFTER * Tolerances.GAP * extent;
    }

    /** The gap at which two bodies are found to touch, as of rounding none is known better. */
    double rounding(int a, int b) {
        return noise(a, b) / (2 * Tolerances.ELASTIC_AFTER);
    }

    /** The speed at which a pair would part with all the energy that it has lost in the step. */
    private double regained(int pair, double approach, Impact c) {
        return Math.max(approach, Math.sqrt(approach * approach + 2 * lost[pair] * c.normalMobility()));
    }

    /**
     * Whether so many impacts of a pair in a step have been so short that the two are to lie on one another.
     *
     * @param isPut whether they have but been put on one another, as {@link #isByRounding} says of all of their points
     */
    boolean jams(int pair, int a, int b, Impact c, boolean inHeap, boolean isPut) {
        boolean bounces = c.restitution == 1 || c.restitution > 0 && !isPut;
        if (!bounces && (inHeap || pressing(a, b, c) > 0) && !trajectories.isDriven(a) && !trajectories.isDriven(b)) {
            return true;
        }
        if (c.restitution == 0 && inHeap && !motion.isTied(a) && !motion.isTied(b)) {
            return true; // each bounce of nothing would have the heap solved once more
        }
        int count = counts[pair] * (c.restitution == 0 && c.friction > 0 && (motion.isTied(a) || motion.isTied(b)) ? TURNS : 1);
        if (count > Tolerances.LIE_AFTER && isTiny(a, b, c) || isNoise(pair, a, b, c)) {
            return true;
        }
        int least = inHeap ? Tolerances.JOIN_AFTER : Tolerances.LIE_AFTER;
        int most = c.restitution < 1 ? least : Tolerances.ELASTIC_LIE_AFTER;
        if (count <= most || c.restitution == 1 && c.friction == 0 && !inHeap) {
            return false;
        }
        double approach = Math.max(0, -c.normalVelocity());
        double since = Math.max(trajectories.offset(a) - lastTau[pair], Tolerances.REST * h);
        double closing = Math.max(pressing(a, b, c), (approach + lastSpeed[pair]) / since);
        return 2 * c.restitution * approach <= closing * Tolerances.SHORT * h;
    }

    /** Whether bounces of bodies are counted: where they lose nothing, only those that a force or rounding makes next to nothing. */
    boolean areCounted(int pair, int a, int b, Impact c) {
        return c.restitution < 1 || c.friction > 0 || isTiny(a, b, c) || isNoise(pair, a, b, c);
    }

    /** Whether forces on two bodies give them in next to no time the speed at which they bounce, if they do at all. */
    private boolean isTiny(int a, int b, Impact c) {
        return 2 * c.restitution * Math.max(0, -c.normalVelocity()) < TINY * h * (pull(a) + pull(b));
    }

    /** Whether driven bodies that nothing ties bounce as rounding alone makes what is put flush bounce: they are to lie, however elastic they are. */
    private boolean isNoise(int pair, int a, int b, Impact c) {
        boolean isDriven = trajectories.isDriven(a) || trajectories.isDriven(b);
        if (!isDriven || rattles[pair] <= Tolerances.JOIN_AFTER || motion.isTied(a) || motion.isTied(b)) {
            return false;
        }
        double speed = c.normalVelocity();
        return speed * speed < 2 * (drive(a) + drive(b)) * noise(a, b);
    }

    /** Whether two bodies meet as fast as forces make them on a way that is but rounding, as what is put on one another. */
    boolean isByRounding(int a, int b, Impact c) {
        double speed = c.normalVelocity();
        return speed * speed < 2 * (pull(a) + pull(b)) * noise(a, b);
    }

    private double pull(int body) {
        double[] d = trajectories.bends();
        int o = body * Trajectories.STRIDE & trajectories.bendMask();
        return 2 * (Math.abs(d[o + Trajectories.AX]) + Math.abs(d[o + Trajectories.AY]));
    }

    /** Whether a pair that lies on one another meets at a speed from which it bounces. */
    boolean bounds(int pair, Impact c, double pressing, double size) {
        open(pair);
        double speed = c.restitution * -c.normalVelocity();
        boolean isLong = 2 * speed > Tolerances.SHORT * h * pressing && speed * h > Tolerances.REST * size;
        return counts[pair] <= Tolerances.LIE_AFTER && isLong;
    }

    /**
     * The acceleration of two bodies towards one another, with none of driven ones: what bends their paths is not known where they have just been brought
     * by the integrator, and would be where an impact of the same instant has brought them before. That of what joints tie counts for what lies on it.
     */
    double pressing(int a, int b, Impact c) {
        return 2
                * ((bend(a, b, Trajectories.AX) - bend(b, a, Trajectories.AX)) * c.nx
                        + (bend(a, b, Trajectories.AY) - bend(b, a, Trajectories.AY)) * c.ny);
    }

    private double bend(int body, int other, int component) {
        boolean counts = !trajectories.isDriven(body) || motion.isTied(body) && !state.body(other).isImmobile();
        return counts ? trajectories.bends()[(body * Trajectories.STRIDE & trajectories.bendMask()) + component] : 0;
    }
}
