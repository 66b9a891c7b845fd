package rsal.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.Angles;
import rsal.data.Pose2d;

class ArcTest {
    @Test
    void endsWhereManySmallStepsDo() {
        var random = new SplittableRandom(1);
        for (int i = 0; i < 100; i++) {
            double turn = i % 4 == 0 ? random.nextDouble(-1e-5, 1e-5) : random.nextDouble(-7, 7);
            double left = i % 3 == 0 ? 0 : random.nextDouble(-2, 2);
            var arc = new Arc(new Pose2d(1, 2, random.nextDouble(-3, 3)), random.nextDouble(-2, 2), left, turn);
            double part = random.nextDouble();
            int steps = 20_000;
            double x = 1;
            double y = 2;
            for (int step = 0; step < steps; step++) {
                double theta = arc.from().theta() + turn * part * (step + 0.5) / steps;
                x += part / steps * (arc.forward() * Math.cos(theta) - arc.left() * Math.sin(theta));
                y += part / steps * (arc.forward() * Math.sin(theta) + arc.left() * Math.cos(theta));
            }
            Pose2d end = arc.at(part);
            assertThat(end.x()).as("%s", arc).isCloseTo(x, within(1e-7));
            assertThat(end.y()).as("%s", arc).isCloseTo(y, within(1e-7));
            assertThat(end.theta()).isCloseTo(Angles.wrap(arc.from().theta() + turn * part), within(1e-12));
        }
    }

    @Test
    void noPointOfABodyMovesFartherThanTheLongestWay() {
        var random = new SplittableRandom(2);
        for (int i = 0; i < 500; i++) {
            var arc = new Arc(
                    Pose2d.ORIGIN, random.nextDouble(-2, 2), random.nextDouble(-2, 2), random.nextDouble(-7, 7));
            Pose2d point = Pose2d.polar(0.3, random.nextDouble(-3, 3));
            double distance = 0;
            for (int step = 0; step < 1000; step++) {
                Pose2d from = arc.at(step / 1000.0).compose(point);
                distance += from.distanceTo(arc.at((step + 1) / 1000.0).compose(point));
            }
            assertThat(distance).as("%s", arc).isLessThanOrEqualTo(arc.longestDistance(0.3) + 1e-9);
        }
    }
}
