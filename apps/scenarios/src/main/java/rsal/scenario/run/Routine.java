package rsal.scenario.run;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/// What agents say all the time, as where they are, so that each of it is no event: the newest of each topic, for
/// people who ask for it.
final class Routine {
    /// How many messages of one topic are kept.
    static final int MOST_OF_A_TOPIC = 300;

    /// How many topics are kept: those that were said last.
    private static final int MOST_TOPICS = 32;

    private final Map<String, Deque<Said>> byTopic = Newest.touchedLast(MOST_TOPICS);

    void said(Said said) {
        Deque<Said> all = byTopic.computeIfAbsent(said.topic(), _ -> new ArrayDeque<>());
        all.addLast(said);
        if (all.size() > MOST_OF_A_TOPIC) {
            all.removeFirst();
        }
    }

    /// Which topics there are, each with nothing but the one that is wanted: that with all of it, oldest first.
    Map<String, List<Said>> of(String topic) {
        return byTopic.entrySet().stream()
                .collect(Collectors.toUnmodifiableMap(
                        Map.Entry::getKey,
                        said -> said.getKey().equals(topic) ? List.copyOf(said.getValue()) : List.of()));
    }

    /// Of each topic, oldest first.
    Map<String, List<Said>> all() {
        return byTopic.entrySet().stream()
                .collect(Collectors.toUnmodifiableMap(Map.Entry::getKey, said -> List.copyOf(said.getValue())));
    }
}
