package rsal.navigation.snd;

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
import rsal.navigation.nd.NearnessDiagram;
import rsal.navigation.nd.NearnessDiagram.Region;

/// Drives into the region of a [NearnessDiagram] that is nearest to the goal, turned away from everything
/// around by one law that knows no situations: J. Durham, F. Bullo, Smooth Nearness-Diagram Navigation (IROS
/// 2008). The region is entered past its corner at the safety distance, or through its middle when it is narrow
/// (θ_d in the paper). Each obstacle nearer than the safety distance is a threat (s_i, cut off to 0–1) and
/// turns the robot away (Δ_avoid) with the square of that as its weight, and the nearest one slows it down.
///
/// Differs from the paper in these points:
/// * It drives, the slower the more it turns, until it turns by 90° ([VelocityFilter#towards]); in the paper
///   until 45°.
/// * The safety distance shrinks with the room that there is, as in Player's driver, so that it gets through
///   narrow places at a fifth of its speed.
/// * The robot is a circle for the law. Its true outline counts for [VelocityFilter], which has the last word.
/// * With no region it turns towards the goal.
public final class Snd implements Controller {
    private static final double SHRINKING = 5; // safety distance per room

    /// Named as the options of Player's `snd`.
    ///
    /// @param robotRadius [m]
    /// @param minGapWidth by how much ranges must jump where a region begins [m]
    /// @param obstacleAvoidDist safety distance [m]
    public record Settings(double robotRadius, double minGapWidth, double obstacleAvoidDist) {
        /// Player's defaults for a robot.
        public static Settings of(Footprint footprint) {
            double radius = FootprintOutline.radius(footprint);
            return new Settings(radius, 2 * radius, 4 * radius);
        }
    }

    private final Settings settings;
    private final NearnessDiagram diagram;
    private final VelocityFilter caution;
    private double safetyDistance;
    private double sum;
    private double weights;
    private double nearest;

    /// @param reaction how long a command lasts before the next one can take effect [s]
    public Snd(Footprint footprint, DriveLimits limits, Settings settings, double reaction) {
        this.settings = settings;
        this.diagram = new NearnessDiagram(settings.robotRadius(), settings.minGapWidth());
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
        nearest = Double.POSITIVE_INFINITY;
        diagram.forEach((_, distance) -> nearest = Math.min(nearest, distance));
        double room = nearest - settings.robotRadius();
        safetyDistance = Math.clamp(SHRINKING * room, 0.01, settings.obstacleAvoidDist());
        double wanted = wanted(found.get());
        double direction = Angles.wrap(wanted + deflection(wanted));
        return caution.towards(direction, 1 - threat(nearest), target, motion, obstacles);
    }

    /// The direction to take if nothing were near (θ_d in the paper).
    private double wanted(Region region) {
        if (region.goal()) {
            return region.direction();
        }
        double clear = Math.asin(Math.min(1, (settings.robotRadius() + safetyDistance) / region.cornerDistance()));
        return Angles.wrap(region.corner() + region.side() * Math.min(clear, region.width() / 2));
    }

    /// How near something is: 0 at the safety distance and beyond, 1 at the edge (s_i in the paper).
    private double threat(double distance) {
        return Math.clamp((safetyDistance + settings.robotRadius() - distance) / safetyDistance, 0, 1);
    }

    /// What all obstacles together turn a direction by (Δ_avoid in the paper).
    private double deflection(double wanted) {
        sum = 0;
        weights = 0;
        diagram.forEach((bearing, distance) -> {
            double threat = threat(distance);
            double weight = threat * threat;
            sum += weight * threat * Angles.difference(wanted, bearing + Math.PI);
            weights += weight;
        });
        return weights == 0 ? 0 : sum / weights;
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
