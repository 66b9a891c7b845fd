package rsal.engine.report;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.BinaryOperator;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rsal.time.Phase;

/// What a run has counted so far, for those who watch over the machine. All of it only grows. Different numbers may be
/// of different instants, some ms apart while the run goes on.
///
/// @param time that has passed in the run
/// @param steps how much real time steps of simulated time took, without waiting; empty in real time
/// @param phases real time that went into each, all of them
/// @param processors time of the processor that did, about
/// @param topics what was said, by topic
/// @param events how many there were of each kind, those too that are not kept
public record Performance(
        Duration time,
        Histogram steps,
        Map<Phase, Duration> phases,
        Map<Phase, Duration> processors,
        List<TopicTraffic> topics,
        Map<String, Long> events) {
    /// Of no run.
    public static final Performance NONE =
            new Performance(Duration.ZERO, Histogram.EMPTY, Map.of(), Map.of(), List.of(), Map.of());

    public Performance {
        phases = all(phases);
        processors = all(processors);
        topics = List.copyOf(topics);
        events = Collections.unmodifiableMap(new TreeMap<>(events));
    }

    /// Those of both runs together. Topics that only the other one has are `…` where this has as many as one counts.
    public Performance plus(Performance other) {
        return new Performance(
                time.plus(other.time),
                steps.plus(other.steps),
                both(phases, other.phases, Duration::plus),
                both(processors, other.processors, Duration::plus),
                new ArrayList<>(both(byTopic(topics), byTopic(other.topics(known())), TopicTraffic::plus)
                        .values()),
                both(events, other.events, Long::sum));
    }

    private static Map<Phase, Duration> all(Map<Phase, Duration> times) {
        var all = new EnumMap<Phase, Duration>(Phase.class);
        for (Phase phase : Phase.values()) {
            all.put(phase, times.getOrDefault(phase, Duration.ZERO));
        }
        return Collections.unmodifiableMap(all);
    }

    /// The topics that more may be said about; empty for any.
    private Set<String> known() {
        return topics.size() < TopicTraffic.MOST_TOPICS
                ? Set.of()
                : topics.stream().map(TopicTraffic::topic).collect(Collectors.toSet());
    }

    private List<TopicTraffic> topics(Set<String> known) {
        return topics.stream()
                .map(one -> known.isEmpty() || known.contains(one.topic()) ? one : one.named(TopicTraffic.OTHERS))
                .toList();
    }

    private static Map<String, TopicTraffic> byTopic(List<TopicTraffic> topics) {
        return topics.stream().collect(Collectors.toMap(TopicTraffic::topic, topic -> topic, TopicTraffic::plus));
    }

    private static <K extends Comparable<K>, V> Map<K, V> both(Map<K, V> one, Map<K, V> other, BinaryOperator<V> plus) {
        return Stream.of(one, other)
                .flatMap(map -> map.entrySet().stream())
                .collect(Collectors.toMap(Map.Entry::getKey, Map.Entry::getValue, plus, TreeMap::new));
    }
}
