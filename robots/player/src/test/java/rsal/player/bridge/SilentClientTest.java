package rsal.player.bridge;

import static org.assertj.core.api.Assertions.assertThat;

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
import rsal.player.wire.Kind;
import rsal.player.wire.Packet;
import rsal.sim.SimProvider;
import rsal.system.CommandTimeout;
import rsal.system.RobotSystemProvider;

/// A client that is connected and sends nothing any more, as one that hangs, or whose network is gone. Its clock is not
/// that of the simulation.
@Timeout(60)
class SilentClientTest extends BridgeBench {
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

    private void pass(long millis) {
        nanos.addAndGet(Duration.ofMillis(millis).toNanos());
    }

    private Twist2d velocity() {
        return robot().require(DriveBase.class).latest().orElseThrow().value().velocity();
    }

    private void drive(double forward) {
        command(Position2d.VELOCITY, new Position2d.Velocity(new Pose(forward, 0, 0), 1));
    }

    @Test
    void stopsTheBaseHalfASecondAfterItsLastCommand() throws Exception {
        subscribe(Interface.POSITION2D);
        drive(0.3);
        until(() -> velocity().vx() > 0.29);
        pass(400);
        advance(3);
        assertThat(velocity().vx()).as("simulated time does not count").isGreaterThan(0.29);

        drive(0.25);
        until(() -> velocity().vx() < 0.26);
        pass(400);
        advance(0.2);
        assertThat(velocity().vx()).as("the last command counts").isGreaterThan(0.24);

        pass(60);
        until(() -> velocity().vx() == 0);

        drive(0.3);
        until(() -> velocity().vx() > 0.29);
    }

    @Test
    void leavesGoalsToTheirEnd() throws Exception {
        subscribe(Interface.POSITION2D);
        command(Position2d.GOAL, new Position2d.Goal(new Pose(1, 0, 0), new Pose(0, 0, 0), 1));
        until(() -> velocity().vx() > 0.1);
        pass(60_000);
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
                Kind.COMMAND,
                Actarray.SPEED,
                0,
                new Actarray.Speed(0, 0.2f)));
        until(() -> speed() > 0.1);
        pass(500);
        until(() -> speed() == 0);
    }

    private float speed() {
        return newest(Interface.ACTARRAY, Actarray.State.class)
                .joints()
                .getFirst()
                .speed();
    }
}
