package rsal.player.bridge;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.List;
import rsal.device.Subscription;
import rsal.player.server.Port;
import rsal.robot.Robot;
import rsal.system.Bridge;
import rsal.time.Scheduler;

/// Offers robots to Player's clients on one port, for as long as it is open.
final class PlayerBridge implements Bridge {
    private final Port port;
    private final List<Offered> offered;
    private final List<Subscription> telling;

    private PlayerBridge(Port port, List<Offered> offered, List<Subscription> telling) {
        this.port = port;
        this.offered = offered;
        this.telling = telling;
    }

    /// @param at where to listen; port 0 for any that is free
    /// @throws IOException when nobody may listen there
    static PlayerBridge open(InetSocketAddress at, List<Robot> robots, Scheduler scheduler) throws IOException {
        List<Offered> offers = Offers.of(robots, scheduler);
        var port = new Port(at, offers, () -> Offered.seconds(scheduler.instant()));
        var telling = offers.stream().map(offer -> offer.begin(port)).toList();
        port.start();
        return new PlayerBridge(port, offers, telling);
    }

    @Override
    public int port() {
        return port.number();
    }

    @Override
    public List<Offer> offers() {
        return offered.stream()
                .map(each -> new Offer(each.interf().word() + ":" + each.index(), each.device()))
                .toList();
    }

    @Override
    public void close() {
        port.close();
        offered.forEach(Offered::idle);
        telling.forEach(Subscription::cancel);
    }
}
