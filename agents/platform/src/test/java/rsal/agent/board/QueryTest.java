package rsal.agent.board;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import rsal.agent.Topic;
import rsal.data.Point2d;

class QueryTest {
    private static final Topic<String> CANS = new Topic<>("cans", String.class);
    private static final Point2d HERE = new Point2d(1, 2);

    private static Note<String> note(String author, String name, long second, double x) {
        return new Note<>(
                CANS,
                name,
                "red",
                Optional.of(new Point2d(x, 2)),
                author,
                Instant.EPOCH.plusSeconds(second),
                Duration.ofMinutes(1));
    }

    @Test
    void wantsWhatItNames() {
        Note<String> note = note("amy", "can-1", 5, 4);
        assertThat(Query.of(CANS).wants(note)).isTrue();
        assertThat(Query.of(new Topic<>("tins", String.class)).wants(note)).isFalse();
        assertThat(Query.of(CANS).named("can-1").wants(note)).isTrue();
        assertThat(Query.of(CANS).named("can-2").wants(note)).isFalse();
        assertThat(Query.of(CANS).by("amy").wants(note)).isTrue();
        assertThat(Query.of(CANS).by("bob").wants(note)).isFalse();
        assertThat(Query.of(CANS).since(note.written()).wants(note)).isTrue();
        assertThat(Query.of(CANS).since(note.written().plusNanos(1)).wants(note))
                .isFalse();
        assertThat(Query.of(CANS).within(3, HERE).wants(note)).isTrue();
        assertThat(Query.of(CANS).within(2.9, HERE).wants(note)).isFalse();
    }

    @Test
    void whatIsAboutNoPlaceIsNearNone() {
        var note = new Note<>(CANS, "can", "red", Optional.empty(), "amy", Instant.EPOCH, Duration.ofSeconds(1));
        assertThat(Query.of(CANS).within(1e9, HERE).wants(note)).isFalse();
    }

    @Test
    void newestComeFirstAndEquallyOldOnesByAuthor() {
        Stream<Note<String>> notes = Stream.of(
                note("bob", "b", 1, 0), note("zoe", "z", 3, 0), note("amy", "a", 1, 0), note("amy", "0", 2, 0));
        assertThat(Query.of(CANS).among(notes))
                .extracting(note -> note.author() + " " + note.name())
                .containsExactly("zoe z", "amy 0", "amy a", "bob b");
    }

    @Test
    void nonsenseIsRefusedWhereItIsMade() {
        assertThatThrownBy(() -> Query.of(CANS).newest(0)).hasMessageContaining("1 to 1000 notes, not '0'");
        assertThatThrownBy(() -> Query.of(CANS).newest(1_001)).hasMessageContaining("'1001'");
        assertThatThrownBy(() -> Query.of(CANS).within(Double.NaN, HERE)).hasMessageContaining("'NaN'");
        assertThatThrownBy(() -> Query.of(CANS).within(-1, HERE)).hasMessageContaining("'-1.0'");
        assertThatThrownBy(() -> Query.of(CANS).within(1, new Point2d(Double.NaN, 0)))
                .hasMessageContaining("NaN");
        assertThatThrownBy(() -> Query.of(CANS).named("n".repeat(201))).hasMessageContaining("up to 200");
        assertThatThrownBy(() -> note("amy", "can", 0, Double.NaN)).hasMessageContaining("position");
        assertThatThrownBy(() -> note("amy", " ", 0, 0)).hasMessageContaining("needs a topic and a name");
        Optional<Point2d> nowhere = Optional.empty();
        assertThatThrownBy(() -> new Note<>(
                        CANS, "can", "x".repeat(2_001), nowhere, "amy", Instant.EPOCH, Duration.ofSeconds(1)))
                .hasMessageContaining("has 2001 characters");
        assertThatThrownBy(() -> new Note<>(CANS, "can", "red", nowhere, "amy", Instant.EPOCH, Duration.ZERO))
                .hasMessageContaining("a year");
        @SuppressWarnings({"unchecked", "rawtypes"}) // as an agent with an error does
        Topic<Object> raw = (Topic) CANS;
        assertThatThrownBy(() -> new Note<>(raw, "can", 1, nowhere, "amy", Instant.EPOCH, Duration.ofSeconds(1)))
                .hasMessageContaining("carries String, not '1'");
    }
}
