package rsal.ros2.system;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.device.Device;
import rsal.device.DeviceCore;
import rsal.device.DriveBase;
import rsal.device.Health;
import rsal.device.LaserScanner;
import rsal.device.SonarArray;
import rsal.device.imu.Imu;
import rsal.robot.Robot;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.bridge.PublishedRobots;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;
import rsal.sim.SimProvider;
import rsal.system.Bridge;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.RobotBench;

/// Devices of a robot of our own bridge, whose health comes by `/diagnostics`.
class ReportedHealthTest extends RobotBench {
    private static final String TYPE = "diagnostic_msgs/msg/DiagnosticArray";
    private static final int WELL = 0;
    private static final int WARN = 1;
    private static final int ERROR = 2;
    private static final int STALE = 3;

    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink others = network.join();
    private final List<Health> reported = new ArrayList<>(); // of the laser
    private Publication diagnostics;
    private Bridge bridge;
    private Ros2System system;
    private Robot remote;

    @Override
    protected RobotSystemProvider provider() {
        return new SimProvider();
    }

    @Override
    protected Map<String, String> parts() {
        return Map.of("laser", "urg04lx", "imu", "imu-bmi088");
    }

    @BeforeEach
    void connect() {
        diagnostics = others.advertise(new RosTopic("/diagnostics", TYPE), Profile.DEFAULT);
        bridge = PublishedRobots.publish(List.of(robot()), WORLD.grid(), network.join(), run);
        system = new OneRobot(network, run).system(parts());
        var found = system.discover().toCompletableFuture();
        advance(3);
        remote = found.join().getFirst();
        remote.require(LaserScanner.class).onHealth(reported::add);
    }

    @AfterEach
    void close() {
        system.close();
        bridge.close();
    }

    private void report(int level, String name, String message, String hardware) {
        report(diagnostics, level, name, message, hardware);
    }

    private void report(Publication topic, int level, String name, String message, String hardware) {
        CdrWriter array =
                RosMessages.write(new CdrWriter(), run.instant()).text("").int32(1);
        topic.publish(array.int8((byte) level)
                .text(name)
                .text(message)
                .text(hardware)
                .int32(0)
                .toBytes());
        advance(0.2);
    }

    private Health laser() {
        return remote.require(LaserScanner.class).health();
    }

    private void assertAllWell() {
        assertThat(remote.devices())
                .allSatisfy(device ->
                        assertThat(device.health()).as(device.info().id()).isEqualTo(Health.ok()));
    }

    private static void lose(Device device, Optional<Health> health) {
        ((DeviceCore) device).report(health);
    }

    @Test
    void aDeviceThatIsLostBehindTheBridgeIsLostWithItsReasonUntilItIsBack() {
        lose(robot().require(LaserScanner.class), Optional.of(new Health.Lost("no power")));
        advance(1.5);
        assertThat(laser()).isEqualTo(new Health.Lost("'r1: laser' reports: no power"));
        assertThat(remote.require(Imu.class).health()).isEqualTo(Health.ok());
        assertThat(remote.require(DriveBase.class).health()).isEqualTo(Health.ok());
        assertThat(remote.require(LaserScanner.class).latest().orElseThrow().time())
                .as("scans still come")
                .isAfter(run.instant().minusMillis(500));
        lose(robot().require(LaserScanner.class), Optional.empty());
        advance(1.5);
        assertAllWell();
        assertThat(reported).as("once each").hasSize(2);
    }

    @Test
    void aStaleDeviceIsStale() {
        lose(robot().require(SonarArray.class), Optional.of(new Health.Stale("silent for 2 s")));
        advance(1.5);
        assertThat(remote.require(SonarArray.class).health())
                .isEqualTo(new Health.Stale("'r1: sonar' reports: silent for 2 s"));
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`', textBlock = """
            /r1/laser_driver: Frequency Status, URG-04LX
            hokuyo: LIDAR status,               r1
            hokuyo: lidar,                      /r1
            r1: Laser,                          r1
            """)
    void aDriverIsKnownByItsNameOrItsHardware(String name, String hardware) {
        report(ERROR, name, "Could not open\n/dev/ttyACM0", hardware);
        assertThat(laser()).isEqualTo(new Health.Lost("'%s' reports: Could not open /dev/ttyACM0".formatted(name)));
        assertThat(remote.require(Imu.class).health()).isEqualTo(Health.ok());
    }

    @Test
    void theRobotsOwnTopicIsOfNoOtherRobot() {
        Publication own = others.advertise(new RosTopic("/r1/diagnostics", TYPE), Profile.DEFAULT);
        report(own, STALE, "hokuyo: scan", "no scans", "URG-04LX");
        assertThat(laser()).isEqualTo(new Health.Stale("'hokuyo: scan' reports: no scans"));
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`', textBlock = """
            2, laser: status,      URG-04LX,    of an unknown robot
            2, /r2/laser: status,  URG-04LX,    of another robot
            2, laser: status,      r2,          of another robot
            2, r1: CPU usage,      r1,          no device
            2, r1: lidar imu gyro bms battery sync, , ambiguous
            1, r1: laser,          r1,          a warning
            0, r1: laser,          r1,          well
            7, r1: laser,          r1,          no level
            """)
    void nobodyIsAlarmedForOthers(int level, String name, String hardware, String why) {
        report(level, name, "oh", hardware == null ? "" : hardware);
        assertAllWell();
        assertThat(reported).as(why).isEmpty();
    }

    /// The bridge says that all is well, once a second; the driver says something else under another name.
    @Test
    void aReportEndsWhenItsProgramSaysSoOrSaysNothingFor5Seconds() {
        report(ERROR, "hokuyo: lidar", "blocked", "r1");
        advance(3);
        assertThat(laser().isOk()).isFalse();
        report(WARN, "hokuyo: lidar", "dirty", "r1");
        assertAllWell();
        report(ERROR, "hokuyo: lidar", "blocked", "r1");
        assertThat(laser().isOk()).isFalse();
        advance(5.2);
        assertAllWell();
    }

    @Test
    void theWorseOfAReportAndWhatTheDriverSeesCounts() {
        bridge.close();
        advance(1);
        Health lost = laser();
        assertThat(lost).isInstanceOf(Health.Lost.class);
        report(STALE, "hokuyo: lidar", "no update", "r1");
        assertThat(laser()).isEqualTo(lost);
        report(ERROR, "hokuyo: lidar", "blocked", "r1");
        assertThat(((Health.Lost) laser()).reason()).contains("blocked");
    }

    /// A thousand reports are kept, each under its name: the device is well again once so many have ended, and not
    /// before, whatever else was reported. Of a long text the beginning is told.
    @Test
    void manyErrorsAndLongTextsAreBounded() {
        int kept = 1_000;
        for (int i = 0; i < kept + 500; i++) {
            say(ERROR, "laser " + i, "x".repeat(5_000));
        }
        advance(0.2);
        assertThat(laser()).isInstanceOf(Health.Lost.class);
        assertThat(((Health.Lost) laser()).reason())
                .hasSizeLessThan(500)
                .startsWith("'laser 0' reports: xxxx")
                .endsWith("…");
        for (int i = 0; i < kept - 1; i++) {
            say(WELL, "laser " + i, "");
        }
        advance(0.2);
        assertThat(((Health.Lost) laser()).reason()).startsWith("'laser %d' reports: xxxx".formatted(kept - 1));
        say(WELL, "laser " + (kept - 1), "");
        advance(0.2);
        assertAllWell();
        say(ERROR, "laser again", "there is room again");
        advance(0.2);
        assertThat(laser()).isEqualTo(new Health.Lost("'laser again' reports: there is room again"));
    }

    /// Of the robot's hardware, without waiting.
    private void say(int level, String name, String message) {
        diagnostics.publish(RosMessages.write(new CdrWriter(), run.instant())
                .text("")
                .int32(1)
                .int8((byte) level)
                .text(name)
                .text(message)
                .text("r1")
                .int32(0)
                .toBytes());
        run.runPending();
    }
}
