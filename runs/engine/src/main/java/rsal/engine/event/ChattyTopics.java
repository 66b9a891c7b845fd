package rsal.engine.event;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rsal.engine.report.SentMessage;

/// What agents say all the time, as where they are, so that each of it is no event: the newest of each topic, and what
/// was said before, for people who ask for it. Of what was before at most so many bytes are kept. When it is more, each
/// sender's messages of a topic are thinned, ever more, so that it reaches back to the beginning and what is said
/// seldom stays. For one thread, and for others once nothing more is said.
public final class ChattyTopics {
    /// How many messages of one topic are kept as the newest.
    static final int MOST_OF_A_TOPIC = 300;

    /// Of what was before, where somebody may look back.
    static final long MOST_BYTES = 16L << 20;

    /// The same, else.
    static final long FEW_BYTES = 128L << 10;

    /// How many topics are kept: those that were said last.
    private static final int MOST_TOPICS = 32;

    private static final Duration FIRST_SPACING = Duration.ofMillis(250);
    private static final int MESSAGE = 160; // bytes, but for its words

    private final Map<String, About> byTopic = NewestByName.touchedLast(MOST_TOPICS);
    private volatile long most = FEW_BYTES;
    private Duration spacing = Duration.ZERO; // of one sender's messages of a topic

    /// What was said of one topic, oldest first.
    private static final class About {
        private final Deque<SentMessage> newest = new ArrayDeque<>();
        private List<SentMessage> all = new ArrayList<>(); // with these, as far as they are not thinned
        private final Map<String, Duration> last = new HashMap<>(); // of these, by sender
        private long bytes;

        void keep(SentMessage said, Duration spacing) {
            Duration before = last.get(said.from());
            if (before == null || said.time().minus(before).compareTo(spacing) >= 0) {
                last.put(said.from(), said.time());
                all.add(said);
                bytes += MESSAGE + said.words().length();
            }
        }

        void thin(Duration spacing) {
            List<SentMessage> before = all;
            all = new ArrayList<>();
            last.clear();
            bytes = 0;
            before.forEach(said -> keep(said, spacing));
        }

        void forget() {
            all = new ArrayList<>();
            last.clear();
            bytes = 0;
        }

        /// @param from which does not belong to it
        List<SentMessage> within(Duration from, Duration until) {
            return Stream.concat(all.stream().takeWhile(said -> isBefore(said, newest.getFirst())), newest.stream())
                    .filter(said ->
                            said.time().compareTo(from) > 0 && said.time().compareTo(until) <= 0)
                    .toList();
        }

        private static boolean isBefore(SentMessage one, SentMessage other) {
            return one.time().compareTo(other.time()) < 0;
        }
    }

    /// From now on people may look back on it. From any thread.
    public void remember() {
        most = MOST_BYTES;
    }

    void said(SentMessage said) {
        About about = byTopic.computeIfAbsent(said.topic(), _ -> new About());
        about.newest.addLast(said);
        if (about.newest.size() > MOST_OF_A_TOPIC) {
            about.newest.removeFirst();
        }
        about.keep(said, spacing);
        while (bytes() > most) {
            thin(said.time());
        }
    }

    private void thin(Duration now) {
        if (spacing.compareTo(now) > 0) { // so many said something
            byTopic.values().forEach(About::forget);
            spacing = Duration.ZERO;
            return;
        }
        spacing = spacing.isZero() ? FIRST_SPACING : spacing.multipliedBy(2);
        byTopic.values().forEach(about -> about.thin(spacing));
    }

    /// What is kept of what was before takes, about.
    long bytes() {
        long bytes = 0;
        for (About about : byTopic.values()) {
            bytes += about.bytes;
        }
        return bytes;
    }

    /// Which topics there are, each with nothing but the one that is wanted: that with the newest of it, oldest first.
    public Map<String, List<SentMessage>> of(String topic) {
        return byTopic.entrySet().stream()
                .collect(Collectors.toUnmodifiableMap(
                        Map.Entry::getKey,
                        about -> about.getKey().equals(topic) ? List.copyOf(about.getValue().newest) : List.of()));
    }

    /// The same of what was said by a time, not long before it.
    ///
    /// @param shortly before the time, or as long as it takes until each has said something that is kept
    public Map<String, List<SentMessage>> of(String topic, Duration until, Duration shortly) {
        Duration from = until.minus(shortly.compareTo(spacing) < 0 ? spacing : shortly);
        return byTopic.entrySet().stream()
                .collect(Collectors.toUnmodifiableMap(
                        Map.Entry::getKey,
                        about -> about.getKey().equals(topic) ? about.getValue().within(from, until) : List.of()));
    }
}
