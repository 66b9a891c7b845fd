package rsal.scenario.installed;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rsal.data.FreeSpace;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.settings.Location;
import rsal.settings.Problem;

class MapFactsTest {
    private final MapFacts facts = new MapFacts();

    private static OccupancyGrid map(double resolution) {
        return new OccupancyGrid(30, 20, resolution, 0, 0, new byte[600]);
    }

    @Test
    void theSameMapHasTheSameWorldAndSpace() {
        OccupancyGrid map = map(0.1);
        var again = new OccupancyGrid(30, 20, 0.1, 0, 0, map.cells());
        assertThat(facts.scene(again, List.of())).isSameAs(facts.scene(map, List.of()));
        assertThat(facts.freeSpace(again, 0.42, 0.3)).isSameAs(facts.freeSpace(map, 0.4, 0.3));
    }

    @Test
    void otherMapsWarningsAndDistancesDiffer() {
        OccupancyGrid map = map(0.1);
        var warning = new Problem(Location.of("map"), "It is old.", "");
        assertThat(facts.scene(map, List.of(warning)).warnings()).containsExactly(warning);
        assertThat(facts.scene(map, List.of()).warnings()).isEmpty();
        assertThat(facts.scene(map(0.2), List.of()).map().resolution()).isEqualTo(0.2);
        FreeSpace space = facts.freeSpace(map, 0.4, 0.4);
        assertThat(facts.freeSpace(map(0.1), 0.4, 0.4)).isNotSameAs(space);
        assertThat(facts.freeSpace(map, 0.4, 0.2)).isNotSameAs(space);
        assertThat(places(facts.freeSpace(map, 0.6, 0.6))).isEqualTo(places(new FreeSpace(map, 0.6, 0.6)));
    }

    private static List<Pose2d> places(FreeSpace space) {
        var random = new SplittableRandom(7);
        return IntStream.range(0, 20)
                .mapToObj(_ -> space.choose(random, _ -> true).orElseThrow())
                .toList();
    }

    @Test
    void onlyTheNewestFewAreKept() {
        OccupancyGrid map = map(0.1);
        FreeSpace first = facts.freeSpace(map, 0.1, 0.1);
        for (int i = 1; i <= 16; i++) {
            facts.freeSpace(map, 0.1 + i * 0.1, 0.1);
        }
        assertThat(facts.freeSpace(map, 0.1, 0.1)).isNotSameAs(first);
    }
}
