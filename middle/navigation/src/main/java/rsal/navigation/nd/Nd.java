package rsal.navigation.nd;

import java.util.List;
import java.util.Optional;
import rsal.data.Angles;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.DriveLimits;
import rsal.navigation.avoid.FootprintOutline;
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.avoid.VelocityFilter;
import rsal.navigation.nd.NearnessDiagram.Region;

/// Tells situations apart by a [NearnessDiagram] and has a rule for each: J. Minguez, L. Montano, Nearness
/// Diagram (ND) Navigation: Collision Avoidance in Troubled Scenarios (IEEE Transactions on Robotics and
/// Automation 20, 2004), with the sixth situation and the laws of J. Minguez, J. Osuna, L. Montano, A Divide
/// and Conquer Strategy Based on Situations to Achieve Reactive Collision Avoidance in Troubled Scenarios (ICRA
/// 2004), known as ND+. With nothing near: towards the goal (HSGR), past the corner of a wide region at the
/// security distance (HSWR), or through the middle of a narrow one (HSNR). With something nearer than the
/// security distance on one side: the same, turned away from it, the nearer the more (LS1, or LSGR to the
/// goal); on both sides: between them, as near to the one as to the other (LS2). The nearest obstacle slows it
/// down.
///
/// Differs from the papers in these points:
/// * The robot is a circle for the rules. Its true outline counts for [VelocityFilter], which has the last
///   word.
/// * It is never slowed down below a fifth of its speed by the laws, as the authors' own program for Player
///   does.
/// * With no region it turns towards the goal.
public final class Nd implements Controller {
    private static final double WIDE = Math.PI / 2;
    private static final double SLOWEST = 0.2; // of the highest speed

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
    private final VelocityFilter caution;
    private double nearestLeft;
    private double nearestRight;
    private double directionLeft;
    private double directionRight;

    /// @param reaction how long a command lasts before the next one can take effect [s]
    public Nd(Footprint footprint, DriveLimits limits, Settings settings, double reaction) {
        this.settings = settings;
        this.radius = FootprintOutline.radius(footprint) + settings.safetyDist();
        this.diagram = new NearnessDiagram(radius, 2 * radius);
        this.caution = new VelocityFilter(footprint, limits, reaction);
    }

    @Override
    public Twist2d drive(Obstacles obstacles, Target target, Motion motion) {
        double goal = target.bearing();
        diagram.fill(obstacles);
        Optional<Region> found = diagram.region(goal, target.distance());
        if (found.isEmpty()) {
            return caution.turn(goal, motion.velocity(), obstacles);
        }
        Region region = found.get();
        findNearest(region.direction());
        double left = room(nearestLeft);
        double right = room(nearestRight);
        double direction = left < 1 && right < 1
                ? between(region.direction(), left, right)
                : awayFrom(left < 1 ? directionLeft : directionRight, highSafety(region), Math.min(left, right));
        return caution.towards(direction, Math.max(SLOWEST, Math.min(left, right)), target, motion, obstacles);
    }

    /// Where to go when nothing is near: HSGR, HSWR, HSNR.
    private double highSafety(Region region) {
        if (region.goal()) {
            return region.direction();
        }
        double into = Math.atan2(radius + settings.avoidDist(), region.cornerDistance());
        return region.width() > WIDE ? Angles.wrap(region.corner() + region.side() * into) : region.middle();
    }

    /// Where to go with something near on one side: LS1, LSGR.
    private static double awayFrom(double obstacle, double direction, double room) {
        return Angles.wrap(direction + (1 - room) * Angles.difference(direction, obstacle + Math.PI));
    }

    /// Where to go with something near on both sides, the farther from the nearer one: LS2.
    private static double between(double direction, double left, double right) {
        double ahead = Math.clamp(direction, -Math.PI / 2, Math.PI / 2);
        double share = left + right > 0 ? (left - right) / (left + right) : 0;
        return ahead + share * (share < 0 ? ahead + Math.PI / 2 : Math.PI / 2 - ahead);
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

    /// How much room there is up to something: 0 at the edge, 1 at the security distance and beyond.
    private double room(double distance) {
        return Math.clamp((distance - radius) / settings.avoidDist(), 0, 1);
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
    public List<Point2d> predictedTrajectory() {
        return caution.predictedTrajectory();
    }

    @Override
    public void reset() {
        caution.reset();
    }
}
