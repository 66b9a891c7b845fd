package rsal.navigation.spread;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.map.Maps;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.grid.RandomMaps;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.testkit.DrawnMap;
import rsal.testkit.LongTest;

class SpreaderTest {
    private static final DrawnMap FOUR_ROOMS = DrawnMap.grid(0.5, """
            ##########################
            #...........#............#
            #...........#............#
            #...........#............#
            #........................#
            #........................#
            #...........#............#
            #...........#............#
            #...........#............#
            #####..############..#####
            #...........#............#
            #...........#............#
            #...........#............#
            #...........#............#
            #...........#............#
            #...........#............#
            #...........#............#
            #...........#............#
            ##########################""");
    private static final OccupancyGrid OFFICE =
            new Maps(FileSource.resources(Maps.class, "/")).read("office", Location.of("test"));

    private static Spread spread(ReachableSpace ground, int number, long seed) {
        return new Spreader(ground, number).spread(new SplittableRandom(seed), _ -> {});
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 4, 5, 7, 10, 20, 40})
    void isAsEvenAsTheBestOfAHundredRunsOfLloyds(int number) {
        var slow = new SlowPaths(FOUR_ROOMS.grid(), 0);
        double best = slow.bestOfLloyd(number, 100, new SplittableRandom(number));
        for (long seed = 1; seed <= 3; seed++) {
            Spread spread = spread(ReachableSpace.largest(FOUR_ROOMS.grid(), 0), number, seed);
            int[] places = spread.places().stream().mapToInt(slow::index).toArray();
            assertThat(slow.measure(places).rms()).as("seed %d", seed).isLessThan(1.03 * best);
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void twoPlacesAreTheBestOfAllPairs(long seed) {
        var random = new SplittableRandom(seed);
        OccupancyGrid map = RandomMaps.of(random, 14, 11, 0.25);
        var slow = new SlowPaths(map, 0);
        double best = Double.POSITIVE_INFINITY;
        double bestAlone = Double.POSITIVE_INFINITY;
        for (int a = 0; a < slow.count(); a++) {
            bestAlone = Math.min(bestAlone, slow.measure(a).rms());
            for (int b = 0; b < a; b++) {
                best = Math.min(best, slow.measure(a, b).rms());
            }
        }
        var ground = ReachableSpace.around(map, 0, slow.place(0));
        List<Point2d> two = spread(ground, 2, seed).places();
        Point2d one = spread(ground, 1, seed).places().getFirst();

        assertThat(slow.measure(slow.index(two.getFirst()), slow.index(two.getLast()))
                        .rms())
                .as("seed %d", seed)
                .isLessThan(1.01 * best);
        assertThat(slow.measure(slow.index(one)).rms()).as("seed %d", seed).isLessThan(1.001 * bestAlone);
    }

    @Test
    void eachOfFourRoomsHasOneOfFourPlaces() {
        var rooms = new HashSet<String>();
        for (Point2d place :
                spread(ReachableSpace.largest(FOUR_ROOMS.grid(), 0.2), 4, 1).places()) {
            rooms.add((place.x() < 6.25 ? "left" : "right") + (place.y() < 4.75 ? " below" : " above"));
        }
        assertThat(rooms).hasSize(4);
    }

    @LongTest
    @ParameterizedTest
    @ValueSource(ints = {1, 3, 10, 40, 150})
    void placesInTheOfficeCanBeReachedAndBlockNoDoor(int number) {
        var ground = ReachableSpace.largest(OFFICE, 0.3);
        Spread spread = spread(ground, number, 7);
        var toNotFree = DistanceField.toNotFree(OFFICE);

        assertThat(spread.places()).hasSize(number).doesNotHaveDuplicates().allMatch(ground::contains);
        assertThat(spread.places()).allMatch(place -> toNotFree.at(place.x(), place.y()) >= 0.6);
        assertThat(spread.evenness()).isEqualTo(ground.measure(spread.places()));
        assertThat(spread.evenness().mean()).isLessThan(spread.evenness().rms());
        assertThat(spread.evenness().rms()).isLessThan(spread.evenness().greatest());
    }

    @LongTest
    @Test
    void tenPlacesInTheOfficeAreAsEvenAsLloydsBest() {
        var spreader = new Spreader(ReachableSpace.largest(OFFICE, 0.3), 10);
        double best = Double.POSITIVE_INFINITY;
        var random = new SplittableRandom(1);
        for (int run = 0; run < 5; run++) {
            best = Math.min(best, spreader.lloyd(random).evenness().rms());
        }
        Spread spread = spreader.spread(new SplittableRandom(7), _ -> {});
        assertThat(spread.evenness().rms()).isLessThan(1.01 * best);
    }

    @Test
    void theSameRandomNumbersGiveTheSamePlaces() {
        var ground = ReachableSpace.largest(OFFICE, 0.3);
        var spreader = new Spreader(ground, 6);
        Spread first = spreader.spread(new SplittableRandom(3), _ -> {});
        assertThat(spreader.spread(new SplittableRandom(3), _ -> {})).isEqualTo(first);
        assertThat(spread(ground, 6, 3)).isEqualTo(first);
    }

    @Test
    void reportsHowFarItGot() {
        for (int number : new int[] {5, 200}) {
            var reported = new ArrayList<Double>();
            new Spreader(ReachableSpace.largest(OFFICE, 0.1), number).spread(new SplittableRandom(1), reported::add);
            assertThat(reported)
                    .isSorted()
                    .allMatch(share -> share > 0 && share <= 1)
                    .endsWith(1.0);
        }
    }

    @Test
    void everyCellCanBeAPlace() {
        var map = DrawnMap.grid(1, """
                #####
                #..##
                #...#
                #####""");
        var ground = ReachableSpace.largest(map.grid(), 0);
        Spread spread = spread(ground, 5, 1);
        assertThat(spread.places()).hasSize(5).doesNotHaveDuplicates();
        assertThat(spread.evenness().greatest()).isZero();
    }

    @Test
    void refusesWhatThereIsNoRoomFor() {
        var ground = ReachableSpace.largest(FOUR_ROOMS.grid(), 0.3);
        assertThatThrownBy(() -> new Spreader(ground, 0))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("not '0'")
                .hasMessageContaining("Maybe");
        assertThatThrownBy(() -> new Spreader(ground, 100_000))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("no room for 100000 places")
                .hasMessageContaining("Maybe");
        assertThatThrownBy(() -> spread(ground, 320, 1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("no room for 320 places");
    }
}
