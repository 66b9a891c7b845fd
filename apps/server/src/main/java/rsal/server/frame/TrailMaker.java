package rsal.server.frame;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import rsal.server.message.Messages.Trail;
import rsal.server.message.Messages.Trails;

/// Makes trails of where robots were, moment by moment. For one thread.
public final class TrailMaker {
    /// How long they are.
    public static final Duration SECONDS = Duration.ofSeconds(30);

    private static final int MOST_POINTS = 30_000;
    private static final double LEAST_STEP = 0.05; // [m] between points
    private static final double JUMP = 1; // who got farther at once [m]
    private static final double FASTEST = 3; // and faster than a robot drives [m/s], was put there

    private final List<Made> robots;

    /// @param robots how many there are
    public TrailMaker(int robots) {
        this.robots = new ArrayList<>(robots);
        for (int i = 0; i < robots; i++) {
            this.robots.add(new Made());
        }
    }

    /// How far moments are apart at least, so that trails of many robots are not too long.
    public static Duration spacing(int robots) {
        return SECONDS.multipliedBy(robots).dividedBy(MOST_POINTS);
    }

    /// @param robot its index
    /// @param time of the run [s], not before that of the point before
    /// @param x [m]
    /// @param y [m]
    public void add(int robot, double time, double x, double y) {
        robots.get(robot).add(time, x, y);
    }

    public Trails trails() {
        return new Trails(robots.stream()
                .map(made -> new Trail(made.times, made.xs, made.ys, made.driven))
                .toList());
    }

    private static final class Made {
        private final List<Double> times = new ArrayList<>();
        private final List<Double> xs = new ArrayList<>();
        private final List<Double> ys = new ArrayList<>();
        private final List<Boolean> driven = new ArrayList<>();
        private double seen = Double.NEGATIVE_INFINITY; // when it was there last

        private void add(double time, double x, double y) {
            double moved = times.isEmpty() ? Double.POSITIVE_INFINITY : Math.hypot(x - xs.getLast(), y - ys.getLast());
            if (moved > LEAST_STEP) {
                driven.add(!times.isEmpty() && moved <= Math.max(JUMP, FASTEST * (time - seen)));
                times.add(time);
                xs.add(millimetres(x));
                ys.add(millimetres(y));
            }
            seen = time;
        }

        private static double millimetres(double meters) {
            return Math.round(meters * 1000) / 1000.0;
        }
    }
}
