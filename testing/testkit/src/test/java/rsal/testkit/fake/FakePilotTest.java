package rsal.testkit.fake;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;
import rsal.data.Twist2d;
import rsal.device.Health;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.PilotContract;

class FakePilotTest extends PilotContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }

    @Test
    void standsStillWhileOdometryIsSilentAndGoesOnWhenItIsBack() {
        FakeDriveBase base = robot().require(FakeDriveBase.class);
        wake();
        run.advance(Duration.ofSeconds(2));
        base.turn(new Health.Lost("unplugged by a test"));
        run.advance(Duration.ofSeconds(2));
        assertThat(device().health()).isEqualTo(new Health.Stale("No reading of 'r1/base'."));
        assertThat(base.commands().getLast()).isEqualTo(Twist2d.STOP);
        base.turn(Health.ok());
        run.advance(Duration.ofSeconds(1));
        assertThat(device().health().isOk()).isTrue();
        assertThat(base.commands().getLast()).isEqualTo(Twist2d.drive(0.3, 0));
    }

    @Test
    void releasedItIsWellAgainWhenOdometryIsBack() {
        FakeDriveBase base = robot().require(FakeDriveBase.class);
        wake();
        base.turn(new Health.Lost("unplugged by a test"));
        run.advance(Duration.ofSeconds(2));
        device().release();
        run.advance(Duration.ofSeconds(1));
        assertThat(device().health().isOk()).isFalse();
        base.turn(Health.ok());
        run.advance(Duration.ofSeconds(1));
        assertThat(device().health().isOk()).isTrue();
    }
}
