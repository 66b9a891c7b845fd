package rsal.player.bridge;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import rsal.robot.Robot;
import rsal.system.Bridge;
import rsal.system.BridgeProvider.Lent;
import rsal.time.Scheduler;

/// Offers robots to Player's clients for as long as it is open, each on a port of its own, as Player's servers have it.
final class PlayerBridge implements Bridge {
    private static final int MOST_PORT = 65_535;

    private final List<OfferedPort> ports;

    private PlayerBridge(List<OfferedPort> ports) {
        this.ports = List.copyOf(ports);
    }

    /// @param at where the first robot is, the others on the ports after it; port 0 for any that are free
    /// @throws IOException when nobody may listen there, which its message says
    static PlayerBridge open(InetSocketAddress at, Lent lent, Scheduler scheduler) throws IOException {
        var ports = new ArrayList<OfferedPort>();
        try {
            for (Robot robot : lent.robots()) {
                var offers = new ArrayList<Offered>();
                if (ports.isEmpty()) {
                    lent.simulation().ifPresent(truth -> offers.add(new OfferedSimulation(0, truth, scheduler)));
                }
                offers.addAll(Offers.of(robot, scheduler));
                offers.add(new OfferedMap(0, lent.map(), "rsal", scheduler));
                ports.add(new OfferedPort(after(at, ports.size()), offers, scheduler));
            }
        } catch (IOException | RuntimeException e) {
            ports.forEach(OfferedPort::close);
            throw e;
        }
        ports.forEach(OfferedPort::start);
        return new PlayerBridge(ports);
    }

    private static InetSocketAddress after(InetSocketAddress first, int count) throws IOException {
        int number = first.getPort() == 0 ? 0 : first.getPort() + count;
        if (number > MOST_PORT) {
            throw new IOException(
                    "There is no port (%d) for robot %d: the last one is %d.".formatted(number, count + 1, MOST_PORT));
        }
        return new InetSocketAddress(first.getAddress(), number);
    }

    @Override
    public List<Offer> offers() {
        return ports.stream().flatMap(port -> port.offers().stream()).toList();
    }

    @Override
    public void close() {
        ports.forEach(OfferedPort::close);
    }
}
