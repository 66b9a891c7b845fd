package rsal.engine.metric;

import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/// Counts messages: all of them, and those of each topic that somebody asks for.
final class MessageCounts {
    private static final class Count {
        private long messages;
    }

    private final Map<String, Count> topics = new HashMap<>();
    private long all;

    /// @param topics that are asked for
    MessageCounts(Collection<String> topics) {
        topics.forEach(topic -> this.topics.put(topic, new Count()));
    }

    void add(String topic) {
        all++;
        Count count = topics.get(topic);
        if (count != null) {
            count.messages++;
        }
    }

    /// Of one topic, or of all without one. 0 for a topic that nobody asks for.
    ///
    /// @param names a topic, or nothing
    long of(List<String> names) {
        if (names.isEmpty()) {
            return all;
        }
        Count count = topics.get(names.getFirst());
        return count == null ? 0 : count.messages;
    }
}
