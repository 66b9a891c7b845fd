package rsal.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;

class PaceTest {
    @Test
    void runsAreTakenToGoOnAsTheyDidInThisSession() {
        assertThat(new Pace(40, 20, 30, Duration.ofSeconds(50)).left()).hasValue(Duration.ofSeconds(50));
        assertThat(new Pace(40, 0, 10, Duration.ofSeconds(50)).left()).hasValue(Duration.ofSeconds(150));
    }

    @Test
    void nobodyKnowsBeforeTheFirstHasEndedNorIsAnythingLeftInTheEnd() {
        assertThat(new Pace(40, 20, 20, Duration.ofSeconds(50)).left()).isEmpty();
        assertThat(new Pace(40, 0, 40, Duration.ofSeconds(50)).left()).isEmpty();
    }
}
