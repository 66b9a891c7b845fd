package rsal.navigation.traffic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Point2d;
import rsal.navigation.traffic.Timetable.Entry;
import rsal.navigation.traffic.Timetable.Leg;
import rsal.navigation.traffic.Timetable.Trip;

class TimetableTest {
    private static final Point2d EAST = new Point2d(5, 0);
    private static final Point2d WEST = new Point2d(0, 0);

    private static Trip trip(String id, double waited, boolean isCommitted, Leg... legs) {
        return new Trip(id, 0.5, 20, waited, isCommitted, List.of(legs));
    }

    private static Leg leg(int passage, Point2d entry, double from, double to) {
        return new Leg(List.of(passage), entry, from, to);
    }

    private static double start(Timetable table, String id) {
        return table.entries().stream()
                .filter(entry -> entry.id().equals(id))
                .mapToDouble(Entry::start)
                .min()
                .orElseThrow();
    }

    @Test
    void whoIsNearerGoesFirstIfTheOtherWaitsLessThen() {
        Timetable table = Timetable.of(
                List.of(trip("far", 0, false, leg(0, EAST, 10, 15)), trip("near", 0, false, leg(0, WEST, 1, 6))));
        assertThat(start(table, "near")).isCloseTo(2, within(1e-9)); // 1 m at 0.5 m/s
        assertThat(start(table, "far")).isCloseTo(20, within(1e-9));
    }

    @Test
    void whoIsInsideGoesOn() {
        Timetable table = Timetable.of(
                List.of(trip("a", 0, false, leg(0, WEST, 0.1, 5)), trip("b", 0, true, leg(0, EAST, 0, 4))));
        assertThat(start(table, "b")).isZero();
        assertThat(start(table, "a")).isCloseTo(9, within(1e-9)); // 4 m at 0.5 m/s, and 1 s
    }

    @Test
    void whoHasWaitedForLongGoesBeforeSeveralOthers() {
        var trips = new ArrayList<Trip>();
        trips.add(trip("patient", 600, false, leg(0, EAST, 2, 7)));
        for (int i = 0; i < 4; i++) {
            trips.add(trip("r" + i, 0, false, leg(0, WEST, 1 + i, 6 + i)));
        }
        Timetable table = Timetable.of(trips);
        assertThat(start(table, "patient")).isCloseTo(4, within(1e-9));
    }

    @Test
    void thoseOfOneDirectionFollowEachOther() {
        Timetable table = Timetable.of(
                List.of(trip("a", 0, false, leg(0, WEST, 1, 6)), trip("b", 0, false, leg(0, WEST, 1.2, 6.2))));
        assertThat(Math.abs(start(table, "a") - start(table, "b"))).isCloseTo(3, within(0.5));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
    void noOrderOfFiveRobotsIsBetter(long seed) {
        List<Trip> trips = random(new SplittableRandom(seed), 5, 4);
        Timetable table = Timetable.of(trips);
        assertThatNobodyMeets(table, trips);
        assertThat(table.cost()).isCloseTo(best(trips, new ArrayList<>()), within(1e-6));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
    void ordersOfSevenRobotsAreBetterByAFifthAtMost(long seed) {
        List<Trip> trips = random(new SplittableRandom(seed), 7, 4);
        Timetable table = Timetable.of(trips);
        assertThatNobodyMeets(table, trips);
        assertThat(table.cost()).isLessThanOrEqualTo(1.2 * best(trips, new ArrayList<>()));
    }

    private static void assertThatNobodyMeets(Timetable table, List<Trip> trips) {
        List<Entry> entries = table.entries();
        assertThat(entries)
                .hasSize(trips.stream().mapToInt(trip -> trip.legs().size()).sum());
        for (Entry one : entries) {
            for (Entry other : entries) {
                boolean apart = one.end() <= other.start() || other.end() <= one.start();
                assertThat(one.id().equals(other.id()) || !one.leg().isAgainst(other.leg()) || apart)
                        .as("%s, %s", one, other)
                        .isTrue();
            }
        }
    }

    /// The least cost of all orders.
    private static double best(List<Trip> left, List<Trip> order) {
        if (left.isEmpty()) {
            return Timetable.inOrder(order).cost();
        }
        double best = Double.POSITIVE_INFINITY;
        for (Trip next : left) {
            var others = new ArrayList<>(left);
            others.remove(next);
            order.add(next);
            best = Math.min(best, best(others, order));
            order.removeLast();
        }
        return best;
    }

    private static List<Trip> random(SplittableRandom random, int robots, int passages) {
        var trips = new ArrayList<Trip>();
        for (int i = 0; i < robots; i++) {
            var legs = new ArrayList<Leg>();
            double way = 0;
            int count = random.nextInt(1, passages + 1);
            for (int k = 0; k < count; k++) {
                double from = way + random.nextDouble(0.2, 5);
                way = from + random.nextDouble(1, 6);
                legs.add(leg(random.nextInt(passages), random.nextBoolean() ? EAST : WEST, from, way));
            }
            trips.add(new Trip("r" + i, random.nextDouble(0.2, 0.8), way + 3, random.nextDouble(60), false, legs));
        }
        return trips;
    }
}
