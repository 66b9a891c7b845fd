package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.testkit.DrawnMap;
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

    private static GlobalSearch.Verdict verdict(OccupancyGrid grid, Pose2d pose, float range) {
        var search = new GlobalSearch(new LocalizationMap(grid, 0.1, 0.05));
        return search.verdict(Seen.straight(range), 0, pose, Math.cos(pose.theta()), Math.sin(pose.theta()));
    }

    /// The wall begins 2.9 m away, and its cells' middles are 2.95 m away; hits deviate by 0.1 m.
    @ParameterizedTest
    @CsvSource({
        "2.6, SHORT", // more than three deviations before
        "2.7, HIT",
        "2.9, HIT",
        "3.1, SHORT", // behind the map's border, by less than four deviations
        "3.25, SHORT",
        "3.35, THROUGH",
        "20, THROUGH"
    })
    void beamsAreJudgedByTheWallThatTheyMeet(float range, GlobalSearch.Verdict verdict) {
        OccupancyGrid hall = Seen.hall(60, 60, 0, 0);
        for (double theta : new double[] {0, Math.PI / 2, Math.PI, -Math.PI / 2}) {
            assertThat(verdict(hall, new Pose2d(3, 3, theta), range))
                    .as("%.1f rad", theta)
                    .isEqualTo(verdict);
        }
    }

    /// Across a wall inside: behind it there is floor again.
    @ParameterizedTest
    @CsvSource({"0.9, HIT", "1.2, HIT", "1.35, SHORT", "1.5, THROUGH", "2, THROUGH"})
    void beamsThatEndBehindAWallWentThroughIt(float range, GlobalSearch.Verdict verdict) {
        var wall = new int[58];
        for (int row = 1; row < 59; row++) {
            wall[row - 1] = row * 60 + 40;
        }
        assertThat(verdict(Seen.hall(60, 60, 0, 0, wall), new Pose2d(3, 3, 0), range))
                .isEqualTo(verdict);
    }

    /// The wall is 2.9 m from the base, but the laser stands 1 m ahead of it or behind, and 0.5 m aside.
    @ParameterizedTest
    @CsvSource({"1, 0.5", "-1, 0.5", "1, -0.5", "-1, -0.5"})
    void rangesAreThoseFromTheLaser(float ahead, float left) {
        var search = new GlobalSearch(new LocalizationMap(Seen.hall(60, 60, 0, 0), 0.1, 0.05));
        for (double theta : new double[] {0, Math.PI / 2, Math.PI, -Math.PI / 2}) {
            Pose2d pose = new Pose2d(3, 3, theta);
            for (float end : new float[] {2.4f, 2.9f, 3.25f, 3.35f}) {
                var beams = new Beams(new float[] {end}, new float[] {left}, new float[] {ahead}, new float[] {left});
                assertThat(search.verdict(beams, 0, pose, Math.cos(theta), Math.sin(theta)))
                        .as("%.2f m at %.1f rad", end, theta)
                        .isEqualTo(
                                end == 2.9f
                                        ? GlobalSearch.Verdict.HIT
                                        : end == 3.35f ? GlobalSearch.Verdict.THROUGH : GlobalSearch.Verdict.SHORT);
            }
        }
    }

    /// From outside of the map nothing of it can be seen.
    @Test
    void aLaserOutsideTheMapSeesThroughItsWalls() {
        assertThat(verdict(Seen.hall(60, 60, 0, 0), new Pose2d(-2, 3, 0), 4)).isEqualTo(GlobalSearch.Verdict.THROUGH);
    }

    @Test
    void nobodyKnowsOfBeamsThatLeaveTheMap() {
        assertThat(verdict(Seen.CUT_OFF.grid(), Seen.CUT_OFF.pose('@', 0), 3)).isEqualTo(GlobalSearch.Verdict.OUTSIDE);
    }

    /// The mean over beams: a hit counts by the likelihood of its end, one that is short or leaves the map like one
    /// that
    /// is unlikely, and one that goes through a wall twice that.
    @Test
    void theScoreIsTheMeanOfBeams() {
        var map = new LocalizationMap(Seen.hall(60, 60, 0, 0), 0.1, 0.05);
        var search = new GlobalSearch(map);
        Pose2d pose = new Pose2d(3, 3, 0);
        double unlikely = map.walls.unlikely();
        double hit = map.walls.log(5.9, 3);
        assertThat(search.score(Seen.straight(2.9f), pose)).isCloseTo(hit, within(1e-6));
        assertThat(search.score(Seen.straight(1.5f), pose)).isCloseTo(unlikely, within(1e-6));
        assertThat(search.score(Seen.straight(5), pose)).isCloseTo(2 * unlikely, within(1e-6));
        assertThat(search.score(Seen.straight(2.9f, 1.5f, 5, 5), pose))
                .isCloseTo((hit + 5 * unlikely) / 4, within(1e-6));
        assertThat(search.score(Seen.NOTHING, pose)).isCloseTo(unlikely, within(1e-6));
        assertThat(unlikely).isLessThan(hit);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void theBestPlaceIsWhereTheScanWasTaken(long seed) {
        var random = new SplittableRandom(seed);
        var seen = new Seen(Seen.ROOM);
        var search = new GlobalSearch(new LocalizationMap(Seen.ROOM.grid(), 0.1, 0.05));
        Pose2d truth;
        do {
            truth = new Pose2d(random.nextDouble(0.5, 9.5), random.nextDouble(0.5, 3.8), random.nextDouble(-3, 3));
        } while (!seen.isFree(truth));
        Beams beams = seen.beams(truth, 90);
        List<GlobalSearch.Candidate> found = search.candidates(beams, 5);
        assertThat(found.getFirst().mapFromBase().isNear(truth, 0.05, 0.03))
                .as("%s, not %s", truth, found.getFirst())
                .isTrue();
        for (int i = 0; i < found.size(); i++) {
            GlobalSearch.Candidate one = found.get(i);
            assertThat(one.score()).isCloseTo(search.score(beams, one.mapFromBase()), within(1e-9));
            assertThat(seen.isFree(one.mapFromBase())).isTrue();
            for (GlobalSearch.Candidate better : found.subList(0, i)) {
                assertThat(better.score()).isGreaterThanOrEqualTo(one.score());
                assertThat(better.mapFromBase().isNear(one.mapFromBase(), 0.3, 0.2))
                        .isFalse();
            }
        }
    }

    @Test
    void noMorePlacesComeThanWereAskedFor() {
        var search = new GlobalSearch(new LocalizationMap(Seen.ROOM.grid(), 0.1, 0.05));
        Beams beams = new Seen(Seen.ROOM).beams(Seen.ROOM.pose('a', 30), 60);
        assertThat(search.candidates(beams, 7)).hasSize(7);
        assertThat(search.candidates(beams, 2))
                .hasSize(2)
                .isEqualTo(search.candidates(beams, 7).subList(0, 2));
    }

    /// A square hall looks the same from four sides.
    @Test
    void allPlacesThatLookTheSameAreFound() {
        OccupancyGrid hall = Seen.hall(60, 60, 0, 0);
        var seen = new Seen(new DrawnMap(hall, Map.of()));
        Pose2d truth = new Pose2d(2.2, 3.5, 0.4);
        List<GlobalSearch.Candidate> found =
                new GlobalSearch(new LocalizationMap(hall, 0.1, 0.05)).candidates(seen.beams(truth, 90), 4);
        Pose2d middle = new Pose2d(3, 3, 0);
        for (int quarter = 0; quarter < 4; quarter++) {
            Pose2d twin = middle.compose(new Pose2d(0, 0, quarter * Math.PI / 2))
                    .compose(middle.inverse().compose(truth));
            assertThat(found)
                    .as("quarter %d", quarter)
                    .anyMatch(c -> c.mapFromBase().isNear(twin, 0.06, 0.04));
        }
    }
}
