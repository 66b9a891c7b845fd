package rsal.agents.driving;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.agent.message.GoalReached;
import rsal.agent.message.Hello;
import rsal.agent.message.Hello.Kind;
import rsal.agent.message.PoseReport;
import rsal.agent.platform.AgentPlatform.Status;
import rsal.agents.FakeRobot;
import rsal.agents.Scene;
import rsal.data.Pose2d;
import rsal.robot.Robot;

class WallFollowTest {
    private final Scene scene = new Scene();
    private final FakeRobot r1 = scene.robot("r1", "rover");

    @Test
    void followsTheWallAndReportsItsPose() {
        r1.wakeBase();
        scene.start("wall-follow", r1, Map.of());
        r1.isAt(1, 2);
        scene.advance(1);
        assertThat(r1.pilot.latest().orElseThrow().value().opinions().getFirst().layer())
                .isEqualTo("follow-wall");
        assertThat(r1.base.commands.getLast().vx()).isPositive();
        assertThat(scene.said("r1", PoseReport.TOPIC))
                .containsExactly(new PoseReport("r1", "rover", new Pose2d(1, 2, 0)));
        assertThat(scene.state("r1")).isEqualTo("following the wall");
    }

    @Test
    void answersAPing() {
        scene.start("wall-follow", r1, Map.of());
        scene.hear("operator", Hello.TOPIC, new Hello("", Kind.PING, ""));
        assertThat(scene.said("r1", Hello.TOPIC)).contains(new Hello("r1", Kind.PONG, "operator"));
    }

    @Test
    void drivesWhereItIsSentAndThenFollowsTheWallAgain() {
        scene.start("wall-follow", r1, Map.of());
        scene.order("r1", 3, 0);
        assertThat(r1.pilot.engaged()).isFalse();
        scene.order("r1", 4, 0); // the second order keeps it from the wall
        assertThat(r1.pilot.engaged()).isFalse();
        r1.navigator.reach();
        scene.advance(0);
        assertThat(r1.pilot.engaged()).isTrue();
        assertThat(scene.said("r1", GoalReached.TOPIC))
                .extracting(GoalReached::ending)
                .containsExactly("cancelled", "reached");
    }

    @Test
    void followsTheWallWithoutANavigatorToo() {
        var robot = new Robot("r1", "rover", r1.robot.model(), List.of(r1.base, r1.pilot));
        scene.start("wall-follow", "r1", Optional.of(robot), Map.of());
        scene.order("r1", 3, 0);
        assertThat(r1.pilot.engaged()).isTrue();
        assertThat(scene.view("r1").status()).isEqualTo(Status.RUNNING);
    }

    @Test
    void letsGoOfTheRobotWhenItIsStopped() {
        scene.start("wall-follow", r1, Map.of());
        scene.platform.stop("r1");
        assertThat(r1.pilot.engaged()).isFalse();
    }
}
