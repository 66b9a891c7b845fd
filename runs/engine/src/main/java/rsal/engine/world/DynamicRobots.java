package rsal.engine.world;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import rsal.data.Pose2d;
import rsal.model.RobotColors;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.robot.RobotSpec;
import rsal.scenario.RunPlan;
import rsal.scenario.RunPlan.PlannedAgent;
import rsal.scenario.RunPlan.PlannedDevice;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.scenario.RunPlan.Spare;
import rsal.scenario.RunPlan.Spares;
import rsal.scene.NamedSeed;

/// What robots are to have that nobody planned: the software devices and agents of one that was planned, each
/// with a random stream of its own.
public final class DynamicRobots {
    private final Map<String, PlannedRobot> robots = new HashMap<>();
    private final Map<String, List<PlannedAgent>> agents = new HashMap<>(); // by robot
    private final Set<String> agentNames = new HashSet<>();
    private final Map<String, String> expected = new HashMap<>(); // whom those who are to come are made after
    private final Map<String, PlannedRobot> ordered = new HashMap<>(); // who is to come, and is made after nobody
    private final RunPlan plan;
    private final List<PlannedRobot> planned;
    private final RunPlan.Mrs scenarios;

    public DynamicRobots(RunPlan plan) {
        this.plan = plan;
        scenarios = plan.mrs();
        planned = plan.robots();
        for (PlannedRobot robot : planned) {
            robots.put(robot.spec().id(), robot);
        }
        for (PlannedAgent agent : plan.agents()) {
            agentNames.add(agent.name());
            agent.robot()
                    .ifPresent(robot -> agents.computeIfAbsent(robot, _ -> new ArrayList<>())
                            .add(agent));
        }
    }

    /// A robot is to come that is made after another one: finds an id for it that no robot has or had, the
    /// role's name and the next number.
    ///
    /// @param taken by others
    /// @return empty when there never was that other one
    Optional<String> expect(String example, Set<String> taken) {
        Optional<String> id = Optional.ofNullable(robots.get(example))
                .map(like -> free(like.spec().role(), taken));
        id.ifPresent(free -> expected.put(free, example));
        return id;
    }

    /// A robot of a model is to come, which has the model's name for its role.
    ///
    /// @param id empty for one that nobody has
    /// @param taken ids by others
    RobotSpec expect(RobotModel model, Optional<String> id, Pose2d mapFromBase, Set<String> taken) {
        String role = model.name();
        String color = robots.values().stream()
                .map(PlannedRobot::spec)
                .filter(spec -> spec.role().equals(role))
                .map(RobotSpec::color)
                .min(Comparator.naturalOrder())
                .orElseGet(this::freshColor);
        var spec = new RobotSpec(id.orElseGet(() -> free(role, taken)), role, model, Optional.of(mapFromBase), color);
        ordered.put(spec.id(), plan.newcomer(spec));
        return spec;
    }

    private String freshColor() {
        Set<String> worn =
                robots.values().stream().map(robot -> robot.spec().color()).collect(Collectors.toSet());
        return IntStream.rangeClosed(0, worn.size())
                .mapToObj(RobotColors::of)
                .filter(color -> !worn.contains(color))
                .findFirst()
                .orElse(RobotColors.of(worn.size()));
    }

    /// One that was expected does not come.
    void dismiss(String robot) {
        expected.remove(robot);
        ordered.remove(robot);
    }

    public boolean isExpected(String robot) {
        return expected.containsKey(robot) || ordered.containsKey(robot);
    }

    /// Whether a robot has an id, or had it.
    boolean isKnown(String robot) {
        return robots.containsKey(robot);
    }

    private String free(String role, Set<String> taken) {
        int number = 1;
        while (robots.containsKey(role + "-" + number) || taken.contains(role + "-" + number)) {
            number++;
        }
        return role + "-" + number;
    }

    /// What the scenario plans for a robot; empty for one that nobody planned.
    public Optional<PlannedRobot> planned(String id) {
        return planned.stream().filter(one -> one.spec().id().equals(id)).findFirst();
    }

    /// Plans a robot that is there already. When nobody expected it, it is made after one of its role and
    /// model.
    public PlannedRobot plan(Robot robot, Optional<Pose2d> mapFromBase) {
        PlannedRobot wanted = ordered.remove(robot.id());
        if (wanted != null) {
            robots.put(robot.id(), wanted);
            return wanted;
        }
        Optional<PlannedRobot> example = Optional.ofNullable(expected.remove(robot.id()))
                .map(robots::get)
                .or(() -> planned.stream().filter(one -> isLike(one, robot)).findFirst());
        String id = robot.id();
        String color = example.map(one -> one.spec().color()).orElse("#808080");
        var spec = new RobotSpec(id, robot.role(), robot.model(), mapFromBase, color, robot.marker());
        List<PlannedDevice> drivers =
                devicesLike(example.map(PlannedRobot::drivers).orElse(List.of()), id);
        Spares spares = example.map(PlannedRobot::spares)
                .map(one -> new Spares(spareLike(one.pilot(), id), spareLike(one.navigation(), id)))
                .orElse(Spares.none("No robot like it was planned."));
        var made = new PlannedRobot(
                spec,
                example.map(PlannedRobot::mrs).orElse(scenarios),
                drivers,
                spares,
                example.filter(PlannedRobot::proxy).isPresent(),
                example.filter(PlannedRobot::overlay).isPresent());
        robots.put(id, made);
        example.ifPresent(one -> agents.put(id, agentsLike(one.spec().id(), id)));
        return made;
    }

    private static Spare spareLike(Spare example, String robot) {
        return new Spare(devicesLike(example.devices(), robot), example.refusal());
    }

    private static List<PlannedDevice> devicesLike(List<PlannedDevice> examples, String robot) {
        return examples.stream()
                .map(one -> new PlannedDevice(one.name(), one.driver(), one.options(), seed(one.seed(), robot)))
                .toList();
    }

    private static boolean isLike(PlannedRobot one, Robot robot) {
        return one.spec().role().equals(robot.role()) && one.spec().model().equals(robot.model());
    }

    private List<PlannedAgent> agentsLike(String example, String robot) {
        var made = new ArrayList<PlannedAgent>();
        for (PlannedAgent one : agents.getOrDefault(example, List.of())) {
            String name = free(one.name().equals(example) ? robot : one.role() + "-" + robot);
            agentNames.add(name);
            made.add(new PlannedAgent(
                    name, one.role(), one.type(), one.arguments(), Optional.of(robot), seed(one.seed(), robot)));
        }
        return made;
    }

    private String free(String name) {
        String free = name;
        for (int number = 2; agentNames.contains(free); number++) {
            free = name + "-" + number;
        }
        return free;
    }

    /// Plans another agent like one, with the role's name and the next number.
    ///
    /// @param robot that it acts for
    public PlannedAgent another(PlannedAgent like, Optional<String> robot) {
        int number = 1;
        while (agentNames.contains(like.role() + "-" + number)) {
            number++;
        }
        String name = like.role() + "-" + number;
        return new PlannedAgent(name, like.role(), like.type(), like.arguments(), robot, seed(like.seed(), name));
    }

    /// An agent has come that was planned by itself.
    public void took(PlannedAgent agent) {
        agentNames.add(agent.name());
    }

    /// The agents of a robot.
    public List<PlannedAgent> agents(String robot) {
        return agents.getOrDefault(robot, List.of());
    }

    private static long seed(long example, String robot) {
        return new SplittableRandom(NamedSeed.of(example, robot)).nextLong();
    }
}
