package rsal.ros2.bridge;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;
import rsal.sim.SimProvider;
import rsal.system.Bridge;
import rsal.system.CommandTimeout;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.CommandTimeoutContract;
import rsal.testkit.contract.RobotBench;

/// A program of ROS 2 that published velocities and is silent now. Its clock is not that of the simulation.
class SilentRosClientTest extends RobotBench implements CommandTimeoutContract {
    private final AtomicLong nanos = new AtomicLong();
    private final MemoryNetwork network = new MemoryNetwork();
    private final RosMessages messages = new RosMessages();
    private Bridge bridge;
    private Publication velocities;

    @Override
    protected RobotSystemProvider provider() {
        return new SimProvider();
    }

    @BeforeEach
    void publish() {
        var timeout = new CommandTimeout(Optional.of(CommandTimeout.USUAL), nanos::get);
        bridge = PublishedRobots.publish(List.of(robot()), WORLD.grid(), network.join(), timeout, run);
        velocities = network.join().advertise(new RosTopic("/r1/cmd_vel", "geometry_msgs/msg/Twist"), Profile.DEFAULT);
    }

    @AfterEach
    void close() {
        bridge.close();
    }

    @Override
    public void command() {
        velocities.publish(messages.twist(Twist2d.drive(0, 0.3)));
        advance(0.3);
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
        return robot().require(DriveBase.class)
                        .latest()
                        .orElseThrow()
                        .value()
                        .velocity()
                        .omega()
                > 0;
    }
}
