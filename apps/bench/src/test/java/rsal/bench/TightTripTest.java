package rsal.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;

class TightTripTest {
    @Test
    void robotsGetOutOfANookAndAwayFromThings() {
        assertThat(TightTrip.outOfANook())
                .hasSize(2)
                .allMatch(trip -> trip.drive("vfh", 1, Duration.ofMinutes(5)).reached());
        List<TightTrip> beside = TightTrip.besideThings(4, 1);
        assertThat(beside).hasSize(4).isEqualTo(TightTrip.besideThings(4, 1));
        assertThat(beside)
                .allSatisfy(trip -> assertThat(trip.start().position().distanceTo(trip.goal()))
                        .isBetween(2.0, 11.0))
                .anyMatch(trip -> trip.drive("vfh", 1, Duration.ofSeconds(200)).reached());
    }

    @Test
    void whoHasNoTimeDoesNotGetThere() {
        assertThat(TightTrip.outOfANook())
                .noneMatch(trip -> trip.drive("vfh", 1, Duration.ofSeconds(2)).reached());
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
