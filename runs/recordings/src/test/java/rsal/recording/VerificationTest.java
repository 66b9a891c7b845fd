package rsal.recording;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import rsal.engine.report.RunEvent;
import rsal.recording.Recording.Hashed;
import rsal.recording.Verification.Compared;
import rsal.recording.Verification.Finding;

/// A run that is not the same is never told to be, whatever comes after its first difference.
class VerificationTest {
    private static final RunEvent BEGINS = event(0, "run", "1 robot");
    private static final RunEvent TURNS = event(2, "agent", "turning");
    private static final RunEvent BY_HAND = event(3, "operator", "emergency stop");
    private static final RunEvent ENDS = event(4, "run", "ends: success");

    @Test
    void whatIsEqualIsTheSame() {
        Verification verification = of(true, BEGINS, TURNS, ENDS);
        verification.compare(BEGINS, "a");
        verification.compare(TURNS, "b");
        verification.compare(ENDS, "c");
        verification.ended();
        assertThat(found(verification)).isEqualTo(new Finding.Same(new Compared(3, 0, 0), Duration.ofSeconds(4), true));
    }

    @Test
    void anotherHashBeforeTheEndIsADifference() {
        Verification verification = of(true, BEGINS, TURNS, ENDS);
        verification.compare(BEGINS, "a");
        verification.compare(TURNS, "other");
        verification.compare(ENDS, "other");
        verification.ended();
        assertThat(found(verification)).isInstanceOfSatisfying(Finding.Different.class, VerificationTest::isAtTheTurn);
    }

    @Test
    void anotherHashBeforeSomebodySteppedInIsADifference() {
        Verification verification = of(true, BEGINS, TURNS, BY_HAND);
        verification.compare(BEGINS, "a");
        verification.compare(TURNS, "other");
        verification.compare(ENDS, "other");
        assertThat(found(verification)).isInstanceOfSatisfying(Finding.Different.class, VerificationTest::isAtTheTurn);
    }

    @Test
    void anotherHashBeforeARecordingBreaksOffIsADifference() {
        Verification verification = of(false, BEGINS, TURNS, ENDS);
        verification.compare(BEGINS, "a");
        verification.compare(TURNS, "other");
        verification.compare(event(9, "agent", "turning"), "other");
        assertThat(found(verification)).isInstanceOfSatisfying(Finding.Different.class, VerificationTest::isAtTheTurn);
    }

    private static void isAtTheTurn(Finding.Different different) {
        assertThat(different.time()).isEqualTo(TURNS.time());
        assertThat(different.equalUntil()).isEqualTo(BEGINS.time());
        assertThat(different.compared().events()).isOne();
        assertThat(different.recorded()).contains(TURNS);
        assertThat(different.now()).contains(TURNS);
    }

    /// Recorded with the hashes a, b, c; up to 5 s.
    private static Verification of(boolean isWhole, RunEvent first, RunEvent second, RunEvent third) {
        List<Hashed> recorded = List.of(new Hashed(first, "a"), new Hashed(second, "b"), new Hashed(third, "c"));
        return new Verification(recorded, Map.of(), isWhole, Duration.ofSeconds(5), _ -> List.of());
    }

    private static Finding found(Verification verification) {
        return verification.finding().toCompletableFuture().getNow(null);
    }

    private static RunEvent event(long seconds, String kind, String text) {
        return new RunEvent(1 + seconds, Duration.ofSeconds(seconds), kind, "", text);
    }
}
