package rsal.navigation.slam;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;
import rsal.navigation.slam.Relation.Source;

class GraphResidualTest {
    private static final Pose2d METER = new Pose2d(1, 0, 0);

    private final List<Relation> relations = new ArrayList<>();

    private GraphResidual residual() {
        return GraphResidual.of(relations, List.of(Pose2d.ORIGIN, new Pose2d(1, 0, 0), new Pose2d(2, 0, 0)));
    }

    private void reported(int from, Pose2d fromFromTo, double deviation, Source source) {
        var covariance = Covariance2d.ofDeviations(deviation, deviation, 0.05);
        relations.add(new Relation(from, from + 1, fromFromTo, covariance, source));
    }

    @Test
    void wheelsMaySlipWhereAScanSaysSo() {
        reported(0, METER, 0.1, Source.ODOMETRY);
        reported(0, METER, 0.02, Source.SCANS);
        reported(1, new Pose2d(3, 0, 0), 0.1, Source.ODOMETRY);
        reported(1, new Pose2d(1.02, 0, 0), 0.02, Source.SCANS);

        assertThat(residual().wheels()).hasValueSatisfying(step -> {
            assertThat(step.from()).isEqualTo(1);
            assertThat(step.to()).isEqualTo(2);
            assertThat(step.meters()).isEqualTo(2, within(1e-9));
            assertThat(step.deviations()).isEqualTo(20, within(1e-9));
        });
        assertThat(residual().scans())
                .hasValueSatisfying(step -> assertThat(step.deviations()).isEqualTo(1, within(1e-9)));
        assertThat(residual().tooLarge()).isEmpty();
        assertThat(residual().blind()).isZero();
    }

    @Test
    void whatNothingThatWasReportedFitsIsTooMuch() {
        reported(0, METER, 0.1, Source.ODOMETRY);
        reported(1, new Pose2d(1.7, 0, 0), 0.1, Source.ODOMETRY);
        relations.add(
                new Relation(0, 2, new Pose2d(2, 0, 0), Covariance2d.ofDeviations(0.01, 0.01, 0.01), Source.LOOP));

        assertThat(residual().tooLarge())
                .hasValueSatisfying(step -> assertThat(step.deviations()).isEqualTo(7, within(1e-9)));
        assertThat(residual().steps()).isEqualTo(2);
        assertThat(residual().blind()).isEqualTo(2);
        assertThat(residual().scans()).isEmpty();

        reported(1, new Pose2d(1.3, 0, 0), 0.02, Source.SCANS); // off the map, too
        assertThat(residual().tooLarge()).isPresent();
        assertThat(residual().blind()).isEqualTo(1);
    }

    @Test
    void aHeadingMayBeTooFarOffEitherWay() {
        reported(0, new Pose2d(1, 0, -0.4), 0.1, Source.ODOMETRY);

        assertThat(residual().tooLarge()).hasValueSatisfying(step -> {
            assertThat(step.radians()).isEqualTo(0.4, within(1e-9));
            assertThat(step.deviations()).isEqualTo(8, within(1e-9));
        });
    }

    @Test
    void nothingIsStrainedWhereNothingWasReported() {
        assertThat(residual().all()).isEmpty();
        assertThat(residual().steps()).isZero();
    }
}
