package rsal.foxglove;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

class FoxgloveAccessTest {
    private static final String HERE = "localhost:8765";
    private static final String FOXGLOVE = "https://app.foxglove.dev";

    private final FoxgloveAccess door = new FoxgloveAccess(8765, "secret");

    @Test
    void programsMayLookAndPagesNeedTheToken() {
        assertThat(refuse(HERE, null, null)).isEmpty();
        assertThat(refuse("127.0.0.1:8765", null, "secret")).isEmpty();
        assertThat(refuse(HERE, FOXGLOVE, "secret")).isEmpty();
        assertThat(refuse(HERE, FOXGLOVE, null))
                .hasValueSatisfying(why -> assertThat(why).contains("token"));
        assertThat(refuse(HERE, "null", null)).isPresent();
    }

    @Test
    void aWrongTokenIsNoneAtAll() {
        assertThat(refuse(HERE, null, "guessed")).isPresent();
        assertThat(refuse(HERE, FOXGLOVE, "guessed")).isPresent();
        assertThat(refuse(HERE, FOXGLOVE, "")).isPresent();
        assertThat(door.knows(null)).isFalse();
        assertThat(door.knows("secret")).isTrue();
    }

    @Test
    void namesThatWereMadeToPointHereGetNoAnswer() {
        assertThat(refuse("evil.example:8765", null, "secret"))
                .hasValueSatisfying(why -> assertThat(why).contains("evil.example"));
        assertThat(refuse("localhost:80", null, "secret")).isPresent();
        assertThat(refuse(null, null, "secret")).isPresent();
    }

    private Optional<String> refuse(@Nullable String host, @Nullable String origin, @Nullable String token) {
        return door.refuse(host, origin, token);
    }
}
