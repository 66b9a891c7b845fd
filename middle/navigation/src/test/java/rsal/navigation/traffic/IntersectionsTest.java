package rsal.navigation.traffic;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.navigation.passage.DrawnMaps;
import rsal.navigation.passage.Passages;

/// Points that drive in lanes as they are advised, over a radio that loses messages, at a crossing of two corridors of
/// 2 m.
class IntersectionsTest {
    private static final double SIDE = 20; // m
    private static final Passages PASSAGES = DrawnMaps.passages(cross());
    private static final double LANE = 0.5; // m beside the middle

    private static OccupancyGrid cross() {
        int side = 200;
        var cells = new byte[side * side];
        Arrays.fill(cells, OccupancyGrid.OCCUPIED);
        for (int i = 1; i < side - 1; i++) {
            for (int k = 90; k < 110; k++) {
                cells[i * side + k] = OccupancyGrid.FREE;
                cells[k * side + i] = OccupancyGrid.FREE;
            }
        }
        return new OccupancyGrid(side, side, 0.1, 0, 0, cells);
    }

    /// One robot. It drives through in its lane at 0.4 m/s, and begins again where it began.
    private static final class Driver {
        final Intersections rule;
        final double direction;
        final double back;
        double way;
        int crossings;

        /// @param direction in which it drives [rad]
        /// @param back how far behind the others of its lane it begins [m]
        Driver(LossyLinks radio, String robot, double direction, double back) {
            this.rule = new Intersections(new TrafficType.Participant(
                    robot,
                    DrawnMaps.BODY,
                    radio.link(robot),
                    () -> CompletableFuture.completedStage(PASSAGES),
                    Instant.EPOCH));
            this.direction = direction;
            this.back = back;
            this.way = 4 - back;
        }

        Point2d at(double meters) {
            double along = meters - SIDE / 2;
            return new Point2d(
                    SIDE / 2 + along * Math.cos(direction) + LANE * Math.sin(direction),
                    SIDE / 2 + along * Math.sin(direction) - LANE * Math.cos(direction));
        }

        Point2d place() {
            return at(way);
        }

        Pose2d pose() {
            return new Pose2d(place().x(), place().y(), direction);
        }

        void step(Instant now) {
            List<Point2d> path = List.of(place(), at(way + 0.01), at(19));
            if (rule.advise(now, pose(), () -> path) instanceof TrafficAdvice.Proceed) {
                way += 0.04;
            }
            if (way > 16) {
                way = 4 - back;
                crossings++;
            }
        }
    }

    private static List<Driver> drivers(LossyLinks radio, int each) {
        var drivers = new ArrayList<Driver>();
        for (int i = 0; i < 4; i++) {
            for (int k = 0; k < each; k++) {
                drivers.add(new Driver(radio, "r" + i + k, i * Math.PI / 2, 2.5 * k));
            }
        }
        return drivers;
    }

    @Test
    void theMapHasOneJunction() {
        assertThat(PASSAGES.junctions()).hasSize(1);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void nobodyMeetsAnybodyAndAllGetThrough(long seed) {
        var radio = new LossyLinks(seed, 0.05 * seed);
        List<Driver> drivers = drivers(radio, 1);
        for (int step = 0; step < 6000; step++) {
            Instant now = Instant.EPOCH.plusMillis(100L * step);
            drivers.forEach(driver -> driver.step(now));
            for (int i = 0; i < drivers.size(); i++) {
                for (int k = 0; k < i; k++) {
                    assertThat(drivers.get(i).place().distanceTo(drivers.get(k).place()))
                            .as("at %d", step)
                            .isGreaterThan(2 * DrawnMaps.BODY);
                }
            }
        }
        assertThat(drivers).allSatisfy(driver -> assertThat(driver.crossings).isGreaterThan(8));
    }

    /// What it costs to take turns: a lone robot needs 30 s.
    @Test
    void fourNeedLessThanTwiceTheTimeOfOne() {
        List<Driver> drivers = drivers(new LossyLinks(1, 0), 1);
        for (int step = 0; step < 6000; step++) {
            Instant now = Instant.EPOCH.plusMillis(100L * step);
            drivers.forEach(driver -> driver.step(now));
        }
        assertThat(drivers.stream().mapToInt(driver -> driver.crossings).sum()).isGreaterThan(4 * 10);
    }

    /// One that has stopped for ever in the junction is an obstacle like others after a while, which controllers avoid.
    @Test
    void whoBreaksDownInAJunctionDoesNotCloseIt() {
        var radio = new LossyLinks(1, 0);
        List<Driver> drivers = drivers(radio, 1);
        Driver broken = drivers.getFirst();
        broken.way = SIDE / 2;
        for (int step = 0; step < 1200; step++) {
            Instant now = Instant.EPOCH.plusMillis(100L * step);
            broken.rule.stands(now, broken.pose());
            drivers.stream().skip(1).forEach(driver -> driver.step(now));
        }
        assertThat(drivers.stream().skip(1))
                .allSatisfy(driver -> assertThat(driver.crossings).isPositive());
    }
}
