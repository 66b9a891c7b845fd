package rsal.navigation.dwa;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.Angles;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.Controller.Motion;
import rsal.navigation.avoid.Controller.Target;
import rsal.navigation.avoid.ControllerContract;
import rsal.navigation.avoid.DriveLimits;
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.avoid.VelocityFilter;
import rsal.testkit.Trials;

class DwaTest extends ControllerContract {
    @Override
    protected Controller planner(Footprint footprint, double reaction, double beat) {
        return new Dwa(footprint, LIMITS, Dwa.Settings.of(0.25, 3), reaction);
    }

    @Trials({"1", "2", "3", "4"})
    void reportsAPathThatIsFree(long seed) {
        assertReportsFreePaths(seed, 0);
    }

    private static final Footprint BOX = Footprint.box(0.5, 0.4, new Point2d(-0.05, 0));
    private static final DriveLimits SLOW = new DriveLimits(0.6, 1, 0.4, 2);
    private static final Dwa.Settings SETTINGS = Dwa.Settings.of(0.25, 3);

    /// One choice of the window, by the formulas of the paper.
    private record Choice(double v, double w, double value) {}

    /// How far the box, 4 cm larger all around, gets on an arc until a thing is in it [m], in steps of 4 mm.
    private static double distance(double v, double w, List<Point2d> things) {
        double step = 0.004;
        for (double distance = 0; distance < SETTINGS.lookahead(); distance += step) {
            double theta = w / v * distance;
            double x = w == 0 ? distance : v / w * Math.sin(theta);
            double y = w == 0 ? 0 : v / w * (1 - Math.cos(theta));
            for (Point2d thing : things) {
                double forward = Math.cos(theta) * (thing.x() - x) + Math.sin(theta) * (thing.y() - y);
                double left = Math.cos(theta) * (thing.y() - y) - Math.sin(theta) * (thing.x() - x);
                if (Math.abs(forward + 0.05) < 0.25 + VelocityFilter.MARGIN
                        && Math.abs(left) < 0.2 + VelocityFilter.MARGIN) {
                    return Math.max(0, distance - step / 2);
                }
            }
        }
        return SETTINGS.lookahead();
    }

    private static double value(double v, double w, Point2d target, List<Point2d> things) {
        double distance = v < 0.02 ? SETTINGS.lookahead() : distance(v, w, things);
        double braking = v * v / (2 * SLOW.acceleration());
        double turning = v < 0.02 ? 0 : w * w / (2 * SLOW.turnAcceleration()) * Math.abs(v / w);
        if (braking > distance || (w != 0 && turning > distance)) {
            return 0;
        }
        double turned = w * 0.25 + w * Math.abs(w) / (2 * SLOW.turnAcceleration());
        double driven = v * 0.25 + braking;
        double bearing =
                Math.atan2(target.y() - driven * Math.sin(turned / 2), target.x() - driven * Math.cos(turned / 2));
        double off = Math.abs(Angles.difference(turned, bearing));
        return 2 * (1 - off / Math.PI) + 0.2 * distance / 3 + 0.2 * v / SLOW.speed();
    }

    /// The best mean of a choice and its neighbors in a window of 11 speeds and 21 turns that it can reach in 0.25 s.
    private static Twist2d best(Twist2d velocity, Point2d target, List<Point2d> things) {
        var window = new Choice[11][21];
        for (int i = 0; i < 11; i++) {
            for (int j = 0; j < 21; j++) {
                double least = Math.clamp(velocity.vx() - 0.1, 0, 0.6);
                double most = Math.clamp(velocity.vx() + 0.1, 0, 0.6);
                double right = Math.max(velocity.omega() - 0.5, -1);
                double left = Math.min(velocity.omega() + 0.5, 1);
                double v = least + (most - least) * i / 10;
                double w = right + (left - right) * j / 20;
                window[i][j] = new Choice(v, w, value(v, w, target, things));
            }
        }
        Choice best = new Choice(0, 0, 0);
        double highest = -1;
        for (int i = 0; i < 11; i++) {
            for (int j = 0; j < 21; j++) {
                double sum = 0;
                int count = 0;
                for (int k = Math.max(0, i - 1); k <= Math.min(10, i + 1); k++) {
                    for (int l = Math.max(0, j - 1); l <= Math.min(20, j + 1); l++) {
                        sum += window[k][l].value;
                        count++;
                    }
                }
                if (window[i][j].value > 0 && sum / count > highest) {
                    highest = sum / count;
                    best = window[i][j];
                }
            }
        }
        return Twist2d.drive(best.v, best.w);
    }

    @Test
    void choosesTheBestOfTheWindow() {
        var random = new SplittableRandom(12);
        int same = 0;
        int compared = 0;
        for (int draw = 0; draw < 150; draw++) {
            boolean ahead = draw % 2 == 0; // so near that it must brake
            Twist2d velocity = Twist2d.drive(random.nextDouble(0.15, 0.6), ahead ? 0 : random.nextDouble(-0.8, 0.8));
            var target = new Point2d(random.nextDouble(1, 4), ahead ? 0.1 : random.nextDouble(-3, 3));
            var things = new ArrayList<Point2d>();
            var obstacles = new Obstacles(5);
            int count = ahead ? 2 : random.nextInt(4);
            for (int i = 0; i < count; i++) {
                var thing = ahead
                        ? new Point2d(random.nextDouble(0.4, 0.9), random.nextDouble(-0.5, 0.5))
                        : new Point2d(random.nextDouble(0.4, 2), random.nextDouble(-1, 1));
                things.add(thing);
                obstacles.add(thing.x(), thing.y());
            }
            Twist2d best = best(velocity, target, things);
            if (best.vx() < 0.02) {
                continue; // it turns in place
            }
            var filter = new VelocityFilter(BOX, SLOW, 0.2);
            Twist2d expected = filter.guarded(best, velocity, obstacles);
            Twist2d command = new Dwa(BOX, SLOW, SETTINGS, 0.2)
                    .drive(obstacles, Target.at(target, false), new Motion(Pose2d.ORIGIN, velocity));
            compared++;
            same += Math.abs(command.vx() - expected.vx()) < 1e-9 && Math.abs(command.omega() - expected.omega()) < 1e-9
                    ? 1
                    : 0;
        }
        assertThat(compared).isGreaterThan(100);
        assertThat((double) same / compared).as("but for rounding of ways").isGreaterThan(0.95);
    }
}
