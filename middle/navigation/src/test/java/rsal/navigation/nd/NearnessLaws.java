package rsal.navigation.nd;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.Controller.Motion;
import rsal.navigation.avoid.Controller.Target;
import rsal.navigation.avoid.DriveLimits;
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.avoid.VelocityFilter;
import rsal.navigation.nd.NearnessDiagram.Region;

/// What controllers with a nearness diagram have in common, by numbers. A direction shows in the turn rate, which is
/// the
/// highest at a right angle.
public abstract class NearnessLaws {
    protected static final Footprint SQUARE = Footprint.box(0.3, 0.3, new Point2d(0, 0));
    protected static final DriveLimits LIMITS = new DriveLimits(0.4, 1.2, 0.8, 3);

    private final Obstacles obstacles = new Obstacles(5);
    private final double radius;

    /// @param radius of the robot in its diagram [m]
    protected NearnessLaws(double radius) {
        this.radius = radius;
    }

    /// The controller under test, a new one each time.
    protected abstract Controller controller();

    protected final Twist2d drive(double goalDegrees, double distance) {
        var target =
                Target.at(Pose2d.polar(distance, Math.toRadians(goalDegrees)).position(), false);
        return controller().drive(obstacles, target, new Motion(Pose2d.ORIGIN, Twist2d.STOP));
    }

    /// @param degrees a multiple of 1.5, as directions are told apart
    /// @param distance from the robot's center [m]
    protected final void postAt(double degrees, double distance) {
        Point2d place = Pose2d.polar(distance, Math.toRadians(degrees)).position();
        obstacles.add(place.x(), place.y());
    }

    protected final void arc(int from, int to, double distance) {
        for (int degrees = from; degrees < to; degrees++) {
            postAt(degrees, distance);
        }
    }

    /// The region that the diagram has for a goal 3 m ahead.
    protected final Region region() {
        var diagram = new NearnessDiagram(radius, 2 * radius);
        diagram.fill(obstacles);
        return diagram.region(0, 3).orElseThrow();
    }

    protected static void assertHeads(Twist2d command, double degrees, double share) {
        assertHeads(command, degrees, share, 1e-3);
    }

    /// @param share of the highest speed, where the robot need not turn
    /// @param tolerance of the direction [degrees]
    protected static void assertHeads(Twist2d command, double degrees, double share, double tolerance) {
        double heading = command.omega() / LIMITS.turnRate() * 90;
        assertThat(heading).isCloseTo(degrees, within(tolerance));
        assertThat(command.vx()).isCloseTo(LIMITS.speed() * share * (1 - Math.abs(heading) / 90), within(1e-4));
    }

    @Test
    void goesThroughTheMiddleOfANarrowGap() {
        arc(-180, 180, 4);
        arc(-180, -65, 1.5);
        arc(-35, 180, 1.5);
        assertHeads(drive(0, 3), Math.toDegrees(region().middle()), 1);
        assertThat(Math.toDegrees(region().middle())).isCloseTo(-50, within(3.0));
    }

    @Test
    void turnsToTheGoalWhereNoRegionLeads() {
        arc(-180, 180, 2);
        Twist2d command = drive(40, 3);
        assertThat(command.vx()).isZero();
        assertThat(command.omega()).isPositive();
    }

    @Test
    void turnsAndCommandsOfOthersAreUpToTheFilter() {
        Controller controller = controller();
        var filter = new VelocityFilter(SQUARE, LIMITS, 0.2);
        var motion = new Motion(Pose2d.ORIGIN, Twist2d.drive(0.1, 0.1));
        postAt(0, 0.2);
        assertThat(controller.turn(obstacles, -0.7, motion)).isEqualTo(filter.turn(-0.7, motion.velocity(), obstacles));
        Twist2d wanted = Twist2d.drive(0.4, 0.2);
        Twist2d safe = filter.guarded(wanted, motion.velocity(), obstacles);
        assertThat(controller.guarded(obstacles, wanted, motion))
                .isEqualTo(safe)
                .isNotEqualTo(wanted);
        assertThat(controller.predictedTrajectory()).isEqualTo(filter.predictedTrajectory());
        controller.guarded(new Obstacles(5), wanted, motion);
        assertThat(controller.predictedTrajectory()).isNotEmpty();
        controller.reset();
        assertThat(controller.predictedTrajectory()).isEmpty();
    }
}
