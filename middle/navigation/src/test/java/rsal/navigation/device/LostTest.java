package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Quality;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.device.Navigator.Result;
import rsal.robot.DeviceDriver;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.testkit.LongTest;
import rsal.testkit.contract.RobotBench;
import rsal.testkit.fake.FakeLocalizer;
import rsal.testkit.fake.FakeSystem;
import rsal.time.LockstepScheduler;

/// A navigator whose localizer says that it is lost, though its deviation is small.
class LostTest {
    private final LockstepScheduler scheduler = new LockstepScheduler();
    private final FakeSystem system = FakeSystem.pioneers(scheduler, RobotBench.WORLD, RobotBench.START);

    private final List<Result> results = new ArrayList<>();

    @Test
    void neverReachesAGoalWhileLost() {
        Robot robot = robot(Map.of());
        Localizer localizer = robot.require(Localizer.class);
        Pose2d goal = RobotBench.START.compose(new Pose2d(2, 0, 0));

        localizer.relocalize(belief(Quality.LOST, truth()));
        scheduler.advance(Duration.ofSeconds(1));
        goTo(goal, robot);
        scheduler.advance(Duration.ofSeconds(20));
        assertThat(results).isEmpty();

        localizer.relocalize(belief(Quality.LOCALIZED, truth()));
        scheduler.advance(Duration.ofSeconds(60));
        assertThat(results)
                .singleElement()
                .isInstanceOfSatisfying(
                        Result.Reached.class,
                        reached -> assertThat(reached.isSure()).isTrue());
    }

    /// It may stand elsewhere: what it measures fits there too.
    @Test
    @LongTest
    void saysThatItIsNotSureWhereItIsWhenItGetsThere() {
        Robot robot = robot(Map.of());
        Localizer localizer = robot.require(Localizer.class);
        localizer.relocalize(belief(Quality.AMBIGUOUS, truth()));
        goTo(RobotBench.START.compose(new Pose2d(2, 0, 0)), robot);
        scheduler.advance(Duration.ofSeconds(60));
        assertThat(results).singleElement().isInstanceOfSatisfying(Result.Reached.class, reached -> {
            assertThat(reached.isSure()).isFalse();
            assertThat(reached.doubt()).contains("ambiguous, confidence 0.10");
        });
    }

    /// It believed to be nearly there, so that all the way that it has to drive in truth is no progress.
    @Test
    @LongTest
    void hasAllItsPatienceWhenItFindsItselfFartherAway() {
        Robot robot = robot(Map.of("timeout", 5.0));
        Localizer localizer = robot.require(Localizer.class);
        Pose2d goal = RobotBench.START.compose(new Pose2d(3, 0, 0));

        localizer.relocalize(belief(Quality.LOCALIZED, goal.compose(new Pose2d(-0.5, 0, 0))));
        goTo(goal, robot);
        scheduler.advance(Duration.ofMillis(300));
        localizer.relocalize(belief(Quality.LOST, truth()));
        scheduler.advance(Duration.ofSeconds(4));
        assertThat(results).isEmpty();

        localizer.relocalize(belief(Quality.LOCALIZED, truth()));
        scheduler.advance(Duration.ofSeconds(30));
        assertThat(results).singleElement().isInstanceOf(Result.Reached.class);
    }

    /// It is always sent back to where it began.
    @Test
    @LongTest
    void givesUpAtLastWhenItFindsItselfAgainAndAgain() {
        Robot robot = robot(Map.of("timeout", 5.0));
        Localizer localizer = robot.require(Localizer.class);
        Pose2d start = truth();
        localizer.relocalize(belief(Quality.LOCALIZED, start));
        goTo(start.compose(new Pose2d(3, 0, 0)), robot);
        for (int time = 0; time < 30 && results.isEmpty(); time++) {
            localizer.relocalize(belief(Quality.LOCALIZED, start));
            scheduler.advance(Duration.ofSeconds(2));
            localizer.relocalize(belief(Quality.LOST, start));
            scheduler.advance(Duration.ofMillis(2500));
        }
        assertThat(results).singleElement().isInstanceOf(Result.Stuck.class);
    }

    @Test
    void drivesOnAtOnceWhenItFindsItself() {
        Robot robot = robot(Map.of());
        Localizer localizer = robot.require(Localizer.class);
        Pose2d goal = RobotBench.START.compose(new Pose2d(6, 0, 0));
        localizer.relocalize(belief(Quality.LOCALIZED, truth()));
        robot.require(Navigator.class).goTo(goal);
        scheduler.advance(Duration.ofSeconds(1));
        localizer.relocalize(belief(Quality.LOST, truth()));
        scheduler.advance(Duration.ofSeconds(10));
        Pose2d before = truth();
        localizer.relocalize(belief(Quality.LOCALIZED, before));
        scheduler.advance(Duration.ofSeconds(5));
        assertThat(truth().distanceTo(goal)).isLessThan(before.distanceTo(goal) - 1);
    }

    private Robot robot(Map<String, ?> settings) {
        system.discover();
        Robot robot = system.robots().getFirst();
        for (DeviceDriver driver : List.of(new FakeLocalizer.Driver(), new NavigatorDriver())) {
            robot = robot.with(driver.create(
                    new DeviceDriver.Context(
                            driver.key(),
                            robot,
                            RobotBench.WORLD.grid(),
                            Optional.of(RobotBench.START),
                            scheduler,
                            new SplittableRandom(1)),
                    Arguments.of(driver.parameters(), driver instanceof NavigatorDriver ? settings : Map.of())));
        }
        return robot;
    }

    private void goTo(Pose2d goal, Robot robot) {
        robot.require(Navigator.class).goTo(goal).result().thenAccept(results::add);
    }

    private Pose2d truth() {
        return system.simulation().orElseThrow().truth("r1").orElseThrow();
    }

    private static PoseEstimate belief(Quality quality, Pose2d pose) {
        var covariance = Covariance2d.ofDeviations(0.05, 0.05, 0.02);
        return new PoseEstimate(
                pose, covariance, List.of(new PoseEstimate.Hypothesis(1, pose, covariance)), 0.1, quality);
    }
}
