package rsal.environment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.Function;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.scenario.RunOptions;

class WorldsTest {
    private static final String SCENARIO = """
            rsal: 1
            scenario: two-roles
            world: {map: office}
            robots:
              learner: {count: 2, model: pioneer2dx, pose: {free: true}, devices: {laser: urg04lx, pilot: {}}}
              other: {model: pioneer2dx, pose: {free: true}, devices: {laser: urg04lx, pilot: {}}}
            agents:
              wander: {type: wander, robot: other}
              replaced: {type: wander, robot: learner}
            run: {stop: [{when: time >= 3, outcome: success}]}
            metrics: [{name: way, from: distance(other)}, {name: late, from: firstTime(time >= 2)}]
            """;

    @TempDir
    private Path folder;

    private Blueprint blueprint(Map<String, Object> action, List<Map<String, Object>> observations) {
        try {
            Path file = Files.writeString(folder.resolve("two-roles.yaml"), SCENARIO);
            return new Environments().read(file.toString(), RunOptions.NONE, "learner", observations, action, 2);
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    private Blueprint blueprint() {
        return blueprint(
                Map.of("type", "velocity", "forward", 0.4),
                List.of(
                        Map.of("type", "ranges", "sectors", 12, "max", 4),
                        Map.of("type", "pose", "from", "truth"),
                        Map.of("type", "velocity"),
                        Map.of("type", "nearest", "count", 2),
                        Map.of("type", "place", "x", 3, "y", -2)));
    }

    private static float[] randomActions(SplittableRandom random, int count) {
        var actions = new float[2 * count];
        for (int i = 0; i < count; i++) {
            actions[2 * i] = random.nextFloat(0, 0.4f);
            actions[2 * i + 1] = random.nextFloat(-1.5f, 1.5f);
        }
        return actions;
    }

    /// What a learner observes follows from the truth, by formulas of its own.
    @Test
    void observationsAreWhatTheTruthSays() {
        try (var worlds = new Worlds(blueprint(), new long[] {7}, 1)) {
            var random = new SplittableRandom(1);
            for (int step = 0; step < 10; step++) {
                worlds.step(randomActions(random, 2));
                int size = worlds.observations().length / 2;
                for (int learner = 0; learner < 2; learner++) {
                    float[] own = Arrays.copyOfRange(worlds.observations(), learner * size, (learner + 1) * size);
                    float[] pose = Arrays.copyOfRange(worlds.truth(), 3 * learner, 3 * learner + 3);
                    assertThat(own[12]).isEqualTo(pose[0]);
                    assertThat(own[14]).isEqualTo((float) Math.cos(pose[2]), within());
                    assertThat(own[16]).as("forward").isBetween(-0.05f, 0.5f);
                    assertThat(mapFromSeen(pose, own[19], own[20])).satisfies(seen -> {
                        assertThat(own[21]).isEqualTo(1);
                        assertThat(isAt(worlds.truth(), seen)).as("nearest").isTrue();
                    });
                    double[] place = mapFromSeen(pose, own[25], own[26]);
                    assertThat(place[0]).isCloseTo(3, Offset.offset(1e-3));
                    assertThat(place[1]).isCloseTo(-2, Offset.offset(1e-3));
                }
            }
        }
    }

    private static Offset<Float> within() {
        return Offset.offset(1e-5f);
    }

    private static double[] mapFromSeen(float[] pose, float x, float y) {
        double cos = Math.cos(pose[2]);
        double sin = Math.sin(pose[2]);
        return new double[] {pose[0] + cos * x - sin * y, pose[1] + sin * x + cos * y};
    }

    private static boolean isAt(float[] truth, double[] place) {
        for (int robot = 0; robot < truth.length / 3; robot++) {
            if (Math.hypot(truth[3 * robot] - place[0], truth[3 * robot + 1] - place[1]) < 1e-3) {
                return true;
            }
        }
        return false;
    }

    @Test
    void aLearnerDrivesAsItActs() {
        try (var worlds = new Worlds(blueprint(), new long[] {7}, 1)) {
            float[] before = worlds.truth().clone();
            for (int step = 0; step < 5; step++) {
                worlds.step(new float[] {0, 1, 0, 0});
            }
            float turned = worlds.truth()[2] - before[2];
            assertThat(Math.IEEEremainder(turned, 2 * Math.PI)).isBetween(0.5, 1.1);
            assertThat(worlds.truth()[5]).as("the other learner stands").isEqualTo(before[5], within());
        }
    }

    @Test
    void worldsDoNotDependOnEachOtherNorOnThreads() {
        float[] alone = observed(new long[] {5}, 1, 0);
        assertThat(observed(new long[] {5}, 1, 0)).isEqualTo(alone);
        assertThat(observed(new long[] {3, 5, 5, 9}, 2, 1)).isEqualTo(alone);
        assertThat(observed(new long[] {3, 5, 5, 9}, 2, 2)).isEqualTo(alone);
        assertThat(observed(new long[] {3, 5}, 1, 0)).isNotEqualTo(alone);
    }

    /// After some steps in which all worlds have the same actions.
    private float[] observed(long[] seeds, int threads, int world) {
        try (var worlds = new Worlds(blueprint(), seeds, threads)) {
            var random = new SplittableRandom(4);
            for (int step = 0; step < 8; step++) {
                float[] own = randomActions(random, 2);
                var actions = new float[own.length * seeds.length];
                for (int i = 0; i < seeds.length; i++) {
                    System.arraycopy(own, 0, actions, i * own.length, own.length);
                }
                worlds.step(actions);
            }
            int size = worlds.observations().length / seeds.length;
            return Arrays.copyOfRange(worlds.observations(), world * size, (world + 1) * size);
        }
    }

    @Test
    void anEpisodeEndsByTheScenarioAndBeginsAgain() {
        try (var worlds = new Worlds(blueprint(), new long[] {5, 6}, 2)) {
            float[] begun = worlds.observations().clone();
            while (worlds.outcome(0).isEmpty()) {
                worlds.step(new float[8]);
            }
            assertThat(worlds.outcome(1)).isEqualTo("success");
            assertThat(worlds.metrics(0)).containsKey("way");
            float[] ended = worlds.observations().clone();
            worlds.step(new float[8]);
            assertThat(worlds.observations()).isEqualTo(ended);
            String hash = worlds.finish(0).eventHash();
            worlds.reset(new int[] {0, 1}, new long[] {5, 6});
            assertThat(worlds.observations()).isEqualTo(begun);
            while (worlds.outcome(0).isEmpty()) {
                worlds.step(new float[8]);
            }
            assertThat(worlds.finish(0).eventHash()).isEqualTo(hash);
        }
    }

    @Test
    void aWrongActionIsRefusedOnSeveralThreadsBeforeAnyWorldMoves() {
        try (var worlds = new Worlds(blueprint(), new long[] {5, 6, 7, 8}, 2)) {
            var actions = new float[4 * 2 * 2];
            Arrays.fill(actions, 0.4f);
            actions[13] = Float.NaN;
            float[] before = worlds.truth().clone();
            assertThatThrownBy(() -> worlds.step(actions))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("'turn [rad/s]' of robot 'learner-1' must be finite");
            assertThat(worlds.truth()).isEqualTo(before);
            actions[13] = 0;
            worlds.step(actions);
            assertThat(worlds.truth()).isNotEqualTo(before);
        }
    }

    @Test
    void eachNumberHasLimitsOfItsOwn() {
        Blueprint all = blueprint(
                Map.of("type", "velocity"),
                List.of(
                        Map.of("type", "pose", "from", "truth", "max", 50),
                        Map.of("type", "nearest", "count", 2, "max", 20),
                        Map.of("type", "idleness", "places", "1 2; 3 4", "max", 30)));
        float[] low = {-50, -50, -1, -1, -20, -20, 0, -20, -20, 0, -30, -30, 0, -30, -30, 0};
        float[] high = {50, 50, 1, 1, 20, 20, 1, 20, 20, 1, 30, 30, 30, 30, 30, 30};
        assertThat(together(all, LearnerObservation::low)).isEqualTo(low);
        assertThat(together(all, LearnerObservation::high)).isEqualTo(high);
        assertThat(all.observed()).isEqualTo(low.length);
    }

    private static float[] together(Blueprint blueprint, Function<LearnerObservation, float[]> limits) {
        var all = new float[blueprint.observed()];
        int next = 0;
        for (LearnerObservation each : blueprint.observations()) {
            float[] own = limits.apply(each);
            System.arraycopy(own, 0, all, next, own.length);
            next += own.length;
        }
        return all;
    }

    /// Eight sonars and 36 sectors: each sector has the range of a sonar.
    @Test
    void sectorsWithoutABeamHaveTheRangeOfTheNearestOne() throws IOException {
        Path file = Files.writeString(folder.resolve("sonars.yaml"), """
                rsal: 1
                scenario: sonars
                world: {map: office}
                robots:
                  learner: {model: pioneer2dx, pose: {free: true}, devices: {sonar: front8}}
                """);
        var observed = List.<Map<String, Object>>of(
                Map.of("type", "ranges", "max", 100), Map.of("type", "ranges", "sectors", 8, "max", 100));
        Blueprint sonars = new Environments()
                .read(file.toString(), RunOptions.NONE, "learner", observed, Map.of("type", "velocity"), 5);
        try (var worlds = new Worlds(sonars, new long[] {3}, 1)) {
            for (int step = 0; step < 5; step++) {
                worlds.step(new float[] {0, 1});
            }
            float[] each = Arrays.copyOfRange(worlds.observations(), 36, 44);
            float least = Float.MAX_VALUE;
            for (float range : each) {
                least = Math.min(least, range);
            }
            assertThat(least).as("a wall is near").isLessThan(5);
            for (int sector = 0; sector < 36; sector++) {
                int nearest = (int) ((sector + 0.5) / 36 * 8);
                assertThat(worlds.observations()[sector])
                        .as("sector %d", sector)
                        .isEqualTo(each[nearest]);
            }
        }
    }

    @Test
    void allMetricsHaveTheirNamesBeforeTheyHaveValues() {
        try (var worlds = new Worlds(blueprint(), new long[] {5}, 1)) {
            assertThat(worlds.metricNames()).containsExactly("way", "late");
            assertThat(worlds.metrics(0)).doesNotContainKey("late");
        }
    }

    @Test
    void choicesDriveAndErrorsSayWhatIsWrong() {
        List<Map<String, Object>> velocity = List.of(Map.of("type", "velocity"));
        Blueprint discrete = blueprint(Map.of("type", "discrete", "speed", 0.3), velocity);
        try (var worlds = new Worlds(discrete, new long[] {7}, 1)) {
            assertThat(discrete.action().choices()).isEqualTo(5);
            for (int step = 0; step < 5; step++) {
                worlds.step(new float[] {1, 0});
            }
            assertThat(worlds.observations()[0]).isEqualTo(0.3f, Offset.offset(0.05f));
            assertThat(worlds.observations()[3]).isEqualTo(0);
            assertThatThrownBy(() -> worlds.step(new float[] {Float.NaN, 0}))
                    .hasMessageContaining("'choice' of robot 'learner-1'");
            for (float none : new float[] {5, -1, 1.5f}) {
                assertThatThrownBy(() -> worlds.step(new float[] {0, none}))
                        .hasMessageContaining("'choice' of robot 'learner-2' must be a whole number from 0 to 4")
                        .hasMessageContaining("'%s'".formatted(none));
            }
            assertThatThrownBy(() -> worlds.step(new float[1])).hasMessageContaining("2 numbers, not '1'");
        }
        assertThatThrownBy(() -> blueprint(Map.of("type", "velocty"), velocity))
                .hasMessageContaining("no action 'velocty'")
                .hasMessageContaining("'velocity'");
        assertThatThrownBy(() -> blueprint(Map.of("type", "velocity", "turn", -1), velocity))
                .hasMessageContaining("'turn'");
        assertThatThrownBy(() -> new Worlds(blueprint(Map.of("type", "goal"), velocity), new long[] {1}, 1))
                .hasMessageContaining("no navigator");
        assertThatThrownBy(() -> blueprint(Map.of("type", "velocity"), List.of()))
                .hasMessageContaining("at least one observation");
    }
}
