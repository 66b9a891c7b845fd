package rsal.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.fail;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Pose2d;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.scenario.fault.Span;
import rsal.settings.InvalidSettings;
import rsal.testkit.LongTest;
import rsal.testkit.Rounds;

class ScenarioTest {
    static final String GOOD = """
            rsal: 1
            scenario: good
            title: A good scenario
            arguments:
              hunters: {type: integer, default: 2, min: 1, max: 4, unit: robots, description: How many.}
              way: {type: string, default: slow, enum: [slow, fast]}
              start: {type: number, default: -12}
              known: {type: boolean, default: true}
            world: {map: office}
            robots:
              prey:
                model: pioneer2dx
                pose: [$start, -1.0, 180]
                devices: {laser: urg04lx, localizer: {type: truthful, error: 0.1}}
              hunter:
                count: $hunters
                model: pioneer3at
                pose: {free: true, clearance: 0.5}
                color: "#123456"
            agents:
              run: {type: wanderer, robot: prey, parameters: {speed: 0.2}}
              chase: {type: wanderer, robot: hunter}
              watch: {type: breaker}
            mas: {use: plain}
            mrs: {use: sim, step: 0.05}
            run:
              seed: 11
              clock: {mode: simulated, speed: 2}
              stop:
                - {when: allCaught(prey), outcome: success, after: 2}
                - {when: time > 30, outcome: timeout}
            metrics:
              - {name: error, from: p95(poseError), per: robot, unit: m, better: less, bound: {max: 0.3}}
            configurations:
              first: {title: As it is}
              second:
                arguments: {hunters: 3}
                robots: {prey: {pose: [-8, -1, 0]}}
                mrs: {step: 0.1}
            """;

    @TempDir
    private Path folder;

    private Scenario scenario(String text) {
        try {
            return Scenario.load(
                    Files.writeString(folder.resolve("good.yaml"), text).toString());
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    private RunPlan plan(String text, RunOptions options) {
        return scenario(text).plan(options);
    }

    /// All errors of a text, without the folder.
    private String errors(String text) {
        try {
            scenario(text).check();
            return "";
        } catch (InvalidSettings e) {
            return String.valueOf(e.getMessage()).replace(folder + "/", "");
        }
    }

    @Test
    void robotsOfARoleWearMarkersInTurn() {
        String marked = GOOD.replace("    color: \"#123456\"\n", "    color: \"#123456\"\n    fiducial: 21\n");
        assertThat(plan(marked, RunOptions.NONE).robots())
                .extracting(robot -> robot.spec().marker())
                .containsExactly(OptionalInt.empty(), OptionalInt.of(21), OptionalInt.of(22));
        assertThat(errors(marked.replace("fiducial: 21", "fiducial: -1"))).contains("robots.hunter.fiducial");
        String twice = marked.replace("    model: pioneer2dx\n", "    model: pioneer2dx\n    fiducial: 22\n");
        assertThat(errors(twice)).contains("'prey' and 'hunter-2' wear the same marker '22'.");
    }

    @Test
    void becomesAPlan() {
        Scenario scenario = scenario(GOOD);
        assertThat(scenario.name()).isEqualTo("good");
        assertThat(scenario.title()).isEqualTo("A good scenario");
        assertThat(scenario.configurations())
                .containsExactly(new Configuration("first", "As it is"), new Configuration("second", ""));
        RunPlan plan = scenario.plan(RunOptions.NONE);
        assertThat(plan.configuration()).isEqualTo("first");
        assertThat(plan.seed()).isEqualTo(11);
        assertThat(plan.speed()).isEqualTo(2);
        assertThat(plan.step()).hasMillis(50);
        assertThat(plan.arguments()).isEqualTo(Map.of("hunters", 2L, "way", "slow", "start", -12.0, "known", true));
        assertThat(plan.robots()).extracting(r -> r.spec().id()).containsExactly("prey", "hunter-1", "hunter-2");
        assertThat(plan.robots().getFirst().spec().mapFromBase()).contains(Pose2d.ofDegrees(-12, -1, 180));
        assertThat(plan.robots().getFirst().drivers()).singleElement().satisfies(device -> {
            assertThat(device.name()).isEqualTo("localizer");
            assertThat(device.options().asMap().get("error")).isEqualTo(0.1);
        });
        assertThat(plan.robots().get(1).spec().color()).isEqualTo("#123456");
        assertThat(plan.agents())
                .extracting(RunPlan.PlannedAgent::name)
                .containsExactly("run", "chase-1", "chase-2", "watch");
        assertThat(plan.agents())
                .extracting(RunPlan.PlannedAgent::robot)
                .endsWith(Optional.of("hunter-2"), Optional.empty());
        assertThat(plan.stops())
                .first()
                .satisfies(stop -> assertThat(stop.after()).hasSeconds(2));
    }

    @Test
    void aConfigurationLiesOverItKeyByKey() {
        RunPlan plan = plan(GOOD, RunOptions.NONE.withConfiguration("second"));
        assertThat(plan.robots()).hasSize(4);
        assertThat(plan.robots().getFirst().spec().mapFromBase()).contains(new Pose2d(-8, -1, 0));
        assertThat(plan.robots().getFirst().drivers()).hasSize(1); // still there
        assertThat(plan.step()).hasMillis(100);
    }

    @Test
    void whoeverStartsItHasTheLastWord() {
        var options = new RunOptions(
                Optional.of("second"),
                Map.of("hunters", "1", "start", "-11.5"),
                OptionalLong.of(5),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                OptionalDouble.of(3));
        RunPlan plan = plan(GOOD, options);
        assertThat(plan.robots()).extracting(r -> r.spec().id()).containsExactly("prey", "hunter-1");
        assertThat(plan.seed()).isEqualTo(5);
        assertThat(plan.speed()).isEqualTo(3);
    }

    @Test
    void freePlacesFollowFromTheSeed() {
        var poses = starts(plan(GOOD, RunOptions.NONE));
        assertThat(starts(plan(GOOD, RunOptions.NONE))).isEqualTo(poses);
        assertThat(starts(plan(GOOD, RunOptions.NONE.withSeed(12)))).isNotEqualTo(poses);
        // one more robot does not move the others
        assertThat(starts(plan(GOOD, RunOptions.NONE.withArguments(Map.of("hunters", "3"))))
                        .subList(0, 3))
                .isEqualTo(poses);
    }

    @Test
    void freePlacesAreInTheBoxAndApart() {
        String crowded = GOOD.replace("clearance: 0.5", "clearance: 0.5, within: [-10, -2.4, 0, 0.4]");
        for (long seed = 0; seed < 10; seed++) {
            var poses = starts(plan(crowded, RunOptions.NONE.withSeed(seed).withArguments(Map.of("hunters", "4"))));
            for (int i = 1; i < poses.size(); i++) {
                assertThat(poses.get(i).x()).as("seed %d", seed).isBetween(-10.0, 0.0);
                for (int j = 0; j < i; j++) {
                    assertThat(poses.get(i).distanceTo(poses.get(j)))
                            .as("seed %d", seed)
                            .isGreaterThan(1);
                }
            }
        }
    }

    @Test
    void seedsOfOnePartDoNotDependOnTheOthers() {
        RunPlan two = plan(GOOD, RunOptions.NONE);
        RunPlan three = plan(GOOD, RunOptions.NONE.withArguments(Map.of("hunters", "3")));
        assertThat(three.agents().get(2).seed()).isEqualTo(two.agents().get(2).seed());
        assertThat(two.agents().stream().map(RunPlan.PlannedAgent::seed).distinct())
                .hasSize(4);
        assertThat(new Seeds(11).of("agent/run"))
                .isEqualTo(two.agents().getFirst().seed());
    }

    private static List<Pose2d> starts(RunPlan plan) {
        return plan.robots().stream()
                .map(PlannedRobot::spec)
                .map(spec -> spec.mapFromBase().orElseThrow())
                .toList();
    }

    /// Each line: what to replace in the good scenario, by what, and what the message must hold.
    static List<List<String>> wrong() {
        return List.of(
                List.of(
                        "configurations:",
                        "configuratons:",
                        "'configuratons' is not known here",
                        "Maybe 'configurations'"),
                List.of("arguments:", "argumnts:", "good.yaml:4:1: 'argumnts' is not known here", "Maybe 'arguments'"),
                List.of(
                        "first: {title: As it is}",
                        "first: {configurations: {}}",
                        "'configurations' can't be changed by a configuration"),
                List.of("title: A good", "titel: A good", "good.yaml:3:1: 'titel' is not known here", "Maybe 'title'"),
                List.of(
                        "rsal: 1",
                        "rsal: 2",
                        "good.yaml:1:7",
                        "This scenario has format '2'; this RSAL reads format 1."),
                List.of("scenario: good\n", "", "'scenario' is missing"),
                List.of("map: office", "map: ofice", "good.yaml:9:14", "There is no map 'ofice'", "Maybe 'office'"),
                List.of("map: office", "map: lab/floor.yaml", "There is no file 'lab/floor.yaml'"),
                List.of("map: office", "map: ../floor.yaml", "lies outside"),
                List.of("pioneer2dx", "pioneer2d", "There is no robot model 'pioneer2d'", "Maybe 'pioneer2dx'"),
                List.of("urg04lx", "urg4lx", "good.yaml:14:22", "There is no part", "Maybe 'urg04lx'"),
                List.of("laser: urg04lx, ", "", "'truthful' needs a LaserScanner", "above 'localizer'"),
                List.of(
                        "laser: urg04lx, localizer: {type: truthful, error: 0.1}",
                        "laser: none, sonar: none, localizer: amcl",
                        "good.yaml:14:52",
                        "'amcl' needs a RangeSensor",
                        "above 'localizer'"),
                List.of(
                        "laser: urg04lx, localizer: {type: truthful, error: 0.1}",
                        "laser: none, localizer: slam",
                        "good.yaml:14:39",
                        "'slam' needs a LaserScanner",
                        "above 'localizer'"),
                List.of(
                        "{type: truthful, error: 0.1}",
                        "{type: slam, maxRange: -1}",
                        "'robots.prey.devices.localizer.maxRange' must be a number from 0.5 to 200"),
                List.of(
                        "localizer: {type: truthful, error: 0.1}",
                        "localizer: amcl, navigator: {}, explorer: {}",
                        "'explorer' can't work on this robot",
                        "It needs a localizer of type 'slam' and a navigator of type 'navigator', not 'amcl'"),
                List.of(
                        "localizer: {type: truthful, error: 0.1}",
                        "localizer: amcl, navigator: {controller: {type: vfh, weightPreviousDir: 3}}",
                        "good.yaml:14:72: 'vfh' can't work with these values.",
                        "'5.0' must weigh more than going straight on '2.0' and keeping the choice '3.0'"),
                List.of(
                        "localizer: {type: truthful, error: 0.1}",
                        "localizer: slam, explorer: {}",
                        "'explorer' needs a Navigator"),
                List.of("type: truthful", "type: truthfull", "no device driver 'truthfull'", "Maybe 'truthful'"),
                List.of(
                        "error: 0.1",
                        "error: 11",
                        "'robots.prey.devices.localizer.error' must be a number from 0 to 10"),
                List.of("error: 0.1", "eror: 0.1", "'eror' is not known", "Maybe 'error'"),
                List.of("[$start, -1.0, 180]", "[-12, -1]", "good.yaml:13:11", "a list of 3 numbers, not a list of 2"),
                List.of("[$start, -1.0, 180]", "somewhere", "must be [x, y, degrees]"),
                List.of("[$start, -1.0, 180]", "[-31.45, -1, 0]", "Robot 'prey'", "good.yaml:13:11"),
                List.of("[$start, -1.0, 180]", "[900, -1, 0]", "Robot 'prey'", "outside the map"),
                List.of("{free: true, clearance: 0.5}", "[-8, -1, 0]", "has 1 for 2 robots"),
                List.of("{free: true, clearance: 0.5}", "{clearance: 0.5}", "{free: true}"),
                List.of("clearance: 0.5", "clearance: 90", "There is no free place for robot 'hunter-1'"),
                List.of("clearance: 0.5", "within: [4, 4, 1, 1]", "[least x, least y, greatest x, greatest y]"),
                List.of("$start", "$star", "There is no argument 'star'", "Maybe 'start'"),
                List.of("A good scenario", "A $way scenario", "never inside other text"),
                List.of("count: $hunters", "count: 5000", "must be a whole number from 1 to 1000, not '5000'"),
                List.of("count: $hunters", "count: 2.5", "must be a whole number"),
                List.of(
                        "\"#123456\"",
                        "\"#12345\"",
                        "'robots.hunter.color' must be a color, \"#rrggbb\" or a name, not '#12345'"),
                List.of(
                        "type: wanderer, robot: prey",
                        "type: wanderrer, robot: prey",
                        "no type of agent 'wanderrer'",
                        "Maybe 'wanderer'"),
                List.of(
                        "type: wanderer, robot: prey",
                        "type: zebra, robot: prey",
                        "no type of agent 'zebra'",
                        "Known are:",
                        "An agent of your own is named by its file, such as Watcher.java"),
                List.of("robot: hunter", "robot: huntr", "No robots have the role 'huntr'", "Maybe 'hunter'"),
                List.of(
                        "chase: {type: wanderer, robot: hunter}",
                        "chase: {type: wanderer}",
                        "needs a robot with a DriveBase"),
                List.of(
                        "speed: 0.2",
                        "speed: fast",
                        "'agents.run.parameters.speed' must be a number from 0 to 1 [m/s]"),
                wrongRobots(
                        "huntr",
                        "'agents.watch.parameters.robot'",
                        "the id of one or all, not 'huntr'",
                        "Maybe 'hunter' was"),
                wrongRobots("hunter-3", "Maybe 'hunter-1' or 'hunter-2' was meant?"),
                wrongRobots("me", "Known are: prey, hunter."),
                wrongRobots("\"\"", "not ''"),
                wrongRobots("$way", "not 'slow'"),
                List.of("use: plain", "use: plan", "no multi-agent system 'plan'", "Maybe 'plain'"),
                List.of("use: plain", "use: wallclock", "can't follow simulated time", "run.clock.mode"),
                List.of("use: plain", "use: jade", "system 'jade' can't follow simulated time", "--clock wall"),
                List.of("use: sim", "use: simm", "no robot system 'simm'", "Maybe 'sim'"),
                List.of("step: 0.05", "step: 5", "'mrs.step' must be"),
                List.of("seed: 11", "seed: eleven", "'run.seed' must be a whole number, not 'eleven'"),
                List.of("speed: 2}", "speed: 0}", "'run.clock.speed' must be a number from 0.01"),
                List.of("mode: simulated", "mode: real", "one of simulated, wall"),
                List.of(
                        "allCaught(prey)",
                        "allCaught(pray)",
                        "good.yaml:30:24",
                        "No robots have the role 'pray'",
                        "Maybe 'prey'"),
                List.of("time > 30", "time >> 30", "good.yaml:31:20", "character 7"),
                List.of("outcome: timeout", "outcome: late", "one of success, failure, timeout"),
                List.of(", outcome: timeout", "", "'run.stop.outcome' is missing"),
                List.of("p95(poseError)", "p95(poseErr)", "'poseErr' is not a signal", "Maybe 'poseError'"),
                List.of("from: p95(poseError)", "from: count(collisions)", "no value per robot"),
                List.of("better: less", "better: smaller", "one of less, more, neither"),
                List.of("bound: {max: 0.3}", "bound: 0.3", "must be a group of settings"),
                List.of(
                        "arguments: {hunters: 3}",
                        "arguments: {hunters: 9}",
                        "'hunters' must be a whole number from 1 to 4"),
                List.of(
                        "arguments: {hunters: 3}",
                        "arguments: {hunter: 3}",
                        "'hunter' is not known",
                        "Maybe 'hunters'"),
                List.of("type: integer, default: 2", "type: integer, default: 9", "'hunters' must be"),
                List.of(
                        "type: integer, default: 2",
                        "type: whole, default: 2",
                        "one of integer, number, string, boolean"),
                List.of("type: integer, default: 2,", "type: integer,", "'arguments.hunters.default' is missing"),
                List.of("  prey:\n", "  all:\n", "'all' can't be the role of robots"),
                List.of("first: {title: As it is}", "first: [1]", "must be a group of settings"),
                List.of(
                        "first: {title: As it is}",
                        "first: {arguments: {hunters: {default: 3}}}",
                        "good.yaml:35:32: 'hunters' must be a whole number from 1 to 4"),
                List.of(
                        "first: {title: As it is}",
                        "first: {args: {hunters: 3}}",
                        "good.yaml:35:11: 'args' is not known",
                        "'args' is now called 'arguments'"),
                List.of("parameters: {speed: 0.2}", "args: {speed: 0.2}", "'args' is now called 'parameters'"),
                List.of("metrics:\n", "measure:\n", "'measure' is now called 'metrics'"),
                List.of("metrics:\n", "metrics:\n  - {type: A.java}\n", "Types of metrics are listed in 'metricTypes'"),
                List.of("first: {title: As it is}", "first: {scenario: better}", "'scenario' can't be changed"),
                List.of("  run: {type", "  all: {type", "'all' can't be the name of an agent"),
                List.of("  watch:", "  operator:", "'operator' can't be the name of an agent"),
                List.of("  watch:", "  chase-2:", "good.yaml:23:12: There are two agents 'chase-2'"),
                wrongFault("at: 60", "'faults.kind' is missing"),
                wrongFault(
                        "kind: deaf, robots: prey, devices: laser",
                        "good.yaml:26:17: 'faults.kind' must be one of dead, frozen",
                        "not 'deaf'. Maybe 'dead'"),
                wrongFault("kind: dead, devices: laser", "'faults.robots' is missing", "Maybe 'robots: all'?"),
                wrongFault("kind: dead, robots: prey", "'faults.devices' is missing"),
                wrongFault(
                        "kind: gone, robots: pry",
                        "good.yaml:26:31: 'faults.robots' must be a role of robots, the id of one",
                        "not 'pry'",
                        "Maybe 'prey'"),
                wrongFault("kind: gone, robots: [prey, hunter-3]", "not 'hunter-3'", "Maybe 'hunter-1'"),
                wrongFault("kind: gone, robots: \"x*\"", "a pattern (r*) or all, not 'x*'"),
                wrongFault("kind: gone, robots: [[prey]]", "must be a name or a list of names, not a list of 1"),
                wrongFault(
                        "kind: dead, robots: prey, devices: lasr",
                        "good.yaml:26:46: Robots called 'prey' have no sensor 'lasr'",
                        "Maybe 'laser'"),
                wrongFault(
                        "kind: dead, robots: [prey, hunter], devices: Localizer",
                        "Robots called 'hunter' have no sensor 'Localizer'",
                        "Known are: base, laser, sonar."),
                wrongFault("kind: dead, robots: all, devices: camera", "called 'all' have no sensor 'camera'"),
                wrongFault(
                        "kind: biased, robots: prey, devices: laser, angle: 5",
                        "good.yaml:26:48: Device 'prey/laser' can't be biased like this.",
                        "measures ranges only"),
                wrongFault(
                        "kind: biased, robots: prey, devices: laser",
                        "A 'biased' sensor needs an error, 'range' or 'angle'"),
                wrongFault("kind: noisy, robots: prey, devices: laser, range: -1", "'faults.range' must be a number"),
                wrongFault("kind: gone, robots: prey, at: -5", "good.yaml:26:41: 'faults.at' must be a number from 0"),
                wrongFault("kind: gone, robots: prey, for: 0", "'faults.for' must be a number from 0.01"),
                wrongFault("kind: gone, robots: prey, for: [5, 1]", "'faults.for' must be [least, most]"),
                wrongFault("kind: gone, robots: prey, for: [5]", "a list of 2 numbers"),
                wrongFault("kind: gone, robots: prey, every: 0", "'faults.every' must be a number from 1"),
                wrongFault("kind: gone, robots: prey, pick: 0", "'faults.pick' must be a whole number from 1"),
                wrongFault("kind: gone, robots: prey, devices: laser", "'devices' is not known in 'faults'"),
                wrongFault("kind: lost, robots: prey", "'robots' is not known in 'faults'"),
                wrongFault("kind: lost, share: 2", "'faults.share' must be a number from 0 to 1, not '2'"),
                wrongFault("kind: lost, delay: 2", "'delay' is not known"),
                wrongFault("kind: late, delay: -1", "'faults.delay' must be a number from 0 to 600"),
                wrongFault(
                        "kind: lost, from: chas",
                        "good.yaml:26:29: 'faults.from' must be an agent, a robot that has one",
                        "not 'chas'",
                        "Maybe 'chase'"),
                wrongCommunication("rnge: 5", "good.yaml:26:17: 'rnge' is not known in 'communication'", "'range'"),
                wrongCommunication("range: -1", "good.yaml:26:24: 'communication.range' must be a number from 0"),
                wrongCommunication("range: far", "'communication.range' must be a number", "not 'far'"),
                wrongCommunication("loss: 5", "'communication.loss' must be a number from 0 to 1, not '5'"),
                wrongCommunication("delay: [0.2, 0.1]", "'communication.delay' must be [least, most]"),
                wrongCommunication("delay: [0.2]", "'communication.delay' must be a list of 2 numbers"),
                wrongCommunication("delay: soon", "'communication.delay' must be a number from 0 to 600"),
                wrongCommunication("bandwidth: 0", "'communication.bandwidth' must be a number from 0.01"),
                wrongCommunication(
                        "range: 5, behindWalls: 15",
                        "good.yaml:26:40: 'communication.behindWalls' must be at most 'range', 5.0 m, not '15.0'",
                        "the other way round"),
                List.of("run:\n  seed", "communication: none\nrun:\n  seed", "must be a group of settings"));
    }

    private static List<String> wrongCommunication(String limits, String... message) {
        return Stream.concat(
                        Stream.of("run:\n  seed", "communication: {%s}\nrun:\n  seed".formatted(limits)),
                        Stream.of(message))
                .toList();
    }

    private static List<String> wrongFault(String fault, String... message) {
        return Stream.concat(
                        Stream.of("run:\n  seed", "faults: [{%s}]\nrun:\n  seed".formatted(fault)), Stream.of(message))
                .toList();
    }

    private static List<String> wrongRobots(String name, String... message) {
        return Stream.concat(
                        Stream.of(
                                "watch: {type: breaker}",
                                "watch: {type: view, parameters: {robot: %s}}".formatted(name),
                                "good.yaml:23:43",
                                "must be a role of robots"),
                        Stream.of(message))
                .toList();
    }

    @ParameterizedTest
    @MethodSource("wrong")
    void everyErrorSaysWhereWhatAndWhatToTry(List<String> example) {
        assertThat(GOOD).contains(example.get(0));
        String message = errors(GOOD.replace(example.get(0), example.get(1)));
        assertThat(message).contains(example.subList(2, example.size())).doesNotContain("null", "Exception");
    }

    @Test
    void thoseThatCountRobotsThatAreGoneCountAllThatMayGo() {
        for (String name : List.of("rescue", "find-and-collect", "foraging")) {
            RunPlan plan = Scenario.load(name).plan(RunOptions.NONE.withConfiguration("faulty"));
            var counted = plan.metrics().stream()
                    .map(metric -> metric.from().toString())
                    .toList();
            var mayGo = plan.robots().stream()
                    .map(RunPlan.PlannedRobot::spec)
                    .filter(robot -> plan.faults().stream()
                            .filter(fault -> fault.kind().equals("gone"))
                            .anyMatch(fault -> fault.targets().stream()
                                    .anyMatch(target -> target.name().equals(robot.id()))))
                    .map(robot -> "count(gone(%s))".formatted(robot.role()))
                    .distinct()
                    .toList();
            assertThat(mayGo).as(name).isNotEmpty();
            assertThat(counted).as(name).containsAll(mayGo);
        }
    }

    @Test
    void configurationsLimitCommunicationLikeAnythingElse() {
        String limited = GOOD.replace("mas: {use", "communication: {range: 15, loss: 0.1, delay: 0.1}\nmas: {use")
                + "    communication: {loss: 0, behindWalls: 5, delay: [0.02, 0.1], bandwidth: 50}\n";
        Communication first = plan(limited, RunOptions.NONE.withConfiguration("first"))
                .communication()
                .orElseThrow();
        Communication second = plan(limited, RunOptions.NONE.withConfiguration("second"))
                .communication()
                .orElseThrow();
        assertThat(first).isEqualTo(new Communication(15, 15, 0.1, Span.of(0.1, 0.1), Optional.empty(), first.seed()));
        assertThat(second).isEqualTo(new Communication(15, 5, 0, Span.of(0.02, 0.1), Optional.of(50.0), first.seed()));
        assertThat(plan(GOOD, RunOptions.NONE.withConfiguration("first")).communication())
                .isEmpty();
    }

    private static final String TWO_ROLES = """
            rsal: 1
            scenario: watch
            arguments:
              often: {type: number, default: 120}
            world: {map: office}
            robots:
              guard: {count: 2, model: pioneer3at, pose: {free: true}}
              thief: {model: pioneer2dx, pose: {free: true}}
            agents:
              run: {type: wanderer, robot: guard}
            with: {scenario: "distribution:found", arguments: {interval: $often}, robots: {robot: guard}}
            configurations:
              first: {}
              without: {with: {robots: {robot: thief}}}
            """;

    @Test
    void agentsWithoutARobotOfAScenarioThatJoinsComeAlong() {
        RunPlan plan = plan(TWO_ROLES, RunOptions.NONE.withArguments(Map.of("often", "90")));
        assertThat(plan.with()).contains("distribution:found");
        assertThat(plan.agents())
                .extracting(RunPlan.PlannedAgent::name)
                .containsExactly("run-1", "run-2", "dispersion");
        assertThat(plan.agents().getLast().arguments().asMap())
                .containsEntry("robots", "guard")
                .containsEntry("places", "")
                .containsEntry("pingInterval", 5.0)
                .containsEntry("allocationInterval", 90.0);
        assertThat(plan.robots()).hasSize(3);
        assertThat(plan.stops()).isEmpty();
        RunPlan other = plan(TWO_ROLES, RunOptions.NONE.withConfiguration("without"));
        assertThat(other.agents().getLast().arguments().asMap().get("robots")).isEqualTo("thief");
    }

    @Test
    void aScenarioOfOnesOwnCanJoinAndOneThatIsTyped() {
        String own = TWO_ROLES
                .replace("scenario: watch", "scenario: own")
                .replace(
                        "  run: {type: wanderer, robot: guard}",
                        "  spread: {type: deployment, parameters: {robots: thief, places: 1 2}}")
                .replaceAll("with: .*\n", "");
        String host = TWO_ROLES.replaceAll("with: \\{scenario.*", "with: own.yaml:without");
        write("own.yaml", own.replaceAll("without: .*", "without: {with: own.yaml}"));
        assertThat(errors(host.replaceAll("first: .*\n.*without: .*", "first: {}")))
                .contains("good.yaml:11:7: It is not given which robots here are 'thief' of scenario 'own:without'.");
        String one = host.replaceAll("  thief: .*\n", "").replaceAll("first: .*\n.*without: .*", "first: {}");
        assertThat(plan(one, RunOptions.NONE)
                        .agents()
                        .getLast()
                        .arguments()
                        .asMap()
                        .get("robots"))
                .isEqualTo("guard");
        RunPlan typed = plan(one, RunOptions.NONE.withJoined("distribution"));
        assertThat(typed.with()).contains("distribution:virtual");
        assertThat(typed.agents())
                .extracting(RunPlan.PlannedAgent::name)
                .containsExactly("run-1", "run-2", "dispersion");
        assertThatThrownBy(() -> plan(one, RunOptions.NONE.withJoined("dispersion")))
                .hasMessageContaining("--with dispersion: There is no scenario 'dispersion'.");
    }

    private void write(String file, String text) {
        try {
            Files.writeString(folder.resolve(file), text);
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    static Stream<List<String>> wrongJoins() {
        String with = "with: {scenario: \"distribution:found\", arguments: {interval: $often}, robots: {robot: guard}}";
        return Stream.of(
                List.of(
                        with,
                        "with: distribtion",
                        "good.yaml:11:7: There is no scenario 'distribtion'.",
                        "'distribution'"),
                List.of(
                        with,
                        "with: \"distribution:fond\"",
                        "good.yaml:11:7: Scenario 'distribution' has no configuration 'fond'.",
                        "'found'"),
                List.of(with, "with: there.yaml", "good.yaml:11:7: There is no file 'there.yaml'."),
                List.of(with, "with: [distribution]", "good.yaml:11:7: 'with' must be a scenario, or a group with one"),
                List.of(with, "with: {arguments: {interval: 3}}", "good.yaml:11:7: 'with.scenario' is missing"),
                List.of(
                        with,
                        "with: \"distribution:found\"",
                        "good.yaml:11:7: It is not given which robots here are 'robot'",
                        "roles here are: guard, thief"),
                List.of("often}", "oftn}", "good.yaml:11:62: There is no argument 'oftn'.", "'often'"),
                List.of(
                        "interval:",
                        "intervall:",
                        "good.yaml:11:52: 'intervall' is not known in 'with.arguments'",
                        "'interval'"),
                List.of("{interval: $often}", "{interval: -1}", "good.yaml:11:", "'interval' must be"),
                List.of(
                        "robot: guard}}",
                        "robot: gard}}",
                        "good.yaml:11:87: No robots have the role 'gard'.",
                        "'guard'"),
                List.of(
                        "robot: guard}}",
                        "robt: guard}}",
                        "good.yaml:11:86: Scenario 'distribution:found' has no robots of role 'robt'.",
                        "'robot'"),
                List.of(
                        "run: {type: wanderer, robot: guard}",
                        "dispersion: {type: breaker}",
                        "good.yaml:11:18: There is an agent 'dispersion' here and in scenario 'distribution:found'."),
                List.of(
                        with,
                        "with: teleop",
                        "good.yaml:11:7: Scenario 'teleop:virtual' has no agents without a robot"));
    }

    @Test
    @LongTest
    void placesAreFoundOnAnotherMap() {
        assertThat(errors(TWO_ROLES.replace("map: office", "map: cave"))).isEmpty();
    }

    @Test
    void placesOfAnotherMapAreNoneHere() {
        String cave = TWO_ROLES.replace("map: office", "map: cave");
        assertThat(errors(cave.replace("distribution:found", "distribution")))
                .contains(
                        "good.yaml:11:18: 'places' of agent 'dispersion' are places of map 'office', on which scenario"
                                + " 'distribution:virtual' is; the one here is 'cave'.",
                        "arguments: {places:");
        assertThat(errors(cave.replace("distribution:found", "distribution")
                        .replace("$often", "$often, places: 1 2; 3 4")))
                .isEmpty();
    }

    @ParameterizedTest
    @MethodSource("wrongJoins")
    void errorsOfJoiningAreReportedWhereTheyAre(List<String> example) {
        assertThat(TWO_ROLES).contains(example.get(0));
        String message =
                errors(TWO_ROLES.replace(example.get(0), example.get(1)).replaceAll("  without: .*\n", ""));
        assertThat(message).contains(example.subList(2, example.size())).doesNotContain("null", "Exception");
        assertThat(message.lines().filter(line -> line.contains("good.yaml:"))).hasSize(1);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "kind: noisy, robots: prey, devices: laser, at: 20, rnage: 0.1",
                "kind: lost, topics: pose, from: all, to: all, share: 20",
                "kind: late, topics: pose, delay: 2, share: 20",
                "kind: slip, robots: prey, way: far"
            })
    void oneErrorInAFaultMakesNoOtherOfWhatIsRight(String fault) {
        assertThat(errors(GOOD.replace("run:\n  seed", "faults: [{%s}]\nrun:\n  seed".formatted(fault))))
                .doesNotContain("'devices' is", "'robots' is", "'topics' is", "'from' is", "'to' is", "'delay' is")
                .containsAnyOf("'rnage'", "'20'", "'far'");
    }

    @Test
    void robotSystemsThatCanNotBreakAnythingSaySo() {
        String fake = GOOD.replace("mrs: {use: sim, step: 0.05}", "mrs: {use: fake}")
                .replace("localizer: {type: truthful, error: 0.1}", "sonar: front8")
                .replace("pose: {free: true, clearance: 0.5}", "pose: [[-8, -1, 0], [-6, -1, 0], [-4, -1, 0]]")
                .replace("    mrs: {step: 0.1}\n", "")
                .replace(
                        "metrics:\n  - {name: error, from: p95(poseError), per: robot, unit: m, better: less, bound: {max: 0.3}}\n",
                        "");
        assertThat(errors(fake)).isEmpty();
        assertThat(errors(fake + "faults: [{kind: lost, share: 0.5}]\n")).isEmpty();
        assertThat(errors(fake + "faults: [{kind: dead, robots: prey, devices: laser}]\n"))
                .contains("'prey/laser' can't be 'dead': Robot system 'fake' can't break robots on purpose.");
    }

    @Test
    void anAgentLeftAloneMustFindTheRobotsItLooksFor() {
        String hunt = GOOD.replace("watch: {type: breaker}", "watch: {type: follow, robot: hunter}");
        String error = "'agents.watch.parameters.prey' must be a role of robots or the id of one, not 'prey'";
        assertThat(errors(hunt)).doesNotContain(error);
        assertThat(errors(hunt.replace("prey", "rabbit"))).contains("good.yaml:23:10", error);
    }

    @Test
    void robotsThatCanNotBeReadAreNotMissed() {
        String text = GOOD.replace("pioneer3at", "pioneer9at")
                .replace("watch: {type: breaker}", "watch: {type: view, parameters: {robot: hunter-1}}");
        assertThat(errors(text)).contains("'pioneer9at'").doesNotContain("'hunter-1'");
    }

    @Test
    void reportsAllErrorsTogether() {
        String text = GOOD.replace("title: A good", "titel: A good")
                .replace("min: 1", "min: one")
                .replace("[$start, -1.0, 180]", "[-31.45, -1, 0]")
                .replace("speed: 0.2", "speed: fast")
                .replace("time > 30", "time >> 30");
        assertThat(errors(text))
                .contains(
                        "'titel'",
                        "'arguments.hunters.min'",
                        "Robot 'prey'",
                        "'agents.run.parameters.speed'",
                        "'run.stop.when'");
    }

    @Test
    void anErrorIsReportedOnceAndNotAgainForWhatFollowsFromIt() {
        assertThat(errors(GOOD.replace("type: integer, default: 2", "type: integer, default: 9"))
                        .lines())
                .as("the argument stands for the number of hunters")
                .hasSize(1);
        assertThat(errors(GOOD.replace("count: $hunters", "count: $huntrs")).lines())
                .as("its value isn't a number")
                .filteredOn(line -> line.startsWith("good.yaml"))
                .hasSize(1);
    }

    @Test
    void errorsThatComeOfWhatWasSetSaySo() {
        String invalid = GOOD.replace("robot: hunter}", "robot: huntr}");
        assertThatThrownBy(() ->
                        scenario(invalid).plan(RunOptions.NONE.withArguments(Map.of("start", "900", "hunters", "3"))))
                .hasMessageContaining("good.yaml:13:11: Robot 'prey'")
                .hasMessageContaining("It is caused by --set start=900.")
                .hasMessageContaining("'huntr'")
                .message()
                .containsOnlyOnce("--set");
        assertThatThrownBy(() -> scenario(GOOD).plan(RunOptions.NONE.withArguments(Map.of("hunters", "many"))))
                .hasMessageNotContaining("It is caused by");
    }

    @Test
    void errorsOfOptionsAreReportedToo() {
        Scenario scenario = scenario(GOOD);
        assertThatThrownBy(() -> scenario.plan(RunOptions.NONE.withConfiguration("secnd")))
                .hasMessageContaining("no configuration 'secnd'")
                .hasMessageContaining("Maybe 'second'");
        assertThatThrownBy(() -> scenario.plan(RunOptions.NONE.withArguments(Map.of("hunters", "many", "huntrs", "1"))))
                .hasMessageContaining("--set hunters=many: 'hunters' must be a whole number from 1 to 4")
                .hasMessageContaining("--set huntrs=1: The scenario has no argument 'huntrs'.")
                .hasMessageContaining("Maybe 'hunters'");
        assertThatThrownBy(() -> scenario.plan(RunOptions.NONE.withSpeed(0).withLimit(Duration.ZERO)))
                .hasMessageContaining("--speed 0.0: A speed must be positive")
                .hasMessageContaining("--for 0: A time limit must be positive");
        var mas = new RunOptions(
                Optional.empty(),
                Map.of(),
                OptionalLong.empty(),
                Optional.of("jasn"),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                OptionalDouble.empty());
        assertThatThrownBy(() -> scenario.plan(mas)).hasMessageContaining("--mas jasn: There is no multi-agent system");
        assertThatThrownBy(() -> scenario.plan(RunOptions.NONE.inRealTimeOn("jadex")))
                .hasMessageContaining("--mas jadex: The multi-agent system 'jadex' is not part of this installation.");
    }

    @Test
    void whoWantsJadexIsInformedWhatThePageAboutItHasThemType() throws IOException {
        String command = "RSAL_WITH=jadex ./rsal run hunt-and-prey --mas jadex --clock wall";
        assertThatThrownBy(() -> Scenario.load("hunt-and-prey").plan(RunOptions.NONE.inRealTimeOn("jadex")))
                .hasMessageContaining("Maybe try " + command + " (docs/how-to/jadex.md).");
        assertThat(Path.of("../../docs/how-to/jadex.md")).content().contains("\n" + command + "\n");
    }

    @Test
    void whoeverStartsItMayWantRealTime() {
        RunPlan plan = plan(GOOD, RunOptions.NONE.inRealTimeOn("wallclock"));
        assertThat(plan.clock()).isEqualTo(RunPlan.Clock.WALL);
        assertThat(plan.mas().provider().key()).isEqualTo("wallclock");
    }

    @ParameterizedTest
    @ValueSource(strings = {"hunt-and-pray", "nothing.yaml", "no/such/folder", "\0.yaml", ""})
    void aScenarioThatIsNotThereIsSaidToBeMissing(String name) {
        assertThatThrownBy(() -> Scenario.load(name)).isInstanceOf(InvalidSettings.class);
    }

    @Test
    void guessesTheScenario() {
        assertThatThrownBy(() -> Scenario.load("hunt-and-pray")).hasMessageContaining("Maybe 'hunt-and-prey'");
    }

    @Test
    void readsTheScenarioOfAFolder() throws IOException {
        Files.writeString(folder.resolve("scenario.yaml"), GOOD);
        assertThat(Scenario.load(folder + "/").name()).isEqualTo("good");
        Path own = Files.createDirectory(folder.resolve("chase"));
        Files.writeString(own.resolve("chase.yaml"), GOOD);
        assertThat(Scenario.load(own.toString()).name()).isEqualTo("good");
    }

    @Test
    void reportsUnderWhichNamesAFoldersScenarioIsLookedFor() throws IOException {
        Path own = Files.createDirectory(folder.resolve("renamed"));
        Files.writeString(own.resolve("chase.yaml"), GOOD);
        assertThatThrownBy(() -> Scenario.load(own.toString()))
                .hasMessageContaining("no 'scenario.yaml' and no 'renamed.yaml'")
                .hasMessageContaining("Maybe one of its files was meant: %s.".formatted(own.resolve("chase.yaml")));
        Files.delete(own.resolve("chase.yaml"));
        assertThatThrownBy(() -> Scenario.load(own.toString())).hasMessageContaining("make one: rsal new NAME");
    }

    @Test
    void readsAMapBesideTheScenario() throws IOException {
        Files.writeString(folder.resolve("room.pgm"), "P2 60 60 255 " + "255 ".repeat(3600));
        Files.writeString(folder.resolve("room.yaml"), "{image: room.pgm, resolution: 0.1, origin: [-15, -3, 0]}");
        RunPlan plan = plan(GOOD.replace("map: office", "map: room.yaml"), RunOptions.NONE);
        assertThat(plan.map().width()).isEqualTo(60);
    }

    @Test
    void aDeviceThatCanNotWorkOnARobotIsRefusedAtItsLine() throws IOException {
        Files.writeString(folder.resolve("car.yaml"), """
                title: Car
                body: {length: 0.4, width: 0.3}
                drive:
                  type: car
                  wheelbase: 0.3
                  maxSteeringAngle: 30
                  maxSpeed: 1
                  maxTurnRate: 90
                  maxAcceleration: 1
                  maxTurnAcceleration: 90
                  odometryNoise: {distancePerMeter: 0, headingPerMeter: 0, headingPerDegree: 0}
                mounts: {}
                sensors: {}
                """);
        String text = GOOD.replace("model: pioneer3at", "model: car.yaml\n    devices: {pilot: {}}");
        assertThat(errors(text))
                .contains("good.yaml:18:22: Device driver 'pilot' can't work on this robot.")
                .contains("which a car 'car.yaml' can't");
    }

    @Test
    void aYamlBombIsRefused() {
        String bomb = "a: &a [x, x, x, x, x, x, x, x, x]\n"
                + IntStream.range(0, 8)
                        .mapToObj(i -> "%c: &%c [%s]\n"
                                .formatted(
                                        'b' + i,
                                        'b' + i,
                                        "*%c, ".formatted('a' + i).repeat(9)))
                        .collect(Collectors.joining());
        assertThat(errors(bomb)).containsPattern("more than 20000 values|Number of aliases|aliases");
    }

    @Test
    void theBuiltInScenariosAreRight() {
        assertThat(Scenario.builtIn()).isNotEmpty().allSatisfy(scenario -> {
            scenario.check();
            assertThat(scenario.title()).isNotEqualTo(scenario.name());
            assertThat(scenario.description()).isNotEmpty();
            assertThat(scenario.arguments())
                    .allSatisfy(argument -> assertThat(argument.description()).isNotEmpty());
        });
    }

    @Test
    void nonsenseGivesNothingButInvalidSettings() {
        String[] bits = {
            "{",
            "}",
            "[",
            "]",
            ":",
            "-",
            "$hunters",
            "$",
            "1e999",
            ".nan",
            "-1",
            "true",
            "~",
            "''",
            "*a",
            "&a",
            "!!x",
            "free",
            "prey",
            "0",
            "\n",
            "  ",
            "9223372036854775808",
            "#",
            "\"",
            "ä",
            "office",
            "\t",
            "|",
            "3.5"
        };
        for (long seed = 0; seed < Rounds.of(40, 400); seed++) {
            var random = new SplittableRandom(seed);
            var text = new StringBuilder(GOOD);
            for (int i = random.nextInt(4); i >= 0; i--) {
                int from = random.nextInt(text.length());
                int to = Math.min(text.length(), from + random.nextInt(12));
                text.replace(from, to, bits[random.nextInt(bits.length)]);
            }
            try {
                scenario(text.toString()).check();
            } catch (InvalidSettings e) {
                assertThat(e.problems()).as("seed %d", seed).isNotEmpty();
            } catch (RuntimeException | StackOverflowError e) {
                fail("seed %d:\n%s".formatted(seed, text), e);
            }
        }
    }
}
