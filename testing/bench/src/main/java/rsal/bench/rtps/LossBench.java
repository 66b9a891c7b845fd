package rsal.bench.rtps;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Result;
import rsal.rtps.GraphListener;
import rsal.rtps.SampleListener.Sample;
import rsal.rtps.SampleReader;
import rsal.rtps.SampleWriter;
import rsal.rtps.discovery.Qos;
import rsal.time.AllowedToReadWallClock;

/// Reliable topics between two participants of which each loses one of ten datagrams that it sends.
///
/// Both publish ten topics, and twenty samples of 1 kB each second on each, with ROS's usual quality of
/// service. `lost` are samples that never came; `delay` is from writing until the other's listener has the
/// sample.
@AllowedToReadWallClock("Benchmarks measure real time.")
public final class LossBench implements Bench {
    private static final String NAME = "ros2.loss10.";
    private static final double LOSS = 0.1;
    private static final String TYPE = "rsal::bench::dds_::Sample_";
    private static final int SIZE = 1_000; // B
    private static final double GOAL_DELAY = 100; // ms, of the 99th percentile

    private final int topics;
    private final int rounds; // samples of each topic
    private final Duration period;

    public LossBench() {
        this(10, 200, Duration.ofMillis(50));
    }

    LossBench(int topics, int rounds, Duration period) {
        this.topics = topics;
        this.rounds = rounds;
        this.period = period;
    }

    @Override
    public List<String> names() {
        return List.of(NAME + "lost", NAME + "delay.p50", NAME + "delay.p99", NAME + "delay.max");
    }

    /// What of one topic was heard.
    private static final class Ear {
        private final long[] delays; // by number [ns]; 0 for what has not come
        private final AtomicInteger count = new AtomicInteger();

        Ear(int rounds) {
            delays = new long[rounds];
        }

        void hear(Sample sample) {
            ByteBuffer payload = sample.payload().slice().order(ByteOrder.LITTLE_ENDIAN);
            int number = payload.getInt(Integer.BYTES);
            if (delays[number] == 0) {
                delays[number] = System.nanoTime() - payload.getLong(2 * Integer.BYTES);
                count.incrementAndGet();
            }
        }
    }

    private static byte[] sample(int number) {
        return ByteBuffer.allocate(SIZE)
                .put(new byte[] {0, 1, 0, 0}) // CDR_LE
                .order(ByteOrder.LITTLE_ENDIAN)
                .putInt(number)
                .putLong(System.nanoTime())
                .array();
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        int repeats = assignment.repeats();
        double[] lost = new double[repeats];
        double[] median = new double[repeats];
        double[] late = new double[repeats];
        double[] latest = new double[repeats];
        for (int i = 0; i < repeats; i++) {
            assignment.reach(NAME + "delay", i, repeats);
            double[] delays = delays(i);
            lost[i] = 2 * topics * rounds - delays.length;
            median[i] = delays[delays.length / 2];
            late[i] = delays[delays.length * 99 / 100];
            latest[i] = delays[delays.length - 1];
        }
        assignment.report(
                Result.less(NAME + "lost", "", lost).toReach(0),
                Result.less(NAME + "delay.p50", "ms", median),
                Result.less(NAME + "delay.p99", "ms", late).toReach(GOAL_DELAY),
                Result.less(NAME + "delay.max", "ms", latest));
    }

    /// @return of all samples that came, sorted [ms]
    private double[] delays(int seed) {
        var random = new SplittableRandom(seed);
        try (LoopbackPeer one = LoopbackPeer.join(LOSS, random.split(), LoopbackPeer.LEASE, GraphListener.NONE);
                LoopbackPeer other = LoopbackPeer.join(LOSS, random.split(), LoopbackPeer.LEASE, GraphListener.NONE)) {
            var ears = new ArrayList<Ear>();
            List<SampleWriter> ours = connect(one, other, "rt/there", ears);
            List<SampleWriter> theirs = connect(other, one, "rt/back", ears);
            LoopbackPeer.await("not all topics were found", () -> isReady(one, ours) && isReady(other, theirs));
            for (int i = 0; i < rounds; i++) {
                for (int k = 0; k < topics; k++) {
                    one.write(ours.get(k), sample(i));
                    other.write(theirs.get(k), sample(i));
                    LockSupport.parkNanos(period.toNanos() / topics);
                }
            }
            long end = System.nanoTime() + Duration.ofSeconds(10).toNanos();
            while (System.nanoTime() < end && ears.stream().anyMatch(ear -> ear.count.get() < rounds)) {
                LockSupport.parkNanos(period.toNanos());
            }
            return ears.stream()
                    .flatMapToLong(ear -> Arrays.stream(ear.delays))
                    .filter(delay -> delay > 0)
                    .mapToDouble(delay -> delay * 1e-6)
                    .sorted()
                    .toArray();
        }
    }

    private List<SampleWriter> connect(LoopbackPeer from, LoopbackPeer to, String name, List<Ear> ears) {
        var writers = new ArrayList<SampleWriter>();
        for (int k = 0; k < topics; k++) {
            var ear = new Ear(rounds);
            ears.add(ear);
            SampleReader reader = to.reader(name + k, TYPE, Qos.DEFAULT, ear::hear);
            writers.add(from.writer(reader.data().topic(), TYPE, Qos.DEFAULT));
        }
        return writers;
    }

    private static boolean isReady(LoopbackPeer peer, List<SampleWriter> writers) {
        return writers.stream().allMatch(writer -> peer.ready(writer) == 1);
    }
}
