package rsal.server.history;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.data.LaserScan;
import rsal.data.Pose2d;

class BytesTest {
    private static LaserScan scan(int beams) {
        return new LaserScan(Pose2d.ORIGIN, 0, 0.1, 0, 8, new float[beams]);
    }

    @Test
    void arraysAndWordsCountAsLongAsTheyAre() {
        assertThat(Bytes.beyond(null, scan(360)) - Bytes.beyond(null, scan(180)))
                .isEqualTo(180 * Float.BYTES);
        assertThat(Bytes.beyond(null, "12345") - Bytes.beyond(null, "1")).isEqualTo(4);
        assertThat(Bytes.beyond(null, Optional.of("12345"))).isGreaterThan(Bytes.beyond(null, Optional.empty()));
    }

    @Test
    void whatIsSharedCountsOnce() {
        LaserScan scan = scan(180);
        assertThat(Bytes.beyond(scan, scan)).isZero();
        assertThat(Bytes.beyond(scan(180), scan)).isGreaterThan(720);
        long all = Bytes.beyond(null, Map.of("r1", List.of(scan, scan(180))));
        long more = Bytes.beyond(Map.of("r1", List.of(scan, scan(180))), Map.of("r1", List.of(scan, scan(180))));
        assertThat(more).isBetween(720L, all - 720);
    }
}
