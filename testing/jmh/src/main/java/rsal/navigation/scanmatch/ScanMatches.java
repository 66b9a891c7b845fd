package rsal.navigation.scanmatch;

import java.util.Optional;
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
import rsal.navigation.grid.DistanceField;
import rsal.navigation.scanmatch.CorrelativeMatcher.Settings;
import rsal.navigation.scanmatch.CorrelativeMatcher.Window;
import rsal.settings.FileSource;
import rsal.settings.Location;

/// Scans of 180 beams matched [1/s] with one that was taken 0.3 m and 10° from there in the office, by branch and bound
/// against trying every place of the window.
@State(Scope.Thread)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class ScanMatches {
    private static final int BEAMS = 180;
    private static final double RANGE = 8; // m
    private static final double RADIANS = 0.35;
    private static final double ENOUGH = 0.3;

    @Param({"0.5", "2"})
    double meters;

    private CorrelativeMatcher bounded;
    private CorrelativeMatcher thorough;
    private Cloud scan;

    @Setup
    public void see() {
        OccupancyGrid office = new Maps(FileSource.disk()).read("office", Location.of("office"));
        DistanceField toOccupied = DistanceField.toOccupied(office);
        Cloud reference = cloud(toOccupied, Pose2d.ORIGIN);
        scan = cloud(toOccupied, new Pose2d(0.27, -0.13, 0.17));
        Settings usual = Settings.DEFAULT;
        bounded = new CorrelativeMatcher(reference, usual);
        thorough = new CorrelativeMatcher(reference, new Settings(usual.resolution(), usual.blur(), 0));
        if (!kernel().equals(slow())) {
            throw new IllegalStateException("%s is not %s.".formatted(kernel(), slow()));
        }
    }

    @Benchmark
    public Optional<Match> kernel() {
        return bounded.match(scan, Pose2d.ORIGIN, new Window(meters, RADIANS), ENOUGH);
    }

    @Benchmark
    public Optional<Match> slow() {
        return thorough.match(scan, Pose2d.ORIGIN, new Window(meters, RADIANS), ENOUGH);
    }

    private static Cloud cloud(DistanceField toOccupied, Pose2d pose) {
        var ranges = new float[BEAMS];
        double apart = Math.PI / BEAMS;
        for (int i = 0; i < BEAMS; i++) {
            double direction = pose.theta() - Math.PI / 2 + i * apart;
            double range = toOccupied.castRay(pose.x(), pose.y(), direction, RANGE);
            ranges[i] = (float) (range < RANGE ? range : Double.POSITIVE_INFINITY);
        }
        return Cloud.of(new LaserScan(Pose2d.ORIGIN, -Math.PI / 2, apart, 0, RANGE, ranges), RANGE);
    }
}
