package rsal.player.bridge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.data.Interval;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.device.DriveBase;
import rsal.player.message.Actarray;
import rsal.player.message.Interface;
import rsal.player.message.Pose;
import rsal.player.message.Position2d;
import rsal.player.message.Session;
import rsal.player.wire.Address;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Axis;
import rsal.robot.RobotModel.Drive;
import rsal.robot.RobotModel.OdometryNoise;
import rsal.robot.RobotModel.Steering;
import rsal.sim.SimProvider;
import rsal.system.RobotSystemProvider;

/// A car with a turntable, as a Player client sees it.
@Timeout(60)
class CarBridgeTest extends BridgeBench {
    private static final double WHEELBASE = 0.3;
    private static final int CAPABILITY = 255;

    @Override
    protected RobotSystemProvider provider() {
        return new SimProvider();
    }

    @Override
    protected Map<String, String> parts() {
        return Map.of("turntable", "turntable");
    }

    @Override
    protected RobotModel model() {
        var drive = new Drive(
                new Steering.Car(WHEELBASE, 0.6),
                new Axis(new Interval(-0.2, 0.8), Interval.around0(1)),
                Axis.NONE,
                Axis.symmetric(2, 8),
                new OdometryNoise(0, 0, 0));
        return super.model().with(drive);
    }

    private Odometry odometry() {
        return robot().require(DriveBase.class).latest().orElseThrow().value();
    }

    @Test
    void steersAsCommandedAndNoMoreThanItCan() throws Exception {
        subscribe(Interface.POSITION2D);
        command(Position2d.CAR, new Position2d.Car(0.3, 0.2));
        until(() -> odometry().velocity().vx() > 0.299);
        assertThat(odometry().velocity().omega()).isCloseTo(0.3 * Math.tan(0.2) / WHEELBASE, within(1e-3));
        command(Position2d.CAR, new Position2d.Car(0.3, 1e300));
        until(() -> odometry().velocity().omega() > 0.3 * Math.tan(0.55) / WHEELBASE);
        assertThat(odometry().velocity().omega()).isCloseTo(0.3 * Math.tan(0.6) / WHEELBASE, within(1e-3));
    }

    @Test
    void takesNoGoalsSinceItDoesNotTurnInPlace() throws Exception {
        ask(Interface.POSITION2D, CAPABILITY, new Session.Capability(MessageKind.COMMAND.code(), Position2d.CAR));
        refused(Interface.POSITION2D, CAPABILITY, new Session.Capability(MessageKind.COMMAND.code(), Position2d.GOAL));
        command(Position2d.GOAL, new Position2d.Goal(new Pose(1, 0, 0), new Pose(0, 0, 0), 1));
        answer(client().devices());
        advance(2);
        assertThat(odometry().odomFromBase()).isEqualTo(Pose2d.ORIGIN);
    }

    private Actarray.Joint joint() {
        return newest(Interface.ACTARRAY, Actarray.State.class).joints().getFirst();
    }

    private void joint(int subtype, Record body) {
        client().command(Packet.of(Address.of(Interface.ACTARRAY.code(), 0), MessageKind.COMMAND, subtype, 0, body));
    }

    @Test
    void itsTurntableGoesToPositionsAndAtSpeedsUntilTheClientIsGone() throws Exception {
        subscribe(Interface.ACTARRAY);
        var shape = asked(Interface.ACTARRAY, Actarray.GEOMETRY, Actarray.Geometry.class)
                .joints();
        assertThat(shape).extracting(Actarray.JointGeometry::type).isEqualTo(List.of(2));
        joint(Actarray.POSITION, new Actarray.Position(0, 0.5f));
        until(() -> Math.abs(joint().position() - 0.5) < 1e-6 && joint().state() == 1);
        joint(Actarray.POSITION, new Actarray.Position(1, -0.5f)); // there is no such joint
        joint(Actarray.POSITIONS, new Actarray.Positions(new float[0]));
        joint(Actarray.SPEEDS, new Actarray.Speeds(new float[] {Float.NaN}));
        answer(client().devices());
        advance(2);
        assertThat(joint().position()).isEqualTo(0.5f);
        joint(Actarray.SPEED, new Actarray.Speed(0, -0.2f));
        until(() -> joint().position() < -0.2); // said once
        joint(Actarray.HOME, new Actarray.Home(-1));
        until(() -> joint().position() == 0 && joint().state() == 1);
        joint(Actarray.SPEED, new Actarray.Speed(0, 0.2f));
        until(() -> joint().state() == 2);
        client().close();
        var turntable = robot().require(rsal.device.Actuator.class);
        until(() -> turntable.latest().orElseThrow().value().speed() == 0);
        assertThat(turntable.latest().orElseThrow().value().position()).isLessThan(1);
    }
}
