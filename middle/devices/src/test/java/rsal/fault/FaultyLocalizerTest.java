package rsal.fault;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.junit.jupiter.api.Test;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.Health;
import rsal.device.Localizer;
import rsal.device.SensorCore;

class FaultyLocalizerTest {
    private final Reported reported = new Reported();
    private final FaultyLocalizer localizer = new FaultyLocalizer(reported);

    /// Believes what it is told.
    private static final class Reported extends SensorCore<PoseEstimate> implements Localizer {
        Reported() {
            super(new DeviceInfo("r1", "localizer", "told"));
        }

        void say(double second, double x) {
            var estimate = PoseEstimate.of(new Pose2d(x, 0, 0), Covariance2d.ofDeviations(0.1, 0.1, 0.1));
            deliver(new Stamped<>(Instant.EPOCH.plusMillis(Math.round(second * 1000)), "map", estimate));
        }

        void recover() {
            health(Health.ok());
        }

        void fail() {
            health(new Health.Lost("It failed."));
        }

        @Override
        public CompletionStage<Void> relocalize(PoseEstimate belief) {
            say(100, belief.mapFromBase().x());
            return CompletableFuture.completedFuture(null);
        }
    }

    private double x() {
        return localizer.latest().orElseThrow().value().mapFromBase().x();
    }

    @Test
    void standsInThePlaceOfTheOther() {
        reported.say(1, 5);
        assertThat(x()).isEqualTo(5);
        assertThat(localizer.info()).isEqualTo(reported.info());
        reported.fail();
        assertThat(localizer.health()).isEqualTo(new Health.Lost("It failed."));
        localizer.relocalize(PoseEstimate.of(new Pose2d(7, 0, 0), Covariance2d.ofDeviations(1, 1, 1)));
        assertThat(x()).isEqualTo(7);
        assertThat(localizer.health()).isEqualTo(Health.ok());
    }

    @Test
    void biasedItIsAheadOfTheOther() {
        localizer.begin(new Fault.Biased(0.5, 0), new SplittableRandom(1));
        reported.say(1, 5);
        assertThat(x()).isEqualTo(5.5);
    }

    @Test
    void deadItTurnsStaleAfterASecondAndIsWellAgainAfterwards() {
        reported.say(1, 5);
        var dead = localizer.begin(new Fault.Dead(), new SplittableRandom(1));
        var health = new ArrayList<Health>();
        localizer.onHealth(health::add);
        reported.say(1.9, 6);
        assertThat(health).isEmpty();
        reported.say(2, 7);
        assertThat(health).singleElement().isInstanceOf(Health.Stale.class);
        assertThat(x()).isEqualTo(5);
        dead.cancel();
        reported.say(3, 8);
        assertThat(localizer.health()).isEqualTo(Health.ok());
        assertThat(x()).isEqualTo(8);
    }

    @Test
    void deadItIsNotWellWhenTheOtherIs() {
        reported.say(1, 5);
        localizer.begin(new Fault.Dead(), new SplittableRandom(1));
        reported.fail();
        var health = new ArrayList<Health>();
        localizer.onHealth(health::add);
        reported.recover();
        reported.say(1.5, 6);
        assertThat(health).isEmpty();
        reported.say(3, 7);
        assertThat(health).singleElement().isInstanceOf(Health.Stale.class);
    }
}
