package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.testkit.LongTest;

class GlobalSearchTest {
    private static final ThreadMXBean THREADS = ManagementFactory.getPlatformMXBean(ThreadMXBean.class);

    @Test
    @LongTest
    void aMapThatIsTooLargeIsNotSearched() {
        Beams beams = new Seen(Seen.ROOM).beams(Seen.ROOM.pose('a', 30), 30);
        for (int side : new int[] {290, 310}) {
            var cells = new byte[side * side];
            cells[side / 2 * side + side / 2] = OccupancyGrid.OCCUPIED;
            var map = new LocalizationMap(new OccupancyGrid(side, side, 1, 0, 0, cells), 0.1, 0.05);
            assertThat(map.freeFloor()).isEqualTo(side * side - 1);
            assertThat(map.isSearchable()).isEqualTo(side == 290);
            assertThat(new GlobalSearch(map).candidates(beams, 3).isEmpty()).isEqualTo(side != 290);
        }
    }

    @Test
    void allocatesNothingForABeam() {
        var search = new GlobalSearch(new LocalizationMap(Seen.ROOM.grid(), 0.1, 0.05));
        Pose2d here = Seen.ROOM.pose('a', 30);
        Beams beams = new Seen(Seen.ROOM).beams(here, 400);
        search.score(beams, here); // loads classes

        long before = THREADS.getCurrentThreadAllocatedBytes();
        search.score(beams, here);
        long bytes = THREADS.getCurrentThreadAllocatedBytes() - before;

        assertThat(bytes).isLessThan(beams.count());
    }
}
