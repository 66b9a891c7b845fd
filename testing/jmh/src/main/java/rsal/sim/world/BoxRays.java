package rsal.sim.world;

import java.util.Arrays;
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
import rsal.bench.place.Office;
import rsal.data.Pose2d;

/// Rays [1/s] of 8 m on the office floor, 180 from each of some places, by boxes and by strides ([RayMarch]).
@State(Scope.Thread)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class BoxRays {
    private static final int BEAMS = 180;
    private static final double REACH = 8;

    @Param({"10", "1000"})
    int places;

    private final RasterWalls walls = RasterWalls.of(Office.MAP);
    private final EmptyBoxes boxes = new EmptyBoxes(walls);
    private Pose2d[] from = {};
    private int next;

    @Setup
    public void draw() {
        var random = new SplittableRandom(1);
        from = new Pose2d[places];
        Arrays.setAll(from, _ -> Office.place(random, place -> walls.emptyAround(place.x(), place.y()) > 0.4));
    }

    @Benchmark
    @OperationsPerInvocation(BEAMS)
    public double kernel() {
        Rays rays = aim();
        boxes.end(rays, REACH);
        return rays.range[0];
    }

    @Benchmark
    @OperationsPerInvocation(BEAMS)
    public double slow() {
        Rays rays = aim();
        rays.march.end(walls, rays, REACH);
        return rays.range[0];
    }

    private Rays aim() {
        Pose2d pose = from[next];
        next = (next + 1) % places;
        Rays rays = Rays.ofThisThread(BEAMS);
        double cos = Math.cos(Math.PI / BEAMS);
        double sin = Math.sin(Math.PI / BEAMS);
        double dx = Math.cos(pose.theta());
        double dy = Math.sin(pose.theta());
        for (int i = 0; i < BEAMS; i++) {
            rays.x[i] = pose.x();
            rays.y[i] = pose.y();
            rays.dx[i] = dx;
            rays.dy[i] = dy;
            double turned = dx * cos - dy * sin;
            dy = dx * sin + dy * cos;
            dx = turned;
        }
        Arrays.fill(rays.range, 0, BEAMS, Double.POSITIVE_INFINITY);
        return rays;
    }
}
