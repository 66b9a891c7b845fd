package rsal.testkit.contract;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/// The TCP ports on which this process listens, as Linux tells them; none are known elsewhere.
final class Ports {
    private static final String LISTEN = "0A"; // state of a socket in /proc/net/tcp

    private Ports() {}

    /// As address and port in hexadecimal digits.
    static Set<String> listening() {
        try {
            Set<String> own = sockets();
            var ports = new HashSet<String>();
            for (String table : List.of("/proc/self/net/tcp", "/proc/self/net/tcp6")) {
                if (Files.isReadable(Path.of(table))) {
                    Files.readAllLines(Path.of(table)).stream()
                            .skip(1) // names of the columns
                            .map(line -> line.strip().split("\\s+", -1))
                            .filter(columns -> columns[3].equals(LISTEN) && own.contains(columns[9]))
                            .forEach(columns -> ports.add(columns[1]));
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
