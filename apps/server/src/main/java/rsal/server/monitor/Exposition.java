package rsal.server.monitor;

import io.javalin.http.Context;
import io.prometheus.metrics.expositionformats.PrometheusTextFormatWriter;
import io.prometheus.metrics.model.snapshots.ClassicHistogramBuckets;
import io.prometheus.metrics.model.snapshots.HistogramSnapshot;
import io.prometheus.metrics.model.snapshots.HistogramSnapshot.HistogramDataPointSnapshot;
import io.prometheus.metrics.model.snapshots.InfoSnapshot;
import io.prometheus.metrics.model.snapshots.InfoSnapshot.InfoDataPointSnapshot;
import io.prometheus.metrics.model.snapshots.Labels;
import io.prometheus.metrics.model.snapshots.MetricSnapshot;
import io.prometheus.metrics.model.snapshots.MetricSnapshots;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.time.Duration;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import java.util.function.ToLongFunction;
import java.util.stream.Stream;
import rsal.agent.platform.AgentPlatform;
import rsal.engine.report.Histogram;
import rsal.engine.report.LossReason;
import rsal.engine.report.Performance;
import rsal.engine.report.Snapshot;
import rsal.engine.report.TopicTraffic;
import rsal.recording.Recorder;
import rsal.scenario.RunPlan;
import rsal.server.live.CurrentRun;
import rsal.server.live.CurrentRun.Numbered;
import rsal.server.live.Live;
import rsal.server.live.ViewerCounts;
import rsal.server.live.ViewerCounts.Kind;
import rsal.server.live.ViewerCounts.Reason;
import rsal.server.monitor.Family.Sample;
import rsal.time.Phase;

/// What Prometheus is shown at `/metrics`: numbers that are there anyway, read when it asks, on any thread. It never
/// waits for the run. Counters go on from run to run; the rest is of the run that is shown.
public final class Exposition {
    private static final PrometheusTextFormatWriter WRITER = PrometheusTextFormatWriter.create();

    /// Kinds of events that are there before the first, so that who watches for one sees it come.
    private static final List<String> AWAITED = List.of("collision", "fault");

    private final CurrentRun current;
    private final Live live;
    private final LongSupplier historyBytes;
    private final Supplier<Optional<Recorder.Tally>> recorded;

    /// @param historyBytes what looking back on the run takes
    /// @param recorded as [rsal.server.RunServer.Options] has it
    public Exposition(
            CurrentRun current, Live live, LongSupplier historyBytes, Supplier<Optional<Recorder.Tally>> recorded) {
        this.current = current;
        this.live = live;
        this.historyBytes = historyBytes;
        this.recorded = recorded;
    }

    public void answer(Context request) throws IOException {
        Numbered now = current.now();
        var all = Stream.of(
                        run(now),
                        counted(now.performance()),
                        viewers(live.counts()),
                        recorded.get().stream().flatMap(Exposition::recordings),
                        ProcessMetrics.all())
                .flatMap(families -> families)
                .toList();
        var text = new ByteArrayOutputStream();
        WRITER.write(text, new MetricSnapshots(all));
        request.contentType(WRITER.getContentType()).result(text.toByteArray());
    }

    private static Stream<MetricSnapshot> run(Numbered now) {
        Snapshot snapshot = now.run().snapshot();
        long gone = snapshot.robots().stream().filter(robot -> robot.gone()).count();
        return Stream.of(
                info(now),
                Family.counter("rsal_runs_total", "Runs that were started.", now.number()),
                Family.gauge(
                        "rsal_run_time_seconds",
                        "Time since the run's start: simulated, or real where its clock is.",
                        Family.seconds(snapshot.time())),
                Family.gauge("rsal_run_speed_ratio", "The run's time over real time, as measured.", snapshot.rate()),
                Family.gauge(
                        "rsal_run_wanted_speed_ratio",
                        "The run's time over real time, as asked for; +Inf is as fast as it can.",
                        snapshot.speed()),
                Family.gauge("rsal_run_paused", "Whether time stands still.", snapshot.paused()),
                Family.gauge("rsal_run_ended", "Whether the run is over.", now.isOver()),
                Family.gauge("rsal_run_emergency_stop", "Whether the emergency stop holds.", snapshot.stopped()),
                Family.gauge(
                        "rsal_robots",
                        "Robots of the run; those are gone that a fault took away.",
                        List.of(
                                Sample.of(snapshot.robots().size() - gone, "state", "present"),
                                Sample.of(gone, "state", "gone"))),
                Family.gauge(
                        "rsal_agents",
                        "Agents of the run.",
                        each(AgentPlatform.Status.class, "status", status -> agents(snapshot, status))));
    }

    private static MetricSnapshot info(Numbered now) {
        RunPlan plan = now.run().plan();
        var labels = Labels.of(
                "run",
                Integer.toString(now.number()),
                "scenario",
                plan.scenario().name(),
                "configuration",
                plan.configuration(),
                "seed",
                Long.toString(plan.seed()),
                "clock",
                Family.word(plan.clock()));
        return InfoSnapshot.builder()
                .name("rsal_run_info")
                .help("The run that is shown.")
                .dataPoint(InfoDataPointSnapshot.builder().labels(labels).build())
                .build();
    }

    private static long agents(Snapshot snapshot, AgentPlatform.Status status) {
        return snapshot.agents().stream()
                .filter(agent -> agent.view().status() == status)
                .count();
    }

    private static List<Sample> byPhase(Map<Phase, Duration> times) {
        return times.entrySet().stream()
                .map(phase -> Sample.of(Family.seconds(phase.getValue()), "phase", Family.word(phase.getKey())))
                .toList();
    }

    private static Stream<MetricSnapshot> counted(Performance performance) {
        List<TopicTraffic> topics = performance.topics();
        var events = new TreeMap<>(performance.events());
        AWAITED.forEach(kind -> events.putIfAbsent(kind, 0L));
        return Stream.of(
                Family.counter(
                        "rsal_simulated_seconds_total",
                        "Time that went by in all runs: simulated, or real where their clock is.",
                        Family.seconds(performance.time())),
                steps(performance.steps()),
                Family.counter(
                        "rsal_phase_seconds_total",
                        "Real time that the thread of the run spent in each phase.",
                        byPhase(performance.phases())),
                Family.counter(
                        "rsal_phase_cpu_seconds_total",
                        "Processor time that the thread of the run spent in each phase, about: one phase in 31 is measured.",
                        byPhase(performance.processors())),
                Family.counter(
                        "rsal_messages_said_total", "Messages that agents said.", byTopic(topics, TopicTraffic::said)),
                Family.counter(
                        "rsal_messages_heard_total",
                        "How often a message reached an agent that listened.",
                        byTopic(topics, TopicTraffic::heard)),
                Family.counter(
                        "rsal_messages_lost_total",
                        "How often a message did not reach an agent that listened.",
                        topics.stream().flatMap(Exposition::lost).toList()),
                Family.counter(
                        "rsal_events_total",
                        "Events by kind, as the page lists them.",
                        events.entrySet().stream()
                                .map(kind -> Sample.of(kind.getValue(), "kind", kind.getKey()))
                                .toList()));
    }

    private static MetricSnapshot steps(Histogram steps) {
        double[] bounds = Stream.concat(
                        Histogram.BOUNDS.stream().map(Family::seconds), Stream.of(Double.POSITIVE_INFINITY))
                .mapToDouble(Double::doubleValue)
                .toArray();
        long[] counts = steps.counts().stream().mapToLong(Long::longValue).toArray();
        return HistogramSnapshot.builder()
                .name("rsal_step_duration_seconds")
                .help("Real time that a step of simulated time took, without waiting.")
                .dataPoint(HistogramDataPointSnapshot.builder()
                        .classicHistogramBuckets(ClassicHistogramBuckets.of(bounds, counts))
                        .sum(Family.seconds(steps.sum()))
                        .build())
                .build();
    }

    private static List<Sample> byTopic(List<TopicTraffic> topics, ToLongFunction<TopicTraffic> count) {
        return topics.stream()
                .map(topic -> Sample.of(count.applyAsLong(topic), "topic", topic.topic()))
                .toList();
    }

    private static Stream<Sample> lost(TopicTraffic topic) {
        Map<LossReason, Long> lost = topic.lost();
        return Arrays.stream(LossReason.values())
                .map(why -> Sample.of(lost.getOrDefault(why, 0L), "topic", topic.topic(), "reason", Family.word(why)));
    }

    private Stream<MetricSnapshot> viewers(ViewerCounts counts) {
        return Stream.of(
                Family.gauge("rsal_viewers", "Browsers that watch.", live.viewers()),
                Family.counter("rsal_viewer_connections_total", "Browsers that came to watch.", counts.came()),
                Family.counter(
                        "rsal_viewers_let_go_total",
                        "Browsers that the server let go.",
                        each(Reason.class, "reason", counts::gone)),
                Family.counter(
                        "rsal_viewer_messages_total",
                        "Messages that were sent to browsers.",
                        each(Kind.class, "kind", counts::messages)),
                Family.counter(
                        "rsal_viewer_bytes_total",
                        "Size of the messages that were sent to browsers.",
                        each(Kind.class, "kind", counts::bytes)),
                Family.counter(
                        "rsal_viewer_skipped_frames_total",
                        "Frames that a browser was not sent, as it had not taken those before.",
                        counts.skippedFrames()),
                Family.gauge("rsal_history_bytes", "Memory for looking back on the run.", historyBytes.getAsLong()));
    }

    private static Stream<MetricSnapshot> recordings(Recorder.Tally tally) {
        return Stream.of(
                Family.counter("rsal_recording_bytes_total", "Size of what was written to recordings.", tally.bytes()),
                Family.counter(
                        "rsal_recording_dropped_states_total",
                        "States of a run that are in no recording, as the file was too slow.",
                        tally.dropped()),
                Family.counter(
                        "rsal_recordings_failed_total", "Recordings that could not be written on.", tally.failed()));
    }

    private static <K extends Enum<K>> List<Sample> each(Class<K> keys, String label, ToLongFunction<K> count) {
        return EnumSet.allOf(keys).stream()
                .map(key -> Sample.of(count.applyAsLong(key), label, Family.word(key)))
                .toList();
    }
}
