package rsal.scenario.condition;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class WrittenFormTest {
    private static final Grammar.Names NAMES = Grammar.Names.of(List.of("prey", "hunter"));

    @ParameterizedTest
    @ValueSource(
            strings = {
                "time > 300",
                "collisions != 0.25",
                "wallCollisions >= 12345678",
                "arrived(prey) < 2 and not time <= 10",
                "exploring(hunter) == 0 and explored >= 0.95",
                "allArrived(prey) or arrived(hunter) == 1 and time > 5",
                "(allArrived(prey) or time > 5) and collisions > 3",
                "not (allArrived(prey) and not time < 2)"
            })
    void conditionsAreAsTheyWereWritten(String text) {
        assertThat(Grammar.condition(text, NAMES)).hasToString(text);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "firstTime(allArrived(prey))",
                "count(wallCollisions)",
                "explored",
                "distance",
                "distance(hunter)",
                "p95(poseError)",
                "max(batteryLevel(prey))"
            })
    void measuresAreAsTheyWereWritten(String text) {
        assertThat(Grammar.metric(text, NAMES)).hasToString(text);
    }
}
