package rsal.navigation.grid;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.LaserScan;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.navigation.grid.ScanMapper.PosedScan;
import rsal.navigation.grid.ScanMapper.Settings;
import rsal.testkit.LongTest;

class IncrementalMapTest {
    private static final int SEEDS = 100;
    private static final double REACH = 4; // m
    private static final Settings SETTINGS = Settings.of(0.1).upTo(REACH, REACH);

    private final IncrementalMap drawing = new IncrementalMap(SETTINGS);

    @LongTest
    @Test
    void whatIsDrawnBitByBitIsWhatIsDrawnAtOnce() {
        for (int seed = 0; seed < SEEDS; seed++) {
            var random = new SplittableRandom(seed);
            var grown = new IncrementalMap(SETTINGS);
            var scans = new ArrayList<PosedScan>();
            do {
                int more = random.nextInt(scans.isEmpty() ? 1 : 0, 4);
                for (int i = 0; i < more; i++) {
                    scans.add(scan(random, 1 + scans.size()));
                }
                assertSame(grown.of(scans), ScanMapper.draw(scans, SETTINGS));
            } while (scans.size() < 30);
        }
    }

    @Test
    void allIsDrawnAnewWhenAScanMoved() {
        for (int seed = 0; seed < SEEDS; seed++) {
            var random = new SplittableRandom(seed);
            var moving = new IncrementalMap(SETTINGS);
            List<PosedScan> scans = scans(random, 10);
            moving.of(scans);
            int moved = random.nextInt(scans.size());
            double off = seed % 2 == 0 ? 1e-4 : 0.1; // m
            scans.set(
                    moved,
                    switch (seed % 3) {
                        case 0 -> by(scans.get(moved), off, 0, 0);
                        case 1 -> by(scans.get(moved), 0, -off, 0);
                        default -> by(scans.get(moved), 0, 0, -off / REACH);
                    });

            assertSame(moving.of(scans), ScanMapper.draw(scans, SETTINGS));
        }
    }

    @Test
    void otherScansFromTheSamePlacesAreDrawnAnew() {
        List<PosedScan> scans = scans(new SplittableRandom(1), 10);
        drawing.of(scans);
        scans.set(
                3,
                new PosedScan(
                        scans.get(3).mapFromBase(),
                        scan(new SplittableRandom(2), 1).scan()));
        assertSame(drawing.of(scans), ScanMapper.draw(scans, SETTINGS));

        scans.removeLast();
        assertSame(drawing.of(scans), ScanMapper.draw(scans, SETTINGS));

        scans.removeFirst();
        assertSame(drawing.of(scans), ScanMapper.draw(scans, SETTINGS));
    }

    @Test
    void whatCanNotBeDrawnLeavesTheRest() {
        List<PosedScan> scans = scans(new SplittableRandom(1), 10);
        assertThatThrownBy(() -> drawing.of(List.of())).hasMessageContaining("no scans");
        drawing.of(scans);
        var tooFar = new ArrayList<>(scans);
        tooFar.add(by(scan(new SplittableRandom(2), 1), 1e6, 1e6, 0));

        assertThatThrownBy(() -> drawing.of(tooFar)).hasMessageContaining("larger cells");
        scans.add(scan(new SplittableRandom(3), 1));
        assertSame(drawing.of(scans), ScanMapper.draw(scans, SETTINGS));
    }

    private static List<PosedScan> scans(SplittableRandom random, int count) {
        var scans = new ArrayList<PosedScan>();
        for (int i = 0; i < count; i++) {
            scans.add(scan(random, 5));
        }
        return scans;
    }

    /// Anything that a laser may tell, near and far, broken beams too, from anywhere, also along the borders of
    /// cells.
    ///
    /// @param far how far from the origin at most [m]
    private static PosedScan scan(SplittableRandom random, double far) {
        var ranges = new float[90];
        for (int i = 0; i < ranges.length; i++) {
            ranges[i] = switch (random.nextInt(10)) {
                case 0 -> Float.POSITIVE_INFINITY;
                case 1 -> Float.NaN;
                case 2 -> Float.NEGATIVE_INFINITY;
                default -> (float) random.nextDouble(0.1, 1.5 * REACH);
            };
        }
        boolean along = random.nextInt(4) == 0; // the borders of cells
        var place = along
                ? new Pose2d(random.nextInt(4) * 0.5, random.nextInt(4) * 0.5, random.nextInt(4) * Math.PI / 2)
                : new Pose2d(
                        random.nextDouble(-far, far),
                        random.nextDouble(-far, far),
                        random.nextDouble(-Math.PI, Math.PI));
        Pose2d baseFromLaser = along ? Pose2d.ORIGIN : new Pose2d(0.2, 0, 0.1);
        return new PosedScan(place, new LaserScan(baseFromLaser, 0, Math.toRadians(4), 0.05, 1.4 * REACH, ranges));
    }

    private static PosedScan by(PosedScan scan, double x, double y, double theta) {
        Pose2d was = scan.mapFromBase();
        return new PosedScan(new Pose2d(was.x() + x, was.y() + y, was.theta() + theta), scan.scan());
    }

    private static void assertSame(OccupancyGrid grid, OccupancyGrid other) {
        assertThat(List.of(grid.width(), grid.height(), grid.originX(), grid.originY()))
                .isEqualTo(List.of(other.width(), other.height(), other.originX(), other.originY()));
        assertThat(Arrays.equals(grid.cells(), other.cells())).isTrue(); // AssertJ would take a minute
    }
}
