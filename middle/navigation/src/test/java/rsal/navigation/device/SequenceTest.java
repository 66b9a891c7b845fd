package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.navigation.grid.ScanMapper.PosedScan;

class SequenceTest {
    private final Sequence sequence = new Sequence();

    private static PosedScan scan(double x) {
        return new PosedScan(new Pose2d(x, 0, 0), new LaserScan(Pose2d.ORIGIN, 0, 1, 0, 10, new float[] {1}));
    }

    /// By robot.
    private List<Double> reported(List<List<Double>> places) {
        List<List<PosedScan>> scans = places.stream()
                .map(own -> own.stream().map(SequenceTest::scan).toList())
                .toList();
        return sequence.of(scans).stream().map(s -> s.mapFromBase().x()).toList();
    }

    @Test
    void whatCameLaterIsLater() {
        assertThat(reported(List.of(List.of(1.0), List.of(2.0, 3.0)))).containsExactly(1.0, 2.0, 3.0);
        assertThat(reported(List.of(List.of(1.0, 4.0), List.of(2.0, 3.0, 5.0), List.of(6.0))))
                .containsExactly(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);
    }

    @Test
    void scansThatMovedKeepTheirPlaces() {
        reported(List.of(List.of(1.0), List.of(2.0)));
        assertThat(reported(List.of(List.of(1.5, 3.0), List.of(2.5)))).containsExactly(1.5, 2.5, 3.0);
    }

    @Test
    void whoBeginsAnotherMapTakesBackTheOther() {
        reported(List.of(List.of(1.0, 2.0), List.of(3.0)));
        assertThat(reported(List.of(List.of(), List.of(3.0, 4.0)))).containsExactly(3.0, 4.0);
        assertThat(reported(List.of(List.of(5.0), List.of(3.0, 4.0)))).containsExactly(3.0, 4.0, 5.0);
        assertThat(reported(List.of(List.of(5.0), List.of(6.0)))).containsExactly(5.0, 6.0);
    }
}
