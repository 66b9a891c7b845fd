package rsal.bench.rtps;

import java.nio.ByteBuffer;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Result;
import rsal.bench.measurement.Stopwatch;
import rsal.data.OccupancyGrid;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.message.MapMessage;
import rsal.ros2.message.RosMessages;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.rtps.SampleWriter;
import rsal.rtps.discovery.Qos;

/// A map of 4,000 × 4,000 cells as `nav_msgs/OccupancyGrid`, from writing it until the other participant has
/// read it: without loss, in long datagrams as between programs of one machine, and where each participant loses
/// one of ten datagrams that it sends, which are as short as in a network.
public final class MapBench implements Bench {
    private static final String WHOLE = "ros2.map.seconds";
    private static final String LOSSY = "ros2.map.loss10.seconds";
    private static final double LOSS = 0.1;
    private static final double GOAL = 1; // s
    private static final String DDS_TYPE = "nav_msgs::msg::dds_::OccupancyGrid_";

    private final int side; // cells
    private final MessageCodec codec;

    public MapBench() {
        this(4_000);
    }

    MapBench(int side) {
        this.side = side;
        TypeLibrary types = TypeLibrary.of(Distribution.JAZZY);
        codec = MessageCodec.of(types.get("nav_msgs/msg/OccupancyGrid"), types);
    }

    @Override
    public List<String> names() {
        return List.of(WHOLE, LOSSY);
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        measure(WHOLE, 0, assignment);
        measure(LOSSY, LOSS, assignment);
    }

    private void measure(String name, double loss, BenchmarkRequest assignment) {
        if (!assignment.wants(name)) {
            return;
        }
        double[] seconds = new double[assignment.repeats()];
        for (int i = 0; i < seconds.length; i++) {
            assignment.reach(name, i, seconds.length);
            seconds[i] = seconds(loss, i);
        }
        assignment.report(Result.less(name, "s", seconds).toReach(GOAL));
    }

    private double seconds(double loss, int seed) {
        var random = new SplittableRandom(seed);
        var cells = new byte[side * side];
        for (int i = 0; i < cells.length; i++) {
            cells[i] = i % 7 == 0 ? OccupancyGrid.OCCUPIED : OccupancyGrid.FREE;
        }
        var map = new OccupancyGrid(side, side, 0.05, 0, 0, cells);
        var read = new CompletableFuture<OccupancyGrid>();
        try (LoopbackPeer server = join(loss, random);
                LoopbackPeer robot = join(loss, random)) {
            robot.reader(
                    "rt/map",
                    DDS_TYPE,
                    Qos.LATCHED,
                    sample -> read(sample.payload()).ifPresent(read::complete));
            SampleWriter writer = server.writer("rt/map", DDS_TYPE, Qos.LATCHED);
            LoopbackPeer.await("no reader of the map was found", () -> server.ready(writer) == 1);
            byte[] message = new RosMessages().map(Instant.EPOCH, map, "map");
            var watch = new Stopwatch();
            server.write(writer, message);
            LoopbackPeer.await("no map has come", read::isDone);
            double seconds = watch.wall();
            if (!Arrays.equals(read.join().cells(), cells)) {
                throw new IllegalStateException("The map that came is another one.");
            }
            return seconds;
        }
    }

    private static LoopbackPeer join(double loss, SplittableRandom random) {
        return loss > 0 ? LoopbackPeer.inNetwork(loss, random.split()) : LoopbackPeer.join();
    }

    private Optional<OccupancyGrid> read(ByteBuffer payload) {
        try {
            return MapMessage.of(codec.read(CdrReader.of(payload)));
        } catch (InvalidCdr e) {
            throw new IllegalStateException("The map that came can't be read.", e);
        }
    }
}
