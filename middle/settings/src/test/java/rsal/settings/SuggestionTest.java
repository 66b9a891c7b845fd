package rsal.settings;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class SuggestionTest {
    @Test
    void guessesAWordThatIsClose() {
        assertThat(Suggestion.among("catchDistnace", List.of("catchDistance", "seed")))
                .isEqualTo("Maybe 'catchDistance' was meant?");
    }

    @Test
    void guessesTheOnlyWordThatBeginsSo() {
        assertThat(Suggestion.among("hunt", List.of("patrol", "hunt-and-prey")))
                .isEqualTo("Maybe 'hunt-and-prey' was meant?");
        assertThat(Suggestion.among("wall", List.of("wall-follow", "wallDistance")))
                .isEqualTo("Known are: wall-follow, wallDistance.");
        assertThat(Suggestion.among("hu", List.of("hunt-and-prey"))).isEqualTo("Known are: hunt-and-prey.");
    }

    @Test
    void namesWhatReplacesAFormerNameWhereThatIsKnown() {
        assertThat(Suggestion.among("reach", List.of("range", "beach"))).isEqualTo("'reach' is now called 'range'.");
        assertThat(Suggestion.among("reach", List.of("beach"))).isEqualTo("Maybe 'beach' was meant?");
        assertThat(Suggestion.among("span", List.of("distance"))).isEqualTo("'span' is now called 'distance'.");
        assertThat(Suggestion.among("span", List.of("distance", "duration")))
                .isEqualTo("'span' is now called 'duration'.");
    }

    @Test
    void listsWhatIsKnownWhenNothingIsClose() {
        assertThat(Suggestion.among("x", List.of("hunter", "prey"))).isEqualTo("Known are: hunter, prey.");
        assertThat(Suggestion.among("x", List.of())).isEqualTo("Nothing is known here.");
    }

    @Test
    void listsOnlyTheFirstOfMany() {
        List<String> many =
                IntStream.range(0, 1000).mapToObj("robot-%03d"::formatted).toList();
        assertThat(Suggestion.among("x", many))
                .startsWith("Known are: robot-000, robot-001")
                .endsWith("robot-039, and 960 more.");
    }

    @Test
    void allThatAreEquallyNearAreNamed() {
        assertThat(Suggestion.among("--sed", List.of("--seed", "--set", "--speed")))
                .isEqualTo("Maybe '--seed' or '--set' was meant?");
    }
}
