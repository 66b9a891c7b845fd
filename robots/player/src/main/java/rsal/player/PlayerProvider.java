package rsal.player;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import rsal.player.PlayerSystem.Overseer;
import rsal.player.client.Delivery;
import rsal.player.device.RemoteRobot;
import rsal.player.message.Session;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotSpec;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.system.RealRobots;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider;
import rsal.system.RobotSystemProvider.InvalidRobots.Problem;
import rsal.time.Scheduler;

/// Robots of Player servers: real ones, and those that Stage or `rsal bridge player` simulates. They follow real time.
public final class PlayerProvider implements RobotSystemProvider {
    private static final String KEY = "player";

    private static final Parameter<String> SERVERS = Parameter.text(
            "servers",
            "",
            "Servers of the robots, in order: HOST:PORT; HOST:PORT:1 for the second robot of a server; + joins"
                    + " servers of one robot. Default: 'host' and 'port'.");
    private static final Parameter<String> HOST =
            Parameter.text("host", "localhost", "Machine of the server, if 'servers' is empty.");
    private static final Parameter<Integer> PORT = Parameter.integer(
            "port",
            Session.USUAL_PORT,
            1,
            Session.LAST_PORT,
            "",
            "Port of the server, if 'servers' is empty; further robots are on the following ports.");
    private static final Parameter<Integer> INDEX = Parameter.integer(
            "index", 0, 0, 9999, "", "Number of the robot on its server, from 0, if 'servers' is empty.");
    private static final Parameter<String> DELIVERY = Parameter.choice(
            "delivery",
            words(Delivery.AUTO),
            Arrays.stream(Delivery.values()).map(PlayerProvider::words).toList(),
            "How data is delivered: pushed at once; pulled in rounds, for slow networks; auto pulls from other"
                    + " machines.");

    private static final String OWN = "own";
    private static final Parameter<String> SIMULATION = Parameter.text(
            "simulation",
            "",
            "Source of the true poses of simulated robots: 'own', the first of their servers that has a simulation,"
                    + " or HOST:PORT of another server. Default: none.");
    private static final Parameter<String> NAMES = Parameter.text(
            "names", "", "Names of the robots in that simulation, in order, separated by commas. Default: their ids.");

    @Override
    public String key() {
        return KEY;
    }

    @Override
    public String description() {
        return "Connects to robots of Player servers, real or in Stage, over the network.";
    }

    @Override
    public boolean followsSchedulerTime() {
        return false;
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(
                SERVERS,
                HOST,
                PORT,
                INDEX,
                DELIVERY,
                RealRobots.WATCHDOG,
                RealRobots.ARMED,
                RealRobots.WAIT,
                RealRobots.LATE,
                SIMULATION,
                NAMES);
    }

    @Override
    public boolean startsDisarmed(Arguments settings) {
        return !settings.get(RealRobots.ARMED);
    }

    @Override
    public RobotSystem create(Config config, Scheduler scheduler) {
        Arguments settings = config.settings();
        var problems = new ArrayList<Problem>();
        for (RobotSpec robot : config.robots()) {
            for (Part part : robot.model().sensors().values()) {
                if (!RemoteRobot.has(part)) {
                    problems.add(new Problem(
                            robot.id(), "model", "Player has nothing like its '%s'.".formatted(part.name())));
                }
            }
        }
        Optional<Map<RobotSpec, ServerAddress>> berths =
                read(() -> berths(settings, config.robots()), config, problems);
        Optional<Optional<Overseer>> overseer = read(() -> overseer(settings, config.robots()), config, problems);
        if (settings.get(RealRobots.LATE) && overseer.flatMap(known -> known).isPresent()) {
            problems.add(new Problem(
                    config.robots().getFirst().id(),
                    "mrs",
                    "'late' can't be used with 'simulation', which must know all robots at the start."));
        }
        if (!problems.isEmpty()) {
            throw new InvalidRobots(problems);
        }
        return new PlayerSystem(
                berths.orElseThrow(),
                overseer.orElseThrow(),
                Delivery.valueOf(settings.get(DELIVERY).toUpperCase(Locale.ROOT)),
                settings.seconds(RealRobots.WATCHDOG),
                settings.get(RealRobots.ARMED),
                RealRobots.Waiting.of(settings),
                scheduler);
    }

    /// What settings say; empty, with a problem more, when that can't be.
    private static <T> Optional<T> read(Supplier<T> settings, Config config, List<Problem> problems) {
        try {
            return Optional.of(settings.get());
        } catch (IllegalArgumentException e) {
            problems.add(new Problem(config.robots().getFirst().id(), "mrs", String.valueOf(e.getMessage())));
            return Optional.empty();
        }
    }

    private static String words(Delivery delivery) {
        return delivery.name().toLowerCase(Locale.ROOT);
    }

    private static Optional<Overseer> overseer(Arguments settings, List<RobotSpec> robots) {
        String who = settings.get(SIMULATION).strip();
        if (who.isEmpty() || robots.isEmpty()) {
            return Optional.empty();
        }
        List<String> ids = robots.stream().map(RobotSpec::id).toList();
        String written = settings.get(NAMES).strip();
        List<String> names = written.isEmpty() ? ids : List.of(written.split("\\s*,\\s*", -1));
        if (names.size() != ids.size()) {
            throw new IllegalArgumentException(
                    "As many 'names' as robots are needed: %d, not %d.".formatted(ids.size(), names.size()));
        }
        var byId = new LinkedHashMap<String, String>();
        for (int i = 0; i < ids.size(); i++) {
            byId.put(ids.get(i), names.get(i));
        }
        if (who.equals(OWN)) {
            return Optional.of(new Overseer(Optional.empty(), byId));
        }
        List<ServerAddress> there = ServerAddress.read(who);
        boolean one = there.size() == 1 && there.getFirst().servers().size() == 1;
        if (!one) {
            throw new IllegalArgumentException("'simulation' must be 'own' or HOST:PORT, not '%s'.".formatted(who));
        }
        return Optional.of(new Overseer(Optional.of(there.getFirst().servers().getFirst()), byId));
    }

    private static Map<RobotSpec, ServerAddress> berths(Arguments settings, List<RobotSpec> robots) {
        if (robots.isEmpty()) {
            return Map.of(); // all of them are elsewhere
        }
        List<ServerAddress> all = ServerAddress.read(settings.get(SERVERS));
        if (all.isEmpty()) {
            int port = settings.get(PORT);
            if (port + robots.size() - 1 > Session.LAST_PORT) {
                throw new IllegalArgumentException(
                        "There are fewer than %d ports from %d on.".formatted(robots.size(), port));
            }
            all = ServerAddress.from(settings.get(HOST), port, settings.get(INDEX), robots.size());
        }
        if (all.size() < robots.size()) {
            throw new IllegalArgumentException(
                    "As many 'servers' as robots are needed: %d, not %d.".formatted(robots.size(), all.size()));
        }
        var berths = new LinkedHashMap<RobotSpec, ServerAddress>();
        var taken = new HashMap<ServerAddress, String>();
        for (int i = 0; i < robots.size(); i++) {
            String other = taken.put(all.get(i), robots.get(i).id());
            if (other != null) {
                throw new IllegalArgumentException("Robots '%s' and '%s' are both at '%s'."
                        .formatted(other, robots.get(i).id(), all.get(i)));
            }
            berths.put(robots.get(i), all.get(i));
        }
        return berths;
    }
}
