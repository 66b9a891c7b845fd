package rsal.cli.show;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.scenario.Communication;
import rsal.scenario.Configuration;
import rsal.scenario.RunPlan;
import rsal.scenario.RunPlan.PlannedAgent;
import rsal.scenario.RunPlan.PlannedDevice;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.scenario.Scenario;
import rsal.scenario.fault.PlannedFault;
import rsal.scenario.fault.Span;
import rsal.settings.Parameter;

/// What a scenario with one of its configurations comes to, as `rsal show --json` prints it.
record ShownScenario(
        String scenario,
        String title,
        String description,
        String file,
        String configuration,
        List<Configuration> configurations,
        List<Argument> arguments,
        World world,
        List<Role> robots,
        List<ShownAgent> agents,
        Optional<String> with,
        Optional<Limits> communication,
        List<Fault> faults,
        Run run,
        List<End> ends,
        List<MetricDefinition> metrics) {
    static ShownScenario of(Scenario scenario, RunPlan plan) {
        return new ShownScenario(
                scenario.name(),
                scenario.title(),
                scenario.description(),
                scenario.location().file(),
                plan.configuration(),
                scenario.configurations(),
                scenario.arguments().stream().map(a -> Argument.of(a, plan)).toList(),
                World.of(plan),
                roles(plan),
                plan.agents().stream().map(ShownAgent::of).toList(),
                plan.with(),
                plan.communication().map(Limits::of),
                plan.faults().stream().map(Fault::of).toList(),
                new Run(plan.seed(), plan.clock() == RunPlan.Clock.WALL ? "wall" : "simulated"),
                plan.stops().stream().map(End::of).toList(),
                plan.metrics().stream().map(MetricDefinition::of).toList());
    }

    record Argument(String name, Object value, String expected, String description) {
        static Argument of(Parameter<?> parameter, RunPlan plan) {
            Object value = Objects.requireNonNull(plan.arguments().get(parameter.name()), "a plan has all arguments");
            return new Argument(parameter.name(), value, parameter.expected(), parameter.description());
        }
    }

    /// @param width and height of the map [m]
    /// @param step of simulated time [s]
    record World(String map, double width, double height, String mrs, String mas, double step) {
        static World of(RunPlan plan) {
            OccupancyGrid map = plan.map();
            return new World(
                    plan.mapName(),
                    rounded(map.width() * map.resolution()),
                    rounded(map.height() * map.resolution()),
                    plan.mrs().provider().key(),
                    plan.mas().provider().key(),
                    plan.step().toNanos() / 1e9);
        }
    }

    /// How communication between agents is limited.
    ///
    /// @param range empty when it is not limited [m]
    /// @param behindWalls the same [m]
    /// @param delay least and most [s]
    /// @param bandwidth messages a second of each agent; empty when it is not limited
    record Limits(
            Optional<Double> range,
            Optional<Double> behindWalls,
            double loss,
            List<Double> delay,
            Optional<Double> bandwidth) {
        static Limits of(Communication limits) {
            Span delay = limits.delay();
            return new Limits(
                    Optional.of(limits.range()).filter(Double::isFinite),
                    Optional.of(limits.behindWalls()).filter(Double::isFinite),
                    limits.loss(),
                    List.of(delay.least().toNanos() / 1e9, delay.most().toNanos() / 1e9),
                    limits.bandwidth());
        }
    }

    /// @param clock `simulated` or `wall`
    record Run(long seed, String clock) {}

    /// Robots of one role that are alike; those of a role whose members differ are several of these.
    ///
    /// @param mrs their robot system, with its settings that are not the usual ones: `player, host=lab`; empty
    /// when it is the scenario's
    /// @param proxy whether stand-ins of them are in the simulated world
    /// @param overlay whether their lasers and sonars see what is in that world
    /// @param devices in the order in which they are made
    record Role(
            String role,
            List<String> ids,
            Optional<String> mrs,
            boolean proxy,
            boolean overlay,
            String model,
            List<String> sensors,
            List<Start> starts,
            List<Made> devices) {
        private Role of(List<PlannedRobot> robots) {
            return new Role(
                    role,
                    robots.stream().map(robot -> robot.spec().id()).toList(),
                    mrs,
                    proxy,
                    overlay,
                    model,
                    sensors,
                    robots.stream().map(Start::of).toList(),
                    devices);
        }

        /// @param pose `[x, y, degrees]` in the map; empty when the robot system chooses
        record Start(String robot, Optional<List<Double>> pose) {
            static Start of(PlannedRobot robot) {
                return new Start(robot.spec().id(), robot.spec().mapFromBase().map(Start::typed));
            }

            private static List<Double> typed(Pose2d mapFromBase) {
                return List.of(
                        rounded(mapFromBase.x()),
                        rounded(mapFromBase.y()),
                        rounded(Math.toDegrees(mapFromBase.theta())));
            }
        }

        /// @param needs types of devices that the robot must have before
        record Made(String name, String driver, String makes, List<String> needs, Map<String, Object> options) {
            static Made of(PlannedDevice device) {
                return new Made(
                        device.name(),
                        device.driver().key(),
                        device.driver().makes().getSimpleName(),
                        device.driver().needs().stream()
                                .map(Class::getSimpleName)
                                .toList(),
                        device.options().written());
            }
        }
    }

    record ShownAgent(String name, String type, Optional<String> robot, Map<String, Object> arguments) {
        static ShownAgent of(PlannedAgent agent) {
            return new ShownAgent(
                    agent.name(),
                    agent.type().key(),
                    agent.robot(),
                    agent.arguments().written());
        }
    }

    /// @param words what is wrong then: `biased by 0.10 m`
    /// @param targets what can have it
    /// @param pick how many of them have it at a time; empty when all have
    /// @param at when it begins [s]
    /// @param every mean time until it begins at random [s]; empty when it does at `at`
    /// @param lasts least and most time [s]; empty for good
    record Fault(
            String kind,
            String words,
            List<String> targets,
            Optional<Integer> pick,
            double at,
            Optional<Double> every,
            Optional<List<Double>> lasts) {
        static Fault of(PlannedFault fault) {
            return new Fault(
                    fault.kind(),
                    fault.targets().getFirst().words(),
                    fault.targets().stream().map(PlannedFault.Target::name).toList(),
                    fault.pick(),
                    seconds(fault.at()),
                    fault.every().map(Fault::seconds),
                    fault.lasts().map(span -> List.of(seconds(span.least()), seconds(span.most()))));
        }

        private static double seconds(Duration time) {
            return time.toNanos() / 1e9;
        }
    }

    /// @param after how long the run still goes on [s]
    record End(String outcome, String when, double after) {
        static End of(RunPlan.Stop stop) {
            return new End(
                    stop.outcome().word(), stop.when().toString(), stop.after().toMillis() / 1e3);
        }
    }

    /// @param min the least value that is still right; empty when there is none
    /// @param max the greatest
    record MetricDefinition(
            String name,
            String unit,
            String from,
            boolean perRobot,
            String better,
            Optional<Double> min,
            Optional<Double> max) {
        static MetricDefinition of(RunPlan.MetricDefinition measured) {
            return new MetricDefinition(
                    measured.name(),
                    measured.unit(),
                    measured.from().toString(),
                    measured.perRobot(),
                    measured.better().word(),
                    Optional.of(measured.min()).filter(Double::isFinite),
                    Optional.of(measured.max()).filter(Double::isFinite));
        }
    }

    private static List<Role> roles(RunPlan plan) {
        var alike = new LinkedHashMap<Role, List<PlannedRobot>>();
        for (PlannedRobot robot : plan.robots()) {
            alike.computeIfAbsent(role(robot, plan), _ -> new ArrayList<>()).add(robot);
        }
        return alike.entrySet().stream()
                .map(entry -> entry.getKey().of(entry.getValue()))
                .toList();
    }

    /// What a robot has in common with those that are like it.
    private static Role role(PlannedRobot robot, RunPlan plan) {
        return new Role(
                robot.spec().role(),
                List.of(),
                Optional.of(robot.mrs()).filter(mrs -> !mrs.equals(plan.mrs())).map(RunPlan.Mrs::words),
                robot.proxy(),
                robot.overlay(),
                robot.spec().model().name(),
                robot.spec().model().sensors().entrySet().stream()
                        .map(sensor -> sensor.getKey() + " " + sensor.getValue().name())
                        .toList(),
                List.of(),
                robot.drivers().stream().map(Role.Made::of).toList());
    }

    private static double rounded(double value) {
        return Math.round(value * 1e3) / 1e3;
    }
}
