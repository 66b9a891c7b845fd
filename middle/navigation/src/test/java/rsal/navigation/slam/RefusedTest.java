package rsal.navigation.slam;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;

class RefusedTest {
    /// Straight on, a meter from frame to frame.
    private static final List<Pose2d> POSES =
            IntStream.range(0, 60).mapToObj(i -> new Pose2d(i, 0, 0)).toList();

    /// Says that a frame is so far off to the left [m] of where the graph has it.
    private static Relation loop(int from, int to, double off) {
        var reported = new Pose2d(to - from, off, 0);
        return new Relation(from, to, reported, Covariance2d.ofDeviations(0.02, 0.02, 0.004), Relation.Source.LOOP);
    }

    private static List<Relation> reported(Refused refused, Relation... loops) {
        List<Relation> agreeing = List.of();
        for (Relation loop : loops) {
            refused.add(List.of(loop), loop.to());
            agreeing = refused.agreeing(POSES);
        }
        return agreeing;
    }

    @Test
    void framesInARowAreOneLook() {
        assertThat(reported(new Refused(), loop(2, 40, 0.3), loop(3, 41, 0.3), loop(4, 42, 0.3), loop(4, 43, 0.3)))
                .isEmpty();
    }

    @Test
    void looksApartThatAgreeAreReported() {
        assertThat(reported(new Refused(), loop(2, 40, 0.3), loop(9, 42, -0.4), loop(4, 44, 0.35)))
                .extracting(Relation::to)
                .containsExactly(40, 44);
    }

    @Test
    void looksThatDisagreeAreNot() {
        assertThat(reported(new Refused(), loop(2, 40, 0.3), loop(4, 44, 0.6), loop(6, 48, -0.3)))
                .isEmpty();
    }

    @Test
    void areReportedAgainWhenOneMoreAgreesOnly() {
        var refused = new Refused();
        assertThat(reported(refused, loop(2, 40, 0.3), loop(4, 44, 0.3))).hasSize(2);
        assertThat(reported(refused, loop(5, 45, 0.3), loop(6, 47, 0.3))).isEmpty();
        assertThat(reported(refused, loop(7, 48, 0.3))).hasSize(5);
    }

    @Test
    void oldOnesAreForgotten() {
        assertThat(reported(new Refused(), loop(2, 20, 0.3), loop(4, 50, 0.3))).isEmpty();
    }

    @Test
    void weighMoreThanHalfAsManyOthers() {
        List<Relation> two = List.of(loop(2, 40, 0.3), loop(4, 44, 0.3));
        assertThat(Refused.outweigh(two, List.of(loop(1, 30, 0), loop(1, 31, 0))))
                .isTrue();
        assertThat(Refused.outweigh(two, List.of(loop(1, 30, 0), loop(2, 35, 0))))
                .isFalse();
    }
}
