package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
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

    /// The mean over beams: a hit counts by the likelihood of its end, one that is short or leaves the map like
    /// one that is unlikely, and one that goes through a wall twice that.
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

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 5, 32, 33, 64, 65, 100, 400})
    void ofManyBeamsSomeAreLookedAtThatAreEvenlySpread(int count) {
        var beams = new Beams(new float[count], new float[count], new float[count], new float[count], 0.3);
        for (int i = 0; i < count; i++) {
            beams.x()[i] = i;
            beams.y()[i] = -i;
            beams.originX()[i] = 2 * i;
            beams.originY()[i] = 3 * i;
        }
        Beams thin = GlobalSearch.thin(beams);
        assertThat(thin.count()).isBetween(Math.min(count, 17), 32);
        assertThat(thin.cone()).isEqualTo(0.3);
        for (int i = 0; i < thin.count(); i++) {
            float beam = thin.x()[i];
            assertThat(beam).isEqualTo(i == 0 ? 0 : thin.x()[i - 1] + thin.x()[1]);
            assertThat(thin.y()[i]).isEqualTo(-beam);
            assertThat(thin.originX()[i]).isEqualTo(2 * beam);
            assertThat(thin.originY()[i]).isEqualTo(3 * beam);
        }
        if (count > 0) {
            assertThat(count - thin.x()[thin.count() - 1])
                    .as("beams after the last")
                    .isLessThanOrEqualTo(13);
        }
    }

    /// All poses of a step of 0.3 m and of 5° that are on free floor, 0.15 m from walls, by bins of three
    /// steps.
    private static Map<List<Integer>, Double> bestOfBins(LocalizationMap map, Beams beams) {
        OccupancyGrid grid = map.grid;
        int stride = (int) Math.round(0.3 / grid.resolution());
        var best = new HashMap<List<Integer>, Double>();
        for (int row = 0; row * stride < grid.height(); row++) {
            for (int column = 0; column * stride < grid.width(); column++) {
                double x = grid.x(Math.min(column * stride + stride / 2, grid.width() - 1));
                double y = grid.y(Math.min(row * stride + stride / 2, grid.height() - 1));
                if (!grid.isFree(x, y) || map.toOccupied.at(x, y) < 0.15) {
                    continue;
                }
                for (int heading = 0; heading < 72; heading++) {
                    var bin = List.of(column / 3, row / 3, heading / 3);
                    best.merge(bin, blurred(map, beams, new Pose2d(x, y, Math.toRadians(5 * heading))), Math::max);
                }
            }
        }
        return best;
    }

    /// The logarithm of how likely a scan is on the blurred map.
    private static double blurred(LocalizationMap map, Beams beams, Pose2d pose) {
        double sum = 0;
        for (int i = 0; i < beams.count(); i++) {
            Point2d end = pose.transform(new Point2d(beams.x()[i], beams.y()[i]));
            sum += map.nearWalls.log(end.x(), end.y());
        }
        return sum;
    }

    @Test
    void firstTheBestPoseOfEachBinIsTaken() {
        for (DrawnMap drawn : List.of(Seen.ROOM, new DrawnMap(Seen.hall(52, 31, -2, 3), Map.of()))) {
            var map = new LocalizationMap(drawn.grid(), 0.1, 0.05);
            Beams beams = new Seen(Seen.ROOM).beams(Seen.ROOM.pose('a', 33), 17);
            Map<List<Integer>, Double> best = bestOfBins(map, beams);
            List<GlobalSearch.Candidate> found = new GlobalSearch(map).coarse(beams);
            assertThat(found).hasSameSizeAs(best.keySet());
            int different = 0; // where a beam ends at the very border of a cell
            for (GlobalSearch.Candidate candidate : found) {
                Pose2d pose = candidate.mapFromBase();
                double heading = Math.toDegrees(pose.theta());
                var bin = List.of(
                        (int) ((pose.x() - map.grid.originX()) / 0.9),
                        (int) ((pose.y() - map.grid.originY()) / 0.9),
                        (int) Math.round(heading < -1e-9 ? heading + 360 : heading) / 5 / 3);
                assertThat(best).as("%s", pose).containsKey(bin);
                boolean same = Math.abs(candidate.score() - best.get(bin)) < 1e-3
                        && Math.abs(candidate.score() - blurred(map, beams, pose)) < 1e-3;
                different += same ? 0 : 1;
            }
            assertThat(different).isLessThan(2 + found.size() / 50);
        }
    }

    /// On a large floor with posts here and there.
    @Test
    void sixThousandBinsAreLookedAt() {
        int[] posts = new SplittableRandom(3).ints(300, 0, 160 * 150).toArray();
        var map = new LocalizationMap(Seen.hall(160, 150, 0, 0, posts), 0.1, 0.05);
        Beams beams = new Seen(Seen.ROOM).beams(Seen.ROOM.pose('a', 33), 7);
        double[] scores = bestOfBins(map, beams).values().stream()
                .mapToDouble(Double::doubleValue)
                .sorted()
                .toArray();
        assertThat(scores.length).isGreaterThan(6_500);
        List<GlobalSearch.Candidate> found = new GlobalSearch(map).coarse(beams);
        double least = scores[scores.length - 6_000];
        assertThat(found).allMatch(candidate -> candidate.score() >= least - 1e-3);
        assertThat(found.size()).isBetween(6_000, scores.length - 1);
    }

    /// From as far off as the nearest pose that was tried is.
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void climbsToWhereNoStepIsBetter(long seed) {
        var random = new SplittableRandom(seed);
        var map = new LocalizationMap(Seen.ROOM.grid(), 0.1, 0.05);
        var search = new GlobalSearch(map);
        Pose2d truth = Seen.ROOM.pose(seed % 2 == 0 ? 'a' : 'b', random.nextDouble(360));
        Beams beams = new Seen(Seen.ROOM).beams(truth, 60);
        Pose2d start = new Pose2d(
                truth.x() + random.nextDouble(-0.15, 0.15),
                truth.y() + random.nextDouble(-0.15, 0.15),
                truth.theta() + random.nextDouble(-0.04, 0.04));
        Pose2d top = search.climb(beams, start);
        double reached = map.walls.log(beams, top.x(), top.y(), top.theta());
        assertThat(reached).isGreaterThan(map.walls.log(beams, start.x(), start.y(), start.theta()));
        assertThat(top.isNear(truth, 0.08, 0.04)).as("%s, not %s", top, truth).isTrue();
        double meters = 0.3 / 2 / 8;
        double radians = Math.PI / 72 / 8;
        for (int sign = -1; sign <= 1; sign += 2) {
            for (Pose2d next : List.of(
                    new Pose2d(top.x() + sign * meters, top.y(), top.theta()),
                    new Pose2d(top.x(), top.y() + sign * meters, top.theta()),
                    new Pose2d(top.x(), top.y(), top.theta() + sign * radians))) {
                assertThat(map.walls.log(beams, next.x(), next.y(), next.theta()))
                        .isLessThanOrEqualTo(reached);
            }
        }
    }

    /// The beams would fit best where a wall is, from 2.9 m to 3.3 m.
    @Test
    void climbsNowhereThatIsNotFree() {
        var wall = new int[4 * 58];
        for (int i = 0; i < wall.length; i++) {
            wall[i] = (i / 4 + 1) * 60 + 29 + i % 4;
        }
        var map = new LocalizationMap(Seen.hall(60, 60, 0, 0, wall), 0.1, 0.05);
        Pose2d top = new GlobalSearch(map).climb(Seen.straight(2.9f, 2.9f, 2.9f), new Pose2d(2.7, 3, 0));
        assertThat(map.grid.isFree(top.x(), top.y())).isTrue();
        assertThat(top.x()).isBetween(2.8, 2.9);
    }

    /// Farther off than a step.
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void slidesToWhereTheScanWasTaken(long seed) {
        var random = new SplittableRandom(seed);
        var search = new GlobalSearch(new LocalizationMap(Seen.ROOM.grid(), 0.1, 0.05));
        Pose2d truth = Seen.ROOM.pose(seed % 2 == 0 ? 'a' : 'b', random.nextDouble(360));
        Beams beams = new Seen(Seen.ROOM).beams(truth, 60);
        Pose2d start = new Pose2d(
                truth.x() + random.nextDouble(-0.25, 0.25),
                truth.y() + random.nextDouble(-0.25, 0.25),
                truth.theta() + random.nextDouble(-0.15, 0.15));
        Pose2d found = search.slide(beams, start);
        assertThat(found.isNear(truth, 0.03, 0.02))
                .as("%s, not %s", found, truth)
                .isTrue();
    }

    @Test
    void ofTwoPlacesTheOneThatFitsIsTaken() {
        var search = new GlobalSearch(new LocalizationMap(Seen.ROOM.grid(), 0.1, 0.05));
        Pose2d truth = Seen.ROOM.pose('a', 30);
        Beams beams = new Seen(Seen.ROOM).beams(truth, 60);
        Pose2d off = truth.compose(new Pose2d(0.2, 0, 0));
        var expected = new GlobalSearch.Candidate(search.score(beams, truth), truth);
        assertThat(search.better(beams, truth, off)).isEqualTo(expected);
        assertThat(search.better(beams, off, truth)).isEqualTo(expected);
    }
}
