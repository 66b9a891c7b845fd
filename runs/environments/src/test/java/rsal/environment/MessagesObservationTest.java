package rsal.environment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.agent.Topic;
import rsal.agent.message.PoseReport;
import rsal.scenario.RunOptions;

class MessagesObservationTest {
    private static final String SCENARIO = """
            rsal: 1
            scenario: talking
            world: {map: office}
            robots:
              learner: {model: pioneer2dx, pose: {free: true}, devices: {laser: urg04lx}}
              first: {model: pioneer2dx, pose: {free: true}, devices: {laser: urg04lx, pilot: {}, localizer: {type: odometry}}}
              second: {model: pioneer2dx, pose: {free: true}, devices: {laser: urg04lx, pilot: {}, localizer: {type: odometry}}}
            agents:
              quick: {type: wander, robot: first, parameters: {period: 0.3}}
              slow: {type: wander, robot: second, parameters: {period: 1}}
            """;
    private static final Topic<?> OWN = new Topic<>("own", Map.class);

    /// What a message can have.
    ///
    /// @param mayBe left out, or not
    private record Content(Duration longTime, boolean isOn, int count, Optional<Content> mayBe, String word) {}

    private static final Topic<Content> CONTENT = new Topic<>("content", Content.class);

    @TempDir
    private Path folder;

    private static Map<String, Object> observation(String from, int newest) {
        return Map.of(
                "type", "messages",
                "topic", "pose",
                "fields", "map_from_base.x map_from_base.y",
                "from", from,
                "newest", newest);
    }

    private Blueprint blueprint(List<Map<String, Object>> observations) throws IOException {
        Path file = Files.writeString(folder.resolve("talking.yaml"), SCENARIO);
        return new Environments()
                .read(file.toString(), RunOptions.NONE, "learner", observations, Map.of("type", "velocity"), 1);
    }

    /// Three messages of a robot are its true places at those times, as far as odometry knows.
    @Test
    void theNewestMessagesComeFirst() throws IOException {
        Blueprint blueprint =
                blueprint(List.of(observation("first", 3), observation("slow", 1), observation("learner", 1)));
        try (Episode episode = Episode.begin(blueprint, 4)) {
            var numbers = new float[blueprint.observed()];
            assertThat(numbers).hasSize(3 * 4 + 4 + 4);
            var places = new ArrayList<float[]>(); // of all robots, by step
            for (int step = 0; step < 40; step++) {
                var truth = new float[9];
                episode.truth(truth, 0);
                places.add(truth);
                episode.observe(numbers, 0);
                check(numbers, 0, places, 3);
                check(numbers, 12, places, 6);
                episode.step(new float[] {0, 0}, 0);
            }
            assertThat(numbers[2]).isLessThanOrEqualTo(0.31F);
            assertThat(numbers[6] - numbers[2]).isCloseTo(0.3F, Offset.offset(0.11F));
            assertThat(numbers[10] - numbers[6]).isCloseTo(0.3F, Offset.offset(0.11F));
            assertThat(new float[] {numbers[3], numbers[7], numbers[11], numbers[15]})
                    .containsOnly(1);
            assertThat(numbers).endsWith(0F, 0F, 0F, 0F); // no learner says anything
        }
    }

    /// @param at where a message begins
    /// @param robot where its place begins
    private static void check(float[] numbers, int at, List<float[]> places, int robot) {
        if (numbers[at + 3] == 0) {
            assertThat(numbers[at + 2]).isZero();
            return;
        }
        int step = places.size() - 1 - Math.round(numbers[at + 2] / 0.1F);
        float[] then = places.get(Math.max(0, step));
        assertThat(numbers[at]).isCloseTo(then[robot], Offset.offset(0.1F));
        assertThat(numbers[at + 1]).isCloseTo(then[robot + 1], Offset.offset(0.1F));
    }

    @Test
    void theyHaveLimits() throws IOException {
        LearnerObservation observed = new Environments()
                .observations(
                        List.of(Map.of("type", "messages", "topic", "pose", "fields", "map_from_base.x", "max", 0.5)))
                .getFirst();
        assertThat(observed.fields())
                .containsExactly("map_from_base.x of message 1", "age of message 1 [s]", "message 1 exists");
        assertThat(observed.low()).containsExactly(-0.5F, 0, 0);
        assertThat(observed.high()).containsExactly(0.5F, 1000, 1);
        Blueprint blueprint = blueprint(
                List.of(Map.of("type", "messages", "topic", "pose", "fields", "map_from_base.x", "max", 0.5)));
        try (Episode episode = Episode.begin(blueprint, 4)) {
            episode.step(new float[] {0, 0}, 0);
            episode.step(new float[] {0, 0}, 0);
            var numbers = new float[3];
            episode.observe(numbers, 0);
            assertThat(Math.abs(numbers[0])).isEqualTo(0.5F);
        }
    }

    @Test
    void numbersAreFoundByTheirNames() {
        var inner = new Content(Duration.ofMillis(1500), true, -3, Optional.empty(), "");
        var outer = new Content(Duration.ZERO, false, 7, Optional.of(inner), "");
        assertThat(MessageNumber.of(CONTENT, "count").in(outer)).isEqualTo(7);
        assertThat(MessageNumber.of(CONTENT, "may_be.count").in(outer)).isEqualTo(-3);
        assertThat(MessageNumber.of(CONTENT, "may_be.long_time").in(outer)).isEqualTo(1.5);
        assertThat(MessageNumber.of(CONTENT, "may_be.is_on").in(outer)).isEqualTo(1);
        assertThat(MessageNumber.of(CONTENT, "may_be.count").in(inner)).isZero();
        assertThat(MessageNumber.of(OWN, "bid.price").in(Map.of("bid", Map.of("price", 2.5))))
                .isEqualTo(2.5);
    }

    @Test
    void numbersThatAreNotThereAreNamed() {
        assertThatThrownBy(() -> MessageNumber.of(PoseReport.TOPIC, "map_from_base.xx"))
                .hasMessageContaining("topic 'pose' have no number 'map_from_base.xx': there is no 'xx'");
        assertThatThrownBy(() -> MessageNumber.of(PoseReport.TOPIC, "map_from_bas.x"))
                .hasMessageContaining("Maybe 'map_from_base' was meant?");
        assertThatThrownBy(() -> MessageNumber.of(PoseReport.TOPIC, "map_from_base"))
                .hasMessageContaining("Known are: x, y, theta");
        assertThatThrownBy(() -> MessageNumber.of(CONTENT, "word")).hasMessageContaining("no number 'word'");
        assertThatThrownBy(() -> MessageNumber.of(OWN, "prise").in(Map.of("price", 1)))
                .hasMessageContaining("topic 'own' have no number 'prise'. Maybe 'price' was meant?");
        assertThatThrownBy(() -> MessageNumber.of(OWN, "price").in(Map.of("price", "high")))
                .hasMessageContaining("no number 'price'");
        assertThatThrownBy(() -> blueprint(List.of(Map.of("type", "messages", "topic", "pose", "fields", " "))))
                .hasMessageContaining("'fields'");
    }
}
