package rsal.scenario.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.data.Pose2d;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;

@Timeout(120)
class TeleopIT {
    @Test
    void robotsGoWherePeopleSendThem() throws InterruptedException {
        var options = RunOptions.NONE.withConfiguration("three").withSpeed(Double.POSITIVE_INFINITY);
        try (var run = LiveRun.start(Scenario.load("teleop").plan(options))) {
            var arrived = new CountDownLatch(1);
            run.onEvents(() -> {
                if (reached(run, "robot-1") && reached(run, "robot-2") && reached(run, "robot-3")) {
                    arrived.countDown();
                }
            });
            run.goTo("robot-1", new Pose2d(17.4, 3.5, 1));
            run.goTo("robot-2", new Pose2d(-21.3, 2, 0));
            run.goTo("robot-3", new Pose2d(-3.6, 3.4, 0));
            assertThat(arrived.await(60, TimeUnit.SECONDS)).isTrue();
            run.stop();
            RunResult result = Runs.result(run);
            assertThat(result.measures().get("arrived").getAsDouble()).isEqualTo(3);
            assertThat(result.measures().get("collisions").getAsDouble()).isZero();
        }
    }

    private static boolean reached(LiveRun run, String robot) {
        return run.events(0).stream()
                .anyMatch(event -> event.kind().equals("goal")
                        && event.text().startsWith(robot + " at ")
                        && event.text().endsWith(": reached"));
    }
}
