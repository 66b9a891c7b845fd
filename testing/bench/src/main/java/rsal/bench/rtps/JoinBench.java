package rsal.bench.rtps;

import java.time.Duration;
import java.util.List;
import java.util.SplittableRandom;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Result;
import rsal.bench.measurement.Stopwatch;
import rsal.rtps.GraphListener;
import rsal.rtps.SampleReader;
import rsal.rtps.SampleWriter;
import rsal.rtps.discovery.Qos;

/// Memory of a participant that stays, while others join, publish and leave, one after the other; one of ten
/// leaves without a word, and is lost when its lease ends. Measured once, with everything collected that
/// nobody holds, when some have come and gone (`start`), in the middle and at the end; `growth` is from the
/// middle to the end.
public final class JoinBench implements Bench {
    private static final String TYPE = "rsal::bench::dds_::Sample_";
    private static final String HEAP = "ros2.joins.heap.";
    private static final String GROWTH = "ros2.joins.growth";
    private static final double GOAL = 1; // MB
    private static final int SILENT = 10; // one of so many leaves without a word
    private static final Duration LEASE = Duration.ofSeconds(1);

    private final int joins;
    private final int first; // before the start

    public JoinBench() {
        this(2_000, 100);
    }

    JoinBench(int joins, int first) {
        this.joins = joins;
        this.first = first;
    }

    @Override
    public List<String> names() {
        return List.of(HEAP + "start", HEAP + "half", HEAP + "end", GROWTH);
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        try (LoopbackPeer stays = LoopbackPeer.join()) {
            SampleReader reader = stays.reader("rt/scan", TYPE, Qos.DEFAULT, _ -> {});
            SampleWriter writer = stays.writer("rt/cmd_vel", TYPE, Qos.DEFAULT);
            come(first, stays, reader, writer, assignment);
            double start = Stopwatch.heap();
            come(joins / 2, stays, reader, writer, assignment);
            double half = Stopwatch.heap();
            come(joins - joins / 2, stays, reader, writer, assignment);
            double end = Stopwatch.heap();
            assignment.report(
                    Result.less(HEAP + "start", "MB", start),
                    Result.less(HEAP + "half", "MB", half),
                    Result.less(HEAP + "end", "MB", end),
                    Result.less(GROWTH, "MB", end - half).toReach(GOAL));
        }
    }

    private static void come(
            int count, LoopbackPeer stays, SampleReader reader, SampleWriter writer, BenchmarkRequest assignment) {
        for (int i = 0; i < count; i++) {
            assignment.reach(GROWTH, i, count);
            try (LoopbackPeer robot = LoopbackPeer.join(0, new SplittableRandom(i), LEASE, GraphListener.NONE)) {
                SampleWriter scans = robot.writer("rt/scan", TYPE, Qos.DEFAULT);
                SampleReader commands = robot.reader("rt/cmd_vel", TYPE, Qos.DEFAULT, _ -> {});
                LoopbackPeer.await(
                        "one that joined was not found",
                        () -> robot.ready(scans) == 1 && stays.reaches(writer, commands));
                if (i % SILENT == 0) {
                    robot.cut(true);
                } else {
                    robot.write(scans, new byte[1_000]);
                    stays.write(writer, new byte[100]);
                }
            }
        }
        LoopbackPeer.await("one that left is still there", () -> stays.others() == 0 && reader.matched() == 0);
    }
}
