package rsal.agents.formation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.agent.message.GoalReached;
import rsal.agent.message.Hello;
import rsal.agent.message.Hello.Kind;
import rsal.agent.message.PoseReport;
import rsal.agents.FakeRobot;
import rsal.agents.Scene;
import rsal.data.Pose2d;

class SwarmMemberTest {
    private final Scene scene = new Scene();
    private final FakeRobot r1 = scene.robot("r1", "rover");

    @Test
    void followsTheWallReportsWhereItIsAndDrivesWhereItIsSent() {
        scene.start("swarm", r1, Map.of());
        r1.isAt(1, 2);
        scene.advance(0);
        assertThat(scene.state("r1")).isEqualTo("following the wall");
        assertThat(scene.said("r1", PoseReport.TOPIC))
                .containsExactly(new PoseReport("r1", "rover", new Pose2d(1, 2, 0)));
        scene.order("r1", 3, 0);
        assertThat(r1.pilot.engaged()).isFalse();
        r1.navigator.reach();
        scene.advance(0);
        assertThat(scene.said("r1", GoalReached.TOPIC))
                .extracting(GoalReached::ending)
                .containsExactly("reached");
        assertThat(r1.pilot.engaged()).isTrue();
    }

    @Test
    void waitsForAGoalWhereThereIsNoPilot() {
        scene.start("swarm", "r1", Optional.of(r1.withoutLocalizer().with(r1.navigator)), Map.of());
        assertThat(scene.state("r1")).isEqualTo("waiting for a goal");
        scene.order("r1", 3, 0);
        assertThat(r1.navigator.driving()).isTrue();
    }

    @Test
    void countsThoseThatAreNear() {
        scene.start("swarm", r1, Map.of("neighborDistance", 4));
        scene.report("r2", "rover", 2, 0); // it does not know yet where it is itself
        r1.isAt(0, 0);
        scene.advance(0);
        scene.report("r3", "rover", 2, 0);
        scene.report("r4", "rover", 3, 0);
        scene.report("r5", "rover", 5, 0);
        scene.advance(1);
        assertThat(neighbors()).isEqualTo("2");
        scene.report("r4", "rover", 4.5, 0); // has gone
        scene.advance(1);
        assertThat(neighbors()).isEqualTo("1");
        scene.advance(11); // not heard of any more
        assertThat(neighbors()).isEqualTo("0");
    }

    @Test
    void hearsOnlyThoseWithinTheRadius() {
        scene.start("swarm", r1, Map.of("neighborDistance", 100, "radius", 3));
        r1.isAt(0, 0);
        scene.advance(0);
        scene.report("r2", "rover", 2, 0);
        scene.report("r3", "rover", 4, 0);
        scene.advance(1);
        assertThat(neighbors()).isEqualTo("1");
    }

    @Test
    void answersAPingAndSaysGoodbye() {
        scene.start("swarm", r1, Map.of());
        scene.hear("operator", Hello.TOPIC, new Hello("", Kind.PING, ""));
        scene.platform.stop("r1");
        assertThat(scene.said("r1", Hello.TOPIC))
                .extracting(Hello::kind)
                .containsExactly(Kind.HELLO, Kind.PONG, Kind.BYE);
        assertThat(r1.pilot.engaged()).isFalse();
    }

    private String neighbors() {
        return scene.view("r1").beliefs().get("neighbors");
    }
}
