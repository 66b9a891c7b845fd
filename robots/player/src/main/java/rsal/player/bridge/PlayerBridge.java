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
import rsal.player.message.Protocol;
import rsal.player.message.Session;
import rsal.robot.Robot;
import rsal.scene.RobotService;
import rsal.system.Bridge;
import rsal.system.BridgeContext;
import rsal.system.ExportedDevice;
import rsal.time.Scheduler;

/// Offers robots to Player's clients for as long as it is open: what the file of their world asks for, or each
/// robot on a port of its own, as Player's servers have it. A robot that comes later has the port after all others;
/// that of one that has gone stays closed.
final class PlayerBridge implements Bridge {
    private final InetSocketAddress at;
    private final BridgeContext context;
    private final Protocol protocol;
    private final Scheduler scheduler;
    private final Map<String, OfferedPort> ports = new LinkedHashMap<>(); // by robot, or by number in a file
    private int next = Session.USUAL_PORT; // for a robot, as numbers in files are

    private PlayerBridge(InetSocketAddress at, BridgeContext context, Protocol protocol, Scheduler scheduler) {
        this.at = at;
        this.context = context;
        this.protocol = protocol;
        this.scheduler = scheduler;
    }

    /// @param at where what is at Player's usual port is, and the others as far from there as they would be; port
    /// 0 for any that are free
    /// @param protocol of clients that don't show another
    /// @throws IOException when nobody may listen there, which its message says
    static PlayerBridge open(InetSocketAddress at, BridgeContext context, Protocol protocol, Scheduler scheduler)
            throws IOException {
        var bridge = new PlayerBridge(at, context, protocol, scheduler);
        try {
            if (context.services().isEmpty()) {
                for (Robot robot : context.robots()) {
                    bridge.listen(robot);
                }
            } else {
                for (Map.Entry<Integer, List<Offered>> port :
                        asked(context, scheduler).entrySet()) {
                    bridge.listen(port.getKey().toString(), port.getKey(), port.getValue());
                }
            }
        } catch (IOException | RuntimeException e) {
            bridge.close();
            throw e;
        }
        bridge.ports.values().forEach(OfferedPort::start);
        return bridge;
    }

    /// At the next port.
    private OfferedPort listen(Robot robot) throws IOException {
        var offers = new ArrayList<Offered>();
        if (next == Session.USUAL_PORT) {
            context.simulation().ifPresent(truth -> offers.add(new OfferedSimulation(0, truth, scheduler)));
        }
        offers.addAll(new Offers(robot, context.timeout(), scheduler).all());
        offers.add(new OfferedMap(0, context.map(), "rsal", scheduler));
        next++; // whether it is free or not
        return listen(robot.id(), next - 1, offers);
    }

    private OfferedPort listen(String name, int number, List<Offered> offers) throws IOException {
        var port = new OfferedPort(moved(at, number), offers, protocol, scheduler);
        ports.put(name, port);
        return port;
    }

    private static InetSocketAddress moved(InetSocketAddress at, int port) throws IOException {
        int number = at.getPort() == 0 ? 0 : at.getPort() + port - Session.USUAL_PORT;
        if (number < 0 || number > Session.LAST_PORT) {
            throw new IOException("There is no port '%d': the last one is %d.".formatted(number, Session.LAST_PORT));
        }
        return new InetSocketAddress(at.getAddress(), number);
    }

    /// What the file of the world asks for, by port.
    private static Map<Integer, List<Offered>> asked(BridgeContext context, Scheduler scheduler) {
        var robots = new HashMap<String, Offers>();
        context.robots().forEach(robot -> robots.put(robot.id(), new Offers(robot, context.timeout(), scheduler)));
        var ports = new LinkedHashMap<Integer, List<Offered>>();
        for (RobotService service : context.services()) {
            List<Offered> offers = ports.computeIfAbsent(service.port(), _ -> new ArrayList<>());
            for (String name : service.devices()) {
                Optional.ofNullable(service.sources().get(name))
                        .flatMap(source -> offer(service, name, source, context, robots, scheduler))
                        .map(offered -> offered.drivenBy(service.driver()))
                        .ifPresent(offers::add);
            }
        }
        return ports;
    }

    /// @param name with its index, `laser:0`
    private static Optional<Offered> offer(
            RobotService service,
            String name,
            String source,
            BridgeContext context,
            Map<String, Offers> robots,
            Scheduler scheduler) {
        int colon = name.indexOf(':');
        Interface as = Interface.of(name.substring(0, colon)).orElse(Interface.OPAQUE); // what a plugin brings along
        int index = Integer.parseInt(name.substring(colon + 1));
        return switch (source) {
            case RobotService.MAP ->
                Optional.of(new OfferedMap(index, context.map(), service.driver(), scheduler))
                        .filter(_ -> as == Interface.MAP)
                        .map(Offered.class::cast);
            case RobotService.SIMULATION ->
                context.simulation()
                        .filter(_ -> as == Interface.SIMULATION)
                        .map(truth -> new OfferedSimulation(index, truth, scheduler));
            default ->
                service.robot()
                        .flatMap(robot -> Optional.ofNullable(robots.get(robot)))
                        .flatMap(offers -> offers.offer(as, index, source, service.tolerance()));
        };
    }

    @Override
    public List<ExportedDevice> offers() {
        return ports.values().stream().flatMap(port -> port.offers().stream()).toList();
    }

    @Override
    public List<ExportedDevice> join(Robot robot) throws IOException {
        if (!context.services().isEmpty() || ports.containsKey(robot.id())) {
            return List.of();
        }
        OfferedPort port = listen(robot);
        port.start();
        return port.offers();
    }

    /// What a file asks for stays, and says nothing more of it.
    @Override
    public void leave(String robot) {
        if (context.services().isEmpty()) {
            Optional.ofNullable(ports.remove(robot)).ifPresent(OfferedPort::close);
        }
    }

    @Override
    public boolean isBehind() {
        return ports.values().stream().anyMatch(OfferedPort::isBehind);
    }

    @Override
    public void close() {
        ports.values().forEach(OfferedPort::close);
        ports.clear();
    }
}
