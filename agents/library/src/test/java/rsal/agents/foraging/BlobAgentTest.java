package rsal.agents.foraging;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.agent.platform.AgentPlatform.Status;
import rsal.agents.FakeWorld;
import rsal.agents.Scene;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.settings.Arguments;

/// What it asks for is in [CollectTest].
class BlobAgentTest {
    private final FakeWorld world = new FakeWorld();
    private final Scene scene = new Scene(Optional.of(world));

    private void start(Map<String, ?> arguments) {
        scene.start("blob", "told", Optional.empty(), arguments);
    }

    @Test
    void putsThingsIntoTheWorld() {
        start(Map.of("places", "4 0; -5 3"));
        assertThat(world.things)
                .containsOnly(Map.entry("told-1", new Pose2d(4, 0, 0)), Map.entry("told-2", new Pose2d(-5, 3, 0)));
    }

    @Test
    void leavesTheWorldAloneWhenTheyLieThereAlready() {
        start(Map.of("places", "4 0", "spawn", false));
        assertThat(world.things).isEmpty();
        assertThat(scene.state("told")).isEqualTo("0 of 1 fetched");
    }

    @Test
    void namesTheThingThatHasNoRoom() {
        start(Map.of("places", "4 0; 400 0"));
        assertThat(scene.view("told").status()).isEqualTo(Status.FAILED);
        assertThat(scene.state("told")).contains("'told-2'").contains("400").contains("outside");
    }

    @Test
    void wantsAColor() {
        start(Map.of("places", "4 0", "color", "gren"));
        assertThat(scene.view("told").status()).isEqualTo(Status.FAILED);
        assertThat(scene.state("told")).contains("'color'").contains("'gren'").contains("Maybe 'green' was meant?");
    }

    @Test
    void knowsColorsByName() {
        start(Map.of("places", "4 0", "color", "Steel Blue"));
        assertThat(world.things).containsKey("told-1");
        var arguments = Arguments.of(List.of(BlobAgent.COLOR), Map.of("color", "Steel Blue"));
        assertThat(Spotting.color(arguments, BlobAgent.COLOR)).contains(new Rgb(0x46, 0x82, 0xb4));
    }
}
