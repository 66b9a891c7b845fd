package rsal.agent.board;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import rsal.agent.Topic;
import rsal.data.Point2d;

/// Something that an agent wants its team to know for a while.
///
/// @param name up to 200 characters; a newer note of the same author under the same topic and name replaces it
/// @param content immutable; its words have up to 2,000 characters
/// @param mapFromPlace where it is about; empty when it is about no place
/// @param author name of the agent that wrote it
/// @param written when its author wrote it
/// @param lifetime how long it counts; up to a year
public record Note<M>(
        Topic<M> topic,
        String name,
        M content,
        Optional<Point2d> mapFromPlace,
        String author,
        Instant written,
        Duration lifetime) {
    static final int LONGEST_NAME = 200;
    static final int MOST_WORDS = 2_000;
    static final Duration LONGEST = Duration.ofDays(366);

    public Note {
        checkName(topic, name);
        if (!topic.type().isInstance(content)) {
            throw new IllegalArgumentException("Topic '%s' carries %s, not '%s'."
                    .formatted(topic.name(), topic.type().getSimpleName(), content));
        }
        int words = String.valueOf(content).length();
        if (words > MOST_WORDS) {
            throw new IllegalArgumentException(
                    "Note '%s/%s' has %d characters; the maximum is %d. Maybe share where others can get it."
                            .formatted(topic.name(), name, words, MOST_WORDS));
        }
        mapFromPlace.ifPresent(place -> {
            if (!Double.isFinite(place.x()) || !Double.isFinite(place.y())) {
                throw new IllegalArgumentException(
                        "Note '%s/%s' can't have the position '%s'.".formatted(topic.name(), name, place));
            }
        });
        if (!lifetime.isPositive() || lifetime.compareTo(LONGEST) > 0) {
            throw new IllegalArgumentException("Note '%s/%s' can't be kept for '%s'; the maximum is a year."
                    .formatted(topic.name(), name, lifetime));
        }
    }

    static void checkName(Topic<?> topic, String name) {
        if (name.isBlank() || name.length() > LONGEST_NAME || topic.name().length() > LONGEST_NAME) {
            throw new IllegalArgumentException(
                    "A note needs a topic and a name of up to %d characters, not '%s' and '%s'."
                            .formatted(LONGEST_NAME, topic.name(), name));
        }
    }

    /// When it is forgotten.
    public Instant fades() {
        return written.plus(lifetime);
    }

    boolean hasFaded(Instant now) {
        return !now.isBefore(fades());
    }

    Key key() {
        return new Key(author, Name.of(topic, name));
    }

    /// `victims/victim-3 of scout-1: ...`
    @Override
    public String toString() {
        return "%s/%s of %s: %s".formatted(topic.name(), name, author, content);
    }

    /// What its author calls it.
    record Name(String topic, String name) {
        static Name of(Topic<?> topic, String name) {
            return new Name(topic.name(), name);
        }

        @Override
        public String toString() {
            return topic + "/" + name;
        }
    }

    /// By what a board knows it.
    record Key(String author, Name name) {}
}
