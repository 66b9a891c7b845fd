package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.InstanceOfAssertFactories.DURATION;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rsal.data.Pose2d;
import rsal.engine.report.Answer;
import rsal.engine.report.RobotView;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.testkit.LongTest;
import rsal.testkit.Trials;

@Timeout(300)
class HuntAndPreyIT {
    @TempDir
    private Path folder;

    private static final Scenario HUNT = Scenario.load("hunt-and-prey");

    private record Hunt(RunResult result, List<RunEvent> events) {}

    private static Hunt hunt(String configuration, long seed) {
        return hunt(configuration, seed, 1);
    }

    private static Hunt hunt(String configuration, long seed, int helpers) {
        var options =
                RunOptions.NONE.withConfiguration(configuration).withSeed(seed).withSpeed(Double.POSITIVE_INFINITY);
        try (var run = LiveRun.of(HUNT.plan(options)).helpers(helpers).start()) {
            var result = run.result()
                    .toCompletableFuture()
                    .orTimeout(60, TimeUnit.SECONDS)
                    .join();
            return new Hunt(result, run.events(0));
        }
    }

    @Test
    @LongTest
    void thePreyIsCaughtInNineOfTenHunts() {
        assertThat(LongStream.rangeClosed(1, 10)
                        .filter(seed -> hunt("virtual", seed).result.outcome().equals("success"))
                        .count())
                .isGreaterThanOrEqualTo(9);
    }

    @Trials({"1", "2", "3", "4", "5", "6", "7", "8", "9", "10"})
    void huntersKnowWhereTheyAreAndTouchNoWall(long seed) {
        RunResult result = hunt("virtual", seed).result;
        assertThat(result.metrics().get("wallCollisions").getAsDouble()).isZero();
        result.metrics().forEach((name, value) -> {
            if (name.startsWith("localizationError.")) {
                assertThat(value.getAsDouble()).as(name).isLessThanOrEqualTo(0.30);
            }
        });
    }

    @LongTest
    @Trials({"1", "2", "3", "4", "5"})
    void agentsInAgentSpeakCatchThePreyEachSeedTheSameWay(long seed) {
        Hunt hunt = hunt("jason", seed);
        assertThat(hunt.result.outcome()).isEqualTo("success");
        assertThat(hunt.result.failed()).isEmpty();
        assertThat(hunt.result.metrics().get("captureDistance").getAsDouble())
                .isLessThan(1.7); // prey and hunter error where they are
        assertThat(hunt.result.metrics().get("wallCollisions").getAsDouble()).isZero();
        assertThat(hunt("jason", seed, 2).result.eventHash())
                .as("seed %d again, on more threads", seed)
                .isEqualTo(hunt.result.eventHash());
    }

    @Test
    @LongTest
    void runsInAgentSpeakDoNotMeetInOneProcess() {
        var options = RunOptions.NONE.withConfiguration("jason").withSeed(3).withSpeed(Double.POSITIVE_INFINITY);
        try (var one = LiveRun.of(HUNT.plan(options)).helpers(1).start();
                var other = LiveRun.of(HUNT.plan(options)).helpers(1).start()) {
            var first = one.result().toCompletableFuture().orTimeout(60, TimeUnit.SECONDS);
            var second = other.result().toCompletableFuture().orTimeout(60, TimeUnit.SECONDS);
            assertThat(first.join().eventHash()).isEqualTo(second.join().eventHash());
        }
    }

    @Test
    @LongTest
    void severalHuntersInAgentSpeakDivideThePreyAmongThem() {
        var options = RunOptions.NONE
                .withConfiguration("jason")
                .withSeed(5)
                .withSpeed(Double.POSITIVE_INFINITY)
                .withArguments(Map.of("hunters", "5", "prey", "3", "assignment", "nearest"));
        try (var run = LiveRun.of(HUNT.plan(options)).helpers(1).start()) {
            var result = run.result()
                    .toCompletableFuture()
                    .orTimeout(60, TimeUnit.SECONDS)
                    .join();
            assertThat(result.outcome()).isEqualTo("success");
        }
    }

    @Test
    @LongTest
    void caughtPreySpinsOnlyAsLongAsItHasRoom() {
        Hunt hunt = hunt("advanced", 14); // one is caught in front of a wall
        assertThat(hunt.result.outcome()).isEqualTo("success");
        assertThat(hunt.events)
                .filteredOn(event -> event.kind().equals("collision"))
                .isEmpty();
    }

    @Test
    void theSameSeedIsTheSameHuntHoweverManyHelp() {
        Hunt first = hunt("virtual", 3, 1);
        Hunt second = hunt("virtual", 3, 4);
        assertThat(second.events).isEqualTo(first.events);
        assertThat(second.result.eventHash()).isEqualTo(first.result.eventHash());
        assertThat(first.result.outcome()).isEqualTo("success");
    }

    @Trials({"1", "2", "3"})
    @LongTest
    void thePreyOfAHunterThatIsGoneIsSoonAnothers(long seed) {
        Hunt hunt = hunt("faulty", seed);
        assertThat(hunt.result.outcome()).isEqualTo("success");
        List<RunEvent> faults = hunt.events.stream()
                .filter(event -> event.kind().equals("fault"))
                .toList();
        assertThat(faults)
                .extracting(event -> event.time().toSeconds(), RunEvent::text)
                .containsExactly(tuple(0L, "lost (20 %)"), tuple(13L, "gone and in the way"));
        RunEvent gone = faults.getLast();
        Handover prey = Handover.of(hunt.events, gone, gone.subject().replace("hunter", "follow"));
        assertThat(prey.job()).matches("hunt prey-\\d");
        assertThat(prey.taken()).get(DURATION).isLessThanOrEqualTo(Handover.MOST);
    }

    @Test
    void theHuntGoesOnWhenRobotsThatOthersKnowAreRemovedAndOthersCome() throws InterruptedException {
        var options = RunOptions.NONE.withSeed(3).withSpeed(20).withLimit(Duration.ofSeconds(40));
        try (var run = LiveRun.start(HUNT.plan(options))) {
            after(run, 5);
            var added = run.operator().addRobot("hunter-1", new Pose2d(0, -1, 0));
            assertThat(added.toCompletableFuture().join()).isEqualTo(new Answer.Added("hunter-3"));
            after(run, 10);
            var removed = run.operator().remove("hunter-1");
            assertThat(removed.toCompletableFuture().join()).isEqualTo(new Answer.Done());
            after(run, 20);
            var gone = run.operator().remove("prey-1");
            assertThat(gone.toCompletableFuture().join()).isEqualTo(new Answer.Done());
            assertThat(Runs.result(run).outcome()).isEqualTo("limit");
            assertThat(run.events(0)).extracting(RunEvent::kind).doesNotContain("fault", "health");
            assertThat(run.snapshot().robots()).extracting(RobotView::id).containsExactly("hunter-2", "hunter-3");
        }
    }

    private static void after(LiveRun run, int seconds) throws InterruptedException {
        while (run.snapshot().time().toSeconds() < seconds) {
            var news = new CountDownLatch(1);
            try (var _ = run.onSnapshot(news::countDown)) {
                run.snapshot();
                news.await();
            }
        }
    }

    @Test
    @LongTest
    void withoutAnyHuntersItEndsWhenTimeIsUp() throws IOException {
        String scenario = Files.readString(
                        Path.of("../scenarios/src/main/resources/rsal/scenarios/hunt-and-prey/scenario.yaml"))
                .replace("pick: 1, at: 13, stays: true", "at: 5")
                .replace("time > 300", "time > 60");
        Path file = Files.writeString(folder.resolve("hunt.yaml"), scenario);
        var options = RunOptions.NONE.withConfiguration("faulty").withSeed(4).withSpeed(Double.POSITIVE_INFINITY);
        RunResult result = Runs.result(Scenario.load(file.toString()).plan(options));
        assertThat(result.outcome()).isEqualTo("timeout");
        assertThat(result.simulatedSeconds()).isCloseTo(60, within(0.2));
    }

    @Test
    void aBehaviorIsInChargeOfThePreyAndANavigatorOfTheHunters() {
        var options =
                RunOptions.NONE.withSeed(3).withSpeed(Double.POSITIVE_INFINITY).withLimit(Duration.ofSeconds(10));
        try (var run = LiveRun.start(HUNT.plan(options))) {
            Runs.result(run);
            assertThat(run.snapshot().robots())
                    .extracting(RobotView::inCharge)
                    .satisfiesExactly(
                            prey -> assertThat(prey).isNotEmpty().isNotEqualTo("navigator"),
                            hunter -> assertThat(hunter).isEqualTo("navigator"),
                            hunter -> assertThat(hunter).isEqualTo("navigator"));
        }
    }

    @LongTest
    @Trials({"1", "2", "3"})
    void fourHuntersThatBidCatchThreeCleverPrey(long seed) {
        Hunt hunt = hunt("advanced", seed);
        assertThat(hunt.result.outcome()).isEqualTo("success");
        assertThat(hunt.result.metrics().get("collisions").getAsDouble()).isZero();
        assertThat(hunt.events)
                .filteredOn(event -> event.kind().equals("caught"))
                .extracting(RunEvent::subject)
                .containsExactlyInAnyOrder("escape-1", "escape-2", "escape-3");
        assertThat(hunt.events)
                .extracting(RunEvent::text)
                .contains("not be caught: run")
                .anyMatch(text -> text.endsWith("accept-proposal: hunt prey-1 as no. 2"));
    }

    @Trials({"1", "2", "3", "4", "5"})
    @LongTest
    void preyThatReportTheirPosesToNobodyAreSeenAndCaught(long seed) {
        Hunt hunt = hunt("unseen", seed);
        assertThat(hunt.result.outcome()).isEqualTo("success");
        assertThat(hunt.result.metrics().get("collisions").getAsDouble()).isZero();
        assertThat(hunt.result.metrics().get("captureDistance").getAsDouble()).isLessThan(2);
        assertThat(hunt.events).extracting(RunEvent::text).anyMatch(text -> text.startsWith("going to look around at"));
    }
}
