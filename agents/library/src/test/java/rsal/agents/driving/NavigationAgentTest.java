package rsal.agents.driving;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.agent.message.GoalReached;
import rsal.agent.message.Hello;
import rsal.agent.message.Hello.Kind;
import rsal.agent.message.NewGoal;
import rsal.agent.message.PoseReport;
import rsal.agent.message.PoseRequest;
import rsal.agent.platform.AgentPlatform.Status;
import rsal.agents.FakeRobot;
import rsal.agents.Scene;
import rsal.data.Pose2d;
import rsal.device.Navigator.Result;

class NavigationAgentTest {
    private final Scene scene = new Scene();
    private final FakeRobot r1 = scene.robot("r1", "rover");

    @Test
    void drivesWhereItIsSentAndSaysWhenItHasArrived() {
        scene.start("nav", r1, Map.of());
        scene.order("r1", 3, -1);
        assertThat(r1.navigator.goals).containsExactly(new Pose2d(3, -1, 0));
        assertThat(scene.state("r1")).isEqualTo("driving to (3.0, -1.0)");
        assertThat(scene.said("r1", GoalReached.TOPIC)).isEmpty();

        r1.navigator.reach();
        scene.advance(0);
        assertThat(scene.said("r1", GoalReached.TOPIC))
                .containsExactly(new GoalReached("r1", new Pose2d(3, -1, 0), "reached", ""));
        assertThat(scene.state("r1")).isEqualTo("(3.0, -1.0): reached");
    }

    @Test
    void obeysOrdersForAllButNotForOthers() {
        scene.start("nav", r1, Map.of());
        scene.order("r2", 1, 1);
        scene.order(NewGoal.ALL, 2, 2);
        assertThat(r1.navigator.goals).containsExactly(new Pose2d(2, 2, 0));
    }

    @Test
    void saysHowEachDriveEnds() {
        scene.start("nav", r1, Map.of());
        scene.order("r1", 1, 0);
        scene.order("r1", 2, 0); // takes over
        r1.navigator.end(new Result.NoPath("a wall"));
        scene.order("r1", 3, 0);
        r1.navigator.end(FakeRobot.stuck());
        scene.advance(0);
        assertThat(scene.said("r1", GoalReached.TOPIC))
                .extracting(GoalReached::ending)
                .containsExactly("cancelled", "no path", "stuck");
    }

    @Test
    void greetsAnswersAndSaysGoodbye() {
        scene.start("nav", r1, Map.of());
        scene.hear("operator", Hello.TOPIC, new Hello("", Kind.PING, ""));
        scene.hear("operator", Hello.TOPIC, new Hello("", Kind.HELLO, ""));
        scene.platform.stop("r1");
        assertThat(scene.said("r1", Hello.TOPIC))
                .containsExactly(
                        new Hello("r1", Kind.HELLO, ""),
                        new Hello("r1", Kind.PONG, "operator"),
                        new Hello("r1", Kind.BYE, ""));
    }

    @Test
    void stopsDrivingWhenItIsStopped() {
        scene.start("nav", r1, Map.of());
        scene.order("r1", 3, -1);
        scene.platform.stop("r1");
        assertThat(r1.navigator.driving()).isFalse();
    }

    @Test
    void reportsItsPoseAtMostOnceAPeriodAndNeverForgetsTheNewest() {
        scene.start("nav", r1, Map.of("period", 0.5));
        for (int i = 0; i < 8; i++) {
            r1.isAt(i, 0); // at 0.0, 0.1, … 0.7 s
            scene.advance(0.1);
        }
        scene.advance(10);
        assertThat(scene.said("r1", PoseReport.TOPIC))
                .extracting(report -> report.mapFromBase().x())
                .containsExactly(0.0, 4.0, 7.0);
        assertThat(scene.said.getLast().time()).isEqualTo(java.time.Instant.EPOCH.plusSeconds(1));
    }

    @Test
    void reportsEachPoseWithoutAPeriod() {
        scene.start("nav", r1, Map.of("period", 0));
        for (int i = 0; i < 8; i++) {
            r1.isAt(i, 0);
            scene.advance(0);
        }
        assertThat(scene.said("r1", PoseReport.TOPIC))
                .hasSize(8)
                .contains(new PoseReport("r1", "rover", Pose2d.ORIGIN));
    }

    @Test
    void reportsOdometryOnceASecondWithoutALocalizer() {
        var robot = r1.withoutLocalizer().with(r1.navigator);
        scene.start("nav", "r1", Optional.of(robot), Map.of());
        scene.advance(1.5); // knows nothing yet
        r1.base.roll(new Pose2d(1, 2, 0), scene.scheduler.instant());
        scene.advance(2);
        assertThat(scene.said("r1", PoseReport.TOPIC))
                .hasSize(2)
                .containsOnly(new PoseReport("r1", "rover", new Pose2d(1, 2, 0)));
    }

    @Test
    void reportsOdometryNoMoreOftenThanItIsAsked() {
        scene.start("nav", "r1", Optional.of(r1.withoutLocalizer().with(r1.navigator)), Map.of("period", 3));
        r1.base.roll(Pose2d.ORIGIN, scene.scheduler.instant());
        scene.advance(9.5);
        assertThat(scene.said("r1", PoseReport.TOPIC)).hasSize(3); // after 1, 4 and 7 s
    }

    @Test
    void saysNothingOfAPoseThatIsNotFinite() {
        scene.start("nav", r1, Map.of());
        r1.isAt(Double.NaN, 0);
        scene.advance(1);
        assertThat(scene.said("r1", PoseReport.TOPIC)).isEmpty();
        r1.isAt(1, 1);
        scene.advance(1);
        assertThat(scene.said("r1", PoseReport.TOPIC)).hasSize(1);
    }

    @Test
    void reportedPoseMustBeAPlace() {
        assertThatThrownBy(() -> scene.report("r1", "rover", Double.NaN, 0))
                .isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void reportsItsPoseWhenAsked() {
        scene.start("nav", r1, Map.of("period", 60));
        scene.hear("operator", PoseRequest.TOPIC, new PoseRequest("r1"));
        assertThat(scene.said("r1", PoseReport.TOPIC)).isEmpty(); // it does not know
        r1.isAt(1, 1);
        scene.advance(0);
        scene.hear("operator", PoseRequest.TOPIC, new PoseRequest("r1"));
        scene.hear("operator", PoseRequest.TOPIC, new PoseRequest(NewGoal.ALL));
        scene.hear("operator", PoseRequest.TOPIC, new PoseRequest("r2"));
        assertThat(scene.said("r1", PoseReport.TOPIC)).hasSize(3);
    }

    @Test
    void failsWithClearWordsWithoutARobot() {
        scene.start("nav", "lost", Optional.empty(), Map.of());
        assertThat(scene.view("lost").status()).isEqualTo(Status.FAILED);
        assertThat(scene.state("lost")).contains("'lost' has no robot");
    }

    @Test
    void goalMustBeAPlace() {
        assertThatThrownBy(() -> scene.order("r1", Double.NaN, 0)).isInstanceOf(IllegalArgumentException.class);
    }
}
