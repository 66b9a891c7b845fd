package rsal.behavior;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Twist2d;

/// Looking ahead whether a body will touch something.
class BodyOutlineTest {
    private static final double STEP = 0.05; // s

    @Test
    void touchesWhenAnObviousLookAtEachStepSaysSo() {
        var random = new Random(7);
        int touches = 0;
        for (int round = 0; round < 20_000; round++) {
            Footprint footprint = footprint(random);
            Surroundings around = surroundings(random);
            Twist2d twist = twist(random);
            double margin = random.nextInt(4) == 0 ? 0 : 0.2 * random.nextDouble();
            double horizon = random.nextInt(3) + random.nextDouble();
            double touched = obvious(footprint, around, twist, margin, horizon);
            touches += touched < horizon ? 1 : 0;
            double time = new BodyOutline(footprint).timeToTouch(around, twist, margin, horizon);
            if (time != touched) {
                assertThat(time)
                        .as("round %d: %s, margin %s, horizon %s", round, twist, margin, horizon)
                        .isEqualTo(touched);
            }
        }
        assertThat(touches).isBetween(2_000, 18_000);
    }

    private static Footprint footprint(Random random) {
        if (random.nextBoolean()) {
            return Footprint.box(
                    0.2 + random.nextDouble(),
                    0.2 + 0.5 * random.nextDouble(),
                    new Point2d(0.1 * random.nextDouble(), 0));
        }
        var directions = new double[3 + random.nextInt(5)];
        Arrays.setAll(directions, i -> 2 * Math.PI * (i + 0.8 * random.nextDouble()) / directions.length);
        double radius = 0.1 + 0.5 * random.nextDouble();
        var corners = new ArrayList<Point2d>();
        for (double direction : directions) {
            corners.add(new Point2d(radius * Math.cos(direction) + 0.02, radius * Math.sin(direction)));
        }
        return new Footprint(corners);
    }

    private static Surroundings surroundings(Random random) {
        var ranges = new float[Surroundings.SECTORS];
        double share = Math.pow(random.nextDouble(), 3);
        for (int i = 0; i < ranges.length; i++) {
            ranges[i] = random.nextDouble() < share ? (float) (3 * random.nextDouble()) : Float.NaN;
        }
        return new Surroundings(ranges);
    }

    private static Twist2d twist(Random random) {
        double vx = random.nextInt(4) == 0 ? 0 : random.nextDouble(-1, 1);
        double vy = random.nextBoolean() ? 0 : random.nextDouble(-1, 1);
        double omega = random.nextBoolean() ? 0 : random.nextDouble(-2, 2);
        return new Twist2d(vx, vy, omega);
    }

    private static double obvious(
            Footprint footprint, Surroundings around, Twist2d twist, double margin, double horizon) {
        double reach = footprint.circumscribedRadius() + margin + twist.speed() * horizon;
        double first = horizon;
        for (int i = 0; i < around.things(); i++) {
            double x = around.x(i);
            double y = around.y(i);
            if (x * x + y * y < reach * reach) {
                first = Math.min(first, obvious(footprint.corners(), x, y, twist, margin, first));
            }
        }
        return first;
    }

    private static double obvious(
            List<Point2d> corners, double x, double y, Twist2d twist, double margin, double horizon) {
        double allowed = Math.min(margin, gap(corners, x, y) - 1e-4);
        double cos = Math.cos(twist.omega() * STEP);
        double sin = Math.sin(twist.omega() * STEP);
        double px = x;
        double py = y;
        for (double t = STEP; t <= horizon; t += STEP) {
            double dx = px - twist.vx() * STEP;
            double dy = py - twist.vy() * STEP;
            px = cos * dx + sin * dy;
            py = cos * dy - sin * dx;
            if (gap(corners, px, py) < allowed) {
                return t - STEP;
            }
        }
        return horizon;
    }

    private static double gap(List<Point2d> corners, double x, double y) {
        double gap = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < corners.size(); i++) {
            Point2d a = corners.get(i);
            Point2d b = corners.get((i + 1) % corners.size());
            double length = a.distanceTo(b);
            double nx = (b.y() - a.y()) / length;
            double ny = (a.x() - b.x()) / length;
            gap = Math.max(gap, nx * x + ny * y - (nx * a.x() + ny * a.y()));
        }
        return gap;
    }
}
