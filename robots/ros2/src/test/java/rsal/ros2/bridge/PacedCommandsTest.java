package rsal.ros2.bridge;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.link.ClockTopics;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;
import rsal.sim.SimProvider;
import rsal.system.Bridge;
import rsal.system.Bridge.Pace;
import rsal.system.CommandTimeout;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.RobotBench;

/// For how long a velocity holds in a run that waits for the program which commands it.
class PacedCommandsTest extends RobotBench {
    private final AtomicLong real = new AtomicLong();
    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink there = network.join();
    private final RosMessages messages = new RosMessages();
    private Bridge bridge;
    private Publication velocities;
    private Publication reached;

    @Override
    protected RobotSystemProvider provider() {
        return new SimProvider();
    }

    @BeforeEach
    void publish() {
        var timeout = new CommandTimeout(Optional.of(CommandTimeout.USUAL), real::get);
        bridge = PublishedRobots.publishPaced(List.of(robot()), WORLD.grid(), network.join(), timeout, run);
        velocities = there.advertise(new RosTopic("/r1/cmd_vel", "geometry_msgs/msg/Twist"), Profile.DEFAULT);
        reached = there.advertise(ClockTopics.REACHED, Profile.DEFAULT);
    }

    @AfterEach
    void close() {
        bridge.close();
    }

    private void command() {
        velocities.publish(messages.twist(Twist2d.drive(0, 0.3)));
    }

    private void pass(Duration time) {
        real.addAndGet(time.toNanos());
    }

    /// The run goes on, and the program follows.
    ///
    /// @param slowness real over simulated time
    private void follow(Duration time, int slowness) {
        for (long left = time.toMillis(); left > 0; left -= 10) {
            advance(0.01);
            pass(Duration.ofMillis(10L * slowness));
            bridge.pace();
            reached.publish(messages.clock(run.instant()));
            assertThat(bridge.pace()).isEqualTo(Pace.FOLLOWED);
        }
    }

    private boolean isMoving() {
        return robot().require(DriveBase.class)
                        .latest()
                        .orElseThrow()
                        .value()
                        .velocity()
                        .omega()
                > 0.1;
    }

    @Test
    void commandsOfAProgramThatIsSlowHoldAsLongAsOfAnother() {
        for (int i = 0; i < 20; i++) {
            command();
            follow(Duration.ofMillis(100), 10);
            assertThat(i < 5 || isMoving()).as("command %d", i).isTrue();
        }
        follow(Duration.ofSeconds(1), 10);
        assertThat(isMoving()).as("it is silent").isFalse();
    }

    /// Another program, or a heavy task.
    @Test
    void aWaitForAnyProgramStopsNoRobot() {
        command();
        follow(Duration.ofMillis(300), 1);
        advance(0.01);
        assertThat(bridge.pace()).isEqualTo(Pace.AWAITED);
        pass(Duration.ofSeconds(3));
        assertThat(bridge.pace()).isEqualTo(Pace.AWAITED);
        follow(Duration.ofMillis(100), 1);
        assertThat(isMoving()).isTrue();
    }

    @Test
    void realTimeCountsWhenTheProgramHasLeft() {
        command();
        follow(Duration.ofMillis(300), 1);
        reached.close();
        pass(Duration.ofMillis(250));
        assertThat(bridge.pace()).isEqualTo(Pace.UNFOLLOWED);
        advance(0.1);
        assertThat(isMoving()).isTrue();
        pass(Duration.ofMillis(300));
        advance(0.5);
        assertThat(isMoving()).isFalse();
    }
}
