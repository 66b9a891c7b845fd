package rsal.server.frame;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;

class TrailMakerTest {
    @Test
    void aTrailHasPlacesThatAreApart() {
        var trails = new TrailMaker(2);
        trails.add(0, 1, 0, 0);
        trails.add(0, 1.1, 0.04, 0);
        trails.add(0, 1.2, 0.08, 0.00049);
        trails.add(1, 1.2, 7, 7);
        assertThat(trails.trails().robots().getFirst().times()).containsExactly(1.0, 1.2);
        assertThat(trails.trails().robots().getFirst().xs()).containsExactly(0.0, 0.08);
        assertThat(trails.trails().robots().getFirst().ys()).containsExactly(0.0, 0.0);
        assertThat(trails.trails().robots().getLast().xs()).containsExactly(7.0);
    }

    /// However long it stood before.
    @Test
    void whoWasPutElsewhereDidNotDriveThere() {
        var trails = new TrailMaker(1);
        for (int second = 0; second < 20; second++) {
            trails.add(0, second, 0, 0);
        }
        trails.add(0, 19.1, 8, 0);
        trails.add(0, 20.1, 10.5, 0); // fast, but it could
        assertThat(trails.trails().robots().getFirst().driven()).containsExactly(false, false, true);
    }

    @Test
    void trailsOfManyRobotsAreCoarser() {
        assertThat(TrailMaker.spacing(6)).isLessThan(Duration.ofMillis(10));
        assertThat(TrailMaker.spacing(1000)).isEqualTo(Duration.ofSeconds(1));
    }
}
