package rsal.settings;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Point2d;

class PlacesTest {
    private static final Parameter<List<Point2d>> POSTS = Parameter.places("posts", "Where to stand.");

    private static List<Point2d> read(Object given) {
        return Arguments.of(List.of(POSTS), Map.of("posts", given)).get(POSTS);
    }

    @Test
    void placesAreSeparatedBySemicolons() {
        assertThat(read("-20 4;3.5, -1 ; 0 0"))
                .containsExactly(new Point2d(-20, 4), new Point2d(3.5, -1), new Point2d(0, 0));
        assertThat(read("1 2")).containsExactly(new Point2d(1, 2));
    }

    @Test
    void thereMayBeNone() {
        assertThat(read(" ")).isEmpty();
        assertThat(Arguments.defaults(List.of(POSTS)).get(POSTS)).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"1", "1 2 3", "1 2;", "a b", "NaN 1", "1 1e999", "1 2; 3"})
    void whatIsNoPlaceIsRefused(String text) {
        assertThatThrownBy(() -> read(text))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("'posts' must be places as x y; x y [m], not '%s'.", text);
    }

    @Test
    void numbersAreNoPlaces() {
        assertThatThrownBy(() -> read(3)).hasMessageContaining("x y; x y");
    }
}
