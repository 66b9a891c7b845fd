package rsal.recording;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.DateTimeException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.agent.bdi.Mind;
import rsal.data.Pose2d;
import rsal.engine.report.MindChange;
import rsal.engine.report.Reading;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunResult;
import rsal.engine.report.SentMessage;
import rsal.engine.report.Snapshot;
import rsal.mcap.Channel;
import rsal.recording.proto.MessageType;
import rsal.recording.proto.MessageType.Kind;
import rsal.scenario.RunPlan;

/// A recorded run, to be seen as it was at any time. The file is read through once at the beginning; from then on what
/// was is found from the nearest of some places that are kept, at most [#MOST_KEPT] bytes of them.
///
/// All methods may be called from any thread.
public final class Playback implements Closeable {
    /// Of what is kept to begin from [B].
    static final long MOST_KEPT = 64L << 20;

    private static final Duration LONGEST = Duration.ofDays(10_000);
    private static final int RECENT = 8; // where viewers are
    private static final int MOST_EVENTS = 110_000; // as many as a live run keeps
    private static final int MOST_CHANGES = 100_000; // of minds
    private static final int LONGEST_TEXT = 10_000; // characters of an event

    private static final Mind.View NOTHING = new Mind.View(Map.of(), List.of());

    // enough of their fields to tell whom they are about
    private static final MessageType SECOND_TEXT =
            MessageType.named("rsal.About").with(2, "about", Kind.STRING);
    private static final MessageType TWO_TEXTS = SECOND_TEXT.with(3, "part", Kind.STRING);
    private static final MessageType SECOND_NUMBER =
            MessageType.named("rsal.About").with(2, "about", Kind.UINT64);

    private final Recording recording;
    private final RunPlan plan;
    private final Decoder decoder;
    private final Decoder aside; // of what is asked besides what is shown
    private final long start; // of the run, on its own clock, in ns
    private final List<RunEvent> events = new ArrayList<>();
    private final Map<String, List<MindChange>> changes = new HashMap<>(); // by topic and agent
    private final Map<String, Mind.View> newest = new HashMap<>(); // the same, while the file is read through
    private int changed; // how many of them there are
    private final ResumePoints places = new ResumePoints(MOST_KEPT);
    private final Map<Long, NewestRecords> recent = new LinkedHashMap<>(RECENT, 0.75f, true);
    private long[] states = new long[1 << 10]; // log times
    private int count; // of states

    private Playback(Recording recording, RunPlan plan, long start) {
        this.recording = recording;
        this.plan = plan;
        this.start = start;
        this.decoder = new Decoder(plan, Instant.EPOCH.plusNanos(start));
        this.aside = decoder.another();
    }

    /// Reads a recording through.
    ///
    /// @param recording whose this is from now on
    /// @throws rsal.settings.InvalidSettings when its scenario can't be read any more
    /// @throws IOException when it can't be read, or says more at once than can be held
    public static Playback of(Recording recording) throws IOException {
        RunPlan plan = recording.plan(false);
        long start = plan.clock() == RunPlan.Clock.SIMULATED ? 0 : started(recording);
        var playback = new Playback(recording, plan, start);
        recording.file().channels().forEach(playback::reads);
        playback.readThrough();
        playback.newest.clear();
        return playback;
    }

    private static long started(Recording recording) {
        try {
            Instant started = Instant.parse(recording.run().getOrDefault("started", ""));
            return started.getEpochSecond() * 1_000_000_000 + started.getNano();
        } catch (DateTimeException _) {
            return recording.file().start().orElse(0);
        }
    }

    private void reads(Channel channel) {
        recording
                .file()
                .schema(channel)
                .flatMap(schema -> ReadingType.of(schema.name(), channel.metadata()))
                .ifPresent(type -> decoder.reads(channel.topic(), type));
    }

    private void readThrough() throws IOException {
        var held = new NewestRecords();
        recording.file().read(Playback::isOfUse, (channel, _, logTime, publishTime, data) -> {
            if (places.isDue(logTime)) {
                places.keep(logTime - 1, held); // all before this message
            }
            switch (channel.topic()) {
                case ChannelNames.EVENTS -> event(logTime, data);
                case ChannelNames.STATE -> {
                    state(logTime);
                    take(held, channel, publishTime, data);
                }
                case ChannelNames.MINDS -> {
                    MessageFields fields = MessageFields.read(Own.MIND, data);
                    note(ChannelNames.about(ChannelNames.MINDS, fields.text("agent")), Decoder.mind(fields), logTime);
                    take(held, channel, publishTime, data);
                }
                case ChannelNames.AGENTS -> {
                    MessageFields fields = MessageFields.read(Own.AGENT, data);
                    note(ChannelNames.about(ChannelNames.AGENTS, fields.text("name")), Decoder.shown(fields), logTime);
                    take(held, channel, publishTime, data);
                }
                default -> take(held, channel, publishTime, data);
            }
        });
    }

    private void state(long logTime) {
        if (count > 0 && states[count - 1] == logTime) {
            return;
        }
        if (count == states.length) {
            states = Arrays.copyOf(states, 2 * count);
        }
        states[count++] = logTime;
    }

    private void event(long logTime, ByteBuffer data) throws IOException {
        if (events.size() >= MOST_EVENTS) {
            return;
        }
        MessageFields fields = MessageFields.read(Own.EVENT, data);
        Duration time = sinceStart(logTime);
        String subject = clip(fields.text("subject"));
        String text = clip(fields.text("text"));
        Optional<SentMessage> said = fields.within("said").map(about -> said(time, subject, about, text));
        events.add(new RunEvent(events.size() + 1L, time, clip(fields.text("kind")), subject, text, said));
    }

    /// @param about to whom it is said, and what kind of message it is
    private static SentMessage said(Duration time, String from, MessageFields about, String words) {
        return new SentMessage(
                time,
                from,
                about.text("to"),
                about.text("topic"),
                about.text("conversation"),
                about.text("protocol"),
                about.text("act"),
                words);
    }

    /// Notes what an agent believes and wants that it did not when it was recorded before.
    private void note(String key, Mind.View now, long logTime) {
        Mind.View before = newest.put(key, now);
        if (changed < MOST_CHANGES) {
            List<MindChange> news = MindChange.between(before == null ? NOTHING : before, now, sinceStart(logTime));
            changes.computeIfAbsent(key, _ -> new ArrayList<>()).addAll(news);
            changed += news.size();
        }
    }

    private static String clip(String text) {
        return text.length() <= LONGEST_TEXT ? text : text.substring(0, LONGEST_TEXT);
    }

    private static boolean isOfUse(Channel channel) {
        return switch (channel.topic()) {
            case "/tf", "/world", ChannelNames.LOG, "/map" -> false;
            default -> true;
        };
    }

    private static void take(NewestRecords held, Channel channel, long publishTime, ByteBuffer data)
            throws IOException {
        String topic = channel.topic();
        boolean fits = switch (topic) {
            case ChannelNames.EVENTS -> true; // known from the beginning
            case ChannelNames.MESSAGES -> {
                MessageFields fields = MessageFields.read(Own.MESSAGE, data);
                yield held.said(
                        fields.text("from"), clip(fields.text("topic") + ": " + fields.text("words")), publishTime);
            }
            case ChannelNames.ROBOTS, ChannelNames.AGENTS, ChannelNames.MINDS ->
                held.put(
                        ChannelNames.about(
                                topic, MessageFields.read(SECOND_TEXT, data).text("about")),
                        publishTime,
                        data);
            case ChannelNames.DEVICES -> {
                MessageFields about = MessageFields.read(TWO_TEXTS, data);
                yield held.put(Decoder.devices(about.text("about")) + about.text("part"), publishTime, data);
            }
            case ChannelNames.THINGS ->
                held.put(
                        ChannelNames.about(
                                topic,
                                Long.toString(
                                        MessageFields.read(SECOND_NUMBER, data).count("about"))),
                        publishTime,
                        data);
            default -> held.put(topic, publishTime, data);
        };
        if (!fits) {
            throw new IOException("Too much was recorded at one time: more than %d messages, or %d bytes."
                    .formatted(NewestRecords.MOST_MESSAGES, NewestRecords.MOST_BYTES));
        }
    }

    /// The run that was recorded.
    public RunPlan plan() {
        return plan;
    }

    /// How it was made, as [Recording#run] has it.
    public Map<String, String> run() {
        return recording.run();
    }

    /// What is wrong with the file, a sentence each.
    public synchronized List<String> damage() {
        return recording.file().damage();
    }

    /// How the run ended; empty when that was not recorded.
    public Optional<RunResult> result() {
        return RecordedOutcome.read(recording.result(), plan);
    }

    /// When the first state was recorded, since the run's start.
    public synchronized Duration from() {
        return count == 0 ? Duration.ZERO : sinceStart(states[0]);
    }

    /// When the last state was recorded, since the run's start.
    public synchronized Duration until() {
        return count == 0 ? Duration.ZERO : sinceStart(states[count - 1]);
    }

    private Duration sinceStart(long logTime) {
        return Duration.ofNanos(logTime - start);
    }

    /// What an agent came to believe and want until then, oldest first: as its mind was recorded, once a second, else
    /// what it showed of itself. Of the first 100,000 changes of all agents.
    public List<MindChange> changes(Duration until, String agent) {
        List<MindChange> shown = changes.getOrDefault(ChannelNames.about(ChannelNames.AGENTS, agent), List.of());
        return changes.getOrDefault(ChannelNames.about(ChannelNames.MINDS, agent), shown).stream()
                .takeWhile(change -> change.time().compareTo(until) <= 0)
                .toList();
    }

    /// All that agents said within some time, oldest first.
    ///
    /// @param from which does not belong to it
    public synchronized List<SentMessage> said(Duration from, Duration until) throws IOException {
        var all = new ArrayList<SentMessage>();
        recording
                .file()
                .read(
                        log(from) + 1,
                        log(until),
                        channel -> channel.topic().equals(ChannelNames.MESSAGES),
                        (_, _, logTime, _, data) -> {
                            MessageFields message = MessageFields.read(Own.MESSAGE, data);
                            all.add(said(
                                    sinceStart(logTime), message.text("from"), message, clip(message.text("words"))));
                        });
        return all;
    }

    /// What devices of a robot had told last.
    ///
    /// @param time since the run's start, when a state was recorded
    public record Reported(Duration time, List<Reading> readings) {
        public Reported {
            readings = List.copyOf(readings);
        }
    }

    /// What devices of a robot had told last, at the times within some when states were recorded, oldest first. What
    /// it takes long for holds up who wants to see something.
    ///
    /// @param from which does not belong to it
    /// @param spacing between them, at least
    public synchronized List<Reported> reported(String robot, Duration from, Duration until, Duration spacing)
            throws IOException {
        int next = count == 0 ? 0 : firstAfter(log(from));
        int end = count == 0 ? 0 : firstAfter(log(until));
        if (next >= end) {
            return List.of();
        }
        var publishing = new Telling(
                robot, next, end, spacing.toNanos(), held(states[next]).copy());
        recording
                .file()
                .read(
                        states[next] + 1,
                        states[end - 1],
                        channel -> isAbout(channel.topic(), robot),
                        (channel, _, logTime, publishTime, data) -> {
                            publishing.passTo(logTime);
                            take(publishing.held, channel, publishTime, data);
                        });
        publishing.passTo(Long.MAX_VALUE);
        return publishing.reported;
    }

    /// Where robots were.
    ///
    /// @param time since the run's start, when a state was recorded
    /// @param mapFromBases by robot: in truth where that is known, else as it believes, else where its stand-in is
    public record RobotPoses(Duration time, Map<String, Pose2d> mapFromBases) {
        public RobotPoses {
            mapFromBases = Map.copyOf(mapFromBases);
        }
    }

    /// Where robots were within some time, oldest first.
    ///
    /// @param from which does not belong to it
    /// @param spacing between them, at least
    public synchronized List<RobotPoses> poses(Duration from, Duration until, Duration spacing) throws IOException {
        var all = new ArrayList<RobotPoses>();
        recording
                .file()
                .read(
                        log(from) + 1,
                        log(until),
                        channel -> channel.topic().equals(ChannelNames.STATE),
                        (_, _, logTime, _, data) -> {
                            Duration time = sinceStart(logTime);
                            if (all.isEmpty()
                                    || time.minus(all.getLast().time()).compareTo(spacing) >= 0) {
                                all.add(new RobotPoses(time, Decoder.poses(MessageFields.read(Own.STATE, data))));
                            }
                        });
        return all;
    }

    /// Goes through states in their order: each is as it was when all that was recorded with it is there.
    private final class Telling {
        private final String robot;
        private final int end;
        private final long spacing;
        private final NewestRecords held;
        private final List<Reported> reported = new ArrayList<>();
        private int next; // which state
        private long last = Long.MIN_VALUE / 2; // log time of the one that was told

        Telling(String robot, int next, int end, long spacing, NewestRecords held) {
            this.robot = robot;
            this.next = next;
            this.end = end;
            this.spacing = spacing;
            this.held = held;
        }

        /// Before what was recorded then.
        void passTo(long logTime) {
            for (; next < end && states[next] < logTime; next++) {
                if (states[next] - last >= spacing) {
                    last = states[next];
                    Duration time = sinceStart(last);
                    reported.add(new Reported(time, aside.readings(held, time, robot)));
                }
            }
        }
    }

    /// Whether what devices of a robot told is, or depends on, what a topic is of.
    private static boolean isAbout(String topic, String robot) {
        return switch (topic) {
            case ChannelNames.STATE, ChannelNames.DEVICES -> true;
            default ->
                topic.startsWith(ChannelNames.of(robot, ""))
                        && !topic.equals(ChannelNames.of(robot, ChannelNames.PARTICLES))
                        && !topic.equals(ChannelNames.of(robot, ChannelNames.PATH))
                        && !topic.equals(ChannelNames.of(robot, ChannelNames.LOCAL_PATH));
        };
    }

    /// What happened, oldest first, numbered from 1.
    public List<RunEvent> events() {
        return Collections.unmodifiableList(events);
    }

    /// When a state was recorded, so many states after the last that was by a time, or before it.
    public synchronized Duration states(Duration time, int after) {
        return count == 0 ? Duration.ZERO : sinceStart(states[Math.clamp((long) newest(time) + after, 0, count - 1)]);
    }

    /// Number of the first state after that; of all when there is none.
    private int firstAfter(long logTime) {
        int found = Arrays.binarySearch(states, 0, count, logTime);
        return found >= 0 ? found + 1 : -found - 1;
    }

    /// Number of the newest state by then; of the first when there was none yet.
    private int newest(Duration time) {
        int found = Arrays.binarySearch(states, 0, count, log(time));
        return Math.max(0, found >= 0 ? found : -found - 2);
    }

    private long log(Duration time) {
        Duration known = time.compareTo(LONGEST) > 0 ? LONGEST : time;
        return start + (known.compareTo(LONGEST.negated()) < 0 ? LONGEST.negated() : known).toNanos();
    }

    /// How everything was when the newest state was recorded by then; of the first when there was none yet. It is
    /// paused, at speed 1, and has no outcome but at the end.
    public synchronized Snapshot at(Duration time) throws IOException {
        if (count == 0) {
            return decoder.nothing();
        }
        int state = newest(time);
        Optional<String> outcome = Optional.of(recording.result())
                .filter(_ -> state == count - 1)
                .flatMap(result -> Optional.ofNullable(result.get("outcome")));
        return decoder.snapshot(seen(states[state]), sinceStart(states[state]), outcome);
    }

    /// What an agent believed and wanted; empty when it did not show that.
    public synchronized Optional<Mind.View> mind(Duration time, String agent) throws IOException {
        return count == 0 ? Optional.empty() : decoder.mind(seen(states[newest(time)]), agent);
    }

    /// The same, from where a viewer is from now on.
    private NewestRecords seen(long logTime) throws IOException {
        NewestRecords held = held(logTime);
        recent.put(logTime, held);
        if (recent.size() > RECENT) {
            recent.remove(recent.keySet().iterator().next());
        }
        return held;
    }

    /// The newest of all that was recorded by then.
    private NewestRecords held(long logTime) throws IOException {
        long from = Long.MIN_VALUE;
        NewestRecords nearest = new NewestRecords();
        for (Map.Entry<Long, NewestRecords> place : recent.entrySet()) {
            if (place.getKey() <= logTime && place.getKey() > from) {
                from = place.getKey();
                nearest = place.getValue();
            }
        }
        Map.Entry<Long, NewestRecords> kept = places.before(logTime);
        if (kept != null && kept.getKey() > from) {
            from = kept.getKey();
            nearest = kept.getValue();
        }
        if (from == logTime) {
            return nearest;
        }
        NewestRecords held = nearest.copy();
        recording
                .file()
                .read(
                        from == Long.MIN_VALUE ? from : from + 1,
                        logTime,
                        Playback::isOfUse,
                        (channel, _, _, publishTime, data) -> take(held, channel, publishTime, data));
        return held;
    }

    @Override
    public synchronized void close() throws IOException {
        recording.close();
    }
}
