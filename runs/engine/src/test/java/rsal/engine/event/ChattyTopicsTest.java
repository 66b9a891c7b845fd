package rsal.engine.event;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rsal.engine.report.SentMessage;

class ChattyTopicsTest {
    private final ChattyTopics routine = new ChattyTopics();

    private SentMessage say(String topic, int second) {
        var said = new SentMessage(Duration.ofSeconds(second), "amy", "", topic, "", "", "", "here");
        routine.said(said);
        return said;
    }

    @Test
    void ofOneTopicAllIsReportedAndOfTheOthersThatTheyAreThere() {
        SentMessage first = say("pose", 1);
        SentMessage hello = say("hello", 2);
        SentMessage second = say("pose", 3);
        assertThat(routine.of("pose")).isEqualTo(Map.of("pose", List.of(first, second), "hello", List.of()));
        assertThat(routine.of("")).isEqualTo(Map.of("pose", List.of(), "hello", List.of()));
        assertThat(routine.of("hello")).isEqualTo(Map.of("pose", List.of(), "hello", List.of(hello)));
    }

    @Test
    void theNewestAreKept() {
        for (int i = 0; i < ChattyTopics.MOST_OF_A_TOPIC + 5; i++) {
            say("pose", i);
        }
        assertThat(routine.of("pose").get("pose"))
                .hasSize(ChattyTopics.MOST_OF_A_TOPIC)
                .extracting(SentMessage::time)
                .startsWith(Duration.ofSeconds(5));
    }

    @Test
    void whatWasSaidLongBeforeIsKnownOfAnyTime() {
        routine.remember();
        for (int i = 0; i < 20_000; i++) {
            say("pose", i);
        }
        assertThat(at("pose", 100, 10)).containsExactly(91, 92, 93, 94, 95, 96, 97, 98, 99, 100);
        assertThat(at("pose", 19_999, 2)).containsExactly(19_998, 19_999);
        assertThat(at("pose", 0, 10)).containsExactly(0);
        assertThat(at("hello", 100, 10)).isEmpty();
        assertThat(routine.of("pose", Duration.ZERO, Duration.ZERO)).containsOnlyKeys("pose");
    }

    /// However long the run is, and however many talk.
    @Test
    void whatIsKeptReachesBackToTheBeginningInSoMuchMemory() {
        for (int i = 0; i < 50_000; i++) {
            said("robot-" + i % 10, "pose", i / 10);
            if (i == 2 || i == 30_000) {
                said("robot-3", "hello", i / 10);
            }
            assertThat(routine.bytes()).isLessThanOrEqualTo(ChattyTopics.FEW_BYTES);
        }
        assertThat(routine.bytes()).isGreaterThan(ChattyTopics.FEW_BYTES / 4);
        assertThat(at("hello", 3_100, 3_101)).as("said seldom").containsExactly(0, 3_000);
        for (int second : new int[] {100, 1_000, 4_000}) {
            assertThat(routine.of("pose", Duration.ofSeconds(second), Duration.ZERO)
                            .get("pose"))
                    .as("by %d s", second)
                    .extracting(SentMessage::from)
                    .containsExactlyInAnyOrderElementsOf(
                            IntStream.range(0, 10).mapToObj(i -> "robot-" + i).toList());
        }
    }

    @Test
    void soManyMayTalkThatOnlyTheNewestIsKept() {
        for (int i = 0; i < 5_000; i++) {
            said("robot-" + i, "pose", i);
            assertThat(routine.bytes()).isLessThanOrEqualTo(ChattyTopics.FEW_BYTES);
        }
        assertThat(at("pose", 4_999, 1)).containsExactly(4_999);
    }

    private void said(String from, String topic, int second) {
        routine.said(new SentMessage(Duration.ofSeconds(second), from, "", topic, "", "", "", "here"));
    }

    /// When it was said, in seconds.
    private List<Integer> at(String topic, int second, int shortly) {
        return routine
                .of(topic, Duration.ofSeconds(second), Duration.ofSeconds(shortly))
                .getOrDefault(topic, List.of())
                .stream()
                .map(said -> (int) said.time().toSeconds())
                .toList();
    }
}
