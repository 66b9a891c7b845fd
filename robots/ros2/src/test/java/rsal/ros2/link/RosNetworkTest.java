package rsal.ros2.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetAddress;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.ros2.link.RosEnvironment.Range;
import rsal.rtps.UdpParticipant;

/// What variables of the environment mean, and which addresses follow.
class RosNetworkTest {
    private static final String RANGE = "ROS_AUTOMATIC_DISCOVERY_RANGE";
    private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

    private static UdpParticipant.Options options(List<String> addresses, Map<String, String> variables) {
        List<InetAddress> here = addresses.stream()
                .map(each -> RosNetwork.machine("address", each))
                .toList();
        return RosNetwork.options(3, here, List.of(), RosEnvironment.of(variables), "tester");
    }

    @ParameterizedTest
    @CsvSource({
        "'', '', NOT_SET",
        "'', 1, LOCALHOST",
        "'', 0, NOT_SET",
        "SUBNET, 1, SUBNET",
        "SYSTEM_DEFAULT, '', SUBNET",
        "OFF, '', OFF",
        "subnet, '', LOCALHOST"
    })
    void rangesAreReadAsRosReadsThem(String range, String localhostOnly, Range wanted) {
        var environment = RosEnvironment.of(Map.of(RANGE, range, "ROS_LOCALHOST_ONLY", localhostOnly));
        assertThat(environment.range()).isEqualTo(wanted);
    }

    @Test
    void domainAndPeersAreRead() {
        var environment = RosEnvironment.of(Map.of("ROS_DOMAIN_ID", " 42 ", "ROS_STATIC_PEERS", "10.0.0.7; 10.0.0.8;"));
        assertThat(environment.domain()).isEqualTo(Optional.of(42));
        assertThat(environment.peers()).containsExactly("10.0.0.7", "10.0.0.8");
        assertThat(environment.words()).isEqualTo("ROS_DOMAIN_ID=42 ROS_STATIC_PEERS=10.0.0.7;10.0.0.8");
        assertThat(RosEnvironment.of(Map.of())).isEqualTo(RosEnvironment.NONE);
        assertThatThrownBy(() -> RosEnvironment.of(Map.of("ROS_DOMAIN_ID", "five")))
                .hasMessage("ROS_DOMAIN_ID is 'five', which is not a number. Set one from 0 to 232.");
    }

    @Test
    void onlyThisMachineIsReachedUnlessSomebodySaysMore() {
        assertThat(options(List.of(), Map.of()).addresses()).containsExactly(LOOPBACK);
        assertThat(options(List.of(), Map.of(RANGE, "LOCALHOST", "ROS_STATIC_PEERS", "10.0.0.7"))
                        .addresses())
                .containsExactly(LOOPBACK);
        assertThat(options(List.of("127.0.0.1", "127.0.0.1"), Map.of(RANGE, "SUBNET"))
                        .addresses())
                .containsExactly(LOOPBACK);
    }

    /// A machine without any other network has its loopback one.
    @Test
    void wholeNetworksAreAllAddressesOfThisMachine() {
        List<InetAddress> all = options(List.of("0.0.0.0"), Map.of()).addresses();
        assertThat(all).isNotEmpty().doesNotContain(RosNetwork.machine("address", "0.0.0.0"));
        assertThat(options(List.of(), Map.of(RANGE, "SUBNET")).addresses()).isEqualTo(all);
    }

    @Test
    void peersAreLookedForByTheAddressThatLeadsThere() {
        UdpParticipant.Options options = options(List.of(), Map.of("ROS_STATIC_PEERS", "127.0.0.1"));
        assertThat(options.addresses()).containsExactly(LOOPBACK);
        assertThat(options.peers()).containsExactly(LOOPBACK);
    }

    @Test
    void whatCannotBeIsRefused() {
        assertThatThrownBy(() -> options(List.of(), Map.of(RANGE, "OFF")))
                .hasMessage("ROS_AUTOMATIC_DISCOVERY_RANGE is OFF, so nobody is found. Set LOCALHOST or SUBNET.");
        assertThatThrownBy(() -> options(List.of("::1"), Map.of()))
                .hasMessageContaining("is an address of IPv6, which can't be used yet.");
        assertThatThrownBy(() -> options(List.of(), Map.of("ROS_STATIC_PEERS", "no machine")))
                .hasMessage("'ROS_STATIC_PEERS' has no machine called 'no machine'.");
    }
}
