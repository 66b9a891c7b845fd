package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.LaserScan;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.navigation.device.Exploration.Body;
import rsal.navigation.device.Exploration.Ready;
import rsal.navigation.device.Exploration.Seen;
import rsal.navigation.grid.ScanMapper.PosedScan;
import rsal.navigation.scanmatch.Walls;
import rsal.navigation.wavefront.CostMap.Clearance;
import rsal.navigation.wavefront.Plan;
import rsal.navigation.wavefront.Wavefront;

class ExplorationTest {
    private static final Exploration.Settings SETTINGS = new Exploration.Settings(0.1, 0.6, 4);
    private static final Body SMALL = new Body(0.25, new Clearance(0.3, 0.5, 1));
    private static final Body LARGE = new Body(0.6, new Clearance(0.7, 0.9, 1));

    /// A room of 5 m × 4 m with a door of 1 m, which leads on.
    private static final Walls ROOM = new Walls()
            .chain(5, 1.5, 5, 0, 0, 0, 0, 4, 5, 4, 5, 2.5)
            .chain(5, 1.5, 12, 1.5)
            .chain(5, 2.5, 12, 2.5);

    private static List<PosedScan> around(Pose2d place) {
        var random = new SplittableRandom(1);
        Pose2d turned = place.compose(new Pose2d(0, 0, Math.PI));
        return List.of(
                new PosedScan(place, ROOM.scan(place, 0, random)), new PosedScan(turned, ROOM.scan(turned, 0, random)));
    }

    @Test
    void eachRobotIsSentWhereItsOwnBodyFits() {
        var small = new Point2d(1.5, 2.6);
        var large = new Point2d(3.5, 2);
        for (boolean largeFirst : new boolean[] {true, false}) {
            var seen = List.of(new Seen(SMALL, around(new Pose2d(3.2, 2, 0))), new Seen(LARGE, List.of()));
            var ready = largeFirst
                    ? List.of(
                            new Ready(LARGE, large, Optional.empty(), true),
                            new Ready(SMALL, small, Optional.empty(), true))
                    : List.of(
                            new Ready(SMALL, small, Optional.empty(), true),
                            new Ready(LARGE, large, Optional.empty(), true));

            List<Exploration.Order> orders = new Exploration(SETTINGS).orders(seen, ready, List.of());

            assertThat(orders.get(largeFirst ? 0 : 1).goal()).isEmpty();
            assertThat(orders.get(largeFirst ? 1 : 0).goal())
                    .hasValueSatisfying(goal -> assertThat(goal.stand().x()).isGreaterThan(5));
        }
    }

    @Test
    void whoWaitsIsSentNowhereAndLeavesWhatItSeesToOthers() {
        var place = new Pose2d(1.5, 2.6, 0);
        var seen = List.of(new Seen(SMALL, List.of()), new Seen(SMALL, around(new Pose2d(3.2, 2, 0))));
        var ready = List.of(
                new Ready(SMALL, place.position(), Optional.empty(), true),
                new Ready(SMALL, new Point2d(3.2, 2), Optional.empty(), false));

        List<Exploration.Order> orders = new Exploration(SETTINGS).orders(seen, ready, List.of());

        assertThat(orders.get(0).goal())
                .hasValueSatisfying(goal -> assertThat(goal.stand().x()).isGreaterThan(5));
        assertThat(orders.get(1).goal()).isEmpty();
        assertThat(orders.get(1).complete()).isFalse();
        assertThat(orders.get(1).map()).isEqualTo(orders.get(0).map());
    }

    /// What it found out of ways to a goal that it still has.
    @Test
    void aNextLookTakesOverWhatIsKnownOfWays() {
        var team = new Exploration(SETTINGS);
        var place = new Pose2d(3.2, 2, 0);
        var goal = new Point2d(1, 1);
        var ready = List.of(new Ready(SMALL, place.position(), Optional.empty(), true));
        List<PosedScan> scans = new ArrayList<>(around(place));
        Wavefront first = team.orders(List.of(new Seen(SMALL, List.copyOf(scans))), ready, List.of())
                .getFirst()
                .wavefront();
        first.plan(place.position(), goal, 0.1);
        first.plan(place.position(), goal, 0.1);
        assertThat(first.kept()).isEqualTo(1);

        scans.addAll(around(new Pose2d(3.0, 1.8, 0)));
        Wavefront second = team.orders(List.of(new Seen(SMALL, scans)), ready, List.of())
                .getFirst()
                .wavefront();

        assertThat(second.map().grid().cells()).isNotEqualTo(first.map().grid().cells());
        assertThat(second.kept()).isEqualTo(1);
        assertThat(second.plan(place.position(), goal, 0.1))
                .isInstanceOf(Plan.Found.class)
                .isEqualTo(new Wavefront(second.map()).plan(place.position(), goal, 0.1));
    }

    @Test
    void inAHallWiderThanTheLaserSeesThereIsSomewhereToGo() {
        var ranges = new float[360];
        Arrays.fill(ranges, Float.POSITIVE_INFINITY);
        var nothing = new LaserScan(Pose2d.ORIGIN, -Math.PI, Math.toRadians(1), 0, 4, ranges);
        var place = new Pose2d(20, 20, 0);
        var seen = new Seen(SMALL, List.of(new PosedScan(place, nothing)));

        Exploration.Order order = new Exploration(SETTINGS)
                .orders(List.of(seen), List.of(new Ready(SMALL, place.position(), Optional.empty(), true)), List.of())
                .getFirst();

        assertThat(order.goal())
                .hasValueSatisfying(goal ->
                        assertThat(goal.frontier().distanceTo(place.position())).isBetween(3.0, 4.3));
    }

    /// A door of 0.5 m is too narrow for its clearance, yet it came in by it.
    @Test
    void noRobotIsShutInByItsOwnMap() {
        var body = new Body(0.3, new Clearance(0.29, 0.5, 1));
        Walls doors = new Walls()
                .chain(5, 1.75, 5, 0, 0, 0, 0, 4, 5, 4, 5, 2.25)
                .chain(5, 1.75, 5, 1, 14, 1)
                .chain(5, 2.25, 5, 3, 14, 3);
        var random = new SplittableRandom(1);
        List<PosedScan> wayIn = new ArrayList<>();
        for (double x = 7; x >= 2.5; x -= 0.5) {
            for (double heading : new double[] {0, Math.PI}) {
                var place = new Pose2d(x, 2, heading);
                wayIn.add(new PosedScan(place, doors.scan(place, 0, random)));
            }
        }
        var ready = List.of(new Ready(body, new Point2d(2.5, 2), Optional.empty(), true));

        Exploration.Order order = new Exploration(SETTINGS)
                .orders(List.of(new Seen(body, wayIn)), ready, List.of())
                .getFirst();

        assertThat(order.complete()).isFalse();
        assertThat(order.goal())
                .hasValueSatisfying(goal -> assertThat(goal.stand().x()).isGreaterThan(5));
    }

    /// The door is 0.55 m wide, the small one needs 0.6 m.
    @Test
    void reportsWhatLiesBehindADoorThatIsHardlyTooNarrow() {
        Walls door = new Walls()
                .chain(5, 1.725, 5, 0, 0, 0, 0, 4, 5, 4, 5, 2.275)
                .chain(5, 1.725, 6.5, 1.725, 6.5, 0, 16, 0)
                .chain(5, 2.275, 6.5, 2.275, 6.5, 4, 16, 4);
        var random = new SplittableRandom(1);
        List<PosedScan> scans = new ArrayList<>();
        for (double heading : new double[] {0, Math.PI}) {
            var place = new Pose2d(3.5, 2, heading);
            scans.add(new PosedScan(place, door.scan(place, 0, random)));
        }
        for (Body body : List.of(SMALL, LARGE)) {
            Exploration.Order order = new Exploration(new Exploration.Settings(0.1, 0.6, 8))
                    .orders(
                            List.of(new Seen(body, scans)),
                            List.of(new Ready(body, new Point2d(3.5, 2), Optional.empty(), true)),
                            List.of())
                    .getFirst();

            assertThat(order.complete()).isTrue();
            if (body.equals(SMALL)) {
                assertThat(order.narrow())
                        .isNotEmpty()
                        .allSatisfy(end -> assertThat(end.x()).isGreaterThan(6));
            } else {
                assertThat(order.narrow()).isEmpty(); // smaller cells wouldn't help it
            }
        }
    }
}
