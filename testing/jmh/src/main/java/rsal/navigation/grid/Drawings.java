package rsal.navigation.grid;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import rsal.data.LaserScan;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.map.Maps;
import rsal.navigation.grid.ScanMapper.PosedScan;
import rsal.navigation.grid.ScanMapper.Settings;
import rsal.settings.FileSource;
import rsal.settings.Location;

/// Drives along the corridor of the office [1/s], of which a map is wanted after every six scans: drawn on, against
/// drawn again each time.
@State(Scope.Thread)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class Drawings {
    private static final int BEAMS = 680;
    private static final double RANGE = 4; // m
    private static final int AT_ONCE = 6;
    private static final double LENGTH = 50; // m

    private final Settings settings = Settings.of(0.1).upTo(RANGE, RANGE);
    private final List<PosedScan> scans = new ArrayList<>();

    @Param({"60", "480"})
    int count;

    @Setup
    public void see() {
        OccupancyGrid office = new Maps(FileSource.disk()).read("office", Location.of("office"));
        DistanceField toOccupied = DistanceField.toOccupied(office);
        for (int i = 0; i < count; i++) {
            var place = new Pose2d(LENGTH * i / count - LENGTH / 2, -1, i);
            scans.add(new PosedScan(place, scan(toOccupied, place)));
        }
        if (!Arrays.equals(kernel().getLast().cells(), slow().getLast().cells())) {
            throw new IllegalStateException("What is drawn on is not what is drawn at once.");
        }
    }

    @Benchmark
    public List<OccupancyGrid> kernel() {
        return drive(new IncrementalMap(settings)::of);
    }

    @Benchmark
    public List<OccupancyGrid> slow() {
        return drive(seen -> ScanMapper.draw(seen, settings));
    }

    private List<OccupancyGrid> drive(Function<List<PosedScan>, OccupancyGrid> map) {
        var maps = new ArrayList<OccupancyGrid>();
        for (int seen = AT_ONCE; seen <= count; seen += AT_ONCE) {
            maps.add(map.apply(scans.subList(0, seen)));
        }
        return maps;
    }

    private static LaserScan scan(DistanceField toOccupied, Pose2d pose) {
        var ranges = new float[BEAMS];
        double apart = 1.5 * Math.PI / BEAMS;
        for (int i = 0; i < BEAMS; i++) {
            double range = toOccupied.castRay(pose.x(), pose.y(), pose.theta() + i * apart, RANGE);
            ranges[i] = (float) (range < RANGE ? range : Double.POSITIVE_INFINITY);
        }
        return new LaserScan(Pose2d.ORIGIN, 0, apart, 0, RANGE, ranges);
    }
}
