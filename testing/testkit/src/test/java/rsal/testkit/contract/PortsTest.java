package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/// What the contract of hosts looks by finds what there is.
class PortsTest {
    @BeforeEach
    void onLinux() {
        Assumptions.assumeTrue(Files.isReadable(Path.of("/proc/self/net/tcp")));
    }

    @Test
    void findsWhoWaitsForConnections() throws IOException {
        Set<String> before = Ports.listening();
        try (var socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            assertThat(added(before)).singleElement().asString().matches("tcp6? " + port(socket.getLocalPort()));
        }
        assertThat(added(before)).isEmpty();
    }

    @Test
    void findsWhoHearsDatagrams() throws IOException {
        Set<String> before = Ports.listening();
        try (var socket = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
            assertThat(added(before)).singleElement().asString().matches("udp6? " + port(socket.getLocalPort()));
        }
        assertThat(added(before)).isEmpty();
    }

    private static Set<String> added(Set<String> before) {
        var now = new HashSet<>(Ports.listening());
        now.removeAll(before);
        return now;
    }

    private static String port(int number) {
        return ".*:%04X".formatted(number);
    }
}
