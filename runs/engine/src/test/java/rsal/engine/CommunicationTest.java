package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.entry;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.Timeout.ThreadMode;
import org.junit.jupiter.api.io.TempDir;
import rsal.data.Pose2d;
import rsal.engine.report.AgentInspection;
import rsal.engine.report.Answer;
import rsal.engine.report.Link;
import rsal.engine.report.Link.Way;
import rsal.engine.report.LossReason;
import rsal.engine.report.Reception;
import rsal.engine.report.RunResult;
import rsal.engine.report.TopicTraffic;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;

@Timeout(value = 120, threadMode = ThreadMode.SEPARATE_THREAD) // who spins is not interrupted
class CommunicationTest {
    /// Two robots on both sides of a wall that ends in the north; each says something ten times a second, and so does
    /// an agent without a robot.
    private static final String SCENARIO = """
            rsal: 1
            scenario: talkative
            world: {map: yard.yaml}
            robots:
              west: {model: pioneer2dx, pose: [4, 2, 90]}
              east: {model: pioneer2dx, pose: [8, 2, 90]}
            agents:
              amy: {type: chatter, robot: west}
              bob: {type: chatter, robot: east}
              base: {type: chatter}
            run:
              seed: 7
              clock: {speed: max}
              stop:
                - {when: time >= 30, outcome: timeout}
            metrics:
              - {name: said, from: count(sentMessages)}
              - {name: heard, from: count(receivedMessages)}
              - {name: lost, from: count(lostMessages)}
            """;

    private static final String YARD = """
            resolution: 1
            drawing: |
              #############
              #...........#
              #...........#
              #.....#.....#
              #.....#.....#
              #.....#.....#
              #.....#.....#
              #############
            """;

    @TempDir
    private Path folder;

    private RunPlan plan(String more) {
        return plan(more, RunOptions.NONE);
    }

    private RunPlan plan(String more, RunOptions options) {
        Runs.write(folder.resolve("yard.yaml"), YARD);
        return Runs.plan(folder, SCENARIO + more, options);
    }

    /// A run that stands still after ten seconds.
    private LiveRun stopped(String more) throws Exception {
        LiveRun run = LiveRun.start(plan(more, RunOptions.NONE.withSpeed(1))); // at full speed it might end first
        run.pause();
        step(run, 100);
        run.speed(Double.POSITIVE_INFINITY);
        return run;
    }

    /// Goes on by so many steps, and returns when they are done.
    private static void step(LiveRun run, int steps) throws Exception {
        Duration before = run.freshSnapshot()
                .toCompletableFuture()
                .get(10, TimeUnit.SECONDS)
                .time();
        for (int i = 0; i < steps; i++) {
            run.step();
        }
        Duration wanted = before.plusMillis(100L * steps);
        run.when(now -> now.time().compareTo(wanted) >= 0).toCompletableFuture().get(10, TimeUnit.SECONDS);
    }

    private static Reception find(List<Reception> all, String sender, String listener) {
        return all.stream()
                .filter(one -> one.sender().equals(sender) && one.listener().equals(listener))
                .findFirst()
                .orElseThrow();
    }

    private static double metric(RunResult result, String name) {
        return result.metrics().get(name).orElseThrow();
    }

    @Test
    void withoutLimitsAllIsHeardAndNothingIsRecorded() {
        RunResult result = Runs.result(plan(""));
        assertThat(result.communication()).isEmpty();
        assertThat(metric(result, "said")).isCloseTo(900, within(3.0));
        assertThat(metric(result, "heard")).isCloseTo(1800, within(6.0));
        assertThat(metric(result, "lost")).isZero();
    }

    @Test
    void recordingAloneChangesNothingThatIsHeard() {
        RunResult result = Runs.result(plan("communication: {}\n"));
        assertThat(result.communication())
                .hasSize(6)
                .allSatisfy(one -> assertThat(one.heard()).isBetween(298L, 300L))
                .allSatisfy(one -> assertThat(one.lost()).isZero())
                .allSatisfy(one -> assertThat(one.topic()).isEqualTo("text"));
        assertThat(metric(result, "heard")).isEqualTo(metric(Runs.result(plan("")), "heard"));
        assertThat(result.eventHash()).isNotEqualTo(Runs.result(plan("")).eventHash());
    }

    @Test
    void robotsBehindAWallHearEachOtherWhenTheyMeet() throws Exception {
        try (var run = stopped("communication: {range: 9, behindWalls: 3}\n")) {
            List<Reception> apart = recorded(run);
            assertThat(find(apart, "amy", "bob").heard()).isZero();
            assertThat(find(apart, "bob", "amy").heard()).isZero();
            assertThat(find(apart, "amy", "bob").lost()).isGreaterThan(80);
            assertThat(find(apart, "base", "bob").lost()).isZero();
            assertThat(find(apart, "amy", "base").lost()).isZero();
            run.operator().place("west", new Pose2d(4, 6, 0));
            run.operator()
                    .place("east", new Pose2d(8, 6, 0))
                    .toCompletableFuture()
                    .get(10, TimeUnit.SECONDS);
            long lost = find(recorded(run), "amy", "bob").lost();
            run.resume();
            List<Reception> together = Runs.result(run).communication();
            assertThat(find(together, "amy", "bob").heard()).isGreaterThan(150);
            assertThat(find(together, "bob", "amy").heard()).isGreaterThan(150);
            assertThat(find(together, "amy", "bob").lost()).isEqualTo(lost);
        }
    }

    /// Who has heard what.
    private static List<Reception> recorded(LiveRun run) throws Exception {
        Answer answer = run.inspector().communication().toCompletableFuture().get(10, TimeUnit.SECONDS);
        assertThat(answer).isInstanceOf(Answer.Heard.class);
        return ((Answer.Heard) answer).communication();
    }

    @Test
    void robotsThatHearEachOtherAreLinked() throws Exception {
        try (var run = stopped("communication: {range: 9, behindWalls: 3}\n")) {
            assertThat(links(run)).isEmpty();
            run.operator().place("west", new Pose2d(4, 6, 0));
            run.operator()
                    .place("east", new Pose2d(8, 6, 0))
                    .toCompletableFuture()
                    .get(10, TimeUnit.SECONDS);
            assertThat(links(run))
                    .containsExactly(new Link("west", "east", new Way(true, false), new Way(true, false)));
            step(run, 2);
            assertThat(links(run)).containsExactly(new Link("west", "east", new Way(true, true), new Way(true, true)));
        }
    }

    @Test
    void whomNobodyHearsHearsTheOthersAllTheSame() throws Exception {
        try (var run = stopped("""
                communication: {range: 100}
                faults: [{kind: lost, from: amy}]
                """)) {
            step(run, 2);
            assertThat(links(run))
                    .containsExactly(new Link("west", "east", new Way(false, false), new Way(true, true)));
        }
    }

    @Test
    void whoHasMoreToSayThanTheBandwidthAllowsIsNotHeard() throws Exception {
        try (var run = stopped("communication: {bandwidth: 0.1}\n")) {
            step(run, 2);
            assertThat(links(run))
                    .noneMatch(link -> link.there().open() || link.back().open());
        }
    }

    @Test
    void whereNothingIsLimitedOnlyWhatIsUsedIsALink() throws Exception {
        try (var run = stopped("")) {
            step(run, 2);
            assertThat(links(run))
                    .containsExactly(new Link("west", "east", new Way(false, true), new Way(false, true)));
        }
    }

    private static List<Link> links(LiveRun run) throws Exception {
        Answer answer = run.inspector().links("").toCompletableFuture().get(10, TimeUnit.SECONDS);
        assertThat(answer).isInstanceOf(Answer.Linked.class);
        return ((Answer.Linked) answer).links();
    }

    @Test
    void lookingForLinksChangesNothing() throws Exception {
        String limits = "communication: {range: 9, behindWalls: 4.5, loss: 0.3, delay: [0, 0.5], bandwidth: 9}\n";
        String unseen = Runs.result(plan(limits)).eventHash();
        try (var run = LiveRun.start(plan(limits, RunOptions.NONE.withSpeed(1)))) {
            run.pause();
            for (int i = 0; i < 100; i++) {
                run.step();
                links(run);
            }
            run.speed(Double.POSITIVE_INFINITY);
            run.resume();
            assertThat(Runs.result(run).eventHash()).isEqualTo(unseen);
        }
    }

    @Test
    void whatTheRadioLosesAndWhatFaultsLoseIsCountedOnce() {
        RunResult result = Runs.result(plan("""
                communication: {loss: 0.2}
                faults: [{kind: lost, share: 0.5}, {kind: doubled, share: 0.5, delay: 0.05}]
                """));
        assertThat(metric(result, "heard") + metric(result, "lost")).isCloseTo(1800, within(10.0));
        double share = 0.8 * 0.5;
        assertThat(metric(result, "heard")).isCloseTo(1800 * share, within(4 * Math.sqrt(1800 * share * (1 - share))));
        assertThat(result.communication().stream().mapToLong(Reception::heard).sum())
                .isEqualTo((long) metric(result, "heard"));
        assertThat(result.communication().stream().mapToLong(Reception::lost).sum())
                .isEqualTo((long) metric(result, "lost"));
    }

    @Test
    void whoSpeaksFasterThanTheBandwidthIsHeardAsOftenAsItAllows() {
        RunResult result = Runs.result(plan("communication: {bandwidth: 4}\n"));
        assertThat(result.communication())
                .hasSize(6)
                .allSatisfy(one -> assertThat(one.heard()).isBetween(115L, 121L));
    }

    @Test
    void eachTopicReportsWhyItsMessagesWereLost() throws Exception {
        try (var run = stopped("""
                communication: {range: 9, behindWalls: 3, loss: 0.2, bandwidth: 9}
                faults: [{kind: lost, share: 0.5}]
                """)) {
            TopicTraffic text = topics(run).getFirst();
            assertThat(text.topic()).isEqualTo("text");
            assertThat(text.said()).isGreaterThan(250);
            assertThat(text.lost().keySet()).containsExactly(LossReason.values());
            assertThat(text.lost().values())
                    .allSatisfy(count -> assertThat(count).isPositive());
            assertThat(text.lost().get(LossReason.RANGE)).isGreaterThan(100);
        }
    }

    private static List<TopicTraffic> topics(LiveRun run) throws Exception {
        Answer answer = run.inspector().topics().toCompletableFuture().get(10, TimeUnit.SECONDS);
        assertThat(answer).isInstanceOf(Answer.Counted.class);
        return ((Answer.Counted) answer).topics();
    }

    @Test
    void withoutLimitsTopicsAreCountedAllTheSame() throws Exception {
        try (var run = stopped("")) {
            assertThat(recorded(run)).isEmpty();
            TopicTraffic text = topics(run).getFirst();
            assertThat(text.heard()).isEqualTo(2 * text.said());
            assertThat(text.lost()).isEmpty();
        }
    }

    @Test
    void anAgentReportsWhatItHeardOfWhom() throws Exception {
        try (var run = stopped("communication: {range: 9, behindWalls: 3}\n")) {
            assertThat(recorded(run)).hasSize(6);
            Answer answer = run.inspector().inside("amy").toCompletableFuture().get(10, TimeUnit.SECONDS);
            assertThat(answer).isInstanceOf(Answer.Seen.class);
            AgentInspection amy = ((Answer.Seen) answer).agent();
            assertThat(amy.mind()).isEmpty();
            assertThat(amy.hearings())
                    .extracting(one -> one.sender() + " to " + one.listener() + (one.lost() > 0 ? ", lost" : ""))
                    .containsExactly("amy to bob, lost", "bob to amy, lost", "amy to base", "base to amy");
            assertThat(run.inspector().inside("zoe").toCompletableFuture().get(10, TimeUnit.SECONDS))
                    .isEqualTo(new Answer.Refused("There is no agent 'zoe'. Known are: amy, base, bob."));
        }
    }

    @Test
    void whatTheGoneShouldHearIsLostByTheFaultAndTheySayNothing() {
        RunResult result = Runs.result(plan("""
                communication: {range: 100}
                faults: [{kind: gone, robots: west, at: 0}]
                """));
        assertThat(result.communication())
                .extracting(one -> one.sender() + " to " + one.listener() + (one.heard() > 0 ? "" : ", lost"))
                .containsExactly("base to amy, lost", "base to bob", "bob to amy, lost", "bob to base");
        TopicTraffic text = result.topics().getFirst();
        assertThat(text.lost()).containsExactly(entry(LossReason.FAULT, text.said()));
        assertThat(text.heard()).isEqualTo(text.said());
        assertThat((long) metric(result, "lost")).isEqualTo(text.said());
    }

    @Test
    void itIsTheSameHoweverManyHelp() {
        RunPlan plan = plan("communication: {range: 5, behindWalls: 4.5, loss: 0.3, delay: [0, 0.5], bandwidth: 9}\n");
        RunResult once = result(plan, 1);
        RunResult again = result(plan, 3);
        assertThat(again.eventHash()).isEqualTo(once.eventHash());
        assertThat(again.communication()).isEqualTo(once.communication());
        RunResult other = Runs.result(plan("communication: {range: 5, loss: 0.2}\n"));
        assertThat(other.eventHash()).isNotEqualTo(once.eventHash());
    }

    private static RunResult result(RunPlan plan, int helpers) {
        try (var run = LiveRun.of(plan).helpers(helpers).start()) {
            return Runs.result(run);
        }
    }
}
