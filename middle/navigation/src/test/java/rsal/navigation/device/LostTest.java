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
import rsal.testkit.contract.RobotBench;
import rsal.testkit.fake.FakeLocalizer;
import rsal.testkit.fake.FakeSystem;
import rsal.time.LockstepScheduler;

/// A navigator whose localizer says that it is lost, though its deviation is small.
class LostTest {
    private final LockstepScheduler scheduler = new LockstepScheduler();
    private final FakeSystem system = FakeSystem.pioneers(scheduler, RobotBench.WORLD, RobotBench.START);

    @Test
    void neverReachesAGoalWhileLost() {
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
                    Arguments.of(driver.parameters(), Map.of())));
        }
        Localizer localizer = robot.require(Localizer.class);
        var results = new ArrayList<Result>();
        Pose2d goal = RobotBench.START.compose(new Pose2d(2, 0, 0));

        localizer.relocalize(belief(Quality.LOST));
        scheduler.advance(Duration.ofSeconds(1));
        robot.require(Navigator.class).goTo(goal).result().thenAccept(results::add);
        scheduler.advance(Duration.ofSeconds(20));
        assertThat(results).isEmpty();

        localizer.relocalize(belief(Quality.LOCALIZED));
        scheduler.advance(Duration.ofSeconds(60));
        assertThat(results).singleElement().isInstanceOf(Result.Reached.class);
    }

    private PoseEstimate belief(Quality quality) {
        Pose2d truth = system.simulation().orElseThrow().truth("r1").orElseThrow();
        var covariance = Covariance2d.ofDeviations(0.05, 0.05, 0.02);
        return new PoseEstimate(
                truth, covariance, List.of(new PoseEstimate.Hypothesis(1, truth, covariance)), 0.1, quality);
    }
}
