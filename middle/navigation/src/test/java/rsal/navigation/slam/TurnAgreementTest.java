package rsal.navigation.slam;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;
import rsal.navigation.slam.Relation.Source;

class TurnAgreementTest {
    private final List<Relation> relations = new ArrayList<>();

    private void step(double wheels, double scan) {
        int from = relations.size() / 2;
        relations.add(turned(from, wheels, Source.ODOMETRY));
        relations.add(turned(from, scan, Source.SCANS));
    }

    private static Relation turned(int from, double radians, Source source) {
        return new Relation(
                from, from + 1, new Pose2d(0.5, 0, radians), Covariance2d.ofDeviations(0.05, 0.05, 0.05), source);
    }

    @Test
    void aMirroredWorldTurnsTheOtherWay() {
        for (int i = 0; i < 10; i++) {
            step(i % 2 == 0 ? 0.3 : -0.2, i % 2 == 0 ? -0.31 : 0.18);
        }

        assertThat(TurnAgreement.of(relations)).isEqualTo(new TurnAgreement(10, 10));
        assertThat(TurnAgreement.of(relations).isReversed()).isTrue();
    }

    @Test
    void wheelsThatSlippedNowAndThenAreNoReason() {
        for (int i = 0; i < 10; i++) {
            step(0.3, i < 4 ? -0.1 : 0.25);
        }

        assertThat(TurnAgreement.of(relations)).isEqualTo(new TurnAgreement(10, 4));
        assertThat(TurnAgreement.of(relations).isReversed()).isFalse();
    }

    @Test
    void fewAndSmallTurnsSayNothing() {
        for (int i = 0; i < 7; i++) {
            step(0.3, -0.3);
        }
        for (int i = 0; i < 20; i++) {
            step(0.05, -0.05);
        }
        relations.add(turned(99, 0.3, Source.ODOMETRY)); // no scan tells

        assertThat(TurnAgreement.of(relations)).isEqualTo(new TurnAgreement(7, 7));
        assertThat(TurnAgreement.of(relations).isReversed()).isFalse();
    }
}
