package rsal.cli.page;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/// Which page a command is for that names no port.
///
/// @param port of the page
/// @param note for a person with several pages; empty where there is no doubt
record ChosenPage(int port, Optional<String> note) {
    private static final int PATIENCE_MILLIS = 500;

    /// @throws IllegalArgumentException with a sentence when only the person can know
    static ChosenPage now() {
        List<Integer> ours = PageKey.ports();
        return among(
                ours.size() < 2
                        ? ours
                        : ours.stream().filter(ChosenPage::isOpen).toList()); // one that was killed leaves its key
    }

    /// @param ours ports of the person's pages
    static ChosenPage among(List<Integer> ours) {
        if (ours.size() < 2) {
            return new ChosenPage(ours.isEmpty() ? PageRuns.DEFAULT_PORT : ours.getFirst(), Optional.empty());
        }
        String ports = ours.stream().map(String::valueOf).collect(Collectors.joining(", "));
        if (!ours.contains(PageRuns.DEFAULT_PORT)) {
            throw new IllegalArgumentException(
                    "There are several runs with a page on this machine, at the ports %s. Choose one: --port %d."
                            .formatted(ports, ours.getFirst()));
        }
        return new ChosenPage(
                PageRuns.DEFAULT_PORT,
                Optional.of(
                        "There are several runs with a page on this machine, at the ports %s. This is for the run at %d; --port chooses."
                                .formatted(ports, PageRuns.DEFAULT_PORT)));
    }

    private static boolean isOpen(int port) {
        try (var socket = new Socket()) {
            socket.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), PATIENCE_MILLIS);
            return true;
        } catch (IOException _) {
            return false;
        }
    }
}
