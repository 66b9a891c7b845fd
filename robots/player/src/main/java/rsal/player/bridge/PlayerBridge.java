package rsal.player.bridge;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.player.message.Interface;
import rsal.player.message.Session;
import rsal.robot.Robot;
import rsal.scene.Service;
import rsal.system.Bridge;
import rsal.system.BridgeProvider.Lent;
import rsal.time.Scheduler;

/// Offers robots to Player's clients for as long as it is open: what the file of their world asks for, or each
/// robot on a port of its own, as Player's servers have it.
final class PlayerBridge implements Bridge {
    private final List<OfferedPort> ports;

    private PlayerBridge(List<OfferedPort> ports) {
        this.ports = List.copyOf(ports);
    }

    /// @param at where what is at Player's usual port is, and the others as far from there as they would be; port
    /// 0 for any that are free
    /// @throws IOException when nobody may listen there, which its message says
    static PlayerBridge open(InetSocketAddress at, Lent lent, Scheduler scheduler) throws IOException {
        var ports = new ArrayList<OfferedPort>();
        Map<Integer, List<Offered>> offers = lent.services().isEmpty() ? each(lent, scheduler) : asked(lent, scheduler);
        try {
            for (Map.Entry<Integer, List<Offered>> port : offers.entrySet()) {
                ports.add(new OfferedPort(moved(at, port.getKey()), port.getValue(), scheduler));
            }
        } catch (IOException | RuntimeException e) {
            ports.forEach(OfferedPort::close);
            throw e;
        }
        ports.forEach(OfferedPort::start);
        return new PlayerBridge(ports);
    }

    private static InetSocketAddress moved(InetSocketAddress at, int port) throws IOException {
        int number = at.getPort() == 0 ? 0 : at.getPort() + port - Session.USUAL_PORT;
        if (number < 0 || number > Session.LAST_PORT) {
            throw new IOException("There is no port (%d): the last one is %d.".formatted(number, Session.LAST_PORT));
        }
        return new InetSocketAddress(at.getAddress(), number);
    }

    /// Everything, by port.
    private static Map<Integer, List<Offered>> each(Lent lent, Scheduler scheduler) {
        var ports = new LinkedHashMap<Integer, List<Offered>>();
        for (Robot robot : lent.robots()) {
            var offers = new ArrayList<Offered>();
            if (ports.isEmpty()) {
                lent.simulation().ifPresent(truth -> offers.add(new OfferedSimulation(0, truth, scheduler)));
            }
            offers.addAll(new Offers(robot, scheduler).all());
            offers.add(new OfferedMap(0, lent.map(), "rsal", scheduler));
            ports.put(Session.USUAL_PORT + ports.size(), offers);
        }
        return ports;
    }

    /// What the file of the world asks for, by port.
    private static Map<Integer, List<Offered>> asked(Lent lent, Scheduler scheduler) {
        var robots = new HashMap<String, Offers>();
        lent.robots().forEach(robot -> robots.put(robot.id(), new Offers(robot, scheduler)));
        var ports = new LinkedHashMap<Integer, List<Offered>>();
        for (Service service : lent.services()) {
            List<Offered> offers = ports.computeIfAbsent(service.port(), _ -> new ArrayList<>());
            for (String name : service.devices()) {
                Optional.ofNullable(service.sources().get(name))
                        .flatMap(source -> offer(service, name, source, lent, robots, scheduler))
                        .map(offered -> offered.drivenBy(service.driver()))
                        .ifPresent(offers::add);
            }
        }
        return ports;
    }

    /// @param name with its index, `laser:0`
    private static Optional<Offered> offer(
            Service service, String name, String source, Lent lent, Map<String, Offers> robots, Scheduler scheduler) {
        int colon = name.indexOf(':');
        Interface as = Interface.of(name.substring(0, colon)).orElse(Interface.OPAQUE); // what a plugin brings along
        int index = Integer.parseInt(name.substring(colon + 1));
        return switch (source) {
            case Service.MAP ->
                Optional.of(new OfferedMap(index, lent.map(), service.driver(), scheduler))
                        .filter(_ -> as == Interface.MAP)
                        .map(Offered.class::cast);
            case Service.SIMULATION ->
                lent.simulation()
                        .filter(_ -> as == Interface.SIMULATION)
                        .map(truth -> new OfferedSimulation(index, truth, scheduler));
            default ->
                service.robot()
                        .flatMap(robot -> Optional.ofNullable(robots.get(robot)))
                        .flatMap(offers -> offers.offer(as, index, source, service.tolerance()));
        };
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
