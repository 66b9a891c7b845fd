package rsal.ros2.bag;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.ToLongFunction;
import rsal.ros2.bag.BagFile.Topic;

/// What topics a file has, by how it numbers them. One that a publisher has left and another has opened again has two
/// numbers.
///
/// @param <K> a number
final class BagTopics<K> {
    private final Map<K, Topic> byKey = new HashMap<>();

    void put(K key, Topic topic) {
        byKey.put(key, topic);
    }

    int size() {
        return byKey.size();
    }

    Optional<Topic> get(K key) {
        return Optional.ofNullable(byKey.get(key));
    }

    /// Each once.
    List<Topic> distinct() {
        return byKey.values().stream().distinct().toList();
    }

    /// How many messages a topic has.
    ///
    /// @param messages of one number
    long count(Topic topic, ToLongFunction<K> messages) {
        return byKey.entrySet().stream()
                .filter(entry -> entry.getValue().equals(topic))
                .mapToLong(entry -> messages.applyAsLong(entry.getKey()))
                .sum();
    }

    Map<K, Topic> chosen(Predicate<Topic> wanted) {
        var chosen = new HashMap<>(byKey);
        chosen.values().removeIf(wanted.negate());
        return chosen;
    }
}
