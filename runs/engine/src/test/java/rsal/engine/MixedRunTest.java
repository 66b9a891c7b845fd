package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.Pose2d;
import rsal.engine.report.Answer;
import rsal.engine.report.RobotView;
import rsal.engine.report.RunBroken;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;

/// Runs with robots of several systems: some simulated, some as if they were real.
@Timeout(60)
class MixedRunTest {
    private static final String MIXED = """
            rsal: 1
            scenario: mixed
            world: {map: office}
            robots:
              prey:
                model: pioneer2dx
                pose: [-12, -1, 180]
                devices: {laser: urg04lx, localizer: {type: truthful}}
              hunter:
                model: pioneer3at
                devices: {laser: urg04lx, localizer: {type: truthful, error: 0.25}}
                members:
                  - {name: real, pose: [-8, -1, 0], mrs: {use: reality, host: lab}}
                  - {name: virtual, pose: [-4, -1, 0]}
            agents:
              run: {type: quitter, robot: prey, parameters: {caughtAfter: 4, by: real, distance: 30, speed: 0}}
              chase: {type: wanderer, robot: hunter}
            mrs: {odometryNoise: 0}
            run:
              seed: 7
              clock: {speed: max}
              stop: [{when: time >= 5, outcome: success}]
            metrics:
              - {name: caughtAt, from: max(captureDistance)}
              - {name: error, from: max(poseError), per: robot}
              - {name: way, from: distance, per: robot}
            """;

    @TempDir
    private Path folder;

    private RunPlan plan(String text) {
        return Runs.plan(folder, text, RunOptions.NONE);
    }

    private static RobotView view(LiveRun run, String robot) {
        return run.snapshot().robots().stream()
                .filter(view -> view.id().equals(robot))
                .findFirst()
                .orElseThrow();
    }

    private static Answer answer(CompletionStage<Answer> stage) {
        return stage.toCompletableFuture().orTimeout(10, TimeUnit.SECONDS).join();
    }

    @Test
    void robotsOfAllSystemsTakePart() {
        try (var run = LiveRun.start(plan(MIXED))) {
            assertThat(Runs.result(run).outcome()).isEqualTo("success");
            assertThat(run.events(0)).extracting(RunEvent::text).contains("3 robots, 3 agents");
            for (String robot : new String[] {"real", "virtual"}) {
                RobotView view = view(run, robot);
                assertThat(view.scan()).isPresent();
                assertThat(view.estimate()).isPresent();
                assertThat(view.odometry().orElseThrow().value().odomFromBase().distanceTo(Pose2d.ORIGIN))
                        .isGreaterThan(0.5);
            }
            assertThat(view(run, "virtual").truth()).isPresent();
            assertThat(view(run, "real").truth()).isEmpty();
        }
    }

    @Test
    void theSameSeedGivesTheSameRun() {
        RunResult once = Runs.result(plan(MIXED));
        assertThat(Runs.result(plan(MIXED)).eventHash()).isEqualTo(once.eventHash());
    }

    @Test
    void theTruthIsMeasuredWhereThereIsOneElseWhatRobotsBelieve() {
        try (var run = LiveRun.start(plan(MIXED))) {
            RunResult result = Runs.result(run);
            assertThat(result.metrics().get("error.virtual").orElseThrow()).isCloseTo(0.25, within(0.01));
            assertThat(result.metrics().get("error.real")).isEmpty();
            assertThat(result.metrics().get("way.virtual").orElseThrow()).isGreaterThan(1);
            assertThat(result.metrics().get("way.real")).isEmpty();
            Pose2d believed = view(run, "real").estimate().orElseThrow().value().mapFromBase();
            assertThat(result.metrics().get("caughtAt").orElseThrow())
                    .as("a second before")
                    .isCloseTo(believed.distanceTo(new Pose2d(-12, -1, 0)), within(0.4));
        }
    }

    @Test
    void standInsAreNothingThatPeopleSeeOrTheTruth() {
        String stands = MIXED.replace("name: real,", "name: real, proxy: true,")
                .replace("pose: [-4, -1, 0]", "pose: [-7, -1, 180]"); // in its way
        try (var run = LiveRun.start(plan(stands))) {
            RunResult result = Runs.result(run);
            assertThat(run.events(0))
                    .filteredOn(event -> event.kind().equals("collision"))
                    .extracting(event -> event.subject() + " " + event.text())
                    .contains("virtual ran into real");
            assertThat(run.snapshot().things()).isEmpty();
            assertThat(view(run, "real").truth()).isEmpty();
            RobotView.Real real = view(run, "real").real().orElseThrow();
            assertThat(real.proxy()).isTrue();
            assertThat(real.standIn()).isPresent();
            assertThat(real.silence().orElseThrow()).isLessThan(Duration.ofMillis(200));
            assertThat(view(run, "virtual").real()).isEmpty();
            assertThat(result.metrics().get("way.real")).isEmpty();
            assertThat(Runs.result(plan(stands)).eventHash()).isEqualTo(result.eventHash());
        }
    }

    @Test
    void realRobotsThatSomebodyWatchesAreMeasuredAndPlacedInTruthButStayReal() {
        String watched = MIXED.replace("host: lab", "host: watched");
        try (var run = LiveRun.start(plan(watched))) {
            RunResult result = Runs.result(run);
            assertThat(result.metrics().get("error.real").orElseThrow()).isCloseTo(0.25, within(0.01));
            assertThat(result.metrics().get("way.real").orElseThrow()).isGreaterThan(1);
            assertThat(view(run, "real").truth()).isPresent();
            assertThat(view(run, "real").real()).isPresent();
        }
        try (var run = LiveRun.start(plan(watched.replace("speed: max", "speed: 1")))) {
            Pose2d there = new Pose2d(-2, -1, 0);
            assertThat(answer(run.operator().place("real", there))).isEqualTo(new Answer.Done());
            run.when(now -> now.robots().stream()
                            .flatMap(view -> view.truth().stream())
                            .anyMatch(truth -> truth.distanceTo(there) < 0.5))
                    .toCompletableFuture()
                    .orTimeout(20, TimeUnit.SECONDS)
                    .join();
            assertThat(answer(run.operator().remove("real")))
                    .isEqualTo(
                            new Answer.Refused("Robot 'real' is real: it can't be taken out of the simulated world."));
        }
    }

    @Test
    void nobodyCountsCollisionsOfRealRobots() {
        String counting = MIXED.replace(
                "metrics:",
                "metrics:\n  - {name: touches, from: count(collisions)}\n"
                        + "  - {name: walls, from: count(wallCollisions)}");
        assertThat(Runs.result(plan(counting)).metrics().get("touches")).isPresent();
        String real = counting.replace("host: lab", "host: watched")
                .replace("mrs: {odometryNoise: 0}", "mrs: {use: reality, host: watched}");
        RunResult result = Runs.result(plan(real));
        assertThat(result.metrics().get("way.real").orElseThrow()).isGreaterThan(1);
        assertThat(result.metrics().get("touches")).isEmpty();
        assertThat(result.metrics().get("walls")).isEmpty();
    }

    @Test
    void realRobotsArePlacedInTheirOwnBeliefOnly() {
        try (var run = LiveRun.start(plan(MIXED.replace("speed: max", "speed: 1")))) {
            Pose2d there = new Pose2d(-2, -1, 0);
            assertThat(answer(run.operator().place("real", there))).isEqualTo(new Answer.Done());
            assertThat(answer(run.operator().remove("real")))
                    .isEqualTo(
                            new Answer.Refused("Robot 'real' is real: it can't be taken out of the simulated world."));
            assertThat(answer(run.operator().addRobot("real", there)))
                    .isEqualTo(new Answer.Refused("Robot 'real' is real: no other like it can be added."));
            assertThat(answer(run.operator().addRobot("virtual", there))).isEqualTo(new Answer.Added("hunter-1"));
        }
    }

    @Test
    void inRealTimeRobotsGoByTheirOwnClocks() {
        String real = MIXED.replace("use: reality", "use: clockwork")
                .replace("name: real,", "name: real, proxy: true,")
                .replace("clock: {speed: max}", "clock: {mode: wall}")
                .replace("time >= 5", "time >= 1");
        try (var run = LiveRun.start(plan(real))) {
            assertThat(Runs.result(run).outcome()).isEqualTo("success");
            assertThat(view(run, "real").real().orElseThrow().standIn()).isPresent();
            assertThat(view(run, "virtual").truth()).isPresent();
        }
    }

    private RunBroken broken(String text) {
        return catchThrowableOfType(RunBroken.class, () -> Runs.result(plan(text)));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            nowhere | Robot system 'reality' of real failed: Nobody is there.
            away    | Robot system 'reality' of real failed: Nobody answers.
            empty   | Robot system 'reality' of real has no robot 'real'; it has [].
            silent  | Robot system 'reality' of real failed: No answer within 10.0 s.
            """)
    void aSystemThatFailsIsNamedWithItsRobotsEvenIfTheRunWouldHaveEndedMeanwhile(String host, String words) {
        assertThat(broken(MIXED.replace("host: lab", "host: " + host))).hasMessage(words);
    }

    @Test
    void systemsAreLetGoOfInReverseOrderWhateverBecomesOfOthers() {
        String stuck = MIXED.replace("host: lab", "host: stuck")
                .replace("virtual, pose: [-4, -1, 0]", "virtual, pose: [-4, -1, 0], mrs: {use: reality, host: %s}");
        RunBroken atTheEnd = broken(stuck.formatted("stuck, port: 7000"));
        assertThat(atTheEnd).hasMessage("Robot system 'reality' of virtual failed: Nobody lets go.");
        assertThat(atTheEnd.getSuppressed())
                .extracting(Throwable::getMessage)
                .containsExactly("Robot system 'reality' of real failed: Nobody lets go.");
        RunBroken atTheStart = broken(stuck.formatted("nowhere"));
        assertThat(atTheStart).hasMessage("Robot system 'reality' of virtual failed: Nobody is there.");
        assertThat(atTheStart.getSuppressed())
                .extracting(Throwable::getMessage)
                .containsExactly("Robot system 'reality' of real failed: Nobody lets go.");
    }
}
