package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.Timeout.ThreadMode;
import org.junit.jupiter.api.io.TempDir;
import rsal.agent.AgentType;
import rsal.agent.platform.AgentPlatform;
import rsal.engine.agent.Agents;
import rsal.engine.report.AgentInspection;
import rsal.engine.report.Answer;
import rsal.engine.report.ReceivedMessage;
import rsal.scenario.RunOptions;

/// People start and stop agents, and say something to them.
@Timeout(value = 120, threadMode = ThreadMode.SEPARATE_THREAD) // who spins is not interrupted
class AgentsByHandTest {
    private static final String SCENARIO = """
            rsal: 1
            scenario: talkative
            world: {map: yard.yaml}
            robots:
              west: {model: pioneer2dx, pose: [4, 2, 90]}
              east: {model: pioneer2dx, pose: [8, 2, 90]}
            agents:
              amy: {type: chatter, robot: west}
              base: {type: chatter}
            run:
              seed: 7
              clock: {speed: 1}
              stop:
                - {when: time >= 30, outcome: timeout}
            """;

    private static final String YARD = """
            resolution: 1
            drawing: |
              #############
              #...........#
              #...........#
              #...........#
              #...........#
              #############
            """;

    @TempDir
    private Path folder;

    private LiveRun run;

    @BeforeEach
    void start() {
        Runs.write(folder.resolve("yard.yaml"), YARD);
        run = LiveRun.start(Runs.plan(folder, SCENARIO, RunOptions.NONE));
        run.pause();
        step(); // its robots and agents come with it
    }

    @AfterEach
    void end() {
        run.close();
    }

    private static Answer answer(CompletionStage<Answer> asked) throws Exception {
        return asked.toCompletableFuture().get(10, TimeUnit.SECONDS);
    }

    private AgentInspection inside(String agent) throws Exception {
        return ((Answer.Seen) answer(run.inspector().inside(agent))).agent();
    }

    private AgentPlatform.Status status(String agent) throws Exception {
        return inside(agent).shown().orElseThrow().status();
    }

    /// Goes on for a step, at least.
    private void step() {
        Duration before = run.freshSnapshot().toCompletableFuture().join().time();
        run.step();
        run.when(now -> now.time().compareTo(before) > 0).toCompletableFuture().join();
    }

    private List<String> byHand() {
        return run.events(0).stream()
                .filter(event -> event.kind().equals("operator"))
                .map(event -> event.subject() + " " + event.text())
                .toList();
    }

    @Test
    void anotherAgentLikeOneIsNamedAfterItsRole() throws Exception {
        assertThat(answer(run.operator().addAgent("amy", "east"))).isEqualTo(new Answer.Added("amy-1"));
        assertThat(answer(run.operator().addAgent("amy", "west"))).isEqualTo(new Answer.Added("amy-2"));
        assertThat(answer(run.operator().addAgent("base", ""))).isEqualTo(new Answer.Added("base-1"));
        assertThat(inside("amy-1").planned().orElseThrow().robot()).contains("east");
        assertThat(status("amy-1")).isEqualTo(AgentPlatform.Status.RUNNING);
        assertThat(byHand())
                .containsExactly(
                        "amy-1 started, like amy, for east",
                        "amy-2 started, like amy, for west",
                        "base-1 started, like base");
    }

    @Test
    void whoCantBeMadeIsRefused() throws Exception {
        assertThat(answer(run.operator().addAgent("zoe", "")))
                .isEqualTo(new Answer.Refused("There is no agent 'zoe'. Known are: amy, base."));
        assertThat(answer(run.operator().addAgent("amy", "")))
                .isEqualTo(new Answer.Refused("Agent 'amy' has a robot, and another one like it needs one."));
        assertThat(answer(run.operator().addAgent("base", "west")))
                .isEqualTo(new Answer.Refused("Agent 'base' has no robot, and neither has another one like it."));
        assertThat(answer(run.operator().addAgent("amy", "north"))).isInstanceOf(Answer.Refused.class);
        assertThat(byHand()).isEmpty();
    }

    @Test
    void anyTypeThatIsInstalledIsStartedAsItIsTyped() throws Exception {
        assertThat(RunOperator.agentTypes()).extracting(AgentType::key).contains("chatter", "wander");
        assertThat(answer(run.operator().newAgent("chatter", "", Map.of()))).isEqualTo(new Answer.Added("chatter-1"));
        assertThat(answer(run.operator().newAgent("chatter", "east", Map.of())))
                .isEqualTo(new Answer.Added("chatter-2"));
        assertThat(inside("chatter-2").planned().orElseThrow().robot()).contains("east");
        assertThat(status("chatter-1")).isEqualTo(AgentPlatform.Status.RUNNING);
        assertThat(byHand())
                .containsExactly("chatter-1 started, as chatter", "chatter-2 started, as chatter, for east");
    }

    @Test
    void whatCantBeStartedSaysWhy() throws Exception {
        assertThat(whyNot("wonder", "east", Map.of()))
                .startsWith("There is no type 'wonder' of agents. Maybe 'wander'");
        assertThat(whyNot("wander", "north", Map.of())).contains("'north'");
        assertThat(whyNot("wander", "", Map.of())).isEqualTo("Agents 'wander' need a robot that they act for.");
        assertThat(whyNot("wander", "east", Map.of("hurry", "1"))).contains("'hurry' is not known here");
        assertThat(whyNot("follow", "east", Map.of("period", "soon"))).contains("'period' must be");
        assertThat(whyNot("witness", "", Map.of("of", "nobody"))).contains("'of' must be", "not 'nobody'");
        assertThat(byHand()).isEmpty();
    }

    private String whyNot(String type, String robot, Map<String, String> arguments) throws Exception {
        return ((Answer.Refused) answer(run.operator().newAgent(type, robot, arguments))).why();
    }

    @Test
    void oneThatWasStoppedStartsAgain() throws Exception {
        assertThat(answer(run.operator().startAgent("amy"))).isEqualTo(new Answer.Refused("Agent 'amy' runs already."));
        assertThat(answer(run.operator().stopAgent("amy"))).isEqualTo(new Answer.Done());
        assertThat(status("amy")).isEqualTo(AgentPlatform.Status.ENDED);
        assertThat(answer(run.operator().stopAgent("amy")))
                .isEqualTo(new Answer.Refused("Agent 'amy' does not run. Maybe start it again."));
        assertThat(answer(run.operator().startAgent("amy"))).isEqualTo(new Answer.Done());
        assertThat(status("amy")).isEqualTo(AgentPlatform.Status.RUNNING);
        assertThat(answer(run.operator().startAgent("zoe")))
                .isEqualTo(new Answer.Refused("There is no agent 'zoe'. Known are: amy, base."));
        assertThat(byHand()).containsExactly("amy stopped", "amy started again");
    }

    @Test
    void peopleStartNoMoreThanARunBears() throws Exception {
        for (int i = 0; i < Agents.MOST_BY_HAND; i++) {
            assertThat(answer(run.operator().addAgent("base", ""))).isInstanceOf(Answer.Added.class);
        }
        assertThat(answer(run.operator().addAgent("base", "")))
                .isInstanceOfSatisfying(
                        Answer.Refused.class,
                        refused -> assertThat(refused.why()).contains("500 times"));
    }

    @Test
    void whatIsSaidReachesTheOneItIsFor() throws Exception {
        assertThat(answer(run.operator().say("amy", "text", Map.of("words", "go home"))))
                .isEqualTo(new Answer.Done());
        step();
        assertThat(letters("amy")).containsExactly("go home");
        assertThat(letters("base")).isEmpty();
        assertThat(answer(run.operator().say("", "text", Map.of("words", "all go home"))))
                .isEqualTo(new Answer.Done());
        step();
        assertThat(letters("amy")).containsExactly("go home", "all go home");
        assertThat(letters("base")).containsExactly("all go home");
        assertThat(byHand()).containsExactly("amy is told on text: go home", " all are told on text: all go home");
    }

    private List<String> letters(String agent) throws Exception {
        return inside(agent).mail().orElseThrow().stream()
                .filter(mail -> mail.from().equals("operator"))
                .map(ReceivedMessage::words)
                .toList();
    }

    @Test
    void whatIsNoMessageIsRefused() throws Exception {
        assertThat(answer(run.operator().say("zoe", "text", Map.of("words", "hi"))))
                .isEqualTo(new Answer.Refused("There is no agent 'zoe'. Known are: amy, base."));
        assertThat(answer(run.operator().say("amy", "nothing", Map.of()))).isInstanceOf(Answer.Refused.class);
        assertThat(answer(run.operator().say("amy", "victim-helped", Map.of("victim", "one"))))
                .isInstanceOf(Answer.Refused.class);
        assertThat(byHand()).isEmpty();
    }
}
