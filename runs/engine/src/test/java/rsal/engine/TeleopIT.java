package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.data.Pose2d;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunResult;
import rsal.engine.report.SentGoal;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.testkit.LongTest;
import rsal.testkit.Trials;

@Timeout(120)
class TeleopIT {
    @Test
    @LongTest
    void robotsGoWherePeopleSendThem() throws InterruptedException {
        var options = RunOptions.NONE.withConfiguration("three").withSpeed(Double.POSITIVE_INFINITY);
        try (var run = LiveRun.start(Scenario.load("teleop").plan(options))) {
            var arrived = new CountDownLatch(1);
            run.onEvents(() -> {
                if (reached(run, "robot-1") && reached(run, "robot-2") && reached(run, "robot-3")) {
                    arrived.countDown();
                }
            });
            run.operator().goTo("robot-1", new Pose2d(17.4, 3.5, 1));
            run.operator().goTo("robot-2", new Pose2d(-21.3, 2, 0));
            run.operator().goTo("robot-3", new Pose2d(-3.6, 3.4, 0));
            assertThat(arrived.await(60, TimeUnit.SECONDS)).isTrue();
            run.stop();
            RunResult result = Runs.result(run);
            assertThat(result.metrics().get("arrived").getAsDouble()).isEqualTo(3);
            assertThat(result.metrics().get("collisions").getAsDouble()).isZero();
            assertThat(run.goals()).extracting(SentGoal::status).containsOnly(SentGoal.Status.SUCCEEDED);
        }
    }

    /// The first is taken away, the second can't be heard from the 10th to the 40th second, and a fifth of all
    /// messages is lost, also of those by which robots are sent.
    @Trials({"1", "2", "3", "4", "5"})
    void peopleAreInformedWhoDoesNotAnswerAndTheOthersGoWhereTheyAreSent(long seed) {
        var options = RunOptions.NONE
                .withConfiguration("faulty")
                .withSeed(seed)
                .withLimit(Duration.ofSeconds(150))
                .withSpeed(0.1); // until all are sent, long before anything goes wrong
        try (var run = LiveRun.start(Scenario.load("teleop").plan(options))) {
            run.operator().goTo("robot-1", new Pose2d(27.4, 0.1, 0));
            run.operator().goTo("robot-2", new Pose2d(-21.3, 2, 0));
            run.operator().goTo("robot-3", new Pose2d(17.4, 3.5, 0));
            run.operator()
                    .goTo("robot-4", new Pose2d(-3.6, 3.4, 0))
                    .toCompletableFuture()
                    .join();
            run.speed(Double.POSITIVE_INFINITY);
            RunResult result = Runs.result(run);
            String as = "seed %d".formatted(seed);
            assertThat(result.metrics().get("arrived").getAsDouble()).as(as).isEqualTo(3);
            assertThat(result.metrics().get("collisions").getAsDouble()).as(as).isZero();
            assertThat(run.goals())
                    .extracting(goal -> goal.status().word())
                    .containsExactly("canceled", "succeeded", "succeeded", "succeeded");
            assertThat(unreached(run, "robot-1"))
                    .as(as)
                    .hasSize(1)
                    .allSatisfy(event ->
                            assertThat(event.time()).isBetween(Duration.ofSeconds(14), Duration.ofSeconds(18)));
            assertThat(run.events(0))
                    .as(as)
                    .filteredOn(event -> event.subject().equals("dispatch"))
                    .anyMatch(event -> event.text().equals("2 of 4 robots answer, silent: robot-1, robot-2")
                            && event.time().toSeconds() < 18)
                    .anyMatch(event -> event.text().equals("3 of 4 robots answer, silent: robot-1")
                            && event.time().toSeconds() >= 40);
        }
    }

    private static List<RunEvent> unreached(LiveRun run, String robot) {
        return run.events(0).stream()
                .filter(event -> event.kind().equals("unreached")
                        && event.subject().equals(robot)
                        && event.text().contains("silent"))
                .toList();
    }

    private static boolean reached(LiveRun run, String robot) {
        return run.events(0).stream()
                .anyMatch(event -> event.kind().equals("goal")
                        && event.text().startsWith(robot + " at ")
                        && event.text().endsWith(": reached"));
    }
}
