package rsal.scenario.run;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import rsal.agent.Message;

/// What reached each agent lately, for people to read: the newest of each topic, so that poses at 10 Hz do not push out
/// the one request. Words are made only for those who ask.
final class Mailboxes {
    /// How many messages of one topic are kept for an agent.
    static final int MOST_OF_A_TOPIC = 8;

    /// How many topics are kept for an agent: those heard of last.
    static final int MOST_TOPICS = 32;

    /// How many agents' are kept: of those that heard something last.
    private static final int MOST_AGENTS = 4_000;

    private final Instant began;
    private final Map<String, Map<String, Newest>> byAgent = newestOf(MOST_AGENTS); // and topic
    private long arrived;

    /// The newest messages of one topic.
    private static final class Newest {
        private final @Nullable Letter[] letters = new Letter[MOST_OF_A_TOPIC];
        private int next;

        void add(Letter letter) {
            letters[next] = letter;
            next = (next + 1) % letters.length;
        }

        void addTo(List<Letter> all) {
            for (Letter letter : letters) {
                if (letter != null) {
                    all.add(letter);
                }
            }
        }
    }

    /// @param number by which those that arrived earlier come before
    private record Letter(long number, Message<?> message) {}

    /// @param began when the run did
    Mailboxes(Instant began) {
        this.began = began;
    }

    void heard(Message<?> message, String listener) {
        byAgent.computeIfAbsent(listener, _ -> newestOf(MOST_TOPICS))
                .computeIfAbsent(message.topic().name(), _ -> new Newest())
                .add(new Letter(arrived++, message));
    }

    /// What reached an agent, oldest first.
    List<Mail> of(String agent) {
        var letters = new ArrayList<Letter>();
        byAgent.getOrDefault(agent, new HashMap<>()).values().forEach(newest -> newest.addTo(letters));
        letters.sort(Comparator.comparingLong(Letter::number));
        return letters.stream().map(letter -> mail(letter.message())).toList();
    }

    private Mail mail(Message<?> message) {
        return new Mail(
                Duration.between(began, message.time()),
                message.sender(),
                message.isForAll(),
                message.topic().name(),
                Words.clipped(message));
    }

    /// What was touched last stays.
    private static <V> Map<String, V> newestOf(int most) {
        return new LinkedHashMap<>(16, 0.75f, true) {
            @Override
            protected boolean removeEldestEntry(Map.Entry<String, V> eldest) {
                return size() > most;
            }
        };
    }
}
