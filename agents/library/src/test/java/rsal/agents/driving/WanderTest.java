package rsal.agents.driving;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import rsal.agent.message.PoseReport;
import rsal.agents.FakeRobot;
import rsal.agents.Scene;
import rsal.data.Pose2d;

class WanderTest {
    private final Scene scene = new Scene();
    private final FakeRobot r1 = scene.robot("r1", "rover");

    @Test
    void drivesAboutAndReportsItsPose() {
        r1.wakeBase();
        scene.start("wander", r1, Map.of());
        r1.isAt(1, 2);
        scene.advance(1);
        assertThat(r1.pilot.latest().orElseThrow().value().opinions().getFirst().layer())
                .isEqualTo("wander");
        assertThat(r1.base.commands.getLast().vx()).isPositive();
        assertThat(scene.said("r1", PoseReport.TOPIC))
                .containsExactly(new PoseReport("r1", "rover", new Pose2d(1, 2, 0)));
        assertThat(scene.state("r1")).isEqualTo("wandering");
    }

    @Test
    void drivesWhereItIsSentAndThenWandersAgain() {
        scene.start("wander", r1, Map.of());
        scene.order("r1", 3, 0);
        assertThat(r1.pilot.engaged()).isFalse();
        r1.navigator.reach();
        scene.advance(0);
        assertThat(r1.pilot.engaged()).isTrue();
    }
}
