package rsal.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static rsal.sim.SimRun.anywhere;
import static rsal.sim.SimRun.robot;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Interval;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.map.Maps;
import rsal.robot.RobotModel;
import rsal.robot.RobotSpec;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.system.RobotSystemProvider.InvalidRobots;
import rsal.testkit.DrawnMap;
import rsal.testkit.ObviousRays;

class SimProviderTest {
    static final OccupancyGrid OFFICE = new Maps(FileSource.folder(Path.of("."))).read("office", Location.of("test"));
    private static final OccupancyGrid ROOM = SimRun.room(6, 4);

    private static void assertRefused(String setting, String words, RobotSpec... robots) {
        assertThatExceptionOfType(InvalidRobots.class)
                .isThrownBy(() -> SimRun.of(ROOM, robots))
                .satisfies(e -> {
                    assertThat(e.problems()).hasSize(1);
                    assertThat(e.problems().getFirst().setting()).isEqualTo(setting);
                    assertThat(e.problems().getFirst().message()).contains(words);
                });
    }

    @Test
    void refusesAStartInsideAWallAndNamesAPlaceNearby() {
        assertRefused(
                "pose",
                "The start pose (0.05, 2.00) is inside a wall. Maybe (0.55, 1.95)",
                robot("r1", Models.box(), new Pose2d(0.05, 2, 0)));
    }

    @Test
    void refusesAStartSoNearAWallThatTheRobotTouches() {
        assertRefused("pose", "would touch a wall", robot("r1", Models.box(), new Pose2d(0.3, 2, 0)));
    }

    @Test
    void namesAPlaceBesideARobotThatStandsInTheWay() {
        assertRefused(
                "pose",
                "would touch robot 'r1'. Maybe (2.55, 1.95), the nearest place with room?",
                robot("r1", Models.box(), new Pose2d(2, 1.95, 0)),
                robot("r2", Models.box(), new Pose2d(2.25, 1.95, 0)));
    }

    @Test
    void refusesAStartOutsideTheMap() {
        assertRefused(
                "pose",
                "(7.00, 2.00) is outside the map, which reaches from (0.00, 0.00) to (6.00, 4.00)",
                robot("r1", Models.box(), new Pose2d(7, 2, 0)));
    }

    @Test
    void refusesAStartInsideAnotherRobot() {
        assertRefused(
                "pose",
                "would touch robot 'r1'",
                robot("r1", Models.box(), new Pose2d(2, 2, 0)),
                robot("r2", Models.box(), new Pose2d(2.3, 2, 0)));
    }

    @Test
    void refusesTwoRobotsOfOneId() {
        assertRefused(
                "id",
                "Two robots",
                robot("r1", Models.box(), new Pose2d(2, 2, 0)),
                robot("r1", Models.box(), new Pose2d(4, 2, 0)));
    }

    @Test
    void refusesARobotThatIsCalledWhatWallsAreCalledInContacts() {
        assertRefused("id", "'wall'", robot("wall", Models.box(), new Pose2d(2, 2, 0)));
    }

    @Test
    void refusesModelsThatItCannotSimulate() {
        RobotModel model = Models.box(Models.DRIVE, Models.laser(0, Duration.ZERO));
        assertRefused("model", "period [s] must be positive", robot("r1", model, new Pose2d(2, 2, 0)));
    }

    @Test
    void refusesDrivesThatItCannotSimulate() {
        RobotModel.Drive drive = Models.DRIVE;
        var unbraked = new RobotModel.Drive(
                drive.steering(),
                new RobotModel.Axis(drive.forward().speed(), new Interval(0, 1)),
                drive.sideways(),
                drive.turn(),
                drive.odometryNoise());
        assertRefused(
                "model", "forward deceleration [m/s²] must be", robot("r1", Models.box(unbraked), new Pose2d(2, 2, 0)));
    }

    @Test
    void reportsAllThatIsWrong() {
        assertThatExceptionOfType(InvalidRobots.class)
                .isThrownBy(() -> SimRun.of(
                        ROOM,
                        robot("r1", Models.box(), new Pose2d(0, 0, 0)),
                        robot("r2", Models.box(), new Pose2d(-1, 0, 0)),
                        robot("r3", Models.box(), new Pose2d(3, 2, 0))))
                .satisfies(e -> assertThat(e.problems())
                        .extracting(InvalidRobots.Problem::robot)
                        .containsExactly("r1", "r2"));
    }

    @Test
    void refusesMoreRobotsThanThereIsRoomFor() {
        var robots = new RobotSpec[30];
        for (int i = 0; i < robots.length; i++) {
            robots[i] = anywhere("r" + i, Models.box());
        }
        assertThatExceptionOfType(InvalidRobots.class)
                .isThrownBy(() -> SimRun.of(ROOM, robots))
                .withMessageContaining("no free place left")
                .satisfies(e -> assertThat(e.problems()).hasSize(1));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 42, -7})
    void robotsWithoutAPoseStartInTheOpenAndApart(long seed) {
        var specs = new ArrayList<RobotSpec>();
        for (int i = 0; i < 20; i++) {
            specs.add(anywhere("r" + i, Models.box()));
        }
        var run = SimRun.seeded(OFFICE, seed, Runnable::run, specs);
        var again = SimRun.seeded(OFFICE, seed, Runnable::run, specs);
        var other = SimRun.seeded(OFFICE, seed + 1, Runnable::run, specs);
        var slow = new ObviousRays(OFFICE);
        for (RobotSpec spec : specs) {
            Pose2d start = run.truth(spec.id());
            assertThat(slow.clearance(start.x(), start.y())).isGreaterThanOrEqualTo(0.4 - 1e-9);
            assertThat(again.truth(spec.id())).isEqualTo(start);
            assertThat(other.truth(spec.id())).isNotEqualTo(start);
            for (RobotSpec neighbor : specs) {
                if (!neighbor.id().equals(spec.id())) {
                    assertThat(start.distanceTo(run.truth(neighbor.id()))).isGreaterThan(0.8);
                }
            }
        }
    }

    @Test
    void robotsWithoutAPoseStartInTheLargestConnectedPlace() {
        var map = DrawnMap.grid(0.5, """
                ####################
                #......#...........#
                #......#...........#
                #......#...........#
                ####################""").grid();
        for (long seed = 0; seed < 20; seed++) {
            var run = SimRun.seeded(map, seed, Runnable::run, List.of(anywhere("r1", Models.box())));
            assertThat(run.truth("r1").x()).as("seed %d", seed).isGreaterThan(4);
        }
    }

    @Test
    void settingsOutOfRangeAreRefused() {
        assertThatExceptionOfType(IllegalArgumentException.class)
                .isThrownBy(() -> SimRun.of(ROOM, Map.of("step", 0.5)))
                .withMessageContaining("'step' must be a number from 0.01 to 0.2 [s], not '0.5'");
    }
}
