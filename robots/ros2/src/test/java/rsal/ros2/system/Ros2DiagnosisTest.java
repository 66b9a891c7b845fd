package rsal.ros2.system;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.ros2.link.RosNetwork;
import rsal.rtps.UdpParticipant;
import rsal.rtps.discovery.BuiltinEndpoint;
import rsal.rtps.discovery.EndpointData;
import rsal.rtps.discovery.ParticipantData;
import rsal.rtps.discovery.Qos;
import rsal.rtps.wire.EntityId;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.GuidPrefix;
import rsal.rtps.wire.Locator;
import rsal.settings.Arguments;
import rsal.system.Diagnosis.Finding;

class Ros2DiagnosisTest {
    private static final Locator UDP = Locator.udp(new InetSocketAddress(InetAddress.getLoopbackAddress(), 7410));
    private static final Locator SHARED_MEMORY = new Locator(16, 7410, 0, 0);

    private static ParticipantData participant(int vendor, Locator locator) {
        return new ParticipantData(
                new GuidPrefix((long) vendor << 48, 1),
                Optional.of(0),
                "",
                BuiltinEndpoint.ALL,
                1,
                List.of(locator),
                List.of(locator),
                "talker",
                "enclave=/;");
    }

    private static EndpointData endpoint(boolean isWriter, String topic, String type, Qos qos) {
        EntityId entity = isWriter ? EntityId.writer(1) : EntityId.reader(1);
        return new EndpointData(new Guid(new GuidPrefix(1, 1), entity), topic, type, qos, List.of(), "");
    }

    @Test
    void nobodyThereIsExplained() {
        List<Finding> findings = Ros2Diagnosis.of(List.of(), List.of());
        assertThat(findings).hasSize(1);
        assertThat(findings.getFirst().ok()).isFalse();
        assertThat(findings.getFirst().remedy()).contains("domain", "--set peers");
    }

    @ParameterizedTest
    @ValueSource(strings = {"topic", "definitions"})
    void whatRosbridgeDoesNotHaveIsRefused(String name) {
        var diagnosis = new Ros2Diagnosis();
        Arguments settings =
                Arguments.parse(diagnosis.parameters(), Map.of("rosbridge", "ws://127.0.0.1:9", name, "scan"));
        assertThatThrownBy(() -> diagnosis.look(settings))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("'topic' and 'definitions' need DDS, which 'rosbridge' replaces. Remove them, or"
                        + " 'rosbridge'.");
    }

    @Test
    void programsAreCountedByWhoMadeTheirDds() {
        List<Finding> findings = Ros2Diagnosis.of(
                List.of(participant(0x0110, UDP), participant(0x010f, UDP), participant(0x010f, UDP)), List.of());
        assertThat(findings).containsExactly(new Finding("programs", true, "1 of Cyclone DDS, 2 of Fast DDS", ""));
    }

    @Test
    void sharedMemoryAloneIsNamed() {
        List<Finding> findings = Ros2Diagnosis.of(List.of(participant(0x010f, SHARED_MEMORY)), List.of());
        assertThat(findings.getLast().ok()).isFalse();
        assertThat(findings.getLast().found()).isEqualTo("Fast DDS 'talker' receives by shared memory or TCP only");
    }

    @Test
    void robotsAreNamespacesWithOdometryAndVelocities() {
        String odometry = "nav_msgs::msg::dds_::Odometry_";
        String twist = "geometry_msgs::msg::dds_::Twist_";
        List<Finding> findings = Ros2Diagnosis.of(
                List.of(participant(0x0110, UDP)),
                List.of(
                        endpoint(true, "rt/r1/odom", odometry, Qos.DEFAULT),
                        endpoint(false, "rt/r1/cmd_vel", twist, Qos.DEFAULT),
                        endpoint(true, "rt/odom", odometry, Qos.DEFAULT),
                        endpoint(true, "rq/r1/odomRequest", odometry, Qos.DEFAULT)));
        assertThat(findings)
                .filteredOn(each -> each.what().equals("robot"))
                .extracting(Finding::ok, Finding::found)
                .containsExactly(tuple(false, "'/' has odometry"), tuple(true, "'/r1' has cmd_vel, odometry"));
    }

    @Test
    void robotsAreThoseThatRunsWouldDrive() {
        String odometry = "nav_msgs::msg::dds_::Odometry_";
        List<Finding> findings = Ros2Diagnosis.of(
                List.of(participant(0x0110, UDP)),
                List.of(
                        endpoint(true, "rt/deep/drive_controller/odom", odometry, Qos.DEFAULT),
                        endpoint(false, "rt/deep/cmd_vel", "geometry_msgs::msg::dds_::TwistStamped_", Qos.DEFAULT),
                        endpoint(true, "rt/odd/odom", odometry, Qos.DEFAULT),
                        endpoint(false, "rt/odd/cmd_vel", "std_msgs::msg::dds_::String_", Qos.DEFAULT)));
        assertThat(findings)
                .filteredOn(each -> each.what().equals("robot"))
                .extracting(Finding::ok, Finding::found)
                .containsExactly(
                        tuple(true, "'/deep' has cmd_vel, odometry"), tuple(false, "'/odd' has cmd_vel, odometry"));
        assertThat(findings.getLast().remedy())
                .isEqualTo("It is not a robot that can be driven: it lacks a subscriber of 'cmd_vel' (%s)."
                        .formatted("geometry_msgs/msg/Twist or geometry_msgs/msg/TwistStamped"));
    }

    @Test
    void qualityOfServiceThatDoesNotMatchIsReportedOnce() {
        String type = "sensor_msgs::msg::dds_::LaserScan_";
        EndpointData reader = endpoint(false, "rt/scan", type, Qos.DEFAULT);
        List<Finding> findings = Ros2Diagnosis.of(
                List.of(participant(0x0110, UDP)),
                List.of(endpoint(true, "rt/scan", type, Qos.SENSOR_DATA), reader, reader));
        assertThat(findings)
                .filteredOn(each -> each.what().equals("topic"))
                .extracting(Finding::found)
                .containsExactly("'/scan': reliability: the reader wants reliable, the writer offers best effort");
    }

    @Test
    void machinesThatCannotBeReachedAreReported() throws IOException {
        InetAddress lab = InetAddress.getByName("10.1.0.5"); // of this machine
        InetAddress robot = InetAddress.getByName("10.1.0.7");
        InetAddress far = InetAddress.getByName("192.168.77.3");
        InetAddress other = InetAddress.getByName("172.16.0.9");
        InetAddress wireless = InetAddress.getByName("172.16.0.2"); // of this machine, but not configured
        var routes = Map.of(robot, lab, other, wireless);
        var options = new UdpParticipant.Options(
                0, List.of(lab), List.of(robot, far, other), Duration.ofSeconds(20), "doctor", "");
        List<Finding> findings = RouteFindings.of(options, peer -> Optional.ofNullable(routes.get(peer)));
        assertThat(findings).extracting(Finding::ok).containsExactly(true, false, false);
        assertThat(findings.get(0).found()).contains("10.1.0.7", "10.1.0.5", "nothing was sent");
        assertThat(findings.get(1).found()).contains("192.168.77.3", "can't be reached");
        assertThat(findings.get(1).remedy()).contains("'peers'");
        assertThat(findings.get(2).found()).contains("172.16.0.9", "172.16.0.2", "10.1.0.5");
        assertThat(findings.get(2).remedy()).endsWith("--set address=10.1.0.5,172.16.0.2");
    }

    @Test
    void programsOnThisMachineNeedNoAddressInOthersNetworks() throws IOException {
        InetAddress lab = InetAddress.getByName("10.1.0.5"); // of this machine
        InetAddress here = InetAddress.getLoopbackAddress();
        var options = new UdpParticipant.Options(0, List.of(lab), List.of(here), Duration.ofSeconds(20), "doctor", "");
        assertThat(RouteFindings.of(options, Optional::of)).singleElement().matches(Finding::ok);
    }

    /// As some systems say.
    @Test
    void aRouteThatBeginsAtNoAddressIsNone() throws IOException {
        InetAddress any = InetAddress.getByName("0.0.0.0");
        InetAddress far = InetAddress.getByName("192.168.77.3");
        var options = new UdpParticipant.Options(
                0, List.of(InetAddress.getByName("10.1.0.5")), List.of(far), Duration.ofSeconds(20), "doctor", "");
        List<Finding> findings = RouteFindings.of(options, _ -> Optional.of(any));
        assertThat(findings).singleElement().matches(each -> !each.ok());
        assertThat(findings.getFirst().found()).contains("can't be reached");
    }

    @Test
    void thisMachineIsReachedByItsOwnAddress() {
        InetAddress here = InetAddress.getLoopbackAddress();
        assertThat(RosNetwork.route(here)).contains(here);
    }
}
