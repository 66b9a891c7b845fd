package rsal.navigation.spread;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.OccupancyGrid;
import rsal.data.PlaceObjective;
import rsal.data.Point2d;
import rsal.navigation.rooms.MapRegion;
import rsal.navigation.rooms.RandomFloor;
import rsal.navigation.rooms.RoomMap;
import rsal.testkit.Trials;

/// More robots than rooms, which are of different sizes.
class RoomChoiceTest {
    private static final double CLEARANCE = 0.4; // m
    private static final double[][] SIDES = { // of rooms [m]
        {11, 10}, {6, 10}, {5, 4}, {2.3, 2.2}, {2.3, 2.2}, {2.3, 2.2}, {2.3, 2.2}
    };

    /// Rooms side by side, with doors between neighbors.
    ///
    /// @param order numbers of the rooms, from left to right
    private static RandomFloor row(List<Integer> order) {
        double across = order.stream().mapToDouble(room -> SIDES[room][0] + 0.2).sum();
        var plan = new RandomFloor(across + 0.2, 10.4);
        double left = 0.2;
        for (int room : order) {
            plan.room(left, 0.2, left + SIDES[room][0], 0.2 + SIDES[room][1]);
            left += SIDES[room][0] + 0.2;
            if (left < across) {
                plan.door(left - 0.2, 0.6, left, 1.7);
            }
        }
        return plan;
    }

    /// How many places each room has, the largest room first.
    private static List<Integer> counts(OccupancyGrid map, int number) {
        RoomMap rooms = RoomMap.of(map);
        assertThat(rooms.regions()).hasSize(SIDES.length);
        var counts = new int[SIDES.length];
        List<Point2d> places =
                new TeamPlaces(ReachableSpace.largest(map, CLEARANCE)).choose(number, PlaceObjective.ROOMS);
        places.forEach(place -> counts[rooms.regionAt(place).orElseThrow()]++);
        return rooms.regions().stream()
                .sorted(Comparator.comparingDouble(MapRegion::area).reversed())
                .map(region -> counts[region.number()])
                .toList();
    }

    /// By hand, of 210.24 m²: after one for each room, the next goes where number · area / total - seats is largest.
    @Trials(
            value = {"8, 2, 1, 1", "9, 3, 1, 1", "10, 4, 1, 1", "12, 5, 2, 1", "20, 10, 5, 1"},
            landing = 2)
    void eachRoomHasOneAndTheOthersGoWhereMostOfTheFloorIsForEach(int number, int first, int second, int third) {
        List<Integer> wanted = List.of(first, second, third, 1, 1, 1, 1);
        var order = new ArrayList<>(IntStream.range(0, SIDES.length).boxed().toList());
        for (int rotations = 0; rotations < SIDES.length; rotations++) {
            OccupancyGrid map = row(order).paint(0.1, 0).map();
            assertThat(counts(map, number)).as("rooms %s", order).isEqualTo(wanted);
            Collections.rotate(order, 1);
        }
    }

    @ParameterizedTest
    @CsvSource({"0.3", "0.9", "1.5707963"})
    void onRotatedMapsRoomsHaveTheSameNumberOfPlaces(double angle) {
        OccupancyGrid map = row(List.of(3, 2, 4, 1, 5, 0, 6)).paint(0.05, angle).map();
        assertThat(counts(map, 10)).containsExactly(4, 1, 1, 1, 1, 1, 1);
    }
}
