package rsal.bench.rtps;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.IntStream;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Result;
import rsal.rtps.GraphListener;
import rsal.rtps.SampleReader;
import rsal.rtps.SampleWriter;
import rsal.rtps.discovery.Qos;
import rsal.time.AllowedToReadWallClock;

/// How soon participants notice who is there and who is not.
///
/// `found`: a hundred participants of this process join one after the other, each with a writer and a reader
/// of the same topic; until every writer has all readers and every reader all writers, from before the first
/// one joined. `silent.lost`: from the last announcement of a participant with a lease of 3 s, which sends
/// nothing more, until another one has lost it. `started.heard`: from before a participant is started until
/// the other one, which is there, hears a sample of it. `mute.heard`: from when one sends again that could not
/// send, but heard the other one, for longer than its lease, until a sample of it is heard.
@AllowedToReadWallClock("Benchmarks measure real time.")
public final class DiscoveryBench implements Bench {
    private static final String TYPE = "rsal::bench::dds_::Sample_";
    private static final Qos QOS = Qos.DEFAULT;
    private static final String LOST = "ros2.silent.lost";
    private static final String STARTED = "ros2.started.heard";
    private static final String MUTE = "ros2.mute.heard";
    private static final double GOAL_FOUND = 3; // s
    private static final double GOAL_LATE = 0.5; // s beyond the lease
    private static final double GOAL_HEARD = 2; // s
    private static final Duration AGAIN = Duration.ofMillis(5); // between samples
    private static final byte[] PAYLOAD = {0, 1, 0, 0, 0, 0, 0, 0};

    private final int participants;
    private final Duration lease;

    public DiscoveryBench() {
        this(100, Duration.ofSeconds(3));
    }

    DiscoveryBench(int participants, Duration lease) {
        this.participants = participants;
        this.lease = lease;
    }

    private String found() {
        return "ros2.participants.%d.found".formatted(participants);
    }

    @Override
    public List<String> names() {
        return List.of(found(), LOST, STARTED, MUTE);
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        int repeats = assignment.repeats();
        if (assignment.wants(found())) {
            double[] found = new double[repeats];
            for (int i = 0; i < repeats; i++) {
                assignment.reach(found(), i, repeats);
                found[i] = seconds();
            }
            assignment.report(Result.less(found(), "s", found).toReach(GOAL_FOUND));
        }
        if (assignment.wantsAny(List.of(LOST, STARTED, MUTE))) {
            var absences = new ArrayList<Absence>();
            for (int i = 0; i < repeats; i++) {
                assignment.reach(LOST, i, repeats);
                absences.add(absence(i));
            }
            double least = lease.toMillis() / 1e3 + GOAL_LATE;
            assignment.report(
                    Result.less(
                                    LOST,
                                    "s",
                                    absences.stream().mapToDouble(Absence::lost).toArray())
                            .toReach(least),
                    Result.less(
                                    STARTED,
                                    "s",
                                    absences.stream()
                                            .mapToDouble(Absence::started)
                                            .toArray())
                            .toReach(GOAL_HEARD),
                    Result.less(
                                    MUTE,
                                    "s",
                                    absences.stream()
                                            .mapToDouble(Absence::mended)
                                            .toArray())
                            .toReach(GOAL_HEARD));
        }
    }

    /// Until all have found all.
    private double seconds() {
        var peers = new ArrayList<LoopbackPeer>();
        var writers = new ArrayList<SampleWriter>();
        var readers = new ArrayList<SampleReader>();
        long begun = System.nanoTime();
        try {
            for (int i = 0; i < participants; i++) {
                LoopbackPeer peer = LoopbackPeer.join();
                peers.add(peer);
                writers.add(peer.writer("rt/tf", TYPE, QOS));
                readers.add(peer.reader("rt/tf", TYPE, QOS, _ -> {}));
            }
            LoopbackPeer.await(
                    "not all found all",
                    () -> readers.stream().allMatch(each -> each.matched() == participants - 1)
                            && IntStream.range(0, participants)
                                    .allMatch(i -> peers.get(i).ready(writers.get(i)) == participants - 1));
            return (System.nanoTime() - begun) * 1e-9;
        } finally {
            peers.forEach(LoopbackPeer::close);
        }
    }

    /// @param lost [s]
    /// @param started [s]
    /// @param mended [s]
    private record Absence(double lost, double started, double mended) {}

    private Absence absence(int seed) {
        var heard = new AtomicInteger();
        var random = new SplittableRandom(seed);
        try (LoopbackPeer watcher = LoopbackPeer.join()) {
            SampleReader reader = watcher.reader("rt/scan", TYPE, QOS, _ -> heard.incrementAndGet());
            double lost;
            try (LoopbackPeer robot = robot()) {
                writeUntilHeard(robot, scans(robot), heard);
                pause(random);
                robot.cut(true);
                LoopbackPeer.await("nobody lost who fell silent", () -> reader.matched() == 0);
                lost = (System.nanoTime() - robot.announced()) * 1e-9;
            }
            long begun = System.nanoTime();
            try (LoopbackPeer robot = robot()) {
                SampleWriter scans = scans(robot);
                writeUntilHeard(robot, scans, heard);
                double started = (System.nanoTime() - begun) * 1e-9;
                robot.cut(true);
                LoopbackPeer.await("nobody lost who was mute", () -> reader.matched() == 0);
                pause(random);
                robot.cut(false);
                return new Absence(lost, started, writeUntilHeard(robot, scans, heard));
            }
        }
    }

    /// So that announcements, which come regularly, do not come just then.
    private void pause(SplittableRandom random) {
        LockSupport.parkNanos(random.nextLong(lease.toNanos()));
    }

    private LoopbackPeer robot() {
        return LoopbackPeer.join(0, new SplittableRandom(0), lease, GraphListener.NONE);
    }

    private static SampleWriter scans(LoopbackPeer robot) {
        return robot.writer("rt/scan", TYPE, QOS);
    }

    private static double writeUntilHeard(LoopbackPeer robot, SampleWriter writer, AtomicInteger heard) {
        int before = heard.get();
        return LoopbackPeer.await("nothing was heard of a robot", () -> {
            robot.write(writer, PAYLOAD.clone());
            LockSupport.parkNanos(AGAIN.toNanos());
            return heard.get() > before;
        });
    }
}
