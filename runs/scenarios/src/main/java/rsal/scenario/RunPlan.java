package rsal.scenario;

import java.time.Duration;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rsal.agent.AgentHostProvider;
import rsal.agent.AgentType;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.robot.DeviceDriver;
import rsal.robot.RobotSpec;
import rsal.scenario.condition.Condition;
import rsal.scenario.condition.MetricExpression;
import rsal.scenario.fault.PlannedFault;
import rsal.scenario.installed.Catalog;
import rsal.scenario.installed.PluginReader;
import rsal.scenario.installed.UntrustedType;
import rsal.scene.Scene;
import rsal.settings.Arguments;
import rsal.settings.Plugin;
import rsal.settings.PluginChoice;
import rsal.settings.Problem;
import rsal.system.RobotSystemProvider;

/// A run with everything decided and nothing started. Immutable; it can be run again and again, and each time
/// is the same run.
///
/// @param configuration name of the one chosen
/// @param options what it was made with
/// @param arguments of the scenario, by name: Double, Long, String or Boolean
/// @param seed all randomness of the run comes from it
/// @param mapName what the scenario calls its map or world
/// @param scene where it takes place
/// @param mrs where robots come from that name no other robot system
/// @param things that are put into the world
/// @param places parts of the floor that conditions and metrics name
/// @param agents in the order in which they start
/// @param with the scenario and its configuration that joins it (`distribution:found`): its agents without a
///         robot are among the agents; empty when none does
/// @param communication its limits; empty when everybody hears everything
/// @param faults what goes wrong
/// @param speed simulated over real time to begin with; +∞ for as fast as it can
/// @param step of simulated time; between two steps a run can be looked at, paused and told things
/// @param stops the first that holds ends the run
/// @param toleratesFailedAgents whether a run in which an agent failed may be a success all the same
/// @param metricTypes whose quantities and signals stop conditions and metrics can name
public record RunPlan(
        Scenario scenario,
        String configuration,
        RunOptions options,
        Map<String, Object> arguments,
        long seed,
        String mapName,
        Scene scene,
        Mrs mrs,
        Mas mas,
        Clock clock,
        List<PlannedRobot> robots,
        List<PlannedThings> things,
        List<Place> places,
        List<PlannedAgent> agents,
        Optional<String> with,
        Optional<Communication> communication,
        List<PlannedFault> faults,
        double speed,
        Duration step,
        List<Stop> stops,
        boolean toleratesFailedAgents,
        List<PlannedMetric> metricTypes,
        List<MetricDefinition> metrics) {
    public RunPlan {
        arguments = Collections.unmodifiableMap(new LinkedHashMap<>(arguments));
        robots = List.copyOf(robots);
        things = List.copyOf(things);
        places = List.copyOf(places);
        agents = List.copyOf(agents);
        faults = List.copyOf(faults);
        stops = List.copyOf(stops);
        metricTypes = List.copyOf(metricTypes);
        metrics = List.copyOf(metrics);
    }

    /// What is right in it, but may not be what people think, each only once. Looks at the map, which takes a while
    /// when it is large.
    public List<Problem> notes() {
        return Notes.of(this);
    }

    /// Files of those agents, metrics and other plugins that are programs from who knows where, and so will not
    /// be run.
    public List<String> untrusted() {
        return Stream.of(
                        agents.stream()
                                .map(PlannedAgent::type)
                                .filter(UntrustedType.class::isInstance)
                                .map(AgentType::key),
                        metricTypes.stream()
                                .map(PlannedMetric::type)
                                .filter(PluginReader::isNotRun)
                                .map(Plugin::key),
                        robots.stream()
                                .flatMap(robot -> robot.drivers().stream())
                                .flatMap(made -> made.options().plugins().stream())
                                .map(PluginChoice::plugin)
                                .filter(PluginReader::isNotRun)
                                .map(Plugin::key))
                .flatMap(files -> files)
                .distinct()
                .toList();
    }

    /// The robot systems that take part: the scenario's, then those that robots name, in their order. The
    /// scenario's does so, too, when no robot is of it, as its world may be of use; unless robots are of one of
    /// its kind.
    public List<Mrs> systems() {
        return systems(mrs, robots);
    }

    static List<Mrs> systems(Mrs mrs, List<PlannedRobot> robots) {
        List<Mrs> named = robots.stream().map(PlannedRobot::mrs).distinct().toList();
        boolean takesPart = named.contains(mrs)
                || named.stream().noneMatch(other -> other.provider().equals(mrs.provider()));
        return Stream.concat(Stream.of(mrs).filter(_ -> takesPart), named.stream())
                .distinct()
                .toList();
    }

    /// What robots that have been told, planners and people know of the world.
    public OccupancyGrid map() {
        return scene.map();
    }

    /// The same with nobody who drives its robots, and nothing that ends it: for others to drive them.
    public RunPlan unmanned() {
        return with(List.of(), Optional.empty(), List.of());
    }

    /// The same with other agents.
    public RunPlan with(List<PlannedAgent> others) {
        return with(others, with, stops);
    }

    private RunPlan with(List<PlannedAgent> others, Optional<String> joined, List<Stop> ends) {
        return new RunPlan(
                scenario,
                configuration,
                options,
                arguments,
                seed,
                mapName,
                scene,
                mrs,
                mas,
                clock,
                robots,
                things,
                places,
                others,
                joined,
                communication,
                faults,
                speed,
                step,
                ends,
                toleratesFailedAgents,
                metricTypes,
                metrics);
    }

    /// Plans a robot that somebody adds to the scenario's robot system while the run goes on: without agents, but with
    /// what it can be given when people tell it what to do.
    public PlannedRobot newcomer(RobotSpec robot) {
        return new DeviceSelector(Catalog.installed(), new Seeds(seed)).robot(robot, mrs, List.of());
    }

    /// Whether the run follows the time of another simulator, which a robot system drives.
    public boolean isTimeDriven() {
        return systems().stream().anyMatch(DrivenTimeChecker::drives);
    }

    /// Whether robots stand until somebody switches their motors on.
    public boolean startsDisarmed() {
        return robots.stream()
                .map(PlannedRobot::mrs)
                .anyMatch(its -> its.provider().startsDisarmed(its.settings()));
    }

    /// A multi-robot system: where robots come from. Those with the same provider and settings are one.
    ///
    /// @param seed of its own randomness
    public record Mrs(RobotSystemProvider provider, Arguments settings, long seed) {
        /// As people know it: `Robot system (sim)`.
        public String name() {
            return "Robot system '%s'".formatted(provider.key());
        }

        /// With its settings, as far as they are not the usual ones: `player, host=lab`.
        public String words() {
            Map<String, Object> usual = new LinkedHashMap<>();
            provider.parameters()
                    .forEach(parameter -> parameter.fallback().ifPresent(value -> usual.put(parameter.name(), value)));
            return settings.asMap().entrySet().stream()
                    .filter(setting -> !setting.getValue().equals(usual.get(setting.getKey())))
                    .map(setting -> ", " + setting.getKey() + "=" + setting.getValue())
                    .collect(Collectors.joining("", provider.key(), ""));
        }

        /// Those robots that are its own.
        public List<RobotSpec> own(List<PlannedRobot> robots) {
            return robots.stream()
                    .filter(robot -> robot.mrs().equals(this))
                    .map(PlannedRobot::spec)
                    .toList();
        }

        /// What its provider asks for to make it.
        ///
        /// @param robots of all systems
        public RobotSystemProvider.Config config(Scene scene, List<PlannedRobot> robots) {
            return new RobotSystemProvider.Config(settings, scene, own(robots), seed);
        }
    }

    /// The multi-agent system: what runs the agents.
    public record Mas(AgentHostProvider provider, Arguments settings) {}

    public enum Clock {
        /// Time stands still while anything happens, then jumps: the same seed gives the same run.
        SIMULATED,
        /// Real time, or that of another simulator ([RunPlan#isTimeDriven]).
        WALL
    }

    /// @param mrs where it comes from
    /// @param drivers of its software devices, in the order in which they are made
    /// @param spares what it can be given besides, when somebody wants it
    /// @param proxy whether a stand-in of it is in the simulated world, of which it is not itself
    /// @param overlay whether its lasers and sonars see what is in that world, too
    public record PlannedRobot(
            RobotSpec spec, Mrs mrs, List<PlannedDevice> drivers, Spares spares, boolean proxy, boolean overlay) {
        public PlannedRobot {
            drivers = List.copyOf(drivers);
        }

        /// A robot that has nothing to do with a simulated world of which it is not.
        public PlannedRobot(RobotSpec spec, Mrs mrs, List<PlannedDevice> drivers, Spares spares) {
            this(spec, mrs, drivers, spares, false, false);
        }

        /// The same robot with other software devices.
        public PlannedRobot with(List<PlannedDevice> others) {
            return new PlannedRobot(spec, mrs, others, spares, proxy, overlay);
        }

        /// The same robot with a stand-in, or without one.
        public PlannedRobot withProxy(boolean stands) {
            return new PlannedRobot(spec, mrs, drivers, spares, stands, overlay);
        }

        /// The same robot with sensors that see what is simulated, or not.
        public PlannedRobot withOverlay(boolean sees) {
            return new PlannedRobot(spec, mrs, drivers, spares, proxy, sees);
        }

        /// Whether a device of that name is made from its others.
        public boolean makes(String device) {
            return drivers.stream().anyMatch(made -> made.name().equals(device));
        }
    }

    /// Software devices that are made when they are wanted first: a robot that nobody sends anywhere pays for none.
    ///
    /// @param navigation its localizer and its navigator
    public record Spares(Spare pilot, Spare navigation) {
        public static Spares none(String why) {
            return new Spares(Spare.none(why), Spare.none(why));
        }

        /// All of them.
        public List<Spare> all() {
            return List.of(pilot, navigation);
        }
    }

    /// @param devices in the order in which they are made
    /// @param refusal why there are none, in a sentence for people; empty when there are
    public record Spare(List<PlannedDevice> devices, String refusal) {
        public Spare {
            devices = List.copyOf(devices);
        }

        public static Spare none(String why) {
            return new Spare(List.of(), why);
        }

        public boolean isPossible() {
            return refusal.isEmpty();
        }
    }

    /// @param name of the device (`localizer`)
    /// @param seed of its random stream
    /// @param mapFromStart where it is told that its robot starts; empty for where that does
    public record PlannedDevice(
            String name, DeviceDriver driver, Arguments options, long seed, Optional<Pose2d> mapFromStart) {
        /// One that is told where its robot starts.
        public PlannedDevice(String name, DeviceDriver driver, Arguments options, long seed) {
            this(name, driver, options, seed, Optional.empty());
        }
    }

    /// @param robot id of the robot it acts for; empty when it has none
    /// @param seed of its random stream
    public record PlannedAgent(
            String name, String role, AgentType type, Arguments arguments, Optional<String> robot, long seed) {}

    /// An end of the run.
    ///
    /// @param after how long it still goes on once that is decided
    public record Stop(Condition when, Outcome outcome, Duration after) {}

    /// How a scenario can say that a run ends.
    public enum Outcome {
        SUCCESS("success"),
        FAILURE("failure"),
        TIMEOUT("timeout");

        private final String word;

        Outcome(String word) {
            this.word = word;
        }

        public String word() {
            return word;
        }
    }

    /// Something to measure.
    ///
    /// @param perRobot whether each robot has a value of its own, called `<name>.<robot>`
    /// @param min the least value that is still right; −∞ when there is none
    /// @param max the greatest value that is still right; +∞ when there is none
    public record MetricDefinition(
            String name, String unit, MetricExpression from, boolean perRobot, Better better, double min, double max) {
        /// What the value of one robot is called.
        public String nameOf(String robot) {
            return name + "." + robot;
        }

        /// What its values are called in a run with these robots: one for all, or one for each robot that it is of.
        public List<String> names(List<PlannedRobot> robots) {
            return perRobot
                    ? robots.stream()
                            .map(PlannedRobot::spec)
                            .filter(robot ->
                                    from.role().map(robot.role()::equals).orElse(true))
                            .map(robot -> nameOf(robot.id()))
                            .toList()
                    : List.of(name);
        }
    }

    /// Which values of a metric are the better ones.
    public enum Better {
        LESS("less"),
        MORE("more"),
        NEITHER("neither");

        private final String word;

        Better(String word) {
            this.word = word;
        }

        public String word() {
            return word;
        }
    }
}
