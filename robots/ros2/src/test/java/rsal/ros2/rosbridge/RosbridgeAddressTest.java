package rsal.ros2.rosbridge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class RosbridgeAddressTest {
    @ParameterizedTest
    @CsvSource({
        "ws://robot.local:9090, ws://robot.local:9090",
        "ws://robot.local, ws://robot.local:9090",
        "ws://robot.local/bridge, ws://robot.local:9090/bridge",
        "'  ws://10.0.0.7:80 ', ws://10.0.0.7:80",
        "ws://[::1]:9090, ws://[::1]:9090",
        "wss://robot.local/bridge, wss://robot.local/bridge" // 443, as of a proxy in front of it
    })
    void isTheServers(String text, String address) {
        assertThat(RosbridgeAddress.parse(text)).hasToString(address);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "robot.local:9090",
                "http://robot.local:9090",
                "ws:",
                "ws://",
                "ws://rob ot",
                "ws://me:secret@robot",
                "ws://robot#x"
            })
    void isNothingElse(String text) {
        assertThatThrownBy(() -> RosbridgeAddress.parse(text))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(text)
                .hasMessageContaining("ws://robot.local:9090");
    }
}
