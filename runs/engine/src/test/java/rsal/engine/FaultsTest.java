package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.time.Duration;
import java.util.HashSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Pose2d;
import rsal.device.Health;
import rsal.engine.report.AgentView;
import rsal.engine.report.Answer;
import rsal.engine.report.DeviceView;
import rsal.engine.report.RobotView;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunResult;
import rsal.engine.report.Snapshot;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.testkit.Rounds;

@Timeout(120)
class FaultsTest {
    private static final String SCENARIO = """
            rsal: 1
            scenario: faulty
            world: {map: office}
            robots:
              prey:
                model: pioneer2dx
                pose: [-12.0, -1.0, 0]
                devices: {laser: urg04lx, localizer: {type: truthful}}
              hunter:
                count: 2
                model: pioneer3at
                pose: [[-8, -1, 180], [0, -1, 180]]
            agents:
              run: {type: wanderer, robot: prey}
              chat: {type: chatter, robot: hunter}
            mrs: {use: sim, odometryNoise: 0}
            run:
              seed: 7
              clock: {speed: max}
              stop:
                - {when: time >= 10, outcome: timeout}
            metrics:
              - {name: error, unit: m, from: p50(poseError(prey))}
              - {name: faults, from: count(faults)}
              - {name: lost, from: count(lostMessages)}
              - {name: gone, from: firstTime(gone(hunter) >= 1)}
              - {name: way, from: distance(prey)}
            """;

    @TempDir
    private Path folder;

    /// @param faults each as in a list, without the hyphen
    private RunPlan plan(String... faults) {
        return plan(RunOptions.NONE, faults);
    }

    private RunPlan plan(RunOptions options, String... faults) {
        String list = faults.length == 0 ? "" : "faults:\n  - " + String.join("\n  - ", faults) + "\n";
        return Runs.plan(folder, SCENARIO + list, options);
    }

    private record Ended(RunResult result, List<RunEvent> events, Snapshot last) {
        double metric(String name) {
            return result.metrics().get(name).orElseThrow();
        }

        List<String> faults() {
            return events.stream()
                    .filter(event -> event.kind().equals("fault"))
                    .map(event -> "%d ms %s %s".formatted(event.time().toMillis(), event.subject(), event.text()))
                    .toList();
        }

        RobotView robot(String id) {
            return last.robots().stream()
                    .filter(robot -> robot.id().equals(id))
                    .findFirst()
                    .orElseThrow();
        }

        /// From a time in the run [s] to its end.
        Duration since(double time) {
            return last.time().minusMillis(Math.round(1000 * time));
        }

        Duration lastSaid(String agent) {
            return last.agents().stream()
                    .filter(view -> view.view().agent().name().equals(agent))
                    .findFirst()
                    .flatMap(AgentView::lastSaid)
                    .orElseThrow();
        }

        /// What an agent shows.
        int shown(String agent, String belief) {
            return last.agents().stream()
                    .map(AgentView::view)
                    .filter(view -> view.agent().name().equals(agent))
                    .map(view -> Integer.parseInt(view.beliefs().getOrDefault(belief, "0")))
                    .findFirst()
                    .orElseThrow();
        }
    }

    private static Ended run(RunPlan plan) {
        return run(plan, 1);
    }

    private static Ended run(RunPlan plan, int helpers) {
        try (var run = LiveRun.of(plan).helpers(helpers).start()) {
            RunResult result = Runs.result(run);
            return new Ended(result, run.events(0), run.snapshot());
        }
    }

    @Test
    void beginAndEndAreEventsOfTheRun() {
        Ended run = run(plan("{kind: dead, robots: prey, devices: laser, at: 2, for: 3}"));
        assertThat(run.faults())
                .containsExactly("2000 ms prey/laser dead for 3.00 s", "5000 ms prey/laser no longer dead");
        assertThat(run.events)
                .filteredOn(event -> event.kind().equals("health"))
                .extracting(RunEvent::subject, RunEvent::text)
                .containsExactly(tuple("prey/laser", "is stale: No reading for 300 ms."), tuple("prey/laser", "works"));
        assertThat(run.metric("faults")).isEqualTo(1);
    }

    @Test
    void whatNeverStrikesChangesNothing() {
        String without = run(plan()).result.eventHash();
        assertThat(run(plan("{kind: gone, robots: any, at: 1000}", "{kind: lost, every: 100000, for: 1}"))
                        .result
                        .eventHash())
                .isEqualTo(without);
        assertThat(run(plan("{kind: frozen, robots: prey, devices: laser, at: 5}"))
                        .result
                        .eventHash())
                .isNotEqualTo(without);
    }

    @Test
    void faultsAtRandomAreTheSameHoweverManyHelp() {
        RunPlan plan = plan(
                "{kind: noisy, robots: all, devices: all, every: 2, for: [0.3, 3], range: 0.1}",
                "{kind: gone, robots: any, every: 3, for: 2}",
                "{kind: lost, share: 0.3}",
                "{kind: late, every: 2, for: 1, delay: [0.1, 2]}");
        Ended once = run(plan, 1);
        assertThat(once.faults()).hasSizeGreaterThan(10);
        assertThat(run(plan, 4).result.eventHash()).isEqualTo(once.result.eventHash());
        assertThat(run(plan, 4).events).isEqualTo(once.events);
    }

    @Test
    void watchingDoesNotChangeThem() {
        RunPlan plan = plan("{kind: gone, robots: any, every: 3, for: 2}", "{kind: lost, share: 0.3}");
        String unwatched = run(plan).result.eventHash();
        try (var run = LiveRun.start(plan)) {
            run.onSnapshot(run::snapshot);
            while (!run.result().toCompletableFuture().isDone()) {
                run.snapshot();
            }
            assertThat(Runs.result(run).eventHash()).isEqualTo(unwatched);
        }
    }

    @Test
    void aFaultDoesNotDependOnWhichOthersThereAre() {
        String random = "{kind: biased, robots: all, devices: sonar, every: 3, for: [0.3, 1], range: 0.1}";
        List<String> alone = run(plan(random)).faults();
        List<String> together = run(plan(
                        random, "{kind: noisy, robots: all, devices: base, every: 2, for: 1, range: 0.1}"))
                .faults();
        assertThat(alone).isNotEmpty();
        assertThat(together).filteredOn(words -> words.contains("biased")).isEqualTo(alone);
        List<String> behind = run(plan(
                        "{kind: noisy, robots: all, devices: base, every: 2, for: 1, range: 0.1}", random))
                .faults();
        assertThat(behind).filteredOn(words -> words.contains("biased")).isEqualTo(alone);
        List<String> twice = run(plan(random, random)).faults();
        assertThat(twice).containsAll(alone).hasSizeGreaterThan(alone.size());
        assertThat(new HashSet<>(twice)).hasSameSizeAs(twice); // the other has a stream of its own
    }

    @Test
    void faultsAtRandomComeAsOftenAsTheyShould() {
        var options = RunOptions.NONE.withSpeed(Double.POSITIVE_INFINITY);
        int seconds = Rounds.of(100, 400);
        String longer = SCENARIO.replace("time >= 10", "time >= " + seconds)
                + "faults: [{kind: frozen, robots: all, devices: base, every: 6, for: [1, 3]}]\n";
        Ended run = run(Runs.plan(folder, longer, options));
        assertThat(run.metric("faults")).isCloseTo(3 * seconds / 8.0, within(4 * Math.sqrt(3 * seconds / 8.0)));
        var lengths = run.faults().stream()
                .filter(words -> words.contains(" for "))
                .map(words -> Double.parseDouble(words.replaceAll(".* for (.*) s", "$1")))
                .toList();
        assertThat(lengths).allSatisfy(length -> assertThat(length).isBetween(1.0, 3.0));
        assertThat(new HashSet<>(lengths)).hasSizeGreaterThan(seconds / 8);
    }

    @Test
    void anyIsOneOfThemAndWhichDependsOnTheSeed() {
        var struck = new HashSet<String>();
        for (long seed = 1; seed <= 12; seed++) {
            Ended run = run(plan(
                    RunOptions.NONE.withSeed(seed).withLimit(Duration.ofSeconds(1)),
                    "{kind: motorDead, robots: any, at: 0.5}"));
            assertThat(run.faults()).hasSize(1);
            struck.add(run.faults().getFirst());
        }
        assertThat(struck)
                .containsExactlyInAnyOrder(
                        "500 ms prey/base without motors",
                        "500 ms hunter-1/base without motors",
                        "500 ms hunter-2/base without motors");
    }

    @Test
    void pickTakesAsMany() {
        Ended run = run(plan("{kind: slip, robots: [hunter, prey], pick: 2, at: 1}"));
        assertThat(run.faults()).hasSize(2);
        Ended all = run(plan("{kind: slip, robots: \"h*\", pick: 20, at: 1}"));
        assertThat(all.faults()).hasSize(2);
    }

    @Test
    void aRobotThatIsGoneIsNotShownAndItsAgentIsSilent() {
        Ended run = run(plan("{kind: gone, robots: hunter-1, at: 4}"));
        assertThat(run.result.outcome()).isEqualTo("timeout");
        assertThat(run.metric("gone")).isCloseTo(4, within(0.11));
        RobotView gone = run.robot("hunter-1");
        assertThat(gone.gone()).isTrue();
        assertThat(gone.goneFor().orElseThrow()).isBetween(run.since(4.2), run.since(3.8));
        assertThat(run.robot("hunter-2").goneFor()).isEmpty();
        assertThat(run.lastSaid("chat-1")).isLessThan(Duration.ofMillis(4100));
        assertThat(run.lastSaid("chat-2")).isGreaterThan(run.last.time().minusMillis(600));
        assertThat(gone.truth()).isEmpty();
        assertThat(gone.ranges()).isEmpty();
        assertThat(gone.devices()).extracting(DeviceView::health).hasOnlyElementsOfType(Health.Lost.class);
        assertThat(run.robot("hunter-2").truth()).isPresent();
        assertThat(run.events)
                .filteredOn(event -> event.subject().equals("chat-1")
                        && event.kind().equals("message")
                        && event.time().compareTo(Duration.ofSeconds(4)) > 0)
                .isEmpty();
        assertThat(run.shown("chat-2", "heard")).isBetween(38, 40);
        assertThat(run.shown("chat-1", "heard")).isBetween(38, 40);
        assertThat(run.metric("lost")).isCloseTo(60, within(2.0)); // what the other says from then on
    }

    @Test
    void oneThatStaysIsShownWithoutWhatItSensed() {
        RobotView gone =
                run(plan("{kind: gone, robots: prey, at: 4, stays: true}")).robot("prey");
        assertThat(gone.gone()).isTrue();
        assertThat(gone.inCharge()).isEmpty();
        assertThat(gone.truth()).isPresent();
        assertThat(gone.odometry()).isEmpty();
        assertThat(gone.scan()).isEmpty();
        assertThat(gone.estimate()).isEmpty();
    }

    @Test
    void anOperatorCanNotReachIt() {
        var plan = plan(RunOptions.NONE.withSpeed(1), "{kind: gone, robots: hunter-1}");
        try (var run = LiveRun.start(plan)) {
            var gone = new Answer.Refused("Robot 'hunter-1' is gone.");
            var there = new Pose2d(-8, -1, 0);
            assertThat(run.operator()
                            .place("hunter-1", there)
                            .toCompletableFuture()
                            .join())
                    .isEqualTo(gone);
            assertThat(run.operator()
                            .goTo("hunter-1", there)
                            .toCompletableFuture()
                            .join())
                    .isEqualTo(gone);
        }
    }

    @Test
    void nobodyPlacesOneThatStaysWhereItIsGone() {
        var plan = plan(RunOptions.NONE.withSpeed(1), "{kind: gone, robots: hunter-1, stays: true}");
        try (var run = LiveRun.start(plan)) {
            assertThat(run.operator()
                            .place("hunter-1", new Pose2d(-6, -1, 0))
                            .toCompletableFuture()
                            .join())
                    .isEqualTo(new Answer.Refused("Robot 'hunter-1' is gone."));
        }
    }

    @Test
    void oneWithoutRoomIsGoneUntilItHasSome() {
        var plan = plan(RunOptions.NONE.withSpeed(1), "{kind: gone, robots: hunter-1, for: 5}");
        try (var run = LiveRun.start(plan)) {
            assertThat(run.operator()
                            .place("hunter-2", new Pose2d(-8, -1, 0))
                            .toCompletableFuture()
                            .join())
                    .isEqualTo(new Answer.Done());
            run.speed(Double.POSITIVE_INFINITY);
            Runs.result(run);
            assertThat(run.events(0))
                    .extracting(RunEvent::text)
                    .contains("gone for 5.00 s")
                    .doesNotContain("no longer gone");
            assertThat(run.snapshot().robots())
                    .filteredOn(robot -> robot.id().equals("hunter-1"))
                    .singleElement()
                    .satisfies(robot -> assertThat(robot.truth()).isEmpty());
        }
    }

    @Test
    void nothingStrikesTheLocalizerOfARobotThatWasRemoved() {
        var plan = plan(RunOptions.NONE.withSpeed(1), "{kind: dead, robots: prey, devices: localizer, at: 5}");
        try (var run = LiveRun.start(plan)) {
            assertThat(run.operator().remove("prey").toCompletableFuture().join())
                    .isEqualTo(new Answer.Done());
            run.speed(Double.POSITIVE_INFINITY);
            Runs.result(run);
            assertThat(run.events(0))
                    .filteredOn(event -> event.kind().equals("fault"))
                    .extracting(RunEvent::text)
                    .containsExactly("not dead: There is no robot 'prey'.");
        }
    }

    @Test
    void anAgentThatWasAddedByHandIsSilentWhileItsRobotIsGone() {
        var plan = plan(RunOptions.NONE.withSpeed(1), "{kind: gone, robots: hunter-1, at: 8}");
        try (var run = LiveRun.start(plan)) {
            assertThat(run.operator()
                            .addAgent("chat-1", "hunter-1")
                            .toCompletableFuture()
                            .join())
                    .isEqualTo(new Answer.Added("chat-3"));
            run.speed(Double.POSITIVE_INFINITY);
            Runs.result(run);
            assertThat(run.events(0))
                    .filteredOn(event -> event.kind().equals("message"))
                    .filteredOn(event -> event.subject().equals("chat-3"))
                    .extracting(RunEvent::time)
                    .isNotEmpty()
                    .allMatch(time -> time.compareTo(Duration.ofSeconds(8)) <= 0);
        }
    }

    @Test
    void oneThatComesBackGoesOn() {
        Ended run = run(plan("{kind: gone, robots: hunter-1, at: 4, for: 3}"));
        assertThat(run.faults()).containsExactly("4000 ms hunter-1 gone for 3.00 s", "7000 ms hunter-1 no longer gone");
        assertThat(run.robot("hunter-1").truth()).isPresent();
        assertThat(run.robot("hunter-1").devices())
                .extracting(DeviceView::health)
                .containsOnly(Health.ok());
        assertThat(run.shown("chat-2", "heard")).isBetween(68, 71);
    }

    @Test
    void aRunEndsWhenTooManyAreGone() {
        String text = SCENARIO.replace(
                        "    - {when: time >= 10, outcome: timeout}",
                        "    - {when: gone(hunter) == 2, outcome: failure}\n    - {when: time >= 10, outcome: timeout}")
                + "faults: [{kind: gone, robots: hunter-1, at: 2}, {kind: gone, robots: hunter-2, at: 3}]\n";
        RunResult result = run(Runs.plan(folder, text, RunOptions.NONE)).result;
        assertThat(result.outcome()).isEqualTo("failure");
        assertThat(result.simulatedSeconds()).isCloseTo(3, within(0.11));
    }

    @Test
    void aBiasedLocalizerIsWrongByThatMuch() {
        assertThat(run(plan()).metric("error")).isCloseTo(0, within(1e-6));
        Ended run = run(plan("{kind: biased, robots: prey, devices: localizer, range: 0.4, angle: 5}"));
        assertThat(run.metric("error")).isCloseTo(0.4, within(1e-3));
        assertThat(run.faults()).containsExactly("0 ms prey/localizer biased by 0.40 m and 5.0°");
    }

    @Test
    void aDeadLocalizerTurnsStale() {
        Ended run = run(plan("{kind: dead, robots: all, devices: Localizer, at: 5}"));
        assertThat(run.robot("prey").devices())
                .filteredOn(device -> device.name().equals("localizer"))
                .extracting(DeviceView::health)
                .containsExactly(new Health.Stale("No estimate for 1 s."));
    }

    @Test
    void withoutMotorsItStands() {
        double way = run(plan()).metric("way");
        assertThat(run(plan("{kind: motorDead, robots: prey}")).metric("way")).isZero();
        assertThat(run(plan("{kind: motorDead, robots: prey, power: 0.5}")).metric("way"))
                .isCloseTo(way / 2, within(0.1 * way));
    }

    @Test
    void slippingDeceivesTheLocalizerNotTheWorld() {
        Ended well = run(plan());
        Ended slipping = run(plan("{kind: slip, robots: prey, way: 0.5}"));
        assertThat(slipping.metric("way")).isEqualTo(well.metric("way"));
        assertThat(slipping.metric("error")).isGreaterThan(0.1);
    }

    @Test
    void messagesAreLostWithTheirShare() {
        String text = SCENARIO.replace("time >= 10", "time >= 300")
                + "faults: [{kind: lost, topics: text, to: hunter-2, share: 0.25}]\n";
        Ended run = run(Runs.plan(folder, text, RunOptions.NONE));
        assertThat(run.metric("lost")).isCloseTo(750, within(4 * Math.sqrt(3000 * 0.25 * 0.75)));
        assertThat(run.shown("chat-2", "heard") + run.metric("lost"))
                .isCloseTo(run.shown("chat-1", "heard"), within(1.0));
    }

    @ParameterizedTest
    @ValueSource(strings = {"chat-1", "hunter-1", "*-1"})
    void messagesComeLateFromThoseNamed(String name) {
        Ended run = run(plan("{kind: late, from: \"%s\", delay: 2.05}".formatted(name)));
        assertThat(run.shown("chat-2", "heard")).isBetween(77, 81);
        assertThat(run.shown("chat-2", "late")).isEqualTo(run.shown("chat-2", "heard"));
        assertThat(run.shown("chat-1", "late")).isZero();
    }

    @Test
    void whatIsStillOnItsWayToARobotThatIsGoneIsLost() {
        Ended run = run(plan("{kind: late, delay: 2.05}", "{kind: gone, robots: hunter-1, at: 4}"));
        assertThat(run.shown("chat-1", "heard")).isBetween(17, 20);
        assertThat(run.shown("chat-2", "heard")).isBetween(37, 40);
        assertThat(run.metric("lost")).isCloseTo(80, within(2.0)); // said between 2 s and 10 s
    }

    @Test
    void whatComesAgainIsLostWhenNoneOfItIsHeard() {
        String late = "{kind: late, delay: 2.05}";
        String gone = "{kind: gone, robots: hunter-1, at: 4}";
        assertThat(run(plan("{kind: doubled, delay: 0.5}", late, gone)).metric("lost"))
                .isCloseTo(80, within(2.0)); // said between 2 s and 10 s
        assertThat(run(plan("{kind: doubled, delay: 3}", "{kind: late, delay: 1.05}", gone.replace("}", ", for: 1}")))
                        .metric("lost"))
                .isCloseTo(10, within(1.0)); // said between 4 s and 5 s: all others come before it goes or after
    }

    @Test
    void messagesComeTwice() {
        Ended run = run(plan("{kind: doubled, topics: [text, pose], at: 5.05, delay: 0.05}"));
        assertThat(run.shown("chat-1", "again")).isBetween(47, 50);
        assertThat(run.shown("chat-1", "late")).isEqualTo(run.shown("chat-1", "again"));
        assertThat(run.faults()).containsExactly("5050 ms messages doubled, 0.05 s later (about text, pose)");
    }
}
