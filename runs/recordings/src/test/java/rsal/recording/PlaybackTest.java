package rsal.recording;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.agent.bdi.Mind;
import rsal.behavior.Decision;
import rsal.data.Blobs;
import rsal.data.GripperState;
import rsal.data.LaserScan;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.RangeArray;
import rsal.data.Stamped;
import rsal.device.Planner;
import rsal.engine.LiveRun;
import rsal.engine.report.Answer;
import rsal.engine.report.NavigatorState;
import rsal.engine.report.Reading;
import rsal.engine.report.RobotView;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunObserver;
import rsal.engine.report.RunResult;
import rsal.engine.report.SentMessage;
import rsal.engine.report.Snapshot;
import rsal.recording.Playback.Reported;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;
import rsal.testkit.LongTest;
import rsal.testkit.Rounds;

class PlaybackTest {
    private static final String HUNT = "hunt-and-prey";

    @TempDir
    Path folder;

    @Test
    void whatWasSeenOfARunIsSeenAgain() throws Exception {
        for (String scenario : List.of(HUNT, "find-and-collect")) {
            Path file = folder.resolve(scenario + ".mcap");
            RunPlan plan = Recorded.plan(scenario, 7, Rounds.of(4, 20));
            Seen seen = record(plan, file);
            try (Playback playback = open(file)) {
                assertThat(playback.until()).isEqualTo(seen.snapshots.getLast().time());
                assertThat(playback.events()).usingRecursiveComparison().isEqualTo(seen.events);
                assertThat(playback.events())
                        .filteredOn(event -> event.kind().equals("message"))
                        .isNotEmpty()
                        .allMatch(event -> event.said().isPresent());
                assertThat(playback.result()).hasValueSatisfying(result -> {
                    assertThat(result.eventHash()).isEqualTo(seen.result.eventHash());
                    assertThat(result.metrics()).isEqualTo(seen.result.metrics());
                    assertThat(result.outOfBounds()).isEqualTo(seen.result.outOfBounds());
                });
                assertThat(seen.snapshots)
                        .anySatisfy(then -> assertThat(then.links().links())
                                .as("they speak with each other")
                                .anyMatch(link -> link.there().used()));
                for (Snapshot then : seen.snapshots) {
                    Snapshot now = playback.at(then.time());
                    assertThat(now.time()).isEqualTo(then.time());
                    assertThat(now.outcome()).isEqualTo(then.outcome());
                    assertThat(now.things()).isEqualTo(then.things());
                    assertThat(now.links()).isEqualTo(then.links());
                    assertThat(now.team()).hasSameSizeAs(then.team());
                    assertThat(now.agents())
                            .usingRecursiveComparison()
                            .ignoringFields("view.agent.robotRole")
                            .isEqualTo(then.agents());
                    assertThat(now.robots())
                            .usingRecursiveComparison()
                            .withComparatorForType(
                                    (a, b) -> Math.abs(a - b) < 1e-9 ? 0 : Double.compare(a, b), Double.class)
                            .ignoringFieldsMatchingRegexes(
                                    "odometry\\.value\\.(time|frame)",
                                    "gripper.*",
                                    "(estimate|readings)\\.value\\.value\\.(hypotheses\\.)?covariance\\.(xTheta|yTheta)",
                                    "(estimate|readings)\\.value\\.value\\.hypotheses\\.weight",
                                    "(scan|ranges)\\.value\\.frame",
                                    "path\\.points.*")
                            .isEqualTo(then.robots());
                }
                assertThat(seen.snapshots)
                        .flatExtracting(Snapshot::robots)
                        .anySatisfy(
                                robot -> assertThat(robot.localPath().points()).hasSizeBetween(2, 16));
            }
        }
    }

    @Test
    void whoHeardWhomIsReportedAgain() throws Exception {
        Path scenario = folder.resolve("radio.yaml");
        Files.writeString(scenario, """
                rsal: 1
                scenario: radio
                title: Robots that hear each other, but for one that nobody hears
                world: { map: four-rooms }
                robots:
                  scout:
                    count: 3
                    model: pioneer2dx
                    pose: { free: true, clearance: 0.6 }
                    devices: { laser: urg04lx, localizer: { type: amcl }, planner: { type: wavefront }, navigator: {} }
                agents:
                  nav: { type: nav, robot: scout }
                communication: { range: 30 }
                faults: [{ kind: lost, from: [nav-1] }]
                """);
        Path file = folder.resolve("radio.mcap");
        Seen seen = record(Recorded.plan(scenario.toString(), 7, 5), file);
        Answer.Linked last = seen.snapshots.getLast().links();
        assertThat(last.links())
                .filteredOn(link -> link.one().equals("scout-1"))
                .hasSize(2)
                .allMatch(link -> !link.there().open() && link.back().open());
        try (Playback playback = open(file)) {
            assertThat(playback.at(playback.until()).links()).isEqualTo(last);
        }
    }

    @Test
    void whatDevicesReportedIsReportedAgain() throws Exception {
        Path file = folder.resolve("run.mcap");
        Seen seen = record(Recorded.plan("find-and-collect", 7, 40), file);
        var kinds = new HashSet<Class<?>>();
        try (Playback playback = open(file)) {
            for (Snapshot then : seen.snapshots) {
                Snapshot now = playback.at(then.time());
                for (int i = 0; i < then.robots().size(); i++) {
                    List<Reading> reported = then.robots().get(i).readings();
                    List<Reading> read = now.robots().get(i).readings();
                    assertThat(read)
                            .extracting(Reading::device)
                            .isEqualTo(reported.stream().map(Reading::device).toList());
                    assertThat(ofOwnTopics(read)).isEqualTo(ofOwnTopics(reported));
                    reported.forEach(
                            reading -> kinds.add(reading.value().value().getClass()));
                }
            }
        }
        assertThat(kinds)
                .contains(
                        Blobs.class,
                        Decision.class,
                        GripperState.class,
                        NavigatorState.class,
                        Planner.Asked.class,
                        LaserScan.class);
    }

    /// Of each of the kinds of which one is drawn, with topics of their own.
    private static List<Reading> ofOwnTopics(List<Reading> readings) {
        return readings.stream()
                .filter(reading -> switch (reading.value().value()) {
                    case LaserScan _, RangeArray _, Odometry _, PoseEstimate _ -> false;
                    default -> ReadingType.of(reading.value().value()).isPresent();
                })
                .toList();
    }

    @Test
    void whatSecondDevicesAndThoseOfUnknownKindsReportedIsReportedAgain() throws Exception {
        Path file = folder.resolve("run.mcap");
        Recorded.runWithMore(Recorded.plan(HUNT, 7, 3), file);
        try (Playback playback = open(file)) {
            for (int tenth = 5; tenth < 30; tenth++) {
                var time = Duration.ofMillis(100L * tenth);
                RobotView robot = playback.at(time).robots().getFirst();
                Map<String, Object> reported = robot.readings().stream()
                        .filter(reading -> reading.age().isZero())
                        .collect(Collectors.toMap(
                                Reading::device, reading -> reading.value().value()));
                List<Object> values = MoreDevices.values(tenth / 10.0);
                for (int i = 0; i < 5; i++) {
                    assertThat(reported.get(MoreDevices.NAMES.get(i)))
                            .usingRecursiveComparison()
                            .isEqualTo(values.get(i));
                }
                assertThat(reported.get("weather"))
                        .as("only the numbers")
                        .isEqualTo(new Quantities(List.of(
                                new RecordedQuantity("wind.speed", "wind speed", "", tenth / 10.0),
                                new RecordedQuantity("wind.angle", "wind angle", "rad", 1.5),
                                new RecordedQuantity("pressure", "pressure", "", Double.NaN))));
                assertThat(reported).doesNotContainKey("speech");
                assertThat(robot.maps()).extracting(RobotView.Drawn::device).containsExactly("chart");
                assertThat(robot.scan()).map(Stamped::value).isNotEqualTo(Optional.of(reported.get("rear")));
            }
        }
    }

    /// Names of robots are parts of topics.
    @Test
    void robotsMayBeCalledAsTopicsAre() throws Exception {
        var names = List.of("devices", "agents", "minds", "robots", "things", "agent", "messages");
        String robots = names.stream()
                .map(name -> "%s: {model: pioneer2dx, pose: [0, %d, 0], devices: {laser: urg04lx, pilot: {}}}"
                        .formatted(name, names.indexOf(name) - 3))
                .collect(Collectors.joining(", "));
        Path scenario = Files.writeString(folder.resolve("own.yaml"), """
                rsal: 1
                scenario: own
                world: {map: office}
                robots: {%s}
                agents: {scan: {type: wander, robot: agent}}
                run: {stop: [{when: time > 2, outcome: success}]}
                """.formatted(robots));
        Path file = folder.resolve("run.mcap");
        Seen seen = record(Recorded.plan(scenario.toString(), 1, 20), file);
        Snapshot then = seen.snapshots.getLast();
        try (Playback playback = open(file)) {
            Snapshot now = playback.at(then.time());
            assertThat(now.agents()).hasSameSizeAs(then.agents());
            assertThat(now.things()).isEqualTo(then.things());
            assertThat(now.robots()).extracting(RobotView::id).isEqualTo(names);
            for (int i = 0; i < names.size(); i++) {
                RobotView robot = now.robots().get(i);
                assertThat(robot.devices()).isEqualTo(then.robots().get(i).devices());
                assertThat(robot.readings()).extracting(Reading::device).contains("base", "laser");
                assertThat(robot.scan().orElseThrow().value().ranges())
                        .isEqualTo(then.robots()
                                .get(i)
                                .scan()
                                .orElseThrow()
                                .value()
                                .ranges());
            }
        }
    }

    /// From wherever one begins, and whatever else is looked at.
    @Test
    void whatDevicesReportedInATimeIsWhatTheyReportedAtEachMoment() throws Exception {
        Path file = folder.resolve("run.mcap");
        record(Recorded.plan("find-and-collect", 7, 12), file);
        var from = Duration.ofMillis(7_300);
        var until = Duration.ofMillis(9_650);
        String robot = "collector-1";
        try (Playback playback = open(file)) {
            playback.at(Duration.ofSeconds(11));
            List<Reported> reported = playback.reported(robot, from, until, Duration.ZERO);
            assertThat(reported).extracting(Reported::time).hasSize(23).isSorted();
            assertThat(reported.getFirst().time()).isEqualTo(Duration.ofMillis(7_400));
            assertThat(reported.getLast().time()).isEqualTo(Duration.ofMillis(9_600));
            for (Reported one : reported) {
                assertThat(one.readings())
                        .hasSizeGreaterThan(5)
                        .usingRecursiveComparison()
                        .isEqualTo(playback.at(one.time()).robots().stream()
                                .filter(view -> view.id().equals(robot))
                                .findFirst()
                                .orElseThrow()
                                .readings());
            }
            assertThat(playback.reported(robot, from, until, Duration.ofSeconds(1)))
                    .extracting(Reported::time)
                    .containsExactly(Duration.ofMillis(7_400), Duration.ofMillis(8_400), Duration.ofMillis(9_400));
            assertThat(playback.reported(robot, until, from, Duration.ZERO)).isEmpty();
            assertThat(playback.reported("nobody", from, until, Duration.ZERO))
                    .hasSize(23)
                    .allMatch(one -> one.readings().isEmpty());
            assertThat(playback.reported(robot, Duration.ofSeconds(-9), Duration.ofDays(1), Duration.ZERO))
                    .hasSize(120);
        }
    }

    /// One that a fault took away says nothing, here as there.
    @Test
    void whatDevicesOfARobotThatIsGoneReportedIsNotSentOn() throws Exception {
        Path scenario = Files.writeString(folder.resolve("own.yaml"), """
                rsal: 1
                scenario: own
                world: {map: office}
                robots: {guard: {model: pioneer2dx, pose: [0, -1, 0], devices: {laser: urg04lx, pilot: {}}}}
                agents: {walk: {type: wander, robot: guard}}
                faults: [{kind: gone, robots: guard, at: 3, for: 2}]
                run: {stop: [{when: time > 8, outcome: success}]}
                """);
        Path file = folder.resolve("run.mcap");
        record(Recorded.plan(scenario.toString(), 1, 20), file);
        try (Playback playback = open(file)) {
            assertThat(reported(playback, 2)).contains("base", "laser", "pilot");
            assertThat(reported(playback, 4)).isEmpty();
            assertThat(reported(playback, 7)).contains("base", "laser", "pilot");
        }
    }

    private static List<String> reported(Playback playback, int second) throws IOException {
        return playback.at(Duration.ofSeconds(second)).robots().getFirst().readings().stream()
                .map(Reading::device)
                .toList();
    }

    @Test
    void aRobotOfAModelThatNobodyPlannedIsSeenAgain() throws Exception {
        Path file = folder.resolve("run.mcap");
        RunPlan plan = Scenario.load(HUNT)
                .plan(RunOptions.NONE.withSeed(7).withSpeed(50).withLimit(Duration.ofSeconds(30)));
        try (Recorder recorder = Recorded.begin(plan, file);
                LiveRun run = LiveRun.of(plan).observer(recorder.observer()).start()) {
            run.when(now -> !now.robots().isEmpty()).toCompletableFuture().get(30, TimeUnit.SECONDS);
            var added =
                    run.operator().newRobot("pioneer2dx", new Pose2d(-8, -1, 0)).toCompletableFuture();
            assertThat(added.get(30, TimeUnit.SECONDS)).isEqualTo(new Answer.Added("pioneer2dx-1"));
            recorder.ended(run.result().toCompletableFuture().get(60, TimeUnit.SECONDS));
        }
        try (Playback playback = open(file)) {
            Snapshot end = playback.at(playback.until());
            assertThat(end.team().getLast().spec().model().title()).isEqualTo("Pioneer 2-DX");
            assertThat(end.robots().getLast().id()).isEqualTo("pioneer2dx-1");
        }
    }

    /// From wherever one comes.
    @Test
    void seekingIsThePlayingUpToThere() throws Exception {
        Path file = folder.resolve("run.mcap");
        record(Recorded.plan(HUNT, 3, 30), file);
        try (Playback played = open(file);
                Playback sought = open(file)) {
            var random = new Random(5);
            List<Duration> times = random.ints(Rounds.of(10, 40), -1000, 32_000)
                    .mapToObj(Duration::ofMillis)
                    .toList();
            var expected = new ArrayList<Snapshot>();
            for (Duration time : times.stream().sorted().toList()) {
                expected.add(played.at(time));
            }
            for (Duration time : times) {
                Snapshot there = sought.at(time);
                Snapshot other = expected.stream()
                        .filter(one -> one.time().equals(there.time()))
                        .findFirst()
                        .orElseThrow();
                assertThat(there).usingRecursiveComparison().isEqualTo(other);
                assertThat(there.time()).isEqualTo(other.time());
            }
            assertThat(sought.states(Duration.ofSeconds(10), 1)).isEqualTo(Duration.ofMillis(10_100));
            assertThat(sought.states(Duration.ofSeconds(10), -1)).isEqualTo(Duration.ofMillis(9_900));
            assertThat(sought.states(Duration.ofSeconds(90), 1)).isEqualTo(Duration.ofSeconds(30));
        }
    }

    @Test
    void whatWasCutOffIsSeenUpToThere() throws Exception {
        Path file = folder.resolve("run.mcap");
        record(Recorded.plan(HUNT, 3, 20), file);
        byte[] bytes = Files.readAllBytes(file);
        Duration before = Duration.ZERO;
        for (int share = 3; share <= 9; share += 2) {
            Files.write(file, Arrays.copyOf(bytes, bytes.length * share / 10));
            try (Playback playback = open(file)) {
                assertThat(playback.damage()).isNotEmpty();
                assertThat(playback.result()).isEmpty();
                assertThat(playback.until()).isGreaterThanOrEqualTo(before).isLessThan(Duration.ofSeconds(20));
                assertThat(playback.at(Duration.ofDays(1)).time()).isEqualTo(playback.until());
                before = playback.until();
            }
        }
        assertThat(before).isPositive();
    }

    /// Bytes that are not as they were: the file is refused in words, or shown as far as it goes.
    @LongTest
    @Test
    void damageIsReportedOrLeftOut() throws Exception {
        Path file = folder.resolve("run.mcap");
        record(Recorded.plan(HUNT, 3, 5), file);
        byte[] bytes = Files.readAllBytes(file);
        var random = new Random(11);
        int opened = 0;
        int rounds = Rounds.of(15, 60);
        for (int i = 0; i < rounds; i++) {
            byte[] damaged = bytes.clone();
            for (int j = random.nextInt(1, 20); j > 0; j--) {
                damaged[random.nextInt(damaged.length)] = (byte) random.nextInt();
            }
            Files.write(file, damaged);
            try (Playback playback = open(file)) {
                for (int second = -1; second < 7; second++) {
                    assertThat(playback.at(Duration.ofSeconds(second)).time())
                            .isBetween(Duration.ZERO, playback.until());
                }
                opened++;
            } catch (IOException | rsal.settings.InvalidSettings e) {
                assertThat(e.getMessage()).isNotBlank();
            }
        }
        assertThat(opened).isBetween(rounds / 6, rounds);
    }

    private static Playback open(Path file) throws IOException {
        return Playback.of(Recording.open(file.toString(), false));
    }

    private static Seen record(RunPlan plan, Path file) throws Exception {
        try (Recorder recorder = Recorded.begin(plan, file)) {
            var seen = new Seen(recorder.observer());
            seen.result = LiveRun.of(plan)
                    .observer(seen)
                    .start()
                    .result()
                    .toCompletableFuture()
                    .get(100, TimeUnit.SECONDS);
            recorder.ended(seen.result);
            return seen;
        }
    }

    /// Keeps what it passes on.
    private static final class Seen implements RunObserver {
        private final RunObserver next;
        private final List<Snapshot> snapshots = new ArrayList<>();
        private final List<RunEvent> events = new ArrayList<>();
        private RunResult result;

        Seen(RunObserver next) {
            this.next = next;
        }

        @Override
        public Duration period() {
            return next.period();
        }

        @Override
        public void sees(Snapshot now, String hash) {
            snapshots.add(now);
            next.sees(now, hash);
        }

        @Override
        public void looksInto(Duration time, Map<String, Mind.View> minds) {
            next.looksInto(time, minds);
        }

        @Override
        public void happened(RunEvent event, String hash) {
            events.add(event);
            next.happened(event, hash);
        }

        @Override
        public void heard(SentMessage message, Object content) {
            next.heard(message, content);
        }
    }
}
