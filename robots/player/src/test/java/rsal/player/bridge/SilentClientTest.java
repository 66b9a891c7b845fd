package rsal.player.bridge;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.player.message.Actarray;
import rsal.player.message.Interface;
import rsal.player.message.Pose;
import rsal.player.message.Position2d;
import rsal.player.wire.Address;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.sim.SimProvider;
import rsal.system.CommandTimeout;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.CommandTimeoutContract;

/// A client that is connected and sends nothing any more, as one that hangs, or whose network is gone. Its clock is not
/// that of the simulation.
@Timeout(60)
class SilentClientTest extends BridgeBench implements CommandTimeoutContract {
    private final AtomicLong nanos = new AtomicLong();

    @Override
    protected RobotSystemProvider provider() {
        return new SimProvider();
    }

    @Override
    protected Map<String, String> parts() {
        return Map.of("turntable", "turntable");
    }

    @Override
    protected CommandTimeout timeout() {
        return new CommandTimeout(Optional.of(CommandTimeout.USUAL), nanos::get);
    }

    private Twist2d velocity() {
        return robot().require(DriveBase.class).latest().orElseThrow().value().velocity();
    }

    @Override
    public void command() throws Exception {
        subscribe(Interface.POSITION2D);
        command(Position2d.VELOCITY, new Position2d.Velocity(new Pose(0, 0, 0.3), 1));
        answer(client().ask(Packet.of(
                Address.of(Interface.POSITION2D.code(), 0), MessageKind.REQUEST, Position2d.GEOMETRY, 0)));
        until(this::isMoving); // what was asked later is answered, so the command has arrived
    }

    @Override
    public void pass(Duration silence) {
        nanos.addAndGet(silence.toNanos());
        advance(1);
    }

    @Override
    public void advanceRobot(Duration time) {
        advance(time.toMillis() / 1e3);
    }

    @Override
    public boolean isMoving() {
        return velocity().omega() > 0;
    }

    @Test
    void leavesGoalsToTheirEnd() throws Exception {
        subscribe(Interface.POSITION2D);
        command(Position2d.GOAL, new Position2d.Goal(new Pose(1, 0, 0), new Pose(0, 0, 0), 1));
        until(() -> velocity().vx() > 0.1);
        pass(Duration.ofMinutes(1));
        until(() -> robot().require(DriveBase.class)
                        .latest()
                        .orElseThrow()
                        .value()
                        .odomFromBase()
                        .x()
                > 0.9);
    }

    @Test
    void stopsAnActuatorThatTurns() throws Exception {
        subscribe(Interface.ACTARRAY);
        client().command(Packet.of(
                Address.of(Interface.ACTARRAY.code(), 0),
                MessageKind.COMMAND,
                Actarray.SPEED,
                0,
                new Actarray.Speed(0, 0.2f)));
        until(() -> speed() > 0.1);
        pass(Duration.ofMillis(500));
        until(() -> speed() == 0);
    }

    private float speed() {
        return newest(Interface.ACTARRAY, Actarray.State.class)
                .joints()
                .getFirst()
                .speed();
    }
}
