package rsal.sim.world;

import java.util.Arrays;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import rsal.jmh.CellWalk;

/// Rays [1/s] of 8 m in a cave of 2560 × 2560 cells, 180 from each of some places, against walking through every
/// cell (Amanatides and Woo 1987).
@State(Scope.Thread)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class WallRays {
    private static final int BEAMS = 180;
    private static final double REACH = 8;

    @Param({"10", "1000"})
    int places;

    private Scenery scenery;
    private int next;

    @Setup
    public void draw() {
        scenery = new Scenery(places);
    }

    @Benchmark
    @OperationsPerInvocation(BEAMS)
    public double kernel() {
        Rays rays = aim();
        scenery.walls.end(rays, REACH);
        return rays.range[0];
    }

    @Benchmark
    @OperationsPerInvocation(BEAMS)
    public double slow() {
        Rays rays = aim();
        for (int i = 0; i < BEAMS; i++) {
            rays.range[i] = CellWalk.range(Scenery.CAVE, rays.x[i], rays.y[i], rays.dx[i], rays.dy[i], REACH);
        }
        return rays.range[0];
    }

    private Rays aim() {
        Figure from = scenery.robots.get(next).figure;
        next = (next + 1) % places;
        Rays rays = Rays.ofThisThread(BEAMS);
        double cos = Math.cos(2 * Math.PI / BEAMS);
        double sin = Math.sin(2 * Math.PI / BEAMS);
        double dx = from.cos();
        double dy = from.sin();
        for (int i = 0; i < BEAMS; i++) {
            rays.x[i] = from.pose().x();
            rays.y[i] = from.pose().y();
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
