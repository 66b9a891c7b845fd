package rsal.bench.rtps;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.DatagramChannel;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Result;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.message.RosMessages;
import rsal.ros2.message.ScanMessage;
import rsal.rtps.SampleReader;
import rsal.rtps.SampleWriter;
import rsal.rtps.discovery.Qos;
import rsal.time.AllowedToReadWallClock;

/// How long a scan of 682 ranges takes to another participant, which reads it, and the same scan back; beside
/// as many bytes between two sockets of Java with a thread each. Both are measured in turn, again and again.
@AllowedToReadWallClock("Benchmarks measure real time.")
public final class TripBench implements Bench {
    private static final String TYPE = "sensor_msgs::msg::dds_::LaserScan_";
    private static final String TRIP = "ros2.trip.";
    private static final String SOCKETS = "ros2.trip.sockets.";
    private static final String MEDIAN = "p50";
    private static final String LATE = "p99";
    private static final int BEAMS = 682;
    private static final double GOAL_MEDIAN = 60; // µs
    private static final double GOAL_LATE = 250; // µs
    private static final String FRAME = "laser";

    private final int trips;
    private final int warm;

    public TripBench() {
        this(20_000, 20_000);
    }

    /// @param trips that are measured, after as many others as are warm
    TripBench(int trips, int warm) {
        this.trips = trips;
        this.warm = warm;
    }

    @Override
    public List<String> names() {
        return List.of(TRIP + MEDIAN, TRIP + LATE, SOCKETS + MEDIAN, SOCKETS + LATE);
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        int repeats = assignment.repeats();
        double[][] ours = new double[2][repeats];
        double[][] sockets = new double[2][repeats];
        for (int i = 0; i < repeats; i++) {
            assignment.reach(TRIP + MEDIAN, i, repeats);
            put(ours(), ours, i);
            put(sockets(), sockets, i);
        }
        assignment.report(
                Result.less(TRIP + MEDIAN, "us", ours[0]).toReach(GOAL_MEDIAN),
                Result.less(TRIP + LATE, "us", ours[1]).toReach(GOAL_LATE),
                Result.less(SOCKETS + MEDIAN, "us", sockets[0]),
                Result.less(SOCKETS + LATE, "us", sockets[1]));
    }

    private void put(long[] times, double[][] to, int repeat) {
        long[] sorted = Arrays.copyOfRange(times, warm, times.length);
        Arrays.sort(sorted);
        to[0][repeat] = sorted[sorted.length / 2] * 1e-3;
        to[1][repeat] = sorted[sorted.length * 99 / 100] * 1e-3;
    }

    private static byte[] scan() {
        float[] ranges = new float[BEAMS];
        Arrays.fill(ranges, 1.5f);
        var scan = new LaserScan(Pose2d.ORIGIN, -2, 4.0 / BEAMS, 0.1, 8, ranges);
        return new RosMessages().scan(Instant.EPOCH, scan, FRAME, 0.1);
    }

    private static void read(ByteBuffer payload) {
        try {
            if (ScanMessage.read(CdrReader.of(payload), FRAME).ranges().length != BEAMS) {
                throw new IllegalStateException("The scan that came is another one.");
            }
        } catch (InvalidCdr e) {
            throw new IllegalStateException("The scan that came can't be read.", e);
        }
    }

    /// @return of each trip [ns]
    private long[] ours() {
        byte[] scan = scan();
        var times = new long[warm + trips];
        var done = new CompletableFuture<Boolean>();
        try (LoopbackPeer one = LoopbackPeer.join();
                LoopbackPeer other = LoopbackPeer.join()) {
            SampleWriter there = one.writer("rt/there", TYPE, Qos.SENSOR_DATA);
            SampleWriter back = other.writer("rt/back", TYPE, Qos.SENSOR_DATA);
            SampleReader outward = other.reader("rt/there", TYPE, Qos.SENSOR_DATA, sample -> {
                read(sample.payload());
                other.write(back, scan);
            });
            var trip = new Object() {
                int number;
                long begun;
            };
            SampleReader homeward = one.reader("rt/back", TYPE, Qos.SENSOR_DATA, sample -> {
                read(sample.payload());
                long now = System.nanoTime();
                times[trip.number++] = now - trip.begun;
                trip.begun = now;
                if (trip.number < times.length) {
                    one.write(there, scan);
                } else {
                    done.complete(true);
                }
            });
            LoopbackPeer.await(
                    "the other was not found",
                    () -> one.ready(there) == 1
                            && other.ready(back) == 1
                            && outward.matched() == 1 // else it would take no first scan
                            && homeward.matched() == 1);
            trip.begun = System.nanoTime();
            one.write(there, scan);
            LoopbackPeer.await("a scan was lost", done::isDone);
        }
        return times;
    }

    private long[] sockets() {
        var scan = ByteBuffer.allocateDirect(scan().length).put(scan()).flip();
        var times = new long[warm + trips];
        var here = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        try (var one = DatagramChannel.open().bind(here);
                var other = DatagramChannel.open().bind(here)) {
            one.connect(other.getLocalAddress());
            other.connect(one.getLocalAddress());
            Thread.ofPlatform().daemon().name("echo").start(() -> echo(other, scan.duplicate()));
            var done = new CompletableFuture<Boolean>();
            Thread.ofPlatform().daemon().name("trips").start(() -> travel(one, scan, times, done));
            LoopbackPeer.await("a datagram was lost", done::isDone);
            done.join(); // or what has failed
        } catch (IOException e) {
            throw new UncheckedIOException("Two sockets of the loopback network can't be connected.", e);
        }
        return times;
    }

    private static void travel(
            DatagramChannel channel, ByteBuffer scan, long[] times, CompletableFuture<Boolean> done) {
        var buffer = ByteBuffer.allocateDirect(scan.capacity());
        try {
            for (int i = 0; i < times.length; i++) {
                long begun = System.nanoTime();
                channel.write(scan.duplicate());
                channel.read(buffer.clear());
                times[i] = System.nanoTime() - begun;
            }
            done.complete(true);
        } catch (IOException e) {
            done.completeExceptionally(e);
        }
    }

    private static void echo(DatagramChannel channel, ByteBuffer scan) {
        var buffer = ByteBuffer.allocateDirect(scan.capacity());
        try {
            while (channel.isOpen()) {
                channel.read(buffer.clear());
                channel.write(scan.duplicate());
            }
        } catch (ClosedChannelException e) {
            // the trips are over
        } catch (IOException e) {
            throw new UncheckedIOException("A socket of the loopback network failed.", e);
        }
    }
}
