package rsal.engine.communication;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import rsal.agent.Message;
import rsal.engine.event.EventLog;
import rsal.engine.metric.MetricsObserver;
import rsal.engine.report.LossReason;
import rsal.engine.report.Reception;
import rsal.engine.report.TopicTraffic;

/// Counts what agents say and hear, by topic. Who heard what is recorded, and part of the event hash, where
/// communication is limited: else all hear all, and the counts are enough. All calls on the run's thread, but for
/// [#topics], which any may ask for.
public final class Traffic {
    private final EventLog eventLog;
    private final MetricsObserver observer;
    private final Optional<ReceptionCounts> hearings;
    private final Map<String, Counts> topics = new ConcurrentHashMap<>();

    private static final class Counts {
        private final AtomicLong said = new AtomicLong();
        private final AtomicLong heard = new AtomicLong();
        private final Map<LossReason, AtomicLong> lost = new EnumMap<>(LossReason.class);

        Counts() {
            for (LossReason why : LossReason.values()) {
                lost.put(why, new AtomicLong());
            }
        }

        void said() {
            addOne(said);
        }

        void heard() {
            addOne(heard);
        }

        void lost(LossReason why) {
            addOne(Objects.requireNonNull(lost.get(why))); // each has one
        }

        private static void addOne(AtomicLong count) {
            count.setRelease(count.getPlain() + 1); // nobody else writes
        }

        TopicTraffic of(String topic) {
            var happened = new EnumMap<LossReason, Long>(LossReason.class);
            lost.forEach((why, count) -> happened.put(why, count.get()));
            happened.values().removeIf(times -> times == 0);
            return new TopicTraffic(topic, said.get(), heard.get(), happened);
        }
    }

    public Traffic(EventLog eventLog, MetricsObserver observer, boolean isLimited) {
        this.eventLog = eventLog;
        this.observer = observer;
        this.hearings = isLimited ? Optional.of(new ReceptionCounts()) : Optional.empty();
    }

    public void said(Message<?> message) {
        observer.messageSaid(message.topic().name());
        of(message).said();
    }

    void heard(Message<?> message, String listener) {
        observer.messageHeard(message.topic().name());
        of(message).heard();
        if (hearings.isPresent()) {
            String topic = message.topic().name();
            eventLog.hash("heard", message.sender(), topic, listener);
            hearings.get().heard(message.sender(), listener, topic);
        }
    }

    void lost(Message<?> message, String listener, LossReason why) {
        eventLog.hash("lost", message.sender(), message.topic().name(), listener);
        count(message, listener, why);
    }

    /// A message does not reach one whose robot is gone. That it is gone has its place in the event hash already.
    void unheard(Message<?> message, String listener) {
        count(message, listener, LossReason.FAULT);
    }

    private void count(Message<?> message, String listener, LossReason why) {
        observer.messageLost(message.topic().name());
        of(message).lost(why);
        hearings.ifPresent(
                all -> all.lost(message.sender(), listener, message.topic().name()));
    }

    private Counts of(Message<?> message) {
        String topic = message.topic().name();
        Counts known = topics.get(topic);
        if (known != null) {
            return known;
        }
        return topics.computeIfAbsent(
                topics.size() < TopicTraffic.MOST_TOPICS ? topic : TopicTraffic.OTHERS, _ -> new Counts());
    }

    /// What was said so far, by topic.
    public List<TopicTraffic> topics() {
        var all = new ArrayList<TopicTraffic>();
        new TreeMap<>(topics).forEach((topic, counts) -> all.add(counts.of(topic)));
        return all;
    }

    /// Who heard what so far; nothing where communication is not limited.
    public List<Reception> hearings() {
        return hearings.map(ReceptionCounts::all).orElse(List.of());
    }

    /// What one agent heard and what was heard of it so far; nothing where communication is not limited.
    public List<Reception> hearings(String agent) {
        return hearings.map(all -> all.of(agent)).orElse(List.of());
    }
}
