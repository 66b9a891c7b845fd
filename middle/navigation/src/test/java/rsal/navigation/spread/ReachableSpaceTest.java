package rsal.navigation.spread;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;
import static org.assertj.core.api.Assertions.within;

import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.navigation.grid.RandomMaps;
import rsal.navigation.spread.UnsuitablePlace.Reason;
import rsal.testkit.DrawnMap;

class ReachableSpaceTest {
    private static final DrawnMap ROOMS = DrawnMap.grid(0.5, """
            ####################
            #..........#.......#
            #..a.......#....s..#
            #..........#.......#
            #w.........#########
            #..........#???????#
            #....b.....#???????#
            #..........#???????#
            ####################""");

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
    void agreesWithLookingAtAllCellsAndWays(long seed) {
        var random = new SplittableRandom(seed);
        OccupancyGrid map =
                RandomMaps.of(random, random.nextInt(6, 18), random.nextInt(6, 18), 0.3 * random.nextDouble());
        double clearance = random.nextInt(3) * 0.03;
        var slow = new SlowPaths(map, clearance);
        if (slow.count() == 0) {
            assertThatThrownBy(() -> ReachableSpace.largest(map, clearance))
                    .isInstanceOf(IllegalArgumentException.class);
            return;
        }
        int[] chosen = IntStream.generate(() -> random.nextInt(slow.count()))
                .limit(random.nextInt(1, 5))
                .toArray();
        var ground = ReachableSpace.around(map, clearance, slow.place(chosen[0]));
        Evenness right = slow.measure(chosen);
        Evenness measured =
                ground.measure(IntStream.of(chosen).mapToObj(slow::place).toList());

        assertThat(ground.area()).as("seed %d", seed).isCloseTo(slow.count() * 0.0025, within(1e-9));
        assertThat(ReachableSpace.largest(map, clearance).area())
                .as("seed %d", seed)
                .isEqualTo(ground.area());
        assertThat(measured.mean()).as("seed %d", seed).isCloseTo(right.mean(), within(0.03 * right.mean() + 1e-9));
        assertThat(measured.rms()).as("seed %d", seed).isCloseTo(right.rms(), within(0.03 * right.rms() + 1e-9));
        assertThat(measured.greatest())
                .as("seed %d", seed)
                .isCloseTo(right.greatest(), within(0.03 * right.greatest()));
    }

    @Test
    void isThePartThatCanBeReachedFromAPlace() {
        var large = ReachableSpace.largest(ROOMS.grid(), 0.3);
        var small = ReachableSpace.around(ROOMS.grid(), 0.3, ROOMS.place('s'));
        assertThat(large.contains(ROOMS.place('a'))).isTrue();
        assertThat(large.contains(ROOMS.place('s'))).isFalse();
        assertThat(small.contains(ROOMS.place('s'))).isTrue();
        assertThat(small.contains(ROOMS.place('a'))).isFalse();
        assertThat(small.area()).isLessThan(large.area());
    }

    @Test
    void aRobotMayStartALittleTooNearToAWall() {
        var ground = ReachableSpace.around(ROOMS.grid(), 0.6, ROOMS.place('w'));
        assertThat(ground.contains(ROOMS.place('w'))).isFalse();
        assertThat(ground.contains(ROOMS.place('a'))).isTrue();
    }

    @Test
    void saysWhyPlacesWontDo() {
        List<Point2d> given = List.of(
                ROOMS.place('a'),
                ROOMS.place('s'),
                ROOMS.place('w'),
                new Point2d(7.75, 1.25),
                new Point2d(0.1, 1),
                new Point2d(99, 1),
                new Point2d(Double.NaN, 1),
                ROOMS.place('b'));
        var ground = ReachableSpace.holding(ROOMS.grid(), 0.6, given);

        List<UnsuitablePlace> wrong = ground.check(given);

        assertThat(wrong)
                .extracting(UnsuitablePlace::index, UnsuitablePlace::reason)
                .containsExactly(
                        tuple(1, Reason.CUT_OFF),
                        tuple(2, Reason.TOO_NEAR),
                        tuple(3, Reason.UNKNOWN),
                        tuple(4, Reason.OCCUPIED),
                        tuple(5, Reason.OUTSIDE),
                        tuple(6, Reason.OUTSIDE));
        assertThat(wrong.get(1).why())
                .isEqualTo(
                        "Place (0.75, 2.25) is '0.25' m from an obstacle or unknown space, nearer than '0.60' m. Maybe the"
                                + " nearest place that will do is meant, (1.25, 2.25).");
        assertThat(wrong.getFirst().why()).contains("cannot be reached with '0.60' m of clearance");
        assertThat(ground.check(List.of(ROOMS.place('a'), ROOMS.place('b')))).isEmpty();
    }

    @Test
    void looksWhetherRobotsGetToPlacesFromWhereTheyStart() {
        List<Point2d> given = List.of(ROOMS.place('w'), new Point2d(0.1, 2.25), ROOMS.place('s'));
        assertThat(wrong(0.4, given, ROOMS.place('a'))).containsExactly(0, 1, 2);
        assertThat(wrong(1.2, given, ROOMS.place('a'))).containsExactly(2);
        assertThat(wrong(1.2, given, ROOMS.place('a'), ROOMS.place('s'))).isEmpty();
        assertThat(wrong(1.2, given, ROOMS.place('s'))).containsExactly(0, 1);
        assertThat(wrong(1.2, given)).as("only that is quite on any part").containsExactly(0, 1);
        assertThat(wrong(1.2, given, new Point2d(40, 40)))
                .as("a start that is nowhere")
                .containsExactly(0, 1);
        assertThat(ReachableSpace.check(ROOMS.grid(), 0.6, List.of(ROOMS.place('a')), given, List.of(1.2, 1.2, 1.2)))
                .singleElement()
                .satisfies(cut -> assertThat(cut.reason()).isEqualTo(Reason.CUT_OFF));
    }

    private static List<Integer> wrong(double within, List<Point2d> given, Point2d... starts) {
        return ReachableSpace.check(
                        ROOMS.grid(), 0.6, List.of(starts), given, Collections.nCopies(given.size(), within))
                .stream()
                .map(UnsuitablePlace::index)
                .toList();
    }

    @Test
    void holdsMostOfThePlacesGiven() {
        List<Point2d> given = List.of(ROOMS.place('s'));
        assertThat(ReachableSpace.holding(ROOMS.grid(), 0.3, given).check(given))
                .isEmpty();
        assertThat(ReachableSpace.holding(ROOMS.grid(), 0.3, List.of()).contains(ROOMS.place('a')))
                .isTrue();
        assertThat(ReachableSpace.holding(ROOMS.grid(), 0.3, List.of(ROOMS.place('s'), ROOMS.place('a')))
                        .contains(ROOMS.place('a')))
                .as("the larger one of two that hold as many")
                .isTrue();
    }

    @ParameterizedTest
    @ValueSource(doubles = {-0.1, Double.NaN, Double.POSITIVE_INFINITY})
    void refusesAClearanceThatIsNoDistance(double clearance) {
        assertThatThrownBy(() -> ReachableSpace.largest(ROOMS.grid(), clearance))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("The clearance '%s'".formatted(clearance))
                .hasMessageContaining("Maybe");
    }

    @Test
    void reportsHowMuchClearanceThereIs() {
        assertThatThrownBy(() -> ReachableSpace.largest(ROOMS.grid(), 4))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("clearance of '4.00' m")
                .hasMessageContaining("the most there is are 1.75 m")
                .hasMessageContaining("Maybe");
        assertThatThrownBy(() -> ReachableSpace.around(ROOMS.grid(), 0.3, new Point2d(40, 40)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("From the start (40.00, 40.00) nothing can be reached")
                .hasMessageContaining("Maybe");
    }

    @Test
    void measuresNoPlacesThatAreNotOnIt() {
        var ground = ReachableSpace.largest(ROOMS.grid(), 0.3);
        assertThatThrownBy(() -> ground.measure(List.of()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("At least one place");
        assertThatThrownBy(() -> ground.measure(List.of(ROOMS.place('s'))))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("cannot be reached");
    }
}
