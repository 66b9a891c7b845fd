package rsal.engine.report;

import java.util.Collections;
import java.util.EnumMap;
import java.util.Map;

/// How much was said about a topic, and what became of it.
///
/// @param topic its name; `…` for all together of which there were too many to count each
/// @param said how many messages
/// @param heard how often one of them reached an agent that listened
/// @param lost how often one did not, by why; what never happened is left out
public record TopicTraffic(String topic, long said, long heard, Map<LossReason, Long> lost) {
    /// How many topics are counted each.
    public static final int MOST_TOPICS = 500;

    /// The name of all others together.
    public static final String OTHERS = "…";

    public TopicTraffic {
        var copy = new EnumMap<LossReason, Long>(LossReason.class);
        copy.putAll(lost);
        lost = Collections.unmodifiableMap(copy);
    }

    TopicTraffic named(String other) {
        return new TopicTraffic(other, said, heard, lost);
    }

    /// This and what was said about the topic elsewhere.
    TopicTraffic plus(TopicTraffic other) {
        var all = new EnumMap<LossReason, Long>(LossReason.class);
        all.putAll(lost);
        other.lost.forEach((why, times) -> all.merge(why, times, Long::sum));
        return new TopicTraffic(topic, said + other.said, heard + other.heard, all);
    }
}
