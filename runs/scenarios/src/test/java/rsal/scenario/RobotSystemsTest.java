package rsal.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.Pose2d;
import rsal.robot.RobotSpec;
import rsal.scenario.RunPlan.Mrs;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.settings.InvalidSettings;

/// Robots of one scenario may be of several robot systems.
class RobotSystemsTest {
    private static final String MIXED = """
            rsal: 1
            scenario: mixed
            arguments:
              host: {type: string, default: hall}
            world: {map: office}
            robots:
              prey: {model: pioneer2dx, pose: [-12, -1, 180]}
              hunter:
                model: pioneer3at
                pose: {free: true}
                fiducial: 11
                members:
                  - {name: real3at, mrs: {use: reality, host: $host}, pose: auto, devices: {laser: urg04lx}}
                  - {name: virtual1}
                  - {fiducial: 21, color: "#123456"}
            agents:
              chase: {type: wanderer, robot: hunter}
            """;

    @TempDir
    private Path folder;

    private Scenario scenario(String text) {
        return Scenario.load(write("mixed.yaml", text).toString());
    }

    private Path write(String file, String text) {
        try {
            return Files.writeString(folder.resolve(file), text);
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    private RunPlan plan(String text) {
        return scenario(text).plan(RunOptions.NONE);
    }

    private String errors(String text) {
        try {
            scenario(text).check();
            return "";
        } catch (InvalidSettings e) {
            return String.valueOf(e.getMessage());
        }
    }

    private static PlannedRobot robot(RunPlan plan, String id) {
        return plan.robots().stream()
                .filter(robot -> robot.spec().id().equals(id))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void aConfigurationNamesOneByOneWhomTheScenarioCountsAndTheOtherWayRound() {
        String both = MIXED + """
                configurations:
                  named: {}
                  counted: {robots: {prey: {members: [{name: ann}, {name: bob, pose: [-8, -1, 180]}]}, hunter: {count: 2}}}
                """;
        assertThat(ids(both, "named")).containsExactly("prey", "real3at", "virtual1", "hunter-3");
        assertThat(ids(both, "counted")).containsExactly("ann", "bob", "hunter-1", "hunter-2");
        String prey = "prey: {model: pioneer2dx, pose: [-12, -1, 180]}";
        assertThat(both).contains(prey);
        assertThat(ids(both.replace(prey, "prey: {count: 3, model: pioneer2dx, pose: {free: true}}"), "counted"))
                .containsExactly("ann", "bob", "hunter-1", "hunter-2");
    }

    private List<String> ids(String text, String configuration) {
        return scenario(text).plan(RunOptions.NONE.withConfiguration(configuration)).robots().stream()
                .map(robot -> robot.spec().id())
                .toList();
    }

    @Test
    void membersHaveWhatTheirRoleHasAndWhatTheySayOtherwise() {
        RunPlan plan = plan(MIXED);
        assertThat(plan.robots())
                .extracting(robot -> robot.spec().id())
                .containsExactly("prey", "real3at", "virtual1", "hunter-3");
        RobotSpec real = robot(plan, "real3at").spec();
        assertThat(real.role()).isEqualTo("hunter");
        assertThat(real.model().name()).isEqualTo("pioneer3at");
        assertThat(laser(real)).isEqualTo("urg04lx");
        assertThat(real.mapFromBase()).isEmpty();
        RobotSpec virtual = robot(plan, "virtual1").spec();
        assertThat(laser(virtual)).isEqualTo("utm30lx");
        assertThat(virtual.mapFromBase()).isPresent();
        assertThat(plan.robots())
                .extracting(robot -> robot.spec().marker())
                .containsExactly(OptionalInt.empty(), OptionalInt.of(11), OptionalInt.of(12), OptionalInt.of(21));
        assertThat(robot(plan, "hunter-3").spec().color()).isEqualTo("#123456");
        assertThat(virtual.color()).isEqualTo(real.color());
        assertThat(plan.agents())
                .extracting(RunPlan.PlannedAgent::name)
                .containsExactly("chase-real3at", "chase-virtual1", "chase-3");
    }

    private static String laser(RobotSpec robot) {
        return Objects.requireNonNull(robot.model().sensors().get("laser")).name();
    }

    @Test
    void robotsOfOneSystemAreMadeTogether() {
        RunPlan plan = plan(MIXED);
        assertThat(plan.systems()).extracting(Mrs::words).containsExactly("sim", "reality, host=hall");
        assertThat(plan.systems().getFirst()).isEqualTo(plan.mrs());
        assertThat(plan.systems())
                .extracting(mrs -> mrs.config(plan.scene(), plan.robots()).robots().stream()
                        .map(RobotSpec::id)
                        .toList())
                .containsExactly(List.of("prey", "virtual1", "hunter-3"), List.of("real3at"));
    }

    @Test
    void eachSystemHasASeedThatDependsOnNoOther() {
        RunPlan mixed = plan(MIXED);
        RunPlan alone = plan(MIXED.replace("mrs: {use: reality, host: $host}, ", ""));
        assertThat(alone.systems()).hasSize(1);
        assertThat(mixed.mrs().seed()).isEqualTo(alone.mrs().seed());
        RunPlan elsewhere = plan(MIXED.replace("default: hall", "default: yard"));
        assertThat(Stream.of(mixed, elsewhere)
                        .flatMap(plan -> plan.systems().stream().map(Mrs::seed)))
                .containsExactly(
                        mixed.mrs().seed(),
                        robot(mixed, "real3at").mrs().seed(),
                        mixed.mrs().seed(),
                        robot(elsewhere, "real3at").mrs().seed());
        assertThat(robot(mixed, "real3at").mrs().seed())
                .isNotEqualTo(robot(elsewhere, "real3at").mrs().seed())
                .isNotEqualTo(mixed.mrs().seed());
    }

    /// With the scenario's `mrs` and that of a robot.
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            {use: reality, host: lab}          | {port: 7000}                  | reality, host=lab, port=7000
            {use: reality, host: lab}          | {use: reality, host: roof}    | reality, host=roof
            {use: reality, host: lab}          | {use: sim, sensorNoise: 0}    | sim, sensorNoise=0.0
            {use: reality, host: lab}          | {use: reality, host: lab}     | reality, host=lab
            {step: 0.05}                       | {use: sim}                    | sim, step=0.05
            {step: 0.05}                       | {use: reality}                | reality
            {step: 0.05}                       | {sensorNoise: 0}              | sim, step=0.05, sensorNoise=0.0
            """)
    void aRobotSaysWhatItHasOtherwiseThanTheScenario(String scenarios, String own, String words) {
        RunPlan plan = plan("""
                rsal: 1
                scenario: mixed
                world: {map: office}
                mrs: %s
                robots:
                  rover: {model: pioneer2dx, pose: [-12, -1, 180], mrs: %s}
                """.formatted(scenarios, own));
        assertThat(robot(plan, "rover").mrs().words()).isEqualTo(words);
        assertThat(robot(plan, "rover").mrs().equals(plan.mrs()))
                .isEqualTo(plan.mrs().words().equals(words));
    }

    @Test
    void aSystemWithoutRobotsTakesPartUnlessAnotherOfItsKindDoes() {
        RunPlan plan = plan("""
                rsal: 1
                scenario: mixed
                world: {map: office}
                robots:
                  rover: {model: pioneer2dx, count: 2, mrs: {use: reality}, pose: {free: true}}
                """);
        assertThat(plan.systems())
                .extracting(mrs -> mrs.own(plan.robots()).size())
                .containsExactly(0, 2);
        assertThat(plan.robots().getFirst().mrs()).isNotEqualTo(plan.mrs());
        RunPlan quiet = plan("""
                rsal: 1
                scenario: quiet
                world: {map: office}
                robots:
                  rover: {model: pioneer2dx, mrs: {sensorNoise: 0}, pose: {free: true}}
                """);
        assertThat(quiet.systems()).containsExactly(quiet.robots().getFirst().mrs());
    }

    @Test
    void aConfigurationThatUsesAnotherSystemHasNoSettingsOfTheFirst() {
        Scenario scenario = scenario("""
                rsal: 1
                scenario: mixed
                world: {map: office}
                robots:
                  rover: {model: pioneer2dx, pose: [-12, -1, 180], mrs: {use: reality, host: lab}}
                configurations:
                  real: {}
                  virtual: {robots: {rover: {mrs: {use: sim, step: 0.05}}}}
                """);
        RunPlan plan = scenario.plan(RunOptions.NONE.withConfiguration("virtual"));
        assertThat(robot(plan, "rover").mrs().words()).isEqualTo("sim, step=0.05");
    }

    @Test
    void anOptionNamesTheSystemOfThoseThatNameNone() {
        var options = new RunOptions(
                Optional.empty(),
                Map.of(),
                OptionalLong.empty(),
                Optional.empty(),
                Optional.of("reality"),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                java.util.OptionalDouble.empty());
        RunPlan plan = scenario(MIXED).plan(options);
        assertThat(plan.robots())
                .extracting(robot -> robot.mrs().words())
                .containsExactly("reality", "reality, host=hall", "reality", "reality");
    }

    @Test
    void simulatedTimeRefusesRobotsThatCantFollowIt() {
        assertThat(errors(MIXED.replace("use: reality", "use: clockwork")))
                .contains("The robot system 'clockwork' of robot 'real3at' can't follow simulated time,")
                .contains("mixed.yaml:13:");
        assertThat(errors(MIXED.replace("use: reality", "use: clockwork") + "run: {clock: {mode: wall}}\n"))
                .isEmpty();
    }

    /// Robots of Player, of ROS 2 without a simulator, and agents with clocks of their own.
    @Test
    void aRunInASimulatorsTimeRefusesWhatNeedsRealTime() {
        String driven = MIXED.replace("arguments:\n  host: {type: string, default: hall}\n", "")
                        .replace("use: reality, host: $host", "use: metronome")
                + "run: {clock: {mode: wall}}\n";
        assertThat(errors(driven)).isEmpty();
        assertThat(plan(driven).isTimeDriven()).isTrue();
        assertThat(errors(driven + "mrs: {use: clockwork}\n"))
                .contains("The run follows the time of another simulator ('metronome'), "
                        + "but robots of 'clockwork' need real time.");
        String own = driven.replace("use: metronome", "use: metronome, drives: true, name: own");
        assertThat(errors(own + "mrs: {use: metronome, drives: false}\n"))
                .contains("robots of 'metronome, drives=false' need real time.");
        assertThat(errors(own + "mrs: {use: metronome}\n"))
                .contains("The time of a run can follow one simulator only, "
                        + "but it should follow those of 'metronome' and 'metronome, name=own'.");
        assertThat(errors(driven + "mas: {use: wallclock}\n"))
                .contains("but the multi-agent system 'wallclock' needs real time.");
    }

    @Test
    void agentsOfARoleNeedWhatAllOfItsMembersHave() {
        String agent = MIXED.replace("type: wanderer", "type: wander");
        String pilot = "devices: {pilot: {}}";
        assertThat(errors(agent.replace("name: virtual1", "name: virtual1, " + pilot)))
                .contains("needs a robot with a Pilot, which robots of role 'hunter' don't have.");
        assertThat(errors(agent.replace("pose: {free: true}", "pose: {free: true}\n    " + pilot)))
                .isEmpty();
    }

    @Test
    void aRunHasOneSimulatedWorld() {
        assertThat(errors(MIXED.replace("{name: virtual1}", "{name: virtual1, mrs: {sensorNoise: 0}}")))
                .contains("Robot 'virtual1' would be in another simulated world than those of sim; a run has one.");
    }

    @Test
    void robotsThatNobodyCanBreakHaveNoFaults() {
        String broken = MIXED + "faults:\n  - {kind: gone, robots: %s, at: 5}\n";
        assertThat(errors(broken.formatted("prey"))).isEmpty();
        assertThat(errors(broken.formatted("real3at")))
                .contains("Robot system 'reality' can't break robots on purpose.");
    }

    @Test
    void realRobotsMayHaveStandInsWhereThereIsASimulatedWorld() {
        String mixed = MIXED.replace("name: real3at,", "name: real3at, proxy: true,");
        assertThat(plan(mixed).robots())
                .filteredOn(PlannedRobot::proxy)
                .extracting(robot -> robot.spec().id())
                .containsExactly("real3at");
        assertThat(errors(mixed.replace("name: virtual1", "name: virtual1, proxy: true")))
                .contains("mixed.yaml:14:")
                .contains("Robot 'virtual1' is simulated itself and has no proxy.");
        assertThat(errors(mixed + "mrs: {use: reality}\n"))
                .contains("There is no simulated world for a proxy of robot 'real3at'.");
    }

    @Test
    void realRobotsMaySeeTheSimulatedWorldWhereThereIsOne() {
        String mixed = MIXED.replace("name: real3at,", "name: real3at, overlay: true,");
        assertThat(plan(mixed).robots())
                .filteredOn(PlannedRobot::overlay)
                .extracting(robot -> robot.spec().id())
                .containsExactly("real3at");
        assertThat(errors(mixed.replace("name: virtual1", "name: virtual1, overlay: true")))
                .contains("mixed.yaml:14:")
                .contains("Robot 'virtual1' is simulated itself and sees its world.");
        assertThat(errors(mixed + "mrs: {use: reality}\n"))
                .contains("There is no simulated world that robot 'real3at' could see.");
        write("blind.yaml", """
                title: Blind
                body: {length: 0.3, width: 0.2}
                drive:
                  maxSpeed: 1
                  maxTurnRate: 90
                  maxAcceleration: 1
                  maxTurnAcceleration: 90
                  odometryNoise: {distancePerMeter: 0, headingPerMeter: 0, headingPerDegree: 0}
                """);
        assertThat(errors(mixed.replace("devices: {laser: urg04lx}", "model: blind.yaml")))
                .contains("Robot 'real3at' has no laser and no sonars by which it could see what is simulated.");
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`', delimiter = '|', textBlock = """
            name: virtual1}  | name: real3at}               | Two robots have the same name
            name: virtual1}  | name: operator}              | 'operator' can't be the name of a robot.
            name: virtual1}  | name: virtual1, mirs: {}}    | 'mirs' is not known in 'robots.hunter.members'.
            name: virtual1}  | name: virtual1, mrs: {use: simm}} | There is no robot system 'simm'.
            name: virtual1}  | name: virtual1, mrs: {host: b}} | 'host' is not known in 'robots.hunter.members.mrs'.
            name: virtual1}  | name: virtual1, pose: otto}  | must be [x, y, degrees], a list of those, or {free: true}
            fiducial: 11     | fiducal: 11                  | 'fiducal' is not known
            fiducial: 11     | count: 3                     | 'robots.hunter.count' is not allowed where robots are
            pose: {free: true} | pose: [[1, 2, 0], [3, 4, 0]] | 'robots.hunter.pose' can't be a list of poses where
            """)
    void errorsAreReportedOnceAndWhereTheyAre(String right, String wrong, String words) {
        assertThat(MIXED).contains(right);
        String errors = errors(MIXED.replace(right, wrong));
        assertThat(errors).contains(words).contains("mixed.yaml:");
        assertThat(errors.split(java.util.regex.Pattern.quote(words), -1))
                .as(errors)
                .hasSize(2);
    }

    @Test
    void aPoseCanBeLeftToTheRobotSystem() {
        RunPlan plan = plan(MIXED.replace("pose: [-12, -1, 180]", "pose: auto"));
        assertThat(robot(plan, "prey").spec().mapFromBase()).isEmpty();
        assertThat(robot(plan(MIXED), "prey").spec().mapFromBase()).contains(Pose2d.ofDegrees(-12, -1, 180));
    }

    @Test
    void whatARobotHasItselfIsNotMadeForItsAgents() {
        String scenario = """
                rsal: 1
                scenario: own
                world: {map: office}
                robots:
                  r: {model: pioneer2dx, pose: [-12, -1, 180], devices: {laser: urg04lx, %s}}
                agents: {go: {type: nav, robot: r}}
                mrs: {use: player}
                run: {clock: {mode: wall}}
                """;
        RunPlan own = plan(scenario.formatted("localizer: own-localizer, navigator: own-navigator"));
        assertThat(robot(own, "r").drivers()).isEmpty();
        RunPlan mixed = plan(scenario.formatted("localizer: own-localizer, navigator: {}"));
        assertThat(robot(mixed, "r").drivers())
                .extracting(device -> device.driver().key())
                .containsExactly("navigator");
    }
}
