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
import rsal.jmh.CellWalk;
import rsal.map.Maps;
import rsal.navigation.grid.DistanceField;
import rsal.settings.FileSource;
import rsal.settings.Location;

/// Readings of a ring of sonars judged [1/s], for 500 particles around a pose in the office where cones are known,
/// against walking all rays of each cone through every cell up to the wall, with a logarithm for each cone.
@State(Scope.Thread)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class ConeLikelihood {
    private static final int PARTICLES = 500;
    private static final double CONE = Math.toRadians(30);
    private static final double STEP = 2 * Math.PI / Cones.DIRECTIONS;
    private static final double REACH = 5; // m
    private static final double ALIKE = 0.05; // of a logarithm; the kernel knows ranges by cell and direction

    @Param({"8", "16"})
    int sonars;

    private final Particles particles = new Particles(PARTICLES);
    private final double[] logs = new double[PARTICLES];
    private final PoseBlock block = new PoseBlock();
    private OccupancyGrid office;
    private BeamModel model;
    private Beams ring;

    @Setup
    public void listen() {
        office = new Maps(FileSource.disk()).read("office", Location.of("office"));
        model = new BeamModel(DistanceField.toOccupied(office), OutOfMapModel.of(office), 0.15, 0.1);
        var endX = new float[sonars];
        var endY = new float[sonars];
        for (int i = 0; i < sonars; i++) {
            double direction = i * 2 * Math.PI / sonars;
            double range = shortest(0, 0, direction);
            endX[i] = (float) (range * Math.cos(direction));
            endY[i] = (float) (range * Math.sin(direction));
        }
        ring = new Beams(endX, endY, new float[sonars], new float[sonars], CONE);
        var random = new SplittableRandom(1);
        for (int i = 0; i < PARTICLES; i++) {
            particles.add(0.1 * random.nextGaussian(), 0.1 * random.nextGaussian(), 0.05 * random.nextGaussian());
        }
        double sum = 0;
        for (double log : kernel()) {
            sum += log;
        }
        if (!(Math.abs(sum / slow() - 1) < ALIKE)) {
            throw new IllegalStateException("%s is not %s.".formatted(sum, slow()));
        }
    }

    @Benchmark
    @OperationsPerInvocation(PARTICLES)
    public double[] kernel() {
        model.logs(ring, particles, block, logs);
        return logs;
    }

    @Benchmark
    @OperationsPerInvocation(PARTICLES)
    public double slow() {
        double sum = 0;
        for (int i = 0; i < PARTICLES; i++) {
            for (int sonar = 0; sonar < sonars; sonar++) {
                double measured = Math.hypot(ring.x()[sonar], ring.y()[sonar]);
                double direction = particles.theta[i] + Math.atan2(ring.y()[sonar], ring.x()[sonar]);
                double expected = shortest(particles.x[i], particles.y[i], direction);
                sum += Math.log(model.likelihood(measured, expected));
            }
        }
        return sum;
    }

    private double shortest(double x, double y, double direction) {
        int aside = Cones.raysAside(CONE);
        double shortest = REACH;
        for (int ray = -aside; ray <= aside; ray++) {
            double along = direction + ray * STEP;
            shortest = Math.min(shortest, CellWalk.range(office, x, y, Math.cos(along), Math.sin(along), REACH));
        }
        return shortest;
    }
}
