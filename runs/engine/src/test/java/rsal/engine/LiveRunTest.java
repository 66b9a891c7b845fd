package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Pose2d;
import rsal.engine.report.Answer;
import rsal.engine.report.DeviceView;
import rsal.engine.report.Performance;
import rsal.engine.report.RobotView;
import rsal.engine.report.RunBroken;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunResult;
import rsal.engine.report.Snapshot;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.testkit.LongTest;
import rsal.time.Phase;

@Timeout(60)
class LiveRunTest {
    @TempDir
    private Path folder;

    private RunPlan plan() {
        return plan(RunOptions.NONE);
    }

    /// Neither robot comes near the other, or anything else, at once.
    private RunPlan withRoom() {
        String text = Runs.TWO_WANDERERS
                .replace("pose: {free: true}", "pose: [-8.0, -1.0, 0]")
                .replace("time >= 20", "time >= 2000"); // however slow the machine, it isn't over while it is looked at
        return Runs.plan(folder, text, RunOptions.NONE.withSpeed(2)); // before the hunter is wedged between walls
    }

    private RunPlan plan(RunOptions options) {
        return Runs.plan(folder, Runs.TWO_WANDERERS, options);
    }

    /// The prey is caught after 3 s: no wall stands between it and its hunter.
    private RunPlan caught() {
        String text = Runs.TWO_WANDERERS.replace("pose: {free: true}", "pose: [-8.0, -1.0, 0]");
        return Runs.plan(folder, text, RunOptions.NONE.withArguments(Map.of("caughtAfter", "3")));
    }

    private RunPlan slow() {
        return plan(RunOptions.NONE.withSpeed(1));
    }

    @Test
    void theSamePlanGivesTheSameRun() {
        RunResult first = Runs.result(plan());
        assertThat(Runs.result(plan()).eventHash()).isEqualTo(first.eventHash()).hasSize(64);
        assertThat(Runs.result(plan(RunOptions.NONE.withSeed(8))).eventHash()).isNotEqualTo(first.eventHash());
    }

    @Test
    void whereRobotsBelieveToBeIsPartOfTheRun() {
        String text = Runs.TWO_WANDERERS.replace("error: 0.2", "error: 0.21"); // nobody acts on it
        assertThat(Runs.result(Runs.plan(folder, text, RunOptions.NONE)).eventHash())
                .isNotEqualTo(Runs.result(plan()).eventHash());
    }

    @Test
    void watchingItDoesNotChangeARun() {
        RunResult unwatched = Runs.result(plan());
        try (var run = LiveRun.start(plan())) {
            run.onSnapshot(run::snapshot);
            run.onEvents(() -> run.events(0));
            while (!run.result().toCompletableFuture().isDone()) {
                run.snapshot();
            }
            assertThat(Runs.result(run).eventHash()).isEqualTo(unwatched.eventHash());
        }
    }

    @Test
    void rememberingItsEndDoesNotChangeARun() {
        try (var run = LiveRun.start(slow())) {
            run.remember();
            run.speed(Double.POSITIVE_INFINITY);
            assertThat(Runs.result(run).eventHash())
                    .isEqualTo(Runs.result(plan()).eventHash());
            assertThat(run.inspector().topics().toCompletableFuture().join()).isInstanceOf(Answer.Counted.class);
            assertThat(run.inspector().readings("nobody").toCompletableFuture().join())
                    .isInstanceOf(Answer.Refused.class);
        }
    }

    @Test
    void countsWhatItHasDone() {
        try (var run = LiveRun.start(plan())) {
            RunResult result = Runs.result(run);
            Performance performance = run.performance();
            assertThat(performance.time()).isEqualTo(run.snapshot().time()).isPositive();
            assertThat(performance.steps().count())
                    .isEqualTo(performance.time().dividedBy(run.plan().step()));
            assertThat(performance.steps().sum()).isPositive();
            assertThat(performance.phases()).containsOnlyKeys(Phase.values());
            assertThat(performance.phases().get(Phase.WORLD)).isPositive();
            assertThat(performance.phases().get(Phase.OBSERVE)).isPositive();
            Duration inPhases = performance.phases().values().stream().reduce(Duration.ZERO, Duration::plus);
            assertThat(inPhases).isLessThanOrEqualTo(performance.steps().sum());
            assertThat(performance.topics()).isEqualTo(result.topics());
            assertThat(performance.events())
                    .isEqualTo(run.events(0).stream()
                            .collect(Collectors.groupingBy(RunEvent::kind, Collectors.counting())));
        }
    }

    @Test
    void reportsWhatItHasCountedWhileItGoesOn() {
        try (var run = LiveRun.start(plan())) {
            Performance before = Performance.NONE;
            while (!run.result().toCompletableFuture().isDone()) {
                Performance now = run.performance();
                assertThat(now.time()).isGreaterThanOrEqualTo(before.time());
                assertThat(now.steps().count())
                        .isGreaterThanOrEqualTo(before.steps().count());
                assertThat(now.steps().sum())
                        .isGreaterThanOrEqualTo(before.steps().sum());
                before = now;
            }
            assertThat(before.steps().count()).isPositive();
            assertThat(Runs.result(run).eventHash())
                    .isEqualTo(Runs.result(plan()).eventHash());
        }
    }

    @Test
    void whoIsPausedBeforeTheFirstStepAnswers() throws Exception {
        try (var run = LiveRun.start(plan())) {
            run.pause(); // as soon as its thread begins
            var answer = run.operator().place("hunter-1", new Pose2d(-4, -1, 0)).toCompletableFuture();
            assertThat(answer.get(20, TimeUnit.SECONDS)).isInstanceOf(Answer.Done.class);
        }
    }

    @Test
    void pausingAndSteppingDoNotChangeARun() throws InterruptedException {
        try (var run = LiveRun.start(slow())) {
            var snapshots = snapshots(run);
            run.pause();
            Snapshot before = awaitPaused(snapshots);
            run.step();
            run.step();
            Snapshot after = next(snapshots, before.time().plusMillis(200));
            assertThat(after.paused()).isTrue();
            assertThat(after.time()).isEqualTo(before.time().plusMillis(200));
            run.speed(Double.POSITIVE_INFINITY);
            run.resume();
            assertThat(Runs.result(run).eventHash())
                    .isEqualTo(Runs.result(plan()).eventHash());
        }
    }

    @Test
    void timeStandsStillWhilePaused() throws InterruptedException {
        try (var run = LiveRun.start(slow())) {
            var snapshots = snapshots(run);
            run.pause();
            Snapshot first = awaitPaused(snapshots);
            run.snapshot();
            Snapshot second = snapshots.take();
            assertThat(second.sequence()).isGreaterThan(first.sequence());
            assertThat(second.time()).isEqualTo(first.time());
            assertThat(run.isPaused()).isTrue();
            assertThat(run.elapsed()).isEqualTo(first.time());
        }
    }

    @Test
    void endsAsTheScenarioSays() {
        RunResult timeout = Runs.result(plan());
        assertThat(timeout.outcome()).isEqualTo("timeout");
        assertThat(timeout.simulatedSeconds()).isEqualTo(20);
        assertThat(timeout.metrics().get("captureTime")).isEqualTo(OptionalDouble.empty());
        RunResult success = Runs.result(caught());
        assertThat(success.outcome()).isEqualTo("success");
        assertThat(success.simulatedSeconds()).isCloseTo(3, within(0.11));
    }

    @Test
    void endsWhenTheTimeIsUpThatItsStarterGave() {
        RunResult result = Runs.result(plan(RunOptions.NONE.withLimit(Duration.ofSeconds(2))));
        assertThat(result.outcome()).isEqualTo("limit");
        assertThat(result.simulatedSeconds()).isEqualTo(2);
    }

    @Test
    void measuresAgainstTheTruth() {
        RunResult result = Runs.result(caught());
        assertThat(result.metrics().keySet())
                .containsExactly("captureTime", "captureDistance", "error.prey", "error.hunter-1", "way");
        assertThat(result.metrics().get("error.prey").getAsDouble()).isCloseTo(0.2, within(0.1));
        assertThat(result.metrics().get("error.hunter-1")).isEqualTo(OptionalDouble.empty()); // has no localizer
        assertThat(result.metrics().get("way").getAsDouble()).isBetween(0.3, 0.9);
        assertThat(result.metrics().get("captureDistance").getAsDouble()).isGreaterThan(1);
        assertThat(result.outOfBounds()).containsExactly("error.prey");
    }

    @Test
    void showsRobotsAndAgents() {
        try (var run = LiveRun.start(plan())) {
            Runs.result(run);
            Snapshot last = run.snapshot();
            assertThat(last.outcome()).contains("timeout");
            assertThat(last.robots()).extracting(RobotView::id).containsExactly("prey", "hunter-1");
            RobotView prey = last.robots().getFirst();
            assertThat(prey.truth()).isPresent();
            assertThat(prey.scan()).isPresent();
            assertThat(prey.estimate()).isPresent();
            assertThat(prey.inCharge()).isEmpty(); // an agent drives, no behavior
            assertThat(prey.devices())
                    .extracting(DeviceView::name, DeviceView::driver, DeviceView::type)
                    .contains(
                            org.assertj.core.groups.Tuple.tuple("localizer", "truthful", "Localizer"),
                            org.assertj.core.groups.Tuple.tuple("laser", "sim", "LaserScanner"));
            assertThat(last.agents())
                    .extracting(agent -> agent.view().agent().name())
                    .containsExactly("run", "chase-1");
        }
    }

    @Test
    void reportsWhatHappenedInOrderAndWithoutGaps() {
        try (var run = LiveRun.start(caught())) {
            Runs.result(run);
            List<RunEvent> events = run.events(0);
            assertThat(events).extracting(RunEvent::kind).contains("run", "agent", "caught");
            assertThat(events.getLast().text()).isEqualTo("ends: success");
            for (int i = 0; i < events.size(); i++) {
                assertThat(events.get(i).sequence()).isEqualTo(i + 1);
            }
            assertThat(run.events(events.size() - 1)).containsExactly(events.getLast());
        }
    }

    @Test
    void anOperatorPlacesARobotInTruthAndInItsBelief() throws InterruptedException {
        try (var run = LiveRun.start(slow())) {
            var snapshots = snapshots(run);
            awaitRobots(snapshots);
            assertThat(answer(run.operator().place("prey", new Pose2d(-8, -1, 0))))
                    .isEqualTo(new Answer.Done());
            Duration then = next(snapshots, Duration.ZERO).time();
            Snapshot later = next(snapshots, then.plusMillis(200));
            RobotView prey = later.robots().getFirst();
            assertThat(prey.truth().orElseThrow().distanceTo(new Pose2d(-8, -1, 0)))
                    .isLessThan(1);
            assertThat(answer(run.operator().place("prey", new Pose2d(-1000, 0, 0))))
                    .isInstanceOf(Answer.Refused.class);
            assertThat(answer(run.operator().place("nobody", new Pose2d(-8, -1, 0))))
                    .isInstanceOfSatisfying(
                            Answer.Refused.class, r -> assertThat(r.why()).contains("hunter-1"));
            assertThat(run.events(0)).extracting(RunEvent::kind).contains("operator");
            run.stop();
            assertThat(Runs.result(run).metrics().get("way").getAsDouble()).isLessThan(2); // the jump does not count
        }
    }

    @Test
    void aRobotThatWasPlacedShowsNothingOfWhereItWas() throws InterruptedException {
        try (var run = LiveRun.start(slow())) {
            var snapshots = snapshots(run);
            Snapshot before = next(snapshots, Duration.ofMillis(300));
            assertThat(before.robots().getFirst().scan()).isPresent();
            assertThat(before.robots().getFirst().estimate()).isPresent();
            run.pause();
            var there = new Pose2d(-8, -1, 0);
            assertThat(answer(run.operator().place("prey", there))).isEqualTo(new Answer.Done());
            snapshots.clear();
            run.snapshot();
            snapshots.take(); // may have been under way
            RobotView placed = snapshots.take().robots().getFirst();
            assertThat(placed.truth()).contains(there);
            assertThat(placed.scan()).isEmpty();
            assertThat(placed.estimate()).isEmpty();
            run.resume();
            RobotView later =
                    next(snapshots, before.time().plusMillis(1000)).robots().getFirst();
            assertThat(later.scan()).isPresent();
            assertThat(later.estimate()).isPresent();
        }
    }

    @Test
    void theEmergencyStopHoldsUntilItIsLifted() throws InterruptedException {
        try (var run = LiveRun.start(plan(RunOptions.NONE.withSpeed(5)))) {
            var snapshots = snapshots(run);
            awaitRobots(snapshots);
            assertThat(answer(run.operator().estop())).isInstanceOf(Answer.Stopped.class);
            Snapshot first =
                    next(snapshots, next(snapshots, Duration.ZERO).time().plusMillis(1500));
            Snapshot second = next(snapshots, first.time().plusMillis(1000));
            assertThat(second.stopped()).isTrue();
            assertThat(second.robots().getFirst().truth())
                    .isEqualTo(first.robots().getFirst().truth());
            assertThat(answer(run.operator().rearm())).isInstanceOf(Answer.Armed.class);
            Snapshot third = next(snapshots, second.time().plusMillis(1500));
            assertThat(third.stopped()).isFalse();
            assertThat(third.robots().getFirst().truth())
                    .isNotEqualTo(second.robots().getFirst().truth());
        }
    }

    @Test
    @LongTest
    void oneRobotIsStoppedOrArmedWhileTheOthersGoOn() throws InterruptedException {
        try (var run = LiveRun.start(withRoom())) {
            var snapshots = snapshots(run);
            awaitRobots(snapshots);
            assertThat(answer(run.operator().stop("hunter-1"))).isEqualTo(new Answer.Done());
            assertMoves(snapshots, true, false);
            assertThat(answer(run.operator().estop())).isInstanceOf(Answer.Stopped.class);
            assertMoves(snapshots, false, false);
            assertThat(answer(run.operator().rearm("hunter-1"))).isEqualTo(new Answer.Done());
            assertMoves(snapshots, false, true);
            assertThat(answer(run.operator().rearm("prey"))).isEqualTo(new Answer.Done());
            assertMoves(snapshots, true, true);
            assertThat(answer(run.operator().stop("nobody"))).isInstanceOf(Answer.Refused.class);
        }
    }

    @Test
    void whoWasSwitchedOffStaysOffWhenAllAreArmed() throws InterruptedException {
        try (var run = LiveRun.start(withRoom())) {
            var snapshots = snapshots(run);
            awaitRobots(snapshots);
            answer(run.operator().stop("hunter-1"));
            answer(run.operator().estop());
            assertThat(answer(run.operator().rearm())).isEqualTo(new Answer.Armed(1, List.of("hunter-1")));
            assertMoves(snapshots, true, false);
            assertThat(run.snapshot().robots())
                    .extracting(RobotView::switchedOff)
                    .containsExactly(false, true);
            assertThat(run.events(0))
                    .anySatisfy(event -> assertThat(event.text()).isEqualTo("motors on, but not those of hunter-1"));
            assertThat(answer(run.operator().rearm()))
                    .as("asked again")
                    .isEqualTo(new Answer.Armed(1, List.of("hunter-1")));
            answer(run.operator().estop());
            answer(run.operator().stop("prey")); // while it stands
            assertThat(answer(run.operator().rearm("hunter-1"))).isEqualTo(new Answer.Done());
            assertMoves(snapshots, false, true);
            assertThat(answer(run.operator().rearm())).isEqualTo(new Answer.Armed(1, List.of("prey")));
            assertMoves(snapshots, false, true);
            assertThat(answer(run.operator().rearm("prey"))).isEqualTo(new Answer.Done());
            assertMoves(snapshots, true, true);
        }
    }

    /** Asserts who is driven from 1.5 s on. Somebody may stand for a moment, for lack of room, and is waited for. */
    private static void assertMoves(BlockingQueue<Snapshot> snapshots, boolean prey, boolean hunter)
            throws InterruptedException {
        snapshots.clear(); // they may be of long ago
        Snapshot now = next(snapshots, Duration.ZERO);
        Snapshot first = next(snapshots, now.time().plusMillis(1500));
        Snapshot second = next(snapshots, first.time().plusMillis(1000));
        while ((prey && !moved(first, second, 0)) || (hunter && !moved(first, second, 1))) {
            assertThat(second.time())
                    .as("somebody stands")
                    .isLessThan(first.time().plusSeconds(60));
            second = next(snapshots, second.time().plusMillis(1));
        }
        assertThat(second.stopped()).isEqualTo(!prey && !hunter);
        assertThat(second.robots()).extracting(RobotView::stopped).containsExactly(!prey, !hunter);
        assertThat(moved(first, second, 0)).as("prey").isEqualTo(prey);
        assertThat(moved(first, second, 1)).as("hunter-1").isEqualTo(hunter);
    }

    private static boolean moved(Snapshot first, Snapshot second, int robot) {
        return !second.robots()
                .get(robot)
                .truth()
                .equals(first.robots().get(robot).truth());
    }

    @Test
    void noAgentLiftsTheEmergencyStop() throws InterruptedException {
        String text = Runs.TWO_WANDERERS.replace("type: wanderer, robot: hunter", "type: stubborn, robot: hunter");
        try (var run = LiveRun.start(Runs.plan(folder, text, RunOptions.NONE.withSpeed(5)))) {
            var snapshots = snapshots(run);
            awaitRobots(snapshots);
            assertThat(answer(run.operator().estop())).isInstanceOf(Answer.Stopped.class);
            Snapshot first =
                    next(snapshots, next(snapshots, Duration.ZERO).time().plusMillis(1500));
            Snapshot second = next(snapshots, first.time().plusMillis(1000));
            assertThat(second.robots().getLast().truth())
                    .isEqualTo(first.robots().getLast().truth());
            assertThat(answer(run.operator().rearm())).isInstanceOf(Answer.Armed.class);
            Snapshot third = next(snapshots, second.time().plusMillis(1500));
            assertThat(third.robots().getLast().truth())
                    .isNotEqualTo(second.robots().getLast().truth());
        }
    }

    @Test
    void anAgentThatFailsEndsAlone() {
        String text = Runs.TWO_WANDERERS.replace("chase: {type: wanderer, robot: hunter}", "chase: {type: breaker}");
        try (var run = LiveRun.start(Runs.plan(folder, text, RunOptions.NONE))) {
            RunResult result = Runs.result(run);
            assertThat(result.outcome()).isEqualTo("timeout");
            assertThat(result.failed()).containsOnlyKeys("chase");
            assertThat(result.failed().get("chase")).contains("a screw is loose");
            assertThat(run.events(0)).anySatisfy(event -> {
                assertThat(event.kind()).isEqualTo("fault");
                assertThat(event.subject()).isEqualTo("chase");
                assertThat(event.text()).contains("a screw is loose");
            });
        }
    }

    @ParameterizedTest
    @CsvSource({
        "success, fail, failure",
        "success, tolerate, success",
        "failure, tolerate, failure",
        "timeout, fail, timeout"
    })
    void anAgentThatFailsIsAFailureOfTheRunUnlessThatIsTolerated(String written, String failedAgents, String outcome) {
        String text = Runs.TWO_WANDERERS
                .replace("chase: {type: wanderer, robot: hunter}", "chase: {type: breaker}")
                .replace("outcome: timeout", "outcome: " + written)
                .replace("  seed: 7\n", "  seed: 7\n  failedAgents: %s\n".formatted(failedAgents));
        try (var run = LiveRun.start(Runs.plan(folder, text, RunOptions.NONE))) {
            RunResult result = Runs.result(run);
            assertThat(result.outcome()).isEqualTo(outcome);
            assertThat(result.failed()).containsOnlyKeys("chase");
            assertThat(run.events(0))
                    .last()
                    .satisfies(event -> assertThat(event.text())
                            .isEqualTo("ends: " + outcome + (failedAgents.equals("fail") ? "; failed: chase" : "")));
        }
    }

    @Test
    void anAgentWhoseWordsCantBeMadeEndsAloneAndTheRestIsReported() {
        String text = Runs.TWO_WANDERERS.replace(
                "chase: {type: wanderer, robot: hunter}", "chase: {type: mumbler}\n  chat: {type: chatter}");
        try (var run = LiveRun.start(Runs.plan(folder, text, RunOptions.NONE))) {
            assertThat(Runs.result(run).outcome()).isEqualTo("timeout");
            assertThat(run.events(0))
                    .extracting(event -> event.kind() + " " + event.subject() + ": " + event.text())
                    .contains("fault chase: has failed: There are no words for it.", "message chat: no. 190");
            assertThat(run.snapshot().agents())
                    .filteredOn(agent -> agent.view().agent().name().equals("chat"))
                    .singleElement()
                    .satisfies(chat -> assertThat(chat.lastMessages())
                            .hasSize(5)
                            .allMatch(said -> said.startsWith("text: no. 19")));
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void anAgentThatTakesATopicsNameForAnotherTypeEndsAlone(boolean comesFirst) {
        List<String> agents = List.of("squat: {type: squatter}", "chat: {type: chatter}");
        String text = Runs.TWO_WANDERERS.replace(
                "chase: {type: wanderer, robot: hunter}", String.join("\n  ", comesFirst ? agents : agents.reversed()));
        try (var run = LiveRun.start(Runs.plan(folder, text, RunOptions.NONE))) {
            assertThat(Runs.result(run).outcome()).isEqualTo("timeout");
            assertThat(run.events(0))
                    .filteredOn(event -> event.kind().equals("fault"))
                    .extracting(event -> event.subject() + " " + event.text())
                    .containsExactly("squat has failed: Topic 'text' carries rsal.agent.message.Text since"
                            + " 'platform' used it first, not java.lang.String. Maybe give yours another name.");
        }
    }

    @Test
    void aDeviceThatFailsBreaksTheRunAndIsNamed() {
        assertThatThrownBy(() -> Runs.result(broken("{}")))
                .isInstanceOf(RunBroken.class)
                .hasMessage("Device 'hunter-1/broken' failed: smoke comes out");
        assertThatThrownBy(() -> Runs.result(broken("{atOnce: true}")))
                .isInstanceOf(RunBroken.class)
                .hasMessage("Device 'hunter-1/broken' failed: no batteries included");
    }

    @Test
    void whatCantBeStartedIsNamed() {
        String text = Runs.TWO_WANDERERS
                .replace("clock: {speed: max}", "clock: {mode: wall}")
                .replace("run:\n  seed", "mas: {use: wallclock}\nrun:\n  seed");
        assertThatThrownBy(() -> Runs.result(Runs.plan(folder, text, RunOptions.NONE)))
                .isInstanceOf(RunBroken.class)
                .hasMessage("Multi-agent system 'wallclock' failed: No test starts it.");
    }

    @Test
    void aRunThatBreaksLetsGoOfItsThreads() throws InterruptedException {
        assertThatThrownBy(() -> Runs.result(broken("{unreadable: true}")))
                .isInstanceOf(RunBroken.class)
                .hasMessageContaining("the display is dark");
        for (Thread thread : Thread.getAllStackTraces().keySet()) {
            if (thread.getName().matches("run-\\d+-helper-\\d+")) {
                thread.join(Duration.ofSeconds(10));
                assertThat(thread.isAlive()).as(thread.getName()).isFalse();
            }
        }
    }

    @Test
    void aRunWithoutMemoryLeftEndsAtOnceWithoutALastLook() {
        String text = Runs.TWO_WANDERERS.replace(
                "chase: {type: wanderer, robot: hunter}", "chase: {type: glutton, robot: hunter}");
        try (var run = LiveRun.start(Runs.plan(folder, text, RunOptions.NONE))) {
            assertThatThrownBy(() -> Runs.result(run))
                    .isInstanceOf(RunBroken.class)
                    .hasMessageContaining("Java heap space");
            assertThat(run.snapshot().time()).isLessThan(Duration.ofSeconds(1));
        }
    }

    @Test
    void viewersThatFailHarmOnlyThemselves() {
        RunResult unwatched = Runs.result(plan());
        try (var run = LiveRun.start(plan())) {
            run.onSnapshot(() -> {
                throw new IllegalStateException("The screen is black.");
            });
            run.onEvents(() -> {
                throw new IllegalStateException("The printer is out of paper.");
            });
            run.snapshot();
            assertThat(Runs.result(run).eventHash()).isEqualTo(unwatched.eventHash());
        }
    }

    private RunPlan broken(String options) {
        String text = Runs.TWO_WANDERERS.replace(
                "pose: {free: true}", "pose: {free: true}\n    devices: {broken: " + options + "}");
        return Runs.plan(folder, text, RunOptions.NONE);
    }

    @Test
    void realTimeGoesOnByItself() {
        String text = Runs.TWO_WANDERERS.replace("clock: {speed: max}", "clock: {mode: wall}");
        var plan = Runs.plan(folder, text, RunOptions.NONE.withLimit(Duration.ofMillis(600)));
        try (var run = LiveRun.start(plan)) {
            run.pause();
            run.speed(10);
            assertThat(answer(run.operator().place("prey", new Pose2d(-8, -1, 0))))
                    .isEqualTo(new Answer.Done());
            RunResult result = Runs.result(run);
            assertThat(result.outcome()).isEqualTo("limit");
            assertThat(result.simulatedSeconds()).isCloseTo(result.wallSeconds(), within(0.3));
            assertThat(run.snapshot().robots()).isNotEmpty();
        }
        assertThatThrownBy(() -> Runs.result(Runs.plan(
                        folder,
                        text.replace("pose: {free: true}", "pose: {free: true}\n    devices: {broken: {}}"),
                        RunOptions.NONE)))
                .hasMessage("Device 'hunter-1/broken' failed: smoke comes out");
    }

    @Test
    void anAgentThatNeverReturnsDoesNotHoldUpItsCloser() throws InterruptedException {
        String text = Runs.TWO_WANDERERS.replace("chase: {type: wanderer, robot: hunter}", "chase: {type: thinker}");
        LiveRun run = LiveRun.start(Runs.plan(folder, text, RunOptions.NONE));
        var begun = new CountDownLatch(1);
        run.onEvents(begun::countDown);
        if (run.events(0).isEmpty()) {
            begun.await(); // all agents begin before the next command is taken
        }
        run.close();
        assertThat(run.result().toCompletableFuture()).isNotDone();
        Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.getName().matches("run-\\d+"))
                .forEach(Thread::interrupt); // lets the thinker go
        assertThat(Runs.result(run).outcome()).isEqualTo("stopped");
    }

    @Test
    void closingEndsItAndRefusesWhatComesLater() throws InterruptedException {
        LiveRun run = LiveRun.start(slow());
        run.close();
        assertThat(Runs.result(run).outcome()).isEqualTo("stopped");
        assertThat(answer(run.operator().estop())).isEqualTo(new Answer.Refused("The run has ended."));
        run.close();
    }

    /// When the last snapshot is made, no step comes any more in which it could be answered.
    @Test
    void reportsTheFirstSnapshotOfWhichSomethingIsTrue() throws Exception {
        try (LiveRun run = LiveRun.start(slow())) {
            Snapshot found = run.when(now -> now.time().toMillis() >= 500)
                    .toCompletableFuture()
                    .get(30, TimeUnit.SECONDS);
            assertThat(found.time().toMillis()).isGreaterThanOrEqualTo(500);
            CompletableFuture<Snapshot> never = run.when(_ -> false).toCompletableFuture();
            run.stop();
            assertThatThrownBy(() -> never.get(30, TimeUnit.SECONDS))
                    .hasCauseInstanceOf(IllegalStateException.class)
                    .hasMessageContaining("The run has ended.");
        }
    }

    @Test
    void whatIsAskedAtTheEndIsAnsweredByWhatIsRemembered() {
        var asked = new ConcurrentLinkedQueue<CompletionStage<Answer>>();
        try (var run = LiveRun.start(slow())) {
            run.remember();
            run.onSnapshot(() -> asked.add(run.inspector().topics()));
            run.snapshot();
            run.speed(Double.POSITIVE_INFINITY);
            Runs.result(run);
        }
        assertThat(asked)
                .isNotEmpty()
                .allSatisfy(answer -> assertThat(answer(answer)).isInstanceOf(Answer.Counted.class));
    }

    private static BlockingQueue<Snapshot> snapshots(LiveRun run) {
        var snapshots = new LinkedBlockingQueue<Snapshot>();
        run.onSnapshot(() -> snapshots.add(run.snapshot()));
        run.snapshot();
        return snapshots;
    }

    /// The next snapshot at a time or later.
    private static Snapshot next(BlockingQueue<Snapshot> snapshots, Duration time) throws InterruptedException {
        Snapshot next = snapshots.take();
        while (next.time().compareTo(time) < 0) {
            next = snapshots.take();
        }
        return next;
    }

    private static Snapshot awaitPaused(BlockingQueue<Snapshot> snapshots) throws InterruptedException {
        Snapshot next = snapshots.take();
        while (!next.paused()) {
            next = snapshots.take();
        }
        return next;
    }

    private static void awaitRobots(BlockingQueue<Snapshot> snapshots) throws InterruptedException {
        while (snapshots.take().robots().isEmpty()) {
            // not there yet
        }
    }

    private static Answer answer(CompletionStage<Answer> stage) {
        return stage.toCompletableFuture().orTimeout(10, TimeUnit.SECONDS).join();
    }
}
