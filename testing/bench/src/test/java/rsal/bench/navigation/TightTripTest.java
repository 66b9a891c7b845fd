package rsal.bench.navigation;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.bench.navigation.TightTrip.Outcome;
import rsal.testkit.LongTest;

class TightTripTest {
    @Test
    void robotsGetOutOfANook() {
        assertThat(TightTrip.outOfANook(1))
                .hasSize(2)
                .allSatisfy(trip -> assertThat(trip.drive("snd", Duration.ofMinutes(5)))
                        .matches(Outcome::reached)
                        .matches(outcome -> outcome.contacts() == 0));
    }

    @Test
    void robotsGetAwayFromThings() {
        List<TightTrip> trips = TightTrip.besideThings(4, 1);
        assertThat(trips).hasSize(4).isEqualTo(TightTrip.besideThings(4, 1));
        assertThat(trips)
                .extracting(trip -> trip.start().position().distanceTo(trip.goal()))
                .allMatch(far -> far >= 2 && far <= 11);
        assertThat(trips)
                .filteredOn(trip -> trip.drive("vfh", Duration.ofSeconds(200)).reached())
                .hasSizeGreaterThanOrEqualTo(3);
    }

    /// The simulator refuses robots that would touch something.
    @Test
    @LongTest
    void startsHaveRoom() {
        for (long seed = 2; seed < 12; seed++) {
            assertThat(TightTrip.besideThings(10, seed))
                    .allSatisfy(
                            trip -> assertThat(trip.drive("vfh", Duration.ZERO).contacts())
                                    .isZero());
        }
    }

    @Test
    void whoHasNoTimeDoesNotGetThere() {
        assertThat(TightTrip.outOfANook(1))
                .noneMatch(trip -> trip.drive("vfh", Duration.ofSeconds(2)).reached());
    }

    @Test
    void robotsCrossADoor() {
        try (var run = new DoorRun("vfh", 1)) {
            run.run(Duration.ofMinutes(2));
            assertThat(run.reached()).isPositive();
            assertThat(run.contacts()).isZero();
        }
    }
}
