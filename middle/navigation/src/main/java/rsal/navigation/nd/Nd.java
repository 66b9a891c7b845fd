package rsal.navigation.nd;

import java.util.Optional;
import rsal.data.Angles;
import rsal.data.Footprint;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Caution;
import rsal.navigation.avoid.DriveLimits;
import rsal.navigation.avoid.LocalPlanner;
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.avoid.Outline;
import rsal.navigation.nd.NearnessDiagram.Region;

/// Tells situations apart by a [NearnessDiagram] and has a rule for each: J. Minguez, J. Osuna, L. Montano, A Divide
/// and Conquer Strategy Based on Situations to Achieve Reactive Collision Avoidance in Troubled Scenarios (ICRA
/// 2004), known as ND+. With nothing near: towards the goal (HSGR), along the corner of a wide region (HSWR), or
/// through the middle of a narrow one (HSNR). With something nearer than the security distance on one side (LS1),
/// on both (LS2) or beside a goal that is in the region (LSGR): the same, turned away from what is nearest on each
/// side, and slower.
///
/// Differs from the paper in these points:
/// * The robot is a circle for the rules. Its true outline counts for [Caution], which has the last word.
/// * LS2 weighs the nearest obstacles of both sides by how near they are, as LS1 does with one.
/// * With no region it turns towards the goal.
public final class Nd implements LocalPlanner {
    private static final double WIDE = Math.PI / 2;
    private static final double SLOWEST = 0.1; // of the highest speed

    /// Named as the options of Player's `nd`.
    ///
    /// @param avoidDist security distance: what is nearer to the robot's edge is turned away from [m]
    /// @param safetyDist room beside the robot that counts as part of it [m]
    public record Settings(double avoidDist, double safetyDist) {
        public static final Settings DEFAULT = new Settings(0.5, 0);
    }

    private final Settings settings;
    private final double radius;
    private final NearnessDiagram diagram;
    private final Caution caution;
    private double nearestLeft;
    private double nearestRight;
    private double directionLeft;
    private double directionRight;

    /// @param reaction how long a command lasts before the next one can take effect [s]
    public Nd(Footprint footprint, DriveLimits limits, Settings settings, double reaction) {
        this.settings = settings;
        this.radius = Outline.radius(footprint) + settings.safetyDist();
        this.diagram = new NearnessDiagram(radius, 2 * radius);
        this.caution = new Caution(footprint, limits, reaction);
    }

    @Override
    public Twist2d drive(Obstacles obstacles, Target target, Motion motion) {
        double goal = target.bearing();
        diagram.fill(obstacles);
        Optional<Region> found = diagram.region(goal);
        if (found.isEmpty()) {
            return caution.turn(goal, motion.velocity(), obstacles);
        }
        double direction = highSafety(found.get(), goal);
        findNearest(direction);
        double left = threat(nearestLeft);
        double right = threat(nearestRight);
        direction =
                Angles.wrap(direction + away(directionLeft, direction, left) + away(directionRight, direction, right));
        double near = Math.max(left, right);
        return caution.towards(direction, Math.max(SLOWEST, 1 - near), target, motion, obstacles);
    }

    /// Where to go when nothing is near.
    private static double highSafety(Region region, double goal) {
        if (region.contains(goal)) {
            return goal;
        }
        double into = region.width() > WIDE ? WIDE / 2 : region.width() / 2;
        return Angles.wrap(region.corner() + region.side() * into);
    }

    private void findNearest(double direction) {
        nearestLeft = Double.POSITIVE_INFINITY;
        nearestRight = Double.POSITIVE_INFINITY;
        diagram.forEach((bearing, distance) -> {
            boolean left = Angles.difference(direction, bearing) > 0;
            if (left && distance < nearestLeft) {
                nearestLeft = distance;
                directionLeft = bearing;
            }
            if (!left && distance < nearestRight) {
                nearestRight = distance;
                directionRight = bearing;
            }
        });
    }

    /// How near something is: 0 at the security distance and beyond, 1 at the edge.
    private double threat(double distance) {
        return Math.clamp(1 - (distance - radius) / settings.avoidDist(), 0, 1);
    }

    /// What a direction is turned by because of an obstacle: at most to where it is behind.
    private static double away(double obstacle, double direction, double threat) {
        return threat == 0 ? 0 : threat * Angles.difference(direction, obstacle + Math.PI) / 2;
    }

    @Override
    public Twist2d turn(Obstacles obstacles, double angle, Motion motion) {
        return caution.turn(angle, motion.velocity(), obstacles);
    }

    @Override
    public Twist2d guarded(Obstacles obstacles, Twist2d wanted, Motion motion) {
        return caution.guarded(wanted, motion.velocity(), obstacles);
    }

    @Override
    public void reset() {
        caution.reset();
    }
}
