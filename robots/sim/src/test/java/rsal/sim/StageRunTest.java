package rsal.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import rsal.data.BatteryState;
import rsal.data.BatteryState.Charging;
import rsal.data.Fiducials;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.Actuator;
import rsal.device.Battery;
import rsal.device.FiducialFinder;
import rsal.device.LaserScanner;
import rsal.robot.RobotSpec;
import rsal.scene.Scene;
import rsal.settings.FileSource;
import rsal.stage.StageFormat;

/// Worlds of Stage, run.
class StageRunTest {
    private static SimRun run(String world) {
        FileSource files = (path, most, askedAt) -> world.getBytes(StandardCharsets.UTF_8);
        Scene scene = new StageFormat().read("test.world", files, 1);
        return SimRun.in(scene, scene.robots().toArray(RobotSpec[]::new));
    }

    private static void drive(SimRun run, double speed, double seconds) {
        for (int i = 0; i < 10 * seconds; i++) {
            run.base("r").command(Twist2d.drive(speed, 0));
            run.advance(0.1);
        }
    }

    @Test
    void aRobotThatDrivesOntoAPlateIsChargedThere() {
        var run = run("""
                define plate model ( size [0.4 0.4 0.02] joules -1 give_watts 50 obstacle_return 0 ranger_return -1 )
                model ( name "station" pose [3 0 0 0] size [0.2 1 1] plate ( name "plate" pose [-0.4 0 -1 0] ) )
                position ( name "r" pose [0 0 0 0] size [0.4 0.4 0.3] joules 100 joules_capacity 1000
                  model ( size [0.1 0.1 0.1] pose [0.2 0 -0.3 0] take_watts 30 obstacle_return 0 ) )
                """);
        Battery battery = run.robot("r").require(Battery.class);
        drive(run, 1, 2);
        BatteryState before = battery.latest().orElseThrow().value();
        assertThat(before.charging()).isEqualTo(Charging.DISCHARGING);
        assertThat(before.charge()).isLessThan(100);
        drive(run, 1, 2);
        assertThat(run.truth("r").x()).as("up to the station").isCloseTo(2.7, within(0.01));
        double there = battery.latest().orElseThrow().value().charge();
        run.advance(10);
        BatteryState after = battery.latest().orElseThrow().value();
        assertThat(after.charging()).isEqualTo(Charging.CHARGING);
        assertThat(after.charge() - there).as("30 W in, 1 W out").isCloseTo(290, within(1e-6));
    }

    private static Fiducials fiducials(String finder, String other) {
        var run = run("""
                position ( name "r" size [0.4 0.4 0.3] fiducial ( range_max 8 %s ) )
                model ( name "low" pose [3 0 0 0] size [0.2 0.2 0.1] fiducial_return 5 )
                %s
                """.formatted(finder, other));
        run.advance(0.2);
        return run.robot("r")
                .require(FiducialFinder.class)
                .latest()
                .orElseThrow()
                .value();
    }

    @Test
    void whoIgnoresHeightsSeesMarkersBelowUnlessSomethingHidesThem() {
        assertThat(fiducials("", "").fiducials()).isEmpty();
        assertThat(fiducials("ignore_zloc 1", "").fiducials())
                .singleElement()
                .satisfies(found -> assertThat(found.id()).hasValue(5));
        assertThat(fiducials("ignore_zloc 1", "model ( pose [2 0 0 0] size [0.1 1 1] )")
                        .fiducials())
                .isEmpty();
        assertThat(fiducials("ignore_zloc 1", "model ( pose [2 0 0 0] size [0.1 1 0.1] )")
                        .fiducials())
                .as("behind what is as low")
                .hasSize(1);
    }

    /// Stage 4.3, through Player, reports all three.
    @Test
    void aFinderOnTopOfARobotSeesRobotsThatAreAsHigh() {
        var run = run("""
                define bot position ( size [0.4 0.4 0.22] fiducial ( range_max 6 range_max_id 6 fov 360 ) )
                bot ( name "r" pose [0 0 0.1 0] fiducial_return 9 )
                bot ( name "r1" pose [3 0 0.1 180] fiducial_return 1 )
                bot ( name "r2" pose [0 3 0.1 90] fiducial_return 2 )
                bot ( name "r3" pose [-3 0 0.1 0] fiducial_return 3 )
                bot ( name "low" pose [2 -2 0.09 0] fiducial_return 4 )
                """);
        run.advance(0.2);
        assertThat(run.robot("r")
                        .require(FiducialFinder.class)
                        .latest()
                        .orElseThrow()
                        .value()
                        .fiducials())
                .extracting(found -> found.id().orElseThrow())
                .containsExactlyInAnyOrder(1, 2, 3);
    }

    @Test
    void outlinesWithCornersInALineUpToRoundingAreRobots() {
        var run = run("""
                position ( name "r" size [0.4 0.3 0.2] block ( points 6 point[0] [0 0] point[1] [0.75 0.25] point[2] [1.5 0.5]
                  point[3] [1.5 0.75] point[4] [0 1.25] point[5] [-0.25 0.5] z [0 0.2] ) )
                """);
        drive(run, 1, 1);
        assertThat(run.truth("r").x()).isGreaterThan(0.4);
    }

    private static LaserScan carried(String actuator, double position) {
        var run = run("""
                position ( name "r" size [0.4 0.4 0.3]
                  actuator ( noblocks 1 pose [0.1 0 0 90] min_position -90 max_position 90 max_speed 900 %s
                    ranger ( pose [0.2 0 -1 0] sensor ( range [0 20] fov 180 samples 181 ) ) ) )
                define wall model ( size [0.2 10 1] )
                wall ( pose [5 0 0 0] ) wall ( pose [-4 0 0 0] ) wall ( pose [0 3 0 90] ) wall ( pose [0 -2 0 90] )
                """.formatted(actuator));
        run.robot("r").require(Actuator.class).goTo(position);
        run.advance(0.3);
        return run.robot("r").require(LaserScanner.class).latest().orElseThrow().value();
    }

    private static void assertAt(LaserScan scan, double x, double y, double degrees, double ahead) {
        Pose2d there = Pose2d.ofDegrees(x, y, degrees);
        assertThat(scan.baseFromLaser().isNear(there, 1e-9, 1e-9))
                .as("%s", scan.baseFromLaser())
                .isTrue();
        assertThat(scan.ranges()[90]).isCloseTo((float) ahead, within(1e-5f));
    }

    @Test
    void rangersLookFromWhereActuatorsHaveCarriedThem() {
        assertAt(carried("type \"linear\" axis [1 0 0]", 0), 0.1, 0.2, 90, 2.9 - 0.2);
        assertAt(carried("type \"linear\" axis [1 0 0]", 0.5), 0.1, 0.7, 90, 2.9 - 0.7);
        assertAt(carried("type \"linear\" axis [0 2 0]", 0.5), -0.4, 0.2, 90, 2.9 - 0.2);
        assertAt(carried("type \"linear\" axis [0 0 1] start_position 0.5", 0), 0.1, 0.2, 90, 2.9 - 0.2);
        assertAt(carried("type \"rotational\"", 0), 0.1, 0.2, 90, 2.9 - 0.2);
        assertAt(carried("type \"rotational\"", Math.PI / 2), -0.1, 0, 180, 3.9 - 0.1);
        assertAt(carried("type \"rotational\" start_position 30", -Math.PI / 2), 0.3, 0, 0, 4.9 - 0.3);
    }

    private static LaserScan scan(String noise) {
        var run = run("""
                position ( name "r" size [0.4 0.4 0.3]
                  ranger ( sensor ( range [0 20] fov 180 samples 1001 noise %s ) ) )
                model ( pose [5 0 0 0] size [0.1 1000 1] )
                """.formatted(noise));
        run.advance(0.2);
        return run.robot("r").require(LaserScanner.class).latest().orElseThrow().value();
    }

    @Test
    void proportionalNoiseIsAsLargeAsItsShare() {
        LaserScan exact = scan("[0 0 0]");
        LaserScan noisy = scan("[0 0.1 0]");
        double least = 1;
        double most = -1;
        double sum = 0;
        int count = 0;
        for (int i = 0; i < exact.ranges().length; i++) {
            if (exact.ranges()[i] < 15) {
                double share = noisy.ranges()[i] / exact.ranges()[i] - 1;
                least = Math.min(least, share);
                most = Math.max(most, share);
                sum += share;
                count++;
            }
        }
        assertThat(least).isBetween(-0.10001, -0.098);
        assertThat(most).isBetween(0.098, 0.10001);
        assertThat(sum / count).isCloseTo(0, within(0.01));
    }

    /// A beam at angle a to a wall 5 m off is 5 m / cos a long, so that its length tells its angle.
    @Test
    void angularNoiseTurnsBeamsByAPartOfWhatIsBetweenThem() {
        LaserScan exact = scan("[0 0 0]");
        LaserScan noisy = scan("[0 0 57.29578]"); // 1 rad, which is half of the spacing either way
        double most = 0;
        for (int i = 600; exact.ranges()[i] < 15; i++) {
            double turned = Math.acos(4.95 / noisy.ranges()[i]) - Math.acos(4.95 / exact.ranges()[i]);
            most = Math.max(most, Math.abs(turned) / exact.angleIncrement());
        }
        assertThat(most).isBetween(0.48, 0.501);
    }
}
