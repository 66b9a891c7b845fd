package rsal.navigation.grid;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rsal.data.LaserScan;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.navigation.grid.ScanMapper.PosedScan;
import rsal.navigation.grid.ScanMapper.Settings;

class ScanMapperTest {
    private static final Settings SETTINGS = Settings.of(0.1);

    @Test
    void drawsWhatABeamHitAndFreesTheWayThere() {
        OccupancyGrid map = draw(new PosedScan(new Pose2d(5.05, 2.05, Math.PI / 2), scan(3)));

        assertThat(map.at(map.column(5.05), map.row(5.05))).isEqualTo(OccupancyGrid.OCCUPIED);
        assertThat(map.isFree(5.05, 2.05)).isTrue();
        assertThat(map.isFree(5.05, 4.95)).isTrue();
        assertThat(map.at(map.column(5.05), map.row(5.15))).isEqualTo(OccupancyGrid.UNKNOWN);
        assertThat(map.at(map.column(5.15), map.row(3.05))).isEqualTo(OccupancyGrid.UNKNOWN);
    }

    @Test
    void aLaserIsWhereItIsMounted() {
        var ahead = new LaserScan(new Pose2d(0.5, 0, Math.PI / 2), 0, 0, 0, 80, new float[] {2});

        OccupancyGrid map = draw(new PosedScan(new Pose2d(1.05, 1.05, 0), ahead));

        assertThat(map.at(map.column(1.55), map.row(3.05))).isEqualTo(OccupancyGrid.OCCUPIED);
    }

    @Test
    void whoStoodThereOnceIsForgotten() {
        Pose2d here = new Pose2d(0.05, 0.05, 0);
        OccupancyGrid map = draw(
                new PosedScan(here, scan(1)),
                new PosedScan(here, scan(3)),
                new PosedScan(here, scan(3)),
                new PosedScan(here, scan(3)));

        assertThat(map.isFree(1.05, 0.05)).isTrue();
        assertThat(map.at(map.column(3.05), map.row(0.05))).isEqualTo(OccupancyGrid.OCCUPIED);
    }

    @Test
    void beamsThatHitNothingFreeSomeOfTheirWayAndBrokenOnesNone() {
        Pose2d here = new Pose2d(0.05, 0.05, 0);
        OccupancyGrid map = draw(
                new PosedScan(here, scan(29)),
                new PosedScan(new Pose2d(0.05, 1.05, 0), scan(Float.POSITIVE_INFINITY)),
                new PosedScan(new Pose2d(0.05, 2.05, 0), scan(Float.NaN)),
                new PosedScan(new Pose2d(0.05, 3.05, 0), scan(Float.NEGATIVE_INFINITY)));

        assertThat(map.isFree(9.05, 1.05)).isTrue();
        assertThat(map.at(map.column(10.35), map.row(1.05))).isEqualTo(OccupancyGrid.UNKNOWN);
        assertThat(IntStream.range(0, map.width()))
                .allMatch(column -> map.at(column, map.row(2.05)) == OccupancyGrid.UNKNOWN
                        && map.at(column, map.row(3.05)) == OccupancyGrid.UNKNOWN);
    }

    @Test
    void aHallWhoseWallsAreTooFarIsFreeAsFarAsItIsSeen() {
        var ranges = new float[360];
        Arrays.fill(ranges, Float.POSITIVE_INFINITY);
        var around = new LaserScan(Pose2d.ORIGIN, 0, Math.toRadians(1), 0, 4, ranges);

        OccupancyGrid map = ScanMapper.draw(
                List.of(new PosedScan(new Pose2d(0.05, 0.05, 0), around)), new Settings(0.1, 4, 4, 0.9, -0.4, 4));

        assertThat(map.isFree(3.85, 0.05)).isTrue();
        assertThat(map.isFree(0.05, -3.85)).isTrue();
        assertThat(map.width()).isBetween(80, 100);
    }

    @Test
    void aBeamAlongTheBorderOfCellsFreesThemToItsEnd() {
        for (int quarter = 0; quarter < 4; quarter++) {
            var from = new Pose2d(2, 2, quarter * Math.PI / 2);

            OccupancyGrid map = draw(new PosedScan(from, scan(1.55F)));

            for (double along = 0.25; along < 1.5; along += 0.1) {
                Pose2d left = from.compose(new Pose2d(along, 0.05, 0));
                Pose2d right = from.compose(new Pose2d(along, -0.05, 0));
                assertThat(map.isFree(left.x(), left.y()) || map.isFree(right.x(), right.y()))
                        .as("%.2f m along %s", along, from)
                        .isTrue();
            }
        }
    }

    @Test
    void refusesWhatCanNotBeDrawn() {
        assertThatThrownBy(ScanMapperTest::draw).hasMessageContaining("no scans");
        assertThatThrownBy(() -> draw(new PosedScan(new Pose2d(Double.NaN, 0, 0), scan(1))))
                .hasMessageContaining("NaN");
        assertThatThrownBy(() ->
                        draw(new PosedScan(Pose2d.ORIGIN, scan(1)), new PosedScan(new Pose2d(1e5, 1e5, 0), scan(1))))
                .hasMessageContaining("larger cells");
    }

    private static OccupancyGrid draw(PosedScan... scans) {
        return ScanMapper.draw(List.of(scans), SETTINGS);
    }

    private static LaserScan scan(float range) {
        return new LaserScan(Pose2d.ORIGIN, 0, 0, 0, 80, new float[] {range});
    }
}
