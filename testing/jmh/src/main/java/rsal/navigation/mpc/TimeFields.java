package rsal.navigation.mpc;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.navigation.avoid.Obstacles;

/// Fields of times [1/s] over 10 m × 10 m with 60 posts, as `mpc` makes one for each command, against going over all
/// cells again and again until nothing gets quicker.
@State(Scope.Thread)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class TimeFields {
    private static final int SIDE = 200;
    private static final Point2d GOAL = new Point2d(4.2, 3.9);
    private static final Point2d FAR = new Point2d(-4.9, -4.9); // so that all is reached

    private RollingMap map;
    private TimeField field;

    @Setup
    public void draw() {
        map = new RollingMap(SIDE, 0.05, 100);
        var posts = new Obstacles(7);
        var random = new SplittableRandom(1);
        for (int i = 0; i < 60; i++) {
            posts.add(random.nextDouble(-4.5, 4.5), random.nextDouble(-4.5, 4.5));
        }
        map.note(posts, Pose2d.ORIGIN);
        field = new TimeField(map, TimeFields::speed);
        check(kernel(), slow());
    }

    private static double speed(double distance) {
        return distance < 0.25 ? 0 : Math.min(2, 0.5 + 4 * (distance - 0.25));
    }

    /// The cells of a bucket come in any order, which makes some of them a little later than they could be.
    private void check(TimeField quick, double[] slow) {
        int compared = 0;
        for (int cell = 0; cell < SIDE * SIDE; cell++) {
            if (slow[cell] < Double.POSITIVE_INFINITY && isWithin(cell)) {
                compared++;
                double time = quick.at(map.x(cell % SIDE), map.y(cell / SIDE));
                if (!(Math.abs(time - slow[cell]) <= 0.02 + 0.02 * slow[cell])) {
                    throw new IllegalStateException(
                            "Cell %d: (%f) s, by the slow one (%f) s.".formatted(cell, time, slow[cell]));
                }
            }
        }
        if (compared < SIDE * SIDE / 2) {
            throw new IllegalStateException("Only %d cells were reached.".formatted(compared));
        }
    }

    /// Times are asked between the middles of four cells.
    private static boolean isWithin(int cell) {
        return cell % SIDE < SIDE - 2 && cell / SIDE < SIDE - 2;
    }

    @Benchmark
    public TimeField kernel() {
        field.spread(GOAL, FAR);
        return field;
    }

    @Benchmark
    public double[] slow() {
        var times = new double[SIDE * SIDE];
        Arrays.fill(times, Double.POSITIVE_INFINITY);
        int goal = map.cell(GOAL.x(), GOAL.y());
        times[goal] = 0;
        boolean quicker = true;
        while (quicker) {
            quicker = false;
            for (int cell = 0; cell < times.length; cell++) {
                double time = reached(cell, times);
                if (time < times[cell] - 1e-9) {
                    times[cell] = time;
                    quicker = true;
                }
            }
        }
        return times;
    }

    private double reached(int cell, double[] times) {
        double speed = speed(map.distance(cell));
        if (speed == 0) {
            return Double.POSITIVE_INFINITY;
        }
        double step = map.resolution() / speed;
        int column = cell % SIDE;
        int row = cell / SIDE;
        double beside = Math.min(at(column - 1, row, times), at(column + 1, row, times));
        double above = Math.min(at(column, row - 1, times), at(column, row + 1, times));
        double difference = Math.abs(beside - above);
        return difference < step
                ? (beside + above + Math.sqrt(2 * step * step - difference * difference)) / 2
                : Math.min(beside, above) + step;
    }

    private static double at(int column, int row, double[] times) {
        return column < 0 || row < 0 || column >= SIDE || row >= SIDE
                ? Double.POSITIVE_INFINITY
                : times[row * SIDE + column];
    }
}
