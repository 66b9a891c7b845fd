package rsal.navigation.amcl;

import java.util.SplittableRandom;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import rsal.data.OccupancyGrid;
import rsal.map.Maps;
import rsal.navigation.grid.DistanceField;
import rsal.settings.FileSource;
import rsal.settings.Location;

/// Scans judged [1/s], for 1000 particles around a pose in the office, against the likelihood field as the book writes
/// it down (Probabilistic Robotics, table 6.3): a sine, a cosine, an exponential and a logarithm for each beam.
@State(Scope.Thread)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class ScanLikelihood {
    private static final int PARTICLES = 1000;
    private static final double DEVIATION = 0.1; // m
    private static final double RANDOM = 0.05;

    @Param({"18", "50", "180"})
    int beams;

    private final Particles particles = new Particles(PARTICLES);
    private final PoseBlock block = new PoseBlock();
    private final double[] logs = new double[PARTICLES];
    private DistanceField toOccupied;
    private LikelihoodField field;
    private Beams scan;

    @Setup
    public void see() {
        OccupancyGrid office = new Maps(FileSource.disk()).read("office", Location.of("office"));
        toOccupied = DistanceField.toOccupied(office);
        field = new LikelihoodField(office, toOccupied, DEVIATION, RANDOM);
        var random = new SplittableRandom(1);
        var endX = new float[beams];
        var endY = new float[beams];
        for (int i = 0; i < beams; i++) {
            double direction = -Math.PI / 2 + i * Math.PI / beams;
            double range = toOccupied.castRay(0, 0, direction, 8);
            endX[i] = (float) (range * Math.cos(direction));
            endY[i] = (float) (range * Math.sin(direction));
        }
        scan = new Beams(endX, endY, new float[beams], new float[beams]);
        for (int i = 0; i < PARTICLES; i++) {
            particles.add(0.1 * random.nextGaussian(), 0.1 * random.nextGaussian(), 0.05 * random.nextGaussian());
        }
    }

    @Benchmark
    @OperationsPerInvocation(PARTICLES)
    public double[] kernel() {
        field.logs(scan, particles, block, logs);
        return logs;
    }

    @Benchmark
    @OperationsPerInvocation(PARTICLES)
    public double slow() {
        double sum = 0;
        for (int i = 0; i < PARTICLES; i++) {
            for (int beam = 0; beam < beams; beam++) {
                double range = Math.hypot(scan.x()[beam], scan.y()[beam]);
                double direction = particles.theta[i] + Math.atan2(scan.y()[beam], scan.x()[beam]);
                double distance = toOccupied.at(
                        particles.x[i] + range * Math.cos(direction), particles.y[i] + range * Math.sin(direction));
                double deviations = distance / DEVIATION;
                sum += Math.log((1 - RANDOM) * Math.exp(-deviations * deviations / 2) + RANDOM);
            }
        }
        return sum;
    }
}
