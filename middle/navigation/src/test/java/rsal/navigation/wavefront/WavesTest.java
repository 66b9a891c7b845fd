package rsal.navigation.wavefront;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap.Clearance;

class WavesTest {
    private static final int ROOM = 16;
    private static final int SIDE = 12; // cells

    private final Waves waves = new Waves(emptyRoom());

    @Test
    void goalAskedForAgainGetsAWave() {
        assertThat(hasWave(13)).isFalse();
        assertThat(hasWave(13)).isTrue();
        assertThat(hasWave(13)).isTrue();
    }

    @Test
    void manyGoalsInTurnTakeNoWavesFromEachOther() {
        int[] goals = IntStream.range(0, 2 * ROOM).toArray();
        for (int round = 0; round < 10; round++) {
            for (int goal : goals) {
                boolean isKept = round > 0 && goal < ROOM;
                assertThat(hasWave(goal)).as("goal %d in round %d", goal, round).isEqualTo(isKept);
            }
        }
    }

    @Test
    void goalInUseTakesTheWaveOfOneThatIsNot() {
        IntStream.range(0, ROOM).forEach(this::hasWave);
        IntStream.range(0, ROOM).forEach(this::hasWave);
        assertThat(hasWave(ROOM)).isFalse();
        assertThat(hasWave(ROOM)).isFalse();
        assertThat(hasWave(ROOM)).isTrue();
        assertThat(hasWave(0)).as("that was not asked for the longest").isFalse();
        assertThat(hasWave(1)).isTrue();
    }

    /// Asks for a goal, one of those inside the room.
    private boolean hasWave(int number) {
        int inside = SIDE - 2;
        int cell = (1 + number / inside) * SIDE + 1 + number % inside;
        return waves.from(cell, _ -> true).isPresent();
    }

    private static CostMap emptyRoom() {
        var cells = new byte[SIDE * SIDE];
        Arrays.fill(cells, OccupancyGrid.FREE);
        var room = new OccupancyGrid(SIDE, SIDE, 0.1, 0, 0, cells);
        return CostMap.of(room, DistanceField.toNotFree(room), new Clearance(0, 0, 0));
    }
}
