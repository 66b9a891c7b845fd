package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.robot.DeviceDriver;
import rsal.sim.SimProvider;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.LocalizerContract;

class OdometryLocalizerTest extends LocalizerContract {
    @Override
    protected RobotSystemProvider provider() {
        return new SimProvider();
    }

    @Override
    protected Map<String, Object> settings() {
        return Map.of("odometryNoise", 0.0);
    }

    @Override
    protected List<DeviceDriver> drivers() {
        return List.of(new OdometryLocalizerDriver());
    }

    @Test
    void isAsExactAsOdometry() {
        advance(0.1); // where it starts
        drive(Twist2d.drive(0.4, 0.3), 20);
        Pose2d believed = device().latest().orElseThrow().value().mapFromBase();
        assertThat(believed.isNear(truth(), 1e-9, 1e-9)).isTrue();
        assertThat(device().latest().orElseThrow().time()).isEqualTo(run.instant());
    }

    @Test
    void doesNotMindWhereOdometryStarts() {
        var base = robot().require(DriveBase.class);
        base.resetOdometry(new Pose2d(5, -3, 2));
        drive(Twist2d.drive(0.2, 0), 1);
        assertThat(device().latest().orElseThrow().value().mapFromBase().isNear(truth(), 0.03, 1e-9))
                .isTrue();
    }

    @Test
    void isSilentWhileOdometryIsNoNumber() {
        advance(0.1);
        drive(Twist2d.drive(0.4, 0), 1);
        drive(Twist2d.STOP, 1);
        var reported = new ArrayList<PoseEstimate>();
        device().subscribe(estimate -> reported.add(estimate.value()));
        var base = robot().require(DriveBase.class);
        Pose2d odomFromBase = base.latest().orElseThrow().value().odomFromBase();
        base.resetOdometry(new Pose2d(Double.NaN, 0, 0));
        advance(1);
        assertThat(reported).isEmpty();
        base.resetOdometry(odomFromBase);
        advance(1);
        assertThat(reported)
                .isNotEmpty()
                .allMatch(estimate -> estimate.mapFromBase().isNear(truth(), 1e-9, 1e-9));
    }
}
