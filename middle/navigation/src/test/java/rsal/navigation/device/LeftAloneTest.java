package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.LaserScan;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.navigation.grid.ScanMapper.PosedScan;

class LeftAloneTest {
    private static final Point2d PLACE = new Point2d(3, 4);
    private static final Instant NOW = Instant.EPOCH;

    private final LeftAlone places = new LeftAlone();

    private static PosedScan scan(double x) {
        return new PosedScan(new Pose2d(x, 0, 0), new LaserScan(Pose2d.ORIGIN, 0, 1, 0, 10, new float[] {1}));
    }

    @Test
    void aPlaceHasOneMoreChanceAfterAWhile() {
        Instant later = NOW.plus(LeftAlone.WHILE);
        places.add(PLACE, NOW);

        assertThat(places.at(later.minus(Duration.ofSeconds(1)))).containsExactly(PLACE);
        assertThat(places.at(later)).isEmpty();

        places.add(new Point2d(3.2, 4), later);
        assertThat(places.at(later.plus(Duration.ofDays(1)))).hasSize(1);
    }

    @Test
    void allAreForgottenWhenALoopMovesTheMap() {
        places.follow(List.of(List.of(scan(0), scan(1)), List.of()));
        places.add(PLACE, NOW);
        places.follow(List.of(List.of(scan(0.05), scan(1.1), scan(2)), List.of(scan(9))));
        assertThat(places.at(NOW)).containsExactly(PLACE);

        places.follow(List.of(List.of(scan(0.05), scan(1.1), scan(2.5)), List.of(scan(9))));
        assertThat(places.at(NOW)).isEmpty();

        places.add(PLACE, NOW);
        places.follow(List.of(List.of(scan(0.05), scan(1.1), scan(2.5)), List.of(scan(9))));
        assertThat(places.at(NOW)).containsExactly(PLACE);
    }

    @Test
    void allAreForgottenWhenARobotBeginsAnotherMap() {
        places.follow(List.of(List.of(scan(0), scan(1))));
        places.add(PLACE, NOW);
        places.follow(List.of(List.of(scan(0))));

        assertThat(places.at(NOW)).isEmpty();
    }
}
