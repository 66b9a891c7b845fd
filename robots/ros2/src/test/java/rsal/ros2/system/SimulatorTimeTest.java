package rsal.ros2.system;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.robot.Robot;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.TwoTimes;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.link.ClockTopics;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;
import rsal.ros2.setting.GripperSettings;
import rsal.ros2.setting.RosSettings;
import rsal.ros2.setting.Safety;
import rsal.system.RealRobots.Waiting;
import rsal.time.LockstepScheduler;

/// Robots of another simulator, whose clock the test is.
class SimulatorTimeTest {
    private static final Duration STEP = Duration.ofMillis(50);
    private static final Twist2d AHEAD = Twist2d.drive(0.3, 0);

    private final LockstepScheduler real = new LockstepScheduler();
    private final LockstepScheduler ofSimulator = new LockstepScheduler();
    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink there = network.join();
    private final RosMessages messages = new RosMessages();
    private final List<Twist2d> commanded = new ArrayList<>();
    private final List<Instant> times = new ArrayList<>();
    private Publication odometry;
    private Optional<Publication> clock = Optional.empty();
    private Ros2System system;
    private Instant simulated = Instant.ofEpochSecond(100);

    @BeforeEach
    void robotIsThere() {
        odometry = there.advertise(new RosTopic("/r1/odom", "nav_msgs/msg/Odometry"), Profile.DEFAULT);
        there.subscribe(new RosTopic("/r1/cmd_vel", "geometry_msgs/msg/Twist"), Profile.DEFAULT, this::hear);
        system = new Ros2System(
                Map.of(OneRobot.spec(Map.of()), "/r1"),
                "domain 5",
                network::join,
                Optional.empty(),
                new RosSettings(
                        new Safety(Duration.ofMillis(500), true, "", ""), GripperSettings.USUAL, List.of(), true, true),
                Waiting.USUAL,
                new TwoTimes(real, ofSimulator),
                new SplittableRandom(1));
        system.onTime(times::add);
    }

    @AfterEach
    void close() {
        system.close();
    }

    private void hear(ByteBuffer bytes) {
        try {
            CdrReader reader = CdrReader.of(bytes);
            double vx = reader.float64();
            reader.skip(8, 4);
            commanded.add(new Twist2d(vx, 0, reader.float64()));
        } catch (InvalidCdr e) {
            throw new AssertionError(e);
        }
    }

    private void clockIsThere() {
        clock = Optional.of(there.advertise(new RosTopic("/clock", "rosgraph_msgs/msg/Clock"), Profile.SENSOR_DATA));
    }

    /// @param pace of the simulator; 0 while it is paused
    private void advance(double seconds, double pace) {
        for (int i = 0; i < Math.round(seconds * 20); i++) {
            simulated = simulated.plusNanos(Math.round(pace * STEP.toNanos()));
            clock.filter(_ -> pace > 0).ifPresent(topic -> topic.publish(messages.clock(simulated)));
            odometry.publish(messages.odometry(
                    simulated, new Odometry(Pose2d.ORIGIN, Twist2d.STOP, false), "odom", "base_link"));
            ofSimulator.advance(Duration.ofNanos(Math.round(pace * STEP.toNanos())));
            real.advance(STEP);
        }
    }

    private DriveBase base() {
        CompletableFuture<List<Robot>> found = system.discover().toCompletableFuture();
        clockIsThere();
        advance(3, 1);
        return found.join().getFirst().require(DriveBase.class);
    }

    @Test
    void theRunIsInformedEachTimeAndRobotsWaitForTheFirst() {
        var found = system.discover().toCompletableFuture();
        advance(4, 1);
        assertThat(found).isNotDone();
        clockIsThere();
        advance(1, 2);
        assertThat(found).isCompleted();
        assertThat(times).hasSize(20).isSorted().endsWith(simulated);
        clock.orElseThrow().publish(new byte[] {0, 1, 0, 0, 9}); // malformed
        assertThat(times).hasSize(20);
    }

    /// A simulator that waits does so for runs that have begun, not for those that look for robots.
    @Test
    void itSaysWhichTimeItHasReachedOnceItsRobotsAreThere() {
        var reached = new ArrayList<Long>();
        there.subscribe(ClockTopics.REACHED, Profile.DEFAULT, bytes -> {
            try {
                reached.add(RosMessages.stamp(CdrReader.of(bytes)));
            } catch (InvalidCdr e) {
                throw new AssertionError(e);
            }
        });
        system.reached(Instant.ofEpochSecond(7)); // it has not even joined the network
        var found = system.discover().toCompletableFuture();
        system.reached(Instant.ofEpochSecond(8));
        assertThat(reached).isEmpty();
        clockIsThere();
        advance(3, 1);
        assertThat(found).isCompleted();
        assertThat(reached).as("as the run is about to begin").hasSize(1);
        system.reached(Instant.ofEpochSecond(9, 5));
        assertThat(reached).last().isEqualTo(9_000_000_005L);
        system.close();
        system.reached(Instant.ofEpochSecond(10));
        assertThat(reached).hasSize(2);
    }

    @Test
    void aClockThatNobodyPublishesIsSaid() {
        var found = system.discover().toCompletableFuture();
        advance(12, 0);
        assertThatThrownBy(found::join)
                .hasMessageContaining("Nobody publishes '/clock' (rosgraph_msgs/msg/Clock) in domain 5, which"
                        + " 'useSimTime' needs. Start the simulator with its clock, or leave 'useSimTime' out.");
    }

    @Test
    void aSimulatorThatIsPausedFromTheBeginningIsSaid() {
        var found = system.discover().toCompletableFuture();
        clockIsThere();
        advance(12, 0);
        assertThatThrownBy(found::join)
                .hasMessageContaining("Somebody publishes '/clock' in domain 5, but no time has come."
                        + " Maybe the simulator is paused?");
    }

    /// Motors are kept safe in real time; what was wanted before is wanted again when time goes on.
    @Test
    void basesAreStoppedWhileTimeStandsAndDriveOnAfterwards() {
        DriveBase base = base();
        commanded.clear();
        for (int i = 0; i < 10; i++) {
            base.command(AHEAD);
            advance(0.1, 1);
        }
        assertThat(commanded).containsOnly(AHEAD);
        for (int i = 0; i < 6; i++) {
            base.command(AHEAD);
            advance(0.1, 0);
        }
        commanded.clear();
        for (int i = 0; i < 10; i++) {
            base.command(AHEAD); // a stop follows at once
            assertThat(commanded).last().isEqualTo(AHEAD);
            advance(0.1, 0);
            assertThat(commanded).last().isEqualTo(Twist2d.STOP);
        }
        commanded.clear();
        advance(0.1, 1);
        assertThat(commanded).contains(AHEAD);
    }

    /// Else it would depend on real time what the simulator does in the part that it makes next.
    @Test
    void whatIsWantedIsSentBeforeANewTimeCountsAsReached() {
        DriveBase base = base();
        base.command(AHEAD);
        advance(0.8, 0);
        assertThat(commanded).last().isEqualTo(Twist2d.STOP);
        commanded.clear();
        there.subscribe(
                ClockTopics.REACHED,
                Profile.DEFAULT,
                _ -> assertThat(commanded).last().isEqualTo(AHEAD));
        simulated = simulated.plusMillis(10);
        ofSimulator.advance(Duration.ofMillis(10));
        system.reached(simulated);
        system.reached(simulated);
        assertThat(commanded).as("once").containsExactly(AHEAD);
    }

    /// It waits for a program of several that follow it, or for this one.
    @Test
    void basesAreNotStoppedWhileTheSimulatorSaysTheSameTimeAgain() {
        DriveBase base = base();
        base.command(AHEAD);
        commanded.clear();
        for (int i = 0; i < 60; i++) {
            clock.orElseThrow().publish(messages.clock(simulated));
            advance(0.05, 0);
        }
        assertThat(commanded).doesNotContain(Twist2d.STOP);
        advance(0.8, 0);
        assertThat(commanded).as("it says nothing").last().isEqualTo(Twist2d.STOP);
    }

    @Test
    void aSimulatorThatLeavesEndsTheRun() {
        base();
        clock.orElseThrow().close();
        assertThatThrownBy(() -> advance(10, 0))
                .hasMessageStartingWith("The run can't go on without time. Nobody publishes '/clock'");
    }
}
