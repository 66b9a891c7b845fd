package rsal.sim.world;

import java.util.List;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import rsal.data.Fan;
import rsal.data.Pose2d;

/// Scans [1/s] of 180 beams of 8 m among robots, walls included, against asking every beam for every robot.
@State(Scope.Thread)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class NeighborRays {
    private static final double REACH = 8;
    private static final SensorRays BEAMS =
            new SensorRays(List.of(new Fan(Pose2d.ORIGIN, -Math.PI / 2, Math.PI / 179, 180)), 0);

    @Param({"100", "1000"})
    int robots;

    private Scenery scenery;
    private int next;

    @Setup
    public void draw() {
        scenery = new Scenery(robots);
    }

    @Benchmark
    public double kernel() {
        return BEAMS.cast(scenery.world, self(), REACH)[0];
    }

    @Benchmark
    public double slow() {
        Body self = self();
        double sum = 0;
        for (int i = 0; i < 180; i++) {
            double direction = self.pose().theta() - Math.PI / 2 + i * Math.PI / 179;
            double dx = Math.cos(direction);
            double dy = Math.sin(direction);
            double range = REACH;
            for (Body other : scenery.robots) {
                if (other != self) {
                    range = Math.min(
                            range,
                            other.seen.pieces[0].ray(
                                    self.pose().x(), self.pose().y(), dx, dy));
                }
            }
            Rays ray = Rays.ofThisThread(1);
            ray.x[0] = self.pose().x();
            ray.y[0] = self.pose().y();
            ray.dx[0] = dx;
            ray.dy[0] = dy;
            ray.range[0] = range;
            scenery.walls.end(ray, REACH);
            sum += ray.range[0];
        }
        return sum;
    }

    private Body self() {
        next = (next + 1) % robots;
        return scenery.robots.get(next);
    }
}
