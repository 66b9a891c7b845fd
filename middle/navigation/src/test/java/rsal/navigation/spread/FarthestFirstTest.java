package rsal.navigation.spread;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.navigation.rooms.RandomFloor;

class FarthestFirstTest {
    private static final double CLEARANCE = 0.4; // m

    /// Filled until there is no room for more.
    @ParameterizedTest
    @ValueSource(doubles = {3, 3.3, 3.6, 4, 4.3, 4.7, 5.1})
    void keepsTwiceTheClearanceBetweenAllPairsInACrowdedRoom(double side) {
        OccupancyGrid map = new RandomFloor(side + 0.4, side + 0.4)
                .room(0.2, 0.2, side + 0.2, side + 0.2)
                .paint(0.1, 0.2)
                .map();
        var candidates = new Candidates(ReachableSpace.largest(map, CLEARANCE));
        int[] may = candidates.standing(candidates.count());
        for (int first = 0; first < may.length; first += 7) {
            int[] chosen = FarthestFirst.extended(candidates, may, new int[] {may[first]}, may.length);
            assertThat(chosen).hasSizeLessThan(may.length);
            for (int i = 0; i < chosen.length; i++) {
                for (int j = 0; j < i; j++) {
                    assertThat(candidates.place(chosen[i]).distanceTo(candidates.place(chosen[j])))
                            .as("places %d and %d from %d on", j, i, first)
                            .isGreaterThanOrEqualTo(2 * CLEARANCE);
                }
            }
        }
    }
}
