package rsal.scenario.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class RoutineTest {
    private final Routine routine = new Routine();

    private Said say(String topic, int second) {
        var said = new Said(Duration.ofSeconds(second), "amy", "", topic, "", "", "", "here");
        routine.said(said);
        return said;
    }

    @Test
    void ofOneTopicAllIsToldAndOfTheOthersThatTheyAreThere() {
        Said first = say("pose", 1);
        Said hello = say("hello", 2);
        Said second = say("pose", 3);
        assertThat(routine.of("pose")).isEqualTo(Map.of("pose", List.of(first, second), "hello", List.of()));
        assertThat(routine.of("")).isEqualTo(Map.of("pose", List.of(), "hello", List.of()));
        assertThat(routine.all()).isEqualTo(Map.of("pose", List.of(first, second), "hello", List.of(hello)));
    }

    @Test
    void theNewestAreKept() {
        for (int i = 0; i < Routine.MOST_OF_A_TOPIC + 5; i++) {
            say("pose", i);
        }
        assertThat(routine.of("pose").get("pose"))
                .hasSize(Routine.MOST_OF_A_TOPIC)
                .extracting(Said::time)
                .startsWith(Duration.ofSeconds(5));
    }
}
