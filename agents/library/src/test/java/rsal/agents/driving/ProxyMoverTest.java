package rsal.agents.driving;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.agent.platform.AgentPlatform.Status;
import rsal.agents.FakeWorld;
import rsal.agents.Scene;
import rsal.data.Pose2d;

class ProxyMoverTest {
    private final FakeWorld world = new FakeWorld();
    private final Scene scene = new Scene(Optional.of(world));

    @Test
    void movesStandInsToWhereTheRobotsSayTheyAre() {
        world.things.put("proxy-r1", Pose2d.ORIGIN);
        world.things.put("proxy-r2", Pose2d.ORIGIN);
        scene.start("view", "view", Optional.empty(), Map.of());
        scene.report("r1", "rover", 1, 2);
        scene.report("r2", "rover", 3, 4);
        assertThat(world.things).containsEntry("proxy-r1", new Pose2d(1, 2, 0));
        assertThat(world.things).containsEntry("proxy-r2", new Pose2d(3, 4, 0));
        scene.report("r2", "rover", FakeWorld.WALL, 4);
        assertThat(world.things).containsEntry("proxy-r2", new Pose2d(FakeWorld.WALL, 4, 0));
    }

    @Test
    void movesOnlyTheOneItIsAskedFor() {
        world.things.put("ghost of r1", Pose2d.ORIGIN);
        world.things.put("ghost of r2", Pose2d.ORIGIN);
        scene.start("view", "view", Optional.empty(), Map.of("robot", "r2", "proxy", "ghost of *"));
        scene.report("r1", "rover", 1, 2);
        scene.report("r2", "rover", 3, 4);
        assertThat(world.things).containsEntry("ghost of r1", Pose2d.ORIGIN);
        assertThat(world.things).containsEntry("ghost of r2", new Pose2d(3, 4, 0));
    }

    @Test
    void showsWhatCouldNotBePlacedAndGoesOn() {
        scene.start("view", "view", Optional.empty(), Map.of());
        scene.report("r1", "rover", 1, 2);
        assertThat(scene.view("view").status()).isEqualTo(Status.RUNNING);
        assertThat(scene.view("view").beliefs()).containsEntry("proxy-r1", "not placed: no such thing");
    }

    @Test
    void failsWithClearWordsWhereNothingIsSimulated() {
        var reality = new Scene();
        reality.start("view", "view", Optional.empty(), Map.of());
        assertThat(reality.view("view").status()).isEqualTo(Status.FAILED);
        assertThat(reality.state("view")).contains("'view'").contains("simulated world");
    }
}
