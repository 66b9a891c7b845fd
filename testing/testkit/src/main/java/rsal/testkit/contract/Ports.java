package rsal.testkit.contract;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;

/// The TCP and UDP ports on which this process listens, as Linux tells them; none are known elsewhere.
public final class Ports {
    /// By table, the state of a socket that hears from anybody, as `/proc/net` has it.
    private static final Map<String, String> LISTENING = Map.of("tcp", "0A", "tcp6", "0A", "udp", "07", "udp6", "07");

    private Ports() {}

    /// As protocol, address and port in hexadecimal digits: `udp 0100007F:1F90`.
    public static Set<String> listening() {
        try {
            Set<String> own = sockets();
            var ports = new HashSet<String>();
            for (String protocol : LISTENING.keySet()) {
                Path table = Path.of("/proc/self/net", protocol);
                if (Files.isReadable(table)) {
                    Files.readAllLines(table).stream()
                            .skip(1) // names of the columns
                            .map(line -> line.strip().split("\\s+", -1))
                            .filter(columns -> columns[3].equals(LISTENING.get(protocol)) && own.contains(columns[9]))
                            .forEach(columns -> ports.add(protocol + " " + columns[1]));
                }
            }
            return ports;
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    /// Inodes of this process's sockets.
    private static Set<String> sockets() throws IOException {
        Path files = Path.of("/proc/self/fd");
        var inodes = new HashSet<String>();
        if (Files.isDirectory(files)) {
            try (Stream<Path> open = Files.list(files)) {
                open.forEach(file -> {
                    try {
                        String target = Files.readSymbolicLink(file).toString();
                        if (target.startsWith("socket:[")) {
                            inodes.add(target.substring("socket:[".length(), target.length() - 1));
                        }
                    } catch (IOException _) {
                        // closed meanwhile
                    }
                });
            }
        }
        return inodes;
    }
}
