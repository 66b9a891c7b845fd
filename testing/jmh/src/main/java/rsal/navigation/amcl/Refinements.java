package rsal.navigation.amcl;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import rsal.data.Angles;
import rsal.data.Covariance2d;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.map.Maps;
import rsal.navigation.grid.DistanceField;
import rsal.settings.FileSource;
import rsal.settings.Location;

/// Poses moved to where a scan fits the office [1/s], from 0.13 m and 3° off, against trying all poses around in steps
/// of 2 cm and 0.01 rad and taking the best.
@State(Scope.Thread)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class Refinements {
    private static final double DEVIATION = 0.1; // m
    private static final double INDEPENDENT = 15; // beams
    private static final double VAGUE_METERS = 0.3;
    private static final double VAGUE_RADIANS = 0.2;
    private static final int AROUND = 10; // steps to each side
    private static final double STEP = 0.02; // m
    private static final double TURN = 0.01; // rad
    private static final Covariance2d VAGUE = Covariance2d.ofDeviations(VAGUE_METERS, VAGUE_METERS, VAGUE_RADIANS);
    private static final Pose2d START = new Pose2d(0.11, -0.07, 0.05);

    @Param({"18", "180"})
    int beams;

    private final double[] slope = new double[3];
    private DistanceField toOccupied;
    private Refinement refinement;
    private Beams scan;

    @Setup
    public void see() {
        OccupancyGrid office = new Maps(FileSource.disk()).read("office", Location.of("office"));
        toOccupied = DistanceField.toOccupied(office);
        refinement = new Refinement(toOccupied, DEVIATION, INDEPENDENT);
        var endX = new float[beams];
        var endY = new float[beams];
        for (int i = 0; i < beams; i++) {
            double direction = -Math.PI / 2 + i * Math.PI / beams;
            double range = toOccupied.castRay(0, 0, direction, 8);
            endX[i] = (float) (range * Math.cos(direction));
            endY[i] = (float) (range * Math.sin(direction));
        }
        scan = new Beams(endX, endY, new float[beams], new float[beams]);
        if (!kernel().isNear(slow(), 2 * STEP, 2 * TURN)) {
            throw new IllegalStateException("%s is not near %s.".formatted(kernel(), slow()));
        }
    }

    @Benchmark
    public Pose2d kernel() {
        return refinement.refine(scan, START, VAGUE);
    }

    @Benchmark
    public Pose2d slow() {
        Pose2d best = START;
        double least = Double.POSITIVE_INFINITY;
        for (int i = -AROUND; i <= AROUND; i++) {
            for (int j = -AROUND; j <= AROUND; j++) {
                for (int k = -AROUND; k <= AROUND; k++) {
                    var tried = new Pose2d(START.x() + i * STEP, START.y() + j * STEP, START.theta() + k * TURN);
                    double cost = cost(tried);
                    if (cost < least) {
                        least = cost;
                        best = tried;
                    }
                }
            }
        }
        return best;
    }

    private double cost(Pose2d pose) {
        double near = 4 * DEVIATION * DEVIATION;
        double sum = 0;
        for (int i = 0; i < beams; i++) {
            double range = Math.hypot(scan.x()[i], scan.y()[i]);
            double direction = pose.theta() + Math.atan2(scan.y()[i], scan.x()[i]);
            if (toOccupied.slope(
                    pose.x() + range * Math.cos(direction), pose.y() + range * Math.sin(direction), slope)) {
                double square = slope[0] * slope[0];
                sum += square * near / (near + square);
            }
        }
        double off = pose.distanceTo(START) / VAGUE_METERS;
        double turned = Angles.difference(START.theta(), pose.theta()) / VAGUE_RADIANS;
        return sum * Math.min(1, INDEPENDENT / beams) / (DEVIATION * DEVIATION) + off * off + turned * turned;
    }
}
