package rsal.cli.page;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.security.KeyStore;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.cli.Main;
import rsal.server.access.Listening;

class ReachableHostsTest {
    @TempDir
    private Path folder;

    private KeyStore certificate(String... names) {
        var line = new ArrayList<>(List.of("certificate"));
        line.addAll(List.of(names));
        line.addAll(List.of("--out", folder.toString()));
        assertThat(Main.commandLine(OutputStream.nullOutputStream()).execute(line.toArray(String[]::new)))
                .isZero();
        return PemFiles.identity(folder.resolve("certificate.pem"), folder.resolve("key.pem"));
    }

    private static List<String> hosts(String address, KeyStore identity) {
        var at = new InetSocketAddress(InetAddress.ofLiteral(address), 8443);
        return ReachableHosts.of(new Listening(at, identity, Map.of(), List.of()));
    }

    @Test
    void allAddressesAreThoseInTheCertificateThatOthersCanOpen() {
        KeyStore identity = certificate("localhost", "robots.local", "192.168.1.5", "127.0.0.1", "fd00::5");
        List<String> expected = List.of("robots.local", "192.168.1.5", "[fd00:0:0:0:0:0:0:5]");
        assertThat(hosts("0.0.0.0", identity)).containsExactlyElementsOf(expected);
        assertThat(hosts("::", identity)).containsExactlyElementsOf(expected);
        assertThat(hosts("192.168.1.9", identity)).containsExactly("192.168.1.9");
    }

    @Test
    void whereTheCertificateHasNoneThisMachineIsNamed() throws Exception {
        assertThat(hosts("0.0.0.0", certificate("localhost")))
                .containsExactly(InetAddress.getLocalHost().getHostName());
    }
}
