package rsal.engine.event;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Duration;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.function.Supplier;
import rsal.agent.Message;
import rsal.agent.protocol.Act;
import rsal.data.Pose2d;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunObserver;
import rsal.engine.report.SentMessage;

/// What happened in a run: events to be read by any thread, and a hash over them and over all that only machines
/// care about. Written on the run's thread.
public final class EventLog {
    /// More are hashed but not kept, but for those that count most.
    static final int MOST_EVENTS = 100_000;

    /// How many of those that count most are kept beyond.
    static final int RESERVE = 10_000;

    private static final int WITNESSED_BYTES = 8;
    private static final Set<String> COUNT_MOST = Set.of("operator", "fault", "run");

    private final ConcurrentSkipListMap<Long, RunEvent> events = new ConcurrentSkipListMap<>();
    private final ChattyTopics routine = new ChattyTopics();
    private final Map<String, Long> kinds = new ConcurrentHashMap<>(); // how many events of each
    private final ByteBuffer numbers = ByteBuffer.allocate(4 * Long.BYTES);
    private final MessageDigest digest;
    private final Supplier<Duration> time;
    private final Runnable onEvent;
    private final Optional<RunObserver> observer;
    private String operator = ""; // who has ordered what is done now; empty when nobody knows
    private long sequence;
    private long happened; // events, with those that are not kept

    /// @param time since the run's start
    /// @param onEvent told of each new event
    public EventLog(Supplier<Duration> time, Runnable onEvent) {
        this(time, onEvent, Optional.empty());
    }

    /// @param observer gets each event and message
    public EventLog(Supplier<Duration> time, Runnable onEvent, Optional<RunObserver> observer) {
        this.time = time;
        this.onEvent = onEvent;
        this.observer = observer;
        try {
            this.digest = MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new AssertionError("Every Java has SHA-256.", e);
        }
    }

    /// Something that people may want to know.
    public void event(String kind, String subject, String text) {
        event(kind, subject, text, Optional.empty());
    }

    /// The same of something that somebody says to others.
    public void event(String kind, Message<?> message, String text) {
        event(kind, message.sender(), text, Optional.of(of(message, text)));
    }

    /// Carries out what somebody has ordered. Its events of the kind `operator` then say who.
    ///
    /// @param operator a name for people; empty when it is not known
    public <T> T by(String operator, Supplier<T> order) {
        String before = this.operator;
        this.operator = operator;
        try {
            return order.get();
        } finally {
            this.operator = before;
        }
    }

    /// Something that happens while an order is carried out, but not by it.
    public void byNobody(Runnable happening) {
        by("", () -> {
            happening.run();
            return Optional.empty();
        });
    }

    private void event(String kind, String subject, String words, Optional<SentMessage> said) {
        String text = kind.equals("operator") && !operator.isEmpty() ? "%s (by %s)".formatted(words, operator) : words;
        hash(kind, subject, text);
        kinds.merge(kind, 1L, Long::sum);
        if (sequence == MOST_EVENTS - 1) {
            keep("run", "", "Too many events: of some kinds no more are kept.", Optional.empty());
        }
        if (sequence < MOST_EVENTS + (COUNT_MOST.contains(kind) ? RESERVE : 0)) {
            keep(kind, subject, text, said);
        }
        happened++;
        observer.ifPresent(
                seen -> seen.happened(new RunEvent(happened, time.get(), kind, subject, text, said), hashSoFar()));
    }

    /// Something that is said all the time.
    public void routine(Message<?> message, String words) {
        hash(message.sender(), message.topic().name(), words);
        routine.said(of(message, words));
    }

    /// What is said all the time.
    public ChattyTopics routine() {
        return routine;
    }

    /// Something was said, in words for people.
    public void said(Message<?> message, String words) {
        Object content = message.content() instanceof Act act ? act.content() : message.content();
        observer.ifPresent(seen -> seen.heard(of(message, words), content));
    }

    private SentMessage of(Message<?> message, String words) {
        return message.content() instanceof Act act
                ? of(
                        message,
                        act.conversation(),
                        act.protocol(),
                        act.performative().toString(),
                        words)
                : of(message, "", "", "", words);
    }

    private SentMessage of(Message<?> message, String conversation, String protocol, String act, String words) {
        return new SentMessage(
                time.get(), message.sender(), message.to(), message.topic().name(), conversation, protocol, act, words);
    }

    /// As [RunObserver] has it.
    public String hashSoFar() {
        try {
            byte[] all = ((MessageDigest) digest.clone()).digest();
            return HexFormat.of().formatHex(all, 0, WITNESSED_BYTES);
        } catch (CloneNotSupportedException e) {
            throw new AssertionError("SHA-256 of the JDK can be copied.", e);
        }
    }

    private void keep(String kind, String subject, String text, Optional<SentMessage> said) {
        sequence++;
        events.put(sequence, new RunEvent(sequence, time.get(), kind, subject, text, said));
        onEvent.run();
    }

    /// Something that only counts for whether two runs are the same.
    public void hash(String... words) {
        numbers.clear().putLong(time.get().toNanos());
        digest.update(numbers.flip());
        for (String word : words) {
            byte[] bytes = word.getBytes(StandardCharsets.UTF_8);
            digest.update(numbers.clear().putInt(bytes.length).flip());
            digest.update(bytes);
        }
    }

    public void hash(Pose2d pose) {
        numbers.clear();
        numbers.putDouble(pose.x()).putDouble(pose.y()).putDouble(pose.theta());
        digest.update(numbers.flip());
    }

    /// The hash so far, in hexadecimal. Begins a new one.
    public String finish() {
        return HexFormat.of().formatHex(digest.digest());
    }

    /// How many events there were of each kind, those too that were not kept.
    public Map<String, Long> kinds() {
        return Map.copyOf(kinds);
    }

    public List<RunEvent> after(long sequence) {
        return List.copyOf(events.tailMap(sequence, false).values());
    }
}
