package rsal.data;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;

/// Ranges after REP 117.
class RangesTest {
    private static final float[] RANGES = {
        0.5f, 5, 0.1f, 0.09f, 5.1f, Float.NEGATIVE_INFINITY, Float.POSITIVE_INFINITY, Float.NaN
    };
    private static final boolean[] HITS = {true, true, false, false, false, false, false, false};

    @Test
    void onlyWhatWasMeasuredIsAHit() {
        var scan = new LaserScan(Pose2d.ORIGIN, -1, 0.5, 0.2, 5, RANGES);
        var sonars = new RangeArray(mounts(RANGES.length), 0.5, 0.2, 5, RANGES);
        for (int i = 0; i < RANGES.length; i++) {
            assertThat(scan.isHit(i)).as("beam of %s", RANGES[i]).isEqualTo(HITS[i]);
            assertThat(sonars.isHit(i)).as("sonar of %s", RANGES[i]).isEqualTo(HITS[i]);
        }
        assertThat(scan.count()).isEqualTo(8);
        assertThat(scan.angle(3)).isCloseTo(0.5, within(1e-12));
    }

    @Test
    void noughtIsNoHitWhateverTheLeastRange() {
        float[] ranges = {0, 0.001f};
        var scan = new LaserScan(Pose2d.ORIGIN, -1, 0.5, 0, 5, ranges);
        var sonars = new RangeArray(mounts(2), 0.5, 0, 5, ranges);
        assertThat(scan.isHit(0)).isFalse();
        assertThat(sonars.isHit(0)).isFalse();
        assertThat(scan.isHit(1)).isTrue();
        assertThat(sonars.isHit(1)).isTrue();
    }

    @Test
    void eachSensorHasARange() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new RangeArray(mounts(3), 0.5, 0.2, 5, new float[2]))
                .withMessageContaining("3 sensors")
                .withMessageContaining("2");
    }

    private static List<Pose2d> mounts(int count) {
        return Collections.nCopies(count, Pose2d.ORIGIN);
    }
}
