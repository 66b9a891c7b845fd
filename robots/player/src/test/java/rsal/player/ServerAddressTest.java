package rsal.player;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.player.ServerAddress.Server;

class ServerAddressTest {
    @Test
    void readsOneAfterTheOther() {
        assertThat(ServerAddress.read("player://localhost:6665, robot2:6667 10.0.0.7:6665:1"))
                .containsExactly(
                        new ServerAddress(List.of(new Server("localhost", 6665)), 0),
                        new ServerAddress(List.of(new Server("robot2", 6667)), 0),
                        new ServerAddress(List.of(new Server("10.0.0.7", 6665)), 1));
        assertThat(ServerAddress.read("")).isEmpty();
        assertThat(ServerAddress.read("  ")).isEmpty();
    }

    @Test
    void serversOfOneRobotAreJoined() {
        assertThat(ServerAddress.read("localhost:6665+localhost:6666"))
                .containsExactly(
                        new ServerAddress(List.of(new Server("localhost", 6665), new Server("localhost", 6666)), 0));
        assertThat(ServerAddress.read("a:1+b:2:3").getFirst().index()).isEqualTo(3);
    }

    @Test
    void readsWhatItWrites() {
        for (String text : List.of("a:1", "a:1:2", "a:1+b:2", "a:1+b:2:7")) {
            assertThat(ServerAddress.read(text).getFirst()).hasToString(text);
        }
    }

    @Test
    void severalAreOnThePortsFromOneOn() {
        assertThat(ServerAddress.from("there", 7000, 0, 3)).hasToString("[there:7000, there:7001, there:7002]");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "localhost",
                "localhost:",
                ":6665",
                "localhost:0",
                "localhost:65536",
                "a:b",
                "a:1:b",
                "a:1++b:2",
                "http://a:1",
                "a:1:2:3",
                "a:99999999999"
            })
    void whatIsNoServerIsNamed(String text) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> ServerAddress.read("ok:1 " + text))
                .withMessageContaining("is not a server. Write HOST:PORT");
    }

    @Test
    void anyTextIsReadOrRefused() {
        var random = new SplittableRandom(1);
        String letters = "ab:+,/ 0169.player-\u00e9\n";
        for (int i = 0; i < 20_000; i++) {
            var text = new StringBuilder();
            for (int length = random.nextInt(20); length > 0; length--) {
                text.append(letters.charAt(random.nextInt(letters.length())));
            }
            try {
                ServerAddress.read(text.toString())
                        .forEach(berth ->
                                assertThat(ServerAddress.read(berth.toString())).containsExactly(berth));
            } catch (IllegalArgumentException e) {
                assertThat(e).hasMessageContaining("is not a server");
            }
        }
    }
}
