package rsal.environment;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.junit.jupiter.api.Test;
import rsal.data.Covariance2d;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.Localizer;
import rsal.device.SensorCore;

class OwnStartTest {
    private static final class SlowLocalizer extends SensorCore<PoseEstimate> implements Localizer {
        SlowLocalizer() {
            super(new DeviceInfo("r", "localizer", "slow"));
        }

        void estimates(Pose2d mapFromBase) {
            deliver(new Stamped<>(
                    Instant.EPOCH, "map", PoseEstimate.of(mapFromBase, Covariance2d.ofDeviations(0.1, 0.1, 0.1))));
        }

        @Override
        public CompletionStage<Void> relocalize(PoseEstimate belief) {
            return CompletableFuture.completedStage(null);
        }
    }

    @Test
    void isTheFirstEstimateHoweverLateThatComes() {
        var localizer = new SlowLocalizer();
        var start = new OwnStart(localizer);
        assertThat(start.baseFromStart()).isEqualTo(new Point2d(0, 0));
        assertThat(start.startFromBase()).isEqualTo(Pose2d.ORIGIN);
        localizer.estimates(new Pose2d(2, 5, 0));
        assertThat(start.baseFromStart()).isEqualTo(new Point2d(0, 0));
        localizer.estimates(new Pose2d(4, 6, 0));
        assertThat(start.baseFromStart()).isEqualTo(new Point2d(-2, -1));
        assertThat(start.startFromBase().position()).isEqualTo(new Point2d(2, 1));
    }
}
