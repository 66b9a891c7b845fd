package rsal.agent.board;

import java.time.Instant;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import rsal.agent.Topic;
import rsal.data.Point2d;

/// Which notes of a topic somebody wants: `Query.of(VICTIMS).within(5, here).newest(3)`. The newest come first; of
/// equally old ones, those of the first author by name.
///
/// @param name only notes of that name; empty for all
/// @param author only notes of that agent; empty for all
/// @param since only notes written then or later; empty for all
/// @param near only notes about places around there; empty for all
/// @param most how many at most, from 1 to 1,000
public record Query<M>(
        Topic<M> topic,
        Optional<String> name,
        Optional<String> author,
        Optional<Instant> since,
        Optional<Near> near,
        int most) {
    /// How many notes one may ask for at once.
    public static final int MOST = 1_000;

    private static final Comparator<Note<?>> NEWEST = Comparator.<Note<?>, Instant>comparing(Note::written)
            .reversed()
            .thenComparing(Note::author)
            .thenComparing(Note::name);

    public Query {
        if (name.orElse("").length() > Note.LONGEST_NAME || author.orElse("").length() > Note.LONGEST_NAME) {
            throw new IllegalArgumentException("Names have up to %d characters, not those in '%s' and '%s'."
                    .formatted(Note.LONGEST_NAME, name, author));
        }
        if (most < 1 || most > MOST) {
            throw new IllegalArgumentException("A query can ask for 1 to %d notes, not '%d'.".formatted(MOST, most));
        }
    }

    /// All notes of a topic, up to a hundred.
    public static <M> Query<M> of(Topic<M> topic) {
        return new Query<>(topic, Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty(), 100);
    }

    public Query<M> named(String wanted) {
        return new Query<>(topic, Optional.of(wanted), author, since, near, most);
    }

    public Query<M> by(String agent) {
        return new Query<>(topic, name, Optional.of(agent), since, near, most);
    }

    public Query<M> since(Instant earliest) {
        return new Query<>(topic, name, author, Optional.of(earliest), near, most);
    }

    /// @param distance [m]
    public Query<M> within(double distance, Point2d mapFromCenter) {
        return new Query<>(topic, name, author, since, Optional.of(new Near(distance, mapFromCenter)), most);
    }

    public Query<M> newest(int count) {
        return new Query<>(topic, name, author, since, near, count);
    }

    /// Whether it wants that note, if there are not too many.
    public boolean wants(Note<?> note) {
        return note.topic().equals(topic)
                && name.map(note.name()::equals).orElse(true)
                && author.map(note.author()::equals).orElse(true)
                && since.map(earliest -> !note.written().isBefore(earliest)).orElse(true)
                && near.map(around -> note.mapFromPlace().filter(around::holds).isPresent())
                        .orElse(true);
    }

    /// Those that it wants, the newest first, too many or not.
    List<Note<M>> among(Stream<? extends Note<?>> notes) {
        return notes.filter(this::wants).sorted(NEWEST).map(this::typed).toList();
    }

    @SuppressWarnings("unchecked") // of this very topic, and made with content of its type
    Note<M> typed(Note<?> wanted) {
        return (Note<M>) wanted;
    }

    /// `victims of scout-1, at most 3`
    @Override
    public String toString() {
        return topic.name()
                + name.map("/"::concat).orElse("")
                + author.map(" of "::concat).orElse("")
                + since.map(earliest -> " since " + earliest).orElse("")
                + near.map(around -> " within " + around).orElse("")
                + ", at most " + most;
    }

    /// Around a place.
    ///
    /// @param distance [m], finite and not negative
    public record Near(double distance, Point2d mapFromCenter) {
        public Near {
            boolean isThere = Double.isFinite(mapFromCenter.x()) && Double.isFinite(mapFromCenter.y());
            if (!(distance >= 0 && distance < Double.POSITIVE_INFINITY) || !isThere) {
                throw new IllegalArgumentException(
                        "Notes can't be within '%s' m of '%s'.".formatted(distance, mapFromCenter));
            }
        }

        boolean holds(Point2d mapFromPlace) {
            return mapFromPlace.distanceTo(mapFromCenter) <= distance;
        }

        /// `5.0 m of (1.0, 2.0)`
        @Override
        public String toString() {
            return "%s m of (%s, %s)".formatted(distance, mapFromCenter.x(), mapFromCenter.y());
        }
    }
}
