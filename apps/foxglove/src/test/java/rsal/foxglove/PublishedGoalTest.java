package rsal.foxglove;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Pose2d;
import rsal.foxglove.PublishedGoal.Kind;
import rsal.foxglove.PublishedGoal.Unclear;

class PublishedGoalTest {
    private static final String POSE = """
            {"position": {"x": 1.5, "y": -2, "z": 0}, "orientation": {"x": 0, "y": 0, "z": 0.7071068, "w": 0.7071068}}""";

    @ParameterizedTest
    @CsvSource({
        "/r1/goal, GOAL, r1",
        "/r1/goal_pose, GOAL, r1",
        "/r1/initialpose, POSE, r1",
        "/r1/pose, POSE, r1",
        "/goal_pose, GOAL, ''",
        "/move_base_simple/goal, GOAL, ''",
        "/initialpose, POSE, ''"
    })
    void topicsSayWhatIsWantedOfWhom(String topic, Kind kind, String robot) {
        assertThat(PublishedGoal.of(topic)).contains(new PublishedGoal(kind, robot));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "goal", "/r1/scan", "/clicked_point", "/a/b/goal", "//goal", "/r1/goal/"})
    void otherTopicsMeanNothing(String topic) {
        assertThat(PublishedGoal.of(topic)).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "%s",
                "{\"pose\": %s}",
                "{\"header\": {\"frame_id\": \"map\", \"stamp\": {\"sec\": 1, \"nsec\": 2}}, \"pose\": %s}",
                "{\"header\": {\"frame_id\": \"/map\"}, \"pose\": {\"pose\": %s, \"covariance\": [0, 1]}}",
                "{\"timestamp\": {\"sec\": 0, \"nsec\": 0}, \"frame_id\": \"map\", \"pose\": %s}"
            })
    void posesComeAsRosOrFoxgloveHaveThem(String message) throws Unclear {
        Pose2d pose = PublishedGoal.pose(message.formatted(POSE).getBytes(StandardCharsets.UTF_8));
        assertThat(pose.x()).isEqualTo(1.5);
        assertThat(pose.y()).isEqualTo(-2);
        assertThat(pose.theta()).isCloseTo(Math.PI / 2, within(1e-6));
    }

    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '`',
            delimiter = '|',
            value = {
                "nonsense | JSON",
                "`` | position.x",
                "[] | position.x",
                "{\"position\": {\"x\": 1}} | position.y",
                "{\"position\": {\"x\": \"1\", \"y\": 2}} | position.x",
                "{\"position\": {\"x\": 1e300, \"y\": 2}, \"orientation\": {\"z\": 0, \"w\": 1}} | farther",
                "{\"position\": {\"x\": 1, \"y\": 2}} | orientation.w",
                "{\"position\": {\"x\": 1, \"y\": 2}, \"orientation\": {\"z\": 0, \"w\": 0}} | not a rotation",
                "{\"frame_id\": \"odom\", \"position\": {\"x\": 1, \"y\": 2}, \"orientation\": {\"z\": 0, \"w\": 1}} | 'map'"
            })
    void whatIsUnclearIsReported(String message, String why) {
        assertThatThrownBy(() -> PublishedGoal.pose(message.getBytes(StandardCharsets.UTF_8)))
                .isInstanceOf(Unclear.class)
                .hasMessageContaining(why);
    }

    @ParameterizedTest
    @ValueSource(ints = {20, 309, 400, 999, 5000})
    void integersOfAnySizeAreReported(int digits) {
        String huge = "1" + "0".repeat(digits);
        for (String number : List.of("x", "y", "z", "w")) {
            String message = "{\"position\": {\"x\": 1, \"y\": 2}, \"orientation\": {\"z\": 0, \"w\": 1}}"
                    .replaceFirst("\"" + number + "\": \\d", "\"" + number + "\": " + huge);
            assertThatThrownBy(() -> PublishedGoal.pose(message.getBytes(StandardCharsets.UTF_8)))
                    .as("%s with %d digits", number, digits)
                    .isInstanceOf(Unclear.class);
        }
    }

    @Test
    void brokenMessagesAreOnlyEverUnclear() {
        var random = new Random(1);
        byte[] whole =
                ("{\"header\": {\"frame_id\": \"map\"}, \"pose\": " + POSE + "}").getBytes(StandardCharsets.UTF_8);
        for (int i = 0; i < 20_000; i++) {
            byte[] broken = whole.clone();
            for (int j = random.nextInt(4); j >= 0; j--) {
                broken[random.nextInt(broken.length)] = (byte) random.nextInt();
            }
            try {
                Pose2d pose = PublishedGoal.pose(broken);
                assertThat(pose.x()).isFinite();
                assertThat(pose.y()).isFinite();
                assertThat(pose.theta()).isFinite();
            } catch (Unclear e) {
                assertThat(e.getMessage()).isNotBlank();
            }
        }
    }
}
