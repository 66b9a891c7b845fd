package rsal.navigation.spread;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.data.PlaceObjective;
import rsal.data.Point2d;
import rsal.map.Maps;
import rsal.navigation.rooms.RandomFloor;
import rsal.navigation.rooms.RegionKind;
import rsal.navigation.rooms.RoomMap;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.testkit.LongTest;

class TeamPlacesTest {
    private static final double CLEARANCE = 0.4; // m

    private static OccupancyGrid map(String name) {
        return name.startsWith("random")
                ? RandomFloor.office(new SplittableRandom(name.hashCode()))
                        .paint(0.1, 0)
                        .map()
                : new Maps(FileSource.resources(Maps.class, "/")).read(name, Location.of("test"));
    }

    private static Candidates candidates(String name) {
        return new Candidates(ReachableSpace.largest(map(name), CLEARANCE));
    }

    private static List<Point2d> choose(OccupancyGrid map, int number, PlaceObjective objective) {
        return new TeamPlaces(ReachableSpace.largest(map, CLEARANCE)).choose(number, objective);
    }

    /// The best of a hundred runs of simulated annealing, each from random places: a slow, plain search. Its
    /// moves put one place elsewhere, half of them near to where it was.
    ///
    /// @param cost what is to be small
    private static double annealed(
            Candidates candidates, int[] may, int number, int steps, ToDoubleFunction<int[]> cost) {
        var random = new SplittableRandom(1);
        double best = Double.POSITIVE_INFINITY;
        for (int run = 0; run < 100; run++) {
            int[] chosen = random.ints(0, may.length)
                    .distinct()
                    .limit(number)
                    .map(i -> may[i])
                    .toArray();
            double now = cost.applyAsDouble(chosen);
            best = Math.min(best, now);
            double first = Math.abs(now) * 0.1;
            for (int step = 0; step < steps; step++) {
                double heat = first * (1 - (double) step / steps) + 1e-9;
                int k = random.nextInt(number);
                int before = chosen[k];
                int next = may[random.nextInt(may.length)];
                for (int tries = 0; tries < 20 && random.nextBoolean(); tries++) {
                    int other = may[random.nextInt(may.length)];
                    next = candidates.length(before, other) < candidates.length(before, next) ? other : next;
                }
                if (candidates.isTooNear(next, chosen, k)) {
                    continue;
                }
                chosen[k] = next;
                double then = cost.applyAsDouble(chosen);
                if (then <= now || random.nextDouble() < Math.exp((now - then) / heat)) {
                    now = then;
                    best = Math.min(best, now);
                } else {
                    chosen[k] = before;
                }
            }
        }
        return best;
    }

    @ParameterizedTest
    @ValueSource(strings = {"office", "four-rooms", "random 1", "random 2"})
    void areAsFarApartAsTheBestOfAHundredAnnealedChoices(String name) {
        Candidates candidates = candidates(name);
        int[] may = candidates.standing(6);
        for (int number : new int[] {3, 6, 9}) {
            double best = -annealed(candidates, may, number, 2_000, chosen -> -candidates.least(chosen));
            int[] chosen = new ApartChoice(candidates, may).choose(number);
            assertThat(candidates.least(chosen)).as("%d places", number).isGreaterThan(0.97 * best);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"office", "four-rooms", "random 1", "random 2"})
    @LongTest
    void areAsNearToEverythingAsTheBestOfAHundredAnnealedChoices(String name) {
        Candidates candidates = candidates(name);
        int[] may = candidates.standing(6);
        for (int number : new int[] {3, 6, 9}) {
            double best = annealed(candidates, may, number, 300, candidates::greatest);
            int[] chosen = new NearChoice(candidates, may).choose(number);
            assertThat(candidates.greatest(chosen)).as("%d places", number).isLessThan(1.03 * best);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"office", "four-rooms", "random 1", "random 2"})
    @LongTest
    void seeAsMuchAsTheBestOfAHundredAnnealedChoices(String name) {
        Candidates candidates = candidates(name);
        for (int number : new int[] {3, 6}) {
            var view = new ViewChoice(candidates, candidates.standing(number));
            double best = -annealed(candidates, view.may(), number, 300, chosen -> -view.share(chosen));
            assertThat(view.share(view.choose(number))).as("%d places", number).isGreaterThan(0.97 * best);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"office", "four-rooms", "random 1", "random 2", "random 3"})
    void roomsAreChosenAsTheBestOfAHundredAnnealedChoices(String name) {
        Candidates candidates = candidates(name);
        var choice = new RoomChoice(candidates, candidates.standing(6), RoomMap.of(map(name)));
        int[] places = choice.places();
        for (int number : new int[] {2, 3, 4, 6, 9}) {
            if (number < places.length) {
                double best = -annealed(candidates, places, number, 2_000, chosen -> -candidates.least(chosen));
                int[] chosen = choice.choose(number);
                assertThat(candidates.least(chosen)).as("%d rooms", number).isGreaterThanOrEqualTo(best - 1e-3);
            }
        }
    }

    /// All choices of a few places are tried.
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void branchAndBoundIsExact(long seed) {
        Candidates candidates = candidates("random " + seed);
        int[] places = new RoomChoice(candidates, candidates.standing(4), RoomMap.of(map("random " + seed))).places();
        double farthest = Double.NEGATIVE_INFINITY;
        double nearest = Double.POSITIVE_INFINITY;
        for (int choice = 0; choice < 1 << places.length; choice++) {
            if (Integer.bitCount(choice) == 4) {
                int bits = choice;
                int[] chosen = java.util.stream.IntStream.range(0, places.length)
                        .filter(i -> (bits >> i & 1) == 1)
                        .map(i -> places[i])
                        .toArray();
                double least = candidates.least(chosen);
                double greatest = candidates.greatest(chosen);
                boolean isBetter = least > farthest || (least == farthest && greatest < nearest);
                nearest = isBetter ? greatest : nearest;
                farthest = Math.max(farthest, least);
            }
        }
        int[] best = RoomSubset.best(candidates, places, 4);
        assertThat(candidates.least(best)).isEqualTo(farthest);
        assertThat(candidates.greatest(best)).isEqualTo(nearest);
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 6, 9, 16})
    void eachRobotHasARoomOfItsOwnOnTheOfficeFloor(int number) {
        OccupancyGrid map = map("office");
        RoomMap rooms = RoomMap.of(map);
        var taken = new HashSet<Integer>();
        for (Point2d place : choose(map, number, PlaceObjective.ROOMS)) {
            int region = rooms.regionAt(place).orElseThrow();
            assertThat(rooms.regions().get(region).kind()).isEqualTo(RegionKind.ROOM);
            assertThat(taken.add(region)).as("room %d is taken once", region).isTrue();
        }
    }

    @Test
    void whenThereAreMoreRobotsThanRoomsEachRoomHasOneAndLargeOnesMore() {
        OccupancyGrid map = map("four-rooms");
        RoomMap rooms = RoomMap.of(map);
        var counts = new int[4];
        choose(map, 10, PlaceObjective.ROOMS)
                .forEach(place -> counts[rooms.regionAt(place).orElseThrow()]++);
        assertThat(Arrays.stream(counts).sum()).isEqualTo(10);
        for (int count : counts) {
            assertThat(count).isBetween(2, 3);
        }
    }

    @ParameterizedTest
    @EnumSource(value = PlaceObjective.class, mode = EnumSource.Mode.EXCLUDE, names = "EVENLY")
    void keepClearOfWallsAndOfEachOtherAndAreAlwaysTheSame(PlaceObjective objective) {
        for (String name : List.of("four-rooms", "random 4", "random 5")) {
            OccupancyGrid map = map(name);
            ReachableSpace ground = ReachableSpace.largest(map, CLEARANCE);
            for (int number : new int[] {1, 2, 7, 20}) {
                List<Point2d> places = new TeamPlaces(ground).choose(number, objective);
                assertThat(places).hasSize(number).allMatch(ground::contains);
                for (int i = 0; i < number; i++) {
                    for (int j = 0; j < i; j++) {
                        assertThat(places.get(i).distanceTo(places.get(j))).isGreaterThanOrEqualTo(2 * CLEARANCE);
                    }
                }
                assertThat(new TeamPlaces(ground).choose(number, objective)).isEqualTo(places);
            }
            assertThatThrownBy(() -> new TeamPlaces(ground).choose(0, objective))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("'0'");
        }
    }
}
