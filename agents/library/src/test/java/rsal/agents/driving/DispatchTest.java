package rsal.agents.driving;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rsal.agent.message.GoalReached;
import rsal.agent.message.NewGoal;
import rsal.agents.FakeRobot;
import rsal.agents.Scene;
import rsal.data.Pose2d;

class DispatchTest {
    private final Scene scene = new Scene();
    private final FakeRobot r1 = scene.robot("r1", "rover");
    private final FakeRobot r2 = scene.robot("r2", "rover");

    @BeforeEach
    void start() {
        scene.start("nav", r1, Map.of("period", 0.5));
        scene.start("nav", r2, Map.of("period", 0.5));
        scene.start("dispatch", "dispatch", Optional.empty(), Map.of("timeout", 5));
        scene.advance(2);
    }

    /// Nobody hears a robot's agent, and it hears nobody, from now on.
    private void silence(String agent) {
        scene.platform.deliverBy((message, listener) ->
                message.sender().equals(agent) || listener.equals(agent) ? List.of() : List.of(Duration.ZERO));
    }

    @Test
    void whatARobotHearsTwiceItDoesOnce() {
        scene.order("r1", 3, -1);
        scene.advance(2);
        assertThat(r1.navigator.goals).containsExactly(new Pose2d(3, -1, 0));
        r1.navigator.reach();
        scene.advance(1);
        assertThat(scene.said("r1", GoalReached.TOPIC))
                .containsExactly(new GoalReached("r1", new Pose2d(3, -1, 0), "reached", ""));
        scene.advance(10);
        assertThat(scene.said("dispatch", GoalReached.TOPIC)).isEmpty();
        assertThat(scene.state("dispatch")).isEqualTo("2 of 2 robots answer");
    }

    @Test
    void aRobotThatDidNotHearWherePeopleSentItGoesThereAllTheSame() {
        scene.platform.deliverBy((message, listener) ->
                message.content() instanceof NewGoal && listener.equals("r1") ? List.of() : List.of(Duration.ZERO));
        scene.order("r1", 3, -1);
        scene.advance(1);
        assertThat(r1.navigator.goals).containsExactly(new Pose2d(3, -1, 0));
    }

    @Test
    void whoFallsSilentIsReportedWithinFiveSecondsAndSentAgainWhenItIsBack() {
        scene.order("r1", 3, -1);
        scene.order("r2", 4, 0);
        scene.advance(2);
        silence("r1");
        scene.advance(4);
        assertThat(scene.said("dispatch", GoalReached.TOPIC)).isEmpty();
        scene.advance(3);
        assertThat(scene.said("dispatch", GoalReached.TOPIC)).singleElement().satisfies(end -> {
            assertThat(end.robot()).isEqualTo("r1");
            assertThat(end.ending()).isEqualTo("silent");
            assertThat(end.why()).isNotEmpty();
        });
        assertThat(scene.state("dispatch")).isEqualTo("1 of 2 robots answer, silent: r1");

        r1.navigator.end(FakeRobot.stuck()); // and nobody has heard of it
        scene.advance(1);
        silence("nobody");
        scene.advance(3);
        assertThat(scene.state("dispatch")).isEqualTo("2 of 2 robots answer");
        assertThat(r1.navigator.goals).containsExactly(new Pose2d(3, -1, 0), new Pose2d(3, -1, 0));
        assertThat(r2.navigator.goals).hasSize(1);
    }

    @Test
    void reportsWhenARobotsAgentHasEndedOnItsWay() {
        scene.order("r1", 3, -1);
        scene.advance(2);
        assertThat(r1.navigator.driving()).isTrue();
        scene.platform.stop("r1");
        scene.advance(8);
        assertThat(scene.said("dispatch", GoalReached.TOPIC))
                .singleElement()
                .satisfies(end -> assertThat(end.silent()).isTrue());
        assertThat(scene.state("dispatch")).isEqualTo("1 of 1 robots answer");
    }

    @Test
    void onlyWherePeopleSentARobotLastCounts() {
        silence("r1");
        scene.order("r1", 3, -1);
        scene.order("r1", 5, 5);
        scene.advance(20);
        assertThat(scene.said("dispatch", GoalReached.TOPIC))
                .extracting(GoalReached::mapFromGoal)
                .containsExactly(new Pose2d(5, 5, 0));
    }

    @Test
    void agentsThatSendRobotsSeeToItThemselves() {
        silence("r1");
        scene.hear("other", NewGoal.TOPIC, new NewGoal("r1", new Pose2d(3, -1, 0)));
        scene.advance(20);
        assertThat(scene.said("dispatch", GoalReached.TOPIC)).isEmpty();
    }
}
