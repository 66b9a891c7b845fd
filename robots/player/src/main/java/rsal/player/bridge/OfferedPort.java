package rsal.player.bridge;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.List;
import rsal.device.Subscription;
import rsal.player.message.Protocol;
import rsal.player.server.Port;
import rsal.system.ExportedDevice;
import rsal.time.AllowedToReadWallClock;
import rsal.time.Scheduler;

/// A port and what is offered there. Lives on the scheduler's thread.
@AllowedToReadWallClock("Clients live in real time.")
final class OfferedPort implements AutoCloseable {
    private final Port port;
    private final List<Offered> offered;
    private List<Subscription> publishing = List.of();

    /// Listens at once, but takes no clients before it is [started][#start].
    ///
    /// @param at where; port 0 for any that is free
    /// @param protocol of clients that don't show another
    /// @throws IOException when nobody may listen there, which its message says
    OfferedPort(InetSocketAddress at, List<Offered> offered, Protocol protocol, Scheduler scheduler)
            throws IOException {
        this.offered = List.copyOf(offered);
        try {
            this.port = new Port(
                    at, offered, protocol, () -> Offered.seconds(scheduler.instant()), System::nanoTime, scheduler);
        } catch (IOException e) {
            throw new IOException(
                    "RSAL can't listen at '%s:%d': %s.".formatted(at.getHostString(), at.getPort(), e.getMessage()), e);
        }
    }

    void start() {
        publishing = offered.stream().map(each -> each.begin(port)).toList();
        port.start();
    }

    boolean isBehind() {
        return port.isBehind();
    }

    List<ExportedDevice> offers() {
        return offered.stream()
                .map(each ->
                        new ExportedDevice(port.number(), each.interf().word() + ":" + each.index(), each.device()))
                .toList();
    }

    @Override
    public void close() {
        port.close();
        offered.forEach(Offered::idle);
        publishing.forEach(Subscription::cancel);
    }
}
