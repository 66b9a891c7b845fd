package rsal.environment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.scenario.RunOptions;

class GoalObservationTest {
    private static final String SCENARIO = """
            rsal: 1
            scenario: goals
            world: {map: hall.yaml}
            robots:
              learner:
                model: pioneer2dx
                pose: [2, 2, 0]
                devices: {laser: urg04lx, localizer: {type: odometry}, navigator: {}}
              other: {model: pioneer2dx, pose: [9, 3, 0], devices: {laser: urg04lx}}
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
    private static final float[] NONE = {0, 0, 0, 0};
    private static final float[] UNDER_WAY = {1, 0, 0, 0};
    private static final float[] REACHED = {0, 1, 0, 0};
    private static final float[] NO_PATH = {0, 0, 1, 0};

    @TempDir
    private Path folder;

    private Episode begin(String role, Map<String, Object> act) throws IOException {
        Files.writeString(folder.resolve("hall.yaml"), HALL);
        Path file = Files.writeString(folder.resolve("goals.yaml"), SCENARIO);
        List<Map<String, Object>> observe = List.of(Map.of("type", "goal"));
        return Episode.begin(new Environments().read(file.toString(), RunOptions.NONE, role, observe, act, 1), 1);
    }

    /// The states of a goal, each once, until it has ended or 200 steps are over.
    private static List<float[]> states(Episode episode, float... action) {
        var states = new ArrayList<float[]>();
        for (int step = 0; step < 200; step++) {
            episode.step(action, 0);
            var numbers = new float[4];
            episode.observe(numbers, 0);
            if (states.isEmpty() || !Arrays.equals(states.getLast(), numbers)) {
                states.add(numbers);
            }
            if (numbers[0] == 0) {
                break;
            }
        }
        return states;
    }

    @Test
    void aPlaceIsUnderWayUntilItIsReachedOrHasNoPath() throws IOException {
        try (Episode episode = begin("learner", Map.of("type", "place", "places", "5 3; 9 4"))) {
            var numbers = new float[4];
            episode.observe(numbers, 0);
            assertThat(numbers).containsExactly(NONE);
            assertThat(states(episode, 0)).containsExactly(UNDER_WAY, REACHED);
            assertThat(states(episode, 1)).as("behind a wall").last().isEqualTo(NO_PATH);
            assertThat(states(episode, 0)).as("where it is").last().isEqualTo(REACHED);
        }
    }

    @Test
    void aGoalBesideTheRobotIsReachedAndOneBehindAWallIsNot() throws IOException {
        try (Episode episode = begin("learner", Map.of("type", "goal", "reach", 8))) {
            assertThat(states(episode, 0.1F, 0)).last().isEqualTo(REACHED);
            assertThat(states(episode, 7, 0)).last().isEqualTo(NO_PATH);
        }
    }

    @Test
    void aRobotWithoutANavigatorIsNamed() {
        assertThatThrownBy(() -> begin("other", Map.of("type", "velocity")))
                .hasMessageContaining("'other' has no navigator for the observation 'goal'");
    }
}
