package rsal.navigation.avoid;

import java.util.SplittableRandom;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import rsal.data.Footprint;
import rsal.data.Point2d;

/// Ways along arcs until a robot's outline meets a point [1/s], worked out against found by steps of a centimeter.
@State(Scope.Thread)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class ArcPaths {
    private static final int POINTS = 1000;
    private static final double STEP = 0.01; // m
    private static final double FAR = 3; // m

    private final double[] x = new double[POINTS];
    private final double[] y = new double[POINTS];
    private final double[] curvature = new double[POINTS];
    private FootprintOutline outline;

    @Setup
    public void scatter() {
        outline = new FootprintOutline(Footprint.box(0.5, 0.4, new Point2d(0, 0)), 0.05);
        var random = new SplittableRandom(1);
        for (int i = 0; i < POINTS; i++) {
            x[i] = random.nextDouble(0.4, FAR);
            y[i] = random.nextDouble(-1, 1);
            curvature[i] = random.nextDouble(-1, 1);
        }
    }

    @Benchmark
    @OperationsPerInvocation(POINTS)
    public double kernel() {
        double sum = 0;
        for (int i = 0; i < POINTS; i++) {
            sum += Math.min(FAR, outline.freeDistance(x[i], y[i], curvature[i]));
        }
        return sum;
    }

    @Benchmark
    @OperationsPerInvocation(POINTS)
    public double slow() {
        double sum = 0;
        for (int i = 0; i < POINTS; i++) {
            double way = 0;
            while (way < FAR && !meets(i, way)) {
                way += STEP;
            }
            sum += way;
        }
        return sum;
    }

    private boolean meets(int point, double way) {
        double theta = way * curvature[point];
        double robotX = Math.sin(theta) / curvature[point];
        double robotY = (1 - Math.cos(theta)) / curvature[point];
        double dx = x[point] - robotX;
        double dy = y[point] - robotY;
        double cos = Math.cos(theta);
        double sin = Math.sin(theta);
        return outline.distance(cos * dx + sin * dy, cos * dy - sin * dx) <= 0;
    }
}
