package rsal.environment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.engine.SteppedWatch;
import rsal.scenario.RunOptions;

/// Observations that real robots have, beside what follows from poses that are known.
class SensedObservationsTest {
    private static final Offset<Float> NEAR = Offset.offset(0.02F); // m; odometry and detectors have errors
    private static final String SCENARIO = """
            rsal: 1
            scenario: sensed
            world: {map: hall.yaml}
            robots:
              learner:
                model: pioneer2dx
                pose: [2, 2, 90]
                devices: {fiducials: fiducials360, gripper: pioneer-gripper, localizer: {type: odometry}}
              leader: {model: pioneer2dx, pose: [5, 4, 180], fiducial: 7, devices: {laser: urg04lx}}
              hidden: {model: pioneer2dx, pose: [9, 2, 0], fiducial: 8, devices: {laser: urg04lx}}
            agents: {}
            """;
    private static final String HALL = """
            resolution: 1
            drawing: |
              ###########
              #......#..#
              #......#..#
              #......#..#
              #......#..#
              ###########
            """;

    @TempDir
    private Path folder;

    private Episode begin(Map<String, Object> act, List<Map<String, Object>> observe) throws IOException {
        Files.writeString(folder.resolve("hall.yaml"), HALL);
        Path file = Files.writeString(folder.resolve("sensed.yaml"), SCENARIO);
        return Episode.begin(
                new Environments().read(file.toString(), RunOptions.NONE, "learner", observe, act, 1),
                1,
                new SteppedWatch());
    }

    private float[] observed(Map<String, Object> observation) throws IOException {
        Environments environments = new Environments();
        var numbers = new float
                [environments
                        .observations(List.of(observation))
                        .getFirst()
                        .fields()
                        .size()];
        try (Episode episode = begin(Map.of("type", "velocity"), List.of(observation))) {
            episode.observe(numbers, 0);
        }
        return numbers;
    }

    @Test
    void markersAreWhereTheyAreSeen() throws IOException {
        float[] all = observed(Map.of("type", "markers", "count", 2));
        assertThat(all[0]).as("leader, 2 m ahead").isCloseTo(2, NEAR);
        assertThat(all[1]).as("leader, 3 m to the right").isCloseTo(-3, NEAR);
        assertThat(all).as("a wall hides the other one").endsWith(1F, 0F, 0F, 0F);
        assertThat(observed(Map.of("type", "markers", "first", 8))).containsOnly(0);
        assertThat(observed(Map.of("type", "markers", "last", 6))).containsOnly(0);
        assertThat(observed(Map.of("type", "markers", "visited", 4))).containsOnly(0);
        assertThat(observed(Map.of("type", "markers", "home", 4))).containsOnly(0);
        assertThat(observed(Map.of("type", "markers", "visited", 3, "home", 3))[2])
                .isEqualTo(1);
    }

    @Test
    void aSlotIsInTheFrameOfTheLeader() throws IOException {
        float[] slot = observed(Map.of("type", "slot", "leader", 7, "slots", "1 0.5; 9 9"));
        // In the map the slot is at (4, 3.5), as the leader looks to the left.
        assertThat(slot[0]).isCloseTo(1.5F, NEAR);
        assertThat(slot[1]).isCloseTo(-2, NEAR);
        assertThat(slot[2]).isCloseTo(0, NEAR);
        assertThat(slot[3]).isCloseTo(1, NEAR);
        assertThat(slot[4]).isEqualTo(1);
        assertThat(observed(Map.of("type", "slot", "leader", 8, "slots", "1 1")))
                .containsExactly(0, 0, 1, 0, 0);
        assertThatThrownBy(() -> observed(Map.of("type", "slot"))).hasMessageContaining("'slots'");
    }

    @Test
    void placesAndHomeFollowTheLocalizer() throws IOException {
        float[] place = observed(Map.of("type", "place", "x", 2, "y", 4, "from", "localizer"));
        assertThat(place[0]).isCloseTo(2, NEAR);
        assertThat(place[1]).isCloseTo(0, NEAR);
        assertThat(observed(Map.of("type", "gripper"))).containsExactly(0);
        var observe = List.<Map<String, Object>>of(
                Map.of("type", "home"),
                Map.of("type", "visited", "directions", 2, "distance", 1, "cell", 0.5),
                Map.of("type", "idleness", "places", "2 2; 5 4; 2.3 2.8", "role", "learner", "radius", 0.5));
        try (Episode episode = begin(Map.of("type", "velocity", "forward", 0.5), observe)) {
            var numbers = new float[2 + 2 + 9];
            for (int step = 0; step < 40; step++) {
                episode.observe(numbers, 0);
                episode.step(new float[] {0.3F, 0}, 0);
            }
            episode.observe(numbers, 0);
            var truth = new float[9];
            episode.truth(truth, 0);
            float driven = truth[1] - 2;
            assertThat(driven).isBetween(0.8F, 1.2F);
            assertThat(numbers[0]).as("behind it").isCloseTo(-driven, Offset.offset(0.1F));
            assertThat(numbers[2]).as("ahead it was not").isEqualTo(0);
            assertThat(numbers[3]).as("behind it was").isEqualTo(1);
            assertThat(numbers[6]).as("steps since it left its start").isBetween(5F, 35F);
            assertThat(numbers[9]).as("it was never at the leader").isEqualTo(41);
            assertThat(numbers[12]).as("it has just passed").isLessThan(numbers[6]);
        }
    }

    @Test
    void whatARobotLacksIsNamed() {
        assertThatThrownBy(() -> begin(Map.of("type", "place", "places", "3 3"), List.of(Map.of("type", "velocity"))))
                .hasMessageContaining("no navigator for the action 'place'");
        assertThatThrownBy(() -> begin(Map.of("type", "carry"), List.of(Map.of("type", "ranges", "device", "laser"))))
                .hasMessageContaining("no device 'laser'");
    }
}
