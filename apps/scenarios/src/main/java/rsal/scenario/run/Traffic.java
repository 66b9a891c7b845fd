package rsal.scenario.run;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import rsal.agent.Message;

/// Counts what agents say and hear, by topic. Who heard what is recorded, and part of the event hash, where
/// communication is limited: else all hear all, and the counts are enough. All calls on the run's thread.
final class Traffic {
    private static final int MOST_TOPICS = 500;
    private static final String OTHERS = "…";

    private final Journal journal;
    private final Observer observer;
    private final Optional<Hearings> hearings;
    private final Map<String, Counts> topics = new HashMap<>();

    private static final class Counts {
        private final Map<Loss, Long> lost = new EnumMap<>(Loss.class);
        private long said;
        private long heard;
    }

    Traffic(Journal journal, Observer observer, boolean isLimited) {
        this.journal = journal;
        this.observer = observer;
        this.hearings = isLimited ? Optional.of(new Hearings()) : Optional.empty();
    }

    void said(Message<?> message) {
        observer.messageSaid();
        of(message).said++;
    }

    void heard(Message<?> message, String listener) {
        observer.messageHeard();
        of(message).heard++;
        if (hearings.isPresent()) {
            String topic = message.topic().name();
            journal.hash("heard", message.sender(), topic, listener);
            hearings.get().heard(message.sender(), listener, topic);
        }
    }

    void lost(Message<?> message, String listener, Loss why) {
        journal.hash("lost", message.sender(), message.topic().name(), listener);
        count(message, listener, why);
    }

    /// A message does not reach one whose robot is gone. That it is gone has its place in the event hash already.
    void unheard(Message<?> message, String listener) {
        count(message, listener, Loss.FAULT);
    }

    private void count(Message<?> message, String listener, Loss why) {
        observer.messageLost();
        of(message).lost.merge(why, 1L, Long::sum);
        hearings.ifPresent(
                all -> all.lost(message.sender(), listener, message.topic().name()));
    }

    private Counts of(Message<?> message) {
        String topic = message.topic().name();
        Counts known = topics.get(topic);
        if (known != null) {
            return known;
        }
        return topics.computeIfAbsent(topics.size() < MOST_TOPICS ? topic : OTHERS, _ -> new Counts());
    }

    /// What was said so far, by topic.
    List<TopicTraffic> topics() {
        var all = new ArrayList<TopicTraffic>();
        new TreeMap<>(topics)
                .forEach((topic, counts) -> all.add(new TopicTraffic(topic, counts.said, counts.heard, counts.lost)));
        return all;
    }

    /// Who heard what so far; nothing where communication is not limited.
    List<Hearing> hearings() {
        return hearings.map(Hearings::all).orElse(List.of());
    }

    /// What one agent heard and what was heard of it so far; nothing where communication is not limited.
    List<Hearing> hearings(String agent) {
        return hearings.map(all -> all.of(agent)).orElse(List.of());
    }
}
