package rsal.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.OccupancyGrid;
import rsal.scenario.RunPlan.PlannedAgent;
import rsal.scenario.RunPlan.PlannedDevice;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.scenario.fault.PlannedFault;
import rsal.scene.Touch;
import rsal.settings.InvalidSettings;

/// Scenarios that take place in a world with all that is in it.
class WorldScenarioTest {
    private static final String HALL = """
            interval_sim 50
            quit_time 3
            define cart position ( size [0.4 0.3 0.2] ranger ( sensor ( range [0 4] fov 180 samples 37 ) ) )
            model ( name "walls" size [10 10 1] boundary 1 )
            cart ( name "r0" pose [-2 0 0 0] ctrl "wander" )
            cart ( name "r1" pose [2 0 0 0] )
            position ( name "blind" pose [0 3 0 0] ctrl "wander" )
            """;

    private static final String SCENARIO = """
            rsal: 1
            scenario: visit
            world: {file: hall.world}
            robots:
              guest: {model: pioneer2dx, pose: [0, -3, 0], devices: {laser: urg04lx, pilot: {}}}
            agents:
              roam: {type: wander, robot: cart}
              round: {type: wall-follow, robot: guest}
            """;

    @TempDir
    private Path folder;

    @BeforeEach
    void writeWorld() throws IOException {
        Files.writeString(folder.resolve("hall.world"), HALL);
    }

    private static final String YARD = """
            <?xml version="1.0"?>
            <sdf version="1.9"><world name="yard"><model name="box"><static>true</static><pose>0 0 0.5 0 0 0</pose><link name="l">
            <collision name="c"><geometry><box><size>4 4 1</size></box></geometry></collision></link></model></world></sdf>
            """;

    /// Worlds of Stage and of Gazebo are both called so.
    @Test
    void whatIsInAWorldSaysWhoseItIs() throws IOException {
        Files.writeString(folder.resolve("hall.world"), YARD);
        RunPlan plan = planned(SCENARIO.replace("  roam: {type: wander, robot: cart}\n", ""));
        assertThat(plan.map()
                        .cells()[
                        plan.map().row(1) * plan.map().width() + plan.map().column(1)])
                .isEqualTo(OccupancyGrid.OCCUPIED);
        String path = folder.resolve("hall.world").toString();
        assertThat(Scenario.isWorld(path)).isTrue();
        assertThat(Scenario.scene(path).title()).isEqualTo("yard");
        assertThat(Scenario.load(path).plan(RunOptions.NONE).map().width()).isGreaterThan(80);
    }

    private RunPlan planned(String text) throws IOException {
        return Scenario.load(
                        Files.writeString(folder.resolve("visit.yaml"), text).toString())
                .plan(RunOptions.NONE);
    }

    private RunPlan world() {
        return Scenario.load(folder.resolve("hall.world").toString()).plan(RunOptions.NONE);
    }

    @Test
    void robotsSlideWhereTheScenarioSaysSo() throws IOException {
        assertThat(planned(SCENARIO).scene().touch()).isEqualTo(Touch.STALL);
        String sliding = SCENARIO.replace("{file: hall.world}", "{file: hall.world, onCollision: slide}");
        assertThat(planned(sliding).scene().touch()).isEqualTo(Touch.SLIDE);
        assertThatThrownBy(() -> planned(sliding.replace("slide", "slip")))
                .hasMessageContaining("visit.yaml:3:")
                .hasMessageContaining("world.onCollision")
                .hasMessageContaining("slide");
    }

    @Test
    void robotsOfTheWorldJoinThoseOfTheScenario() throws IOException {
        RunPlan plan = planned(SCENARIO);
        assertThat(plan.robots()).extracting(robot -> robot.spec().id()).containsExactly("r0", "r1", "blind", "guest");
        assertThat(plan.agents())
                .extracting(PlannedAgent::name, agent -> agent.robot().orElseThrow())
                .containsExactly(tuple("roam-r0", "r0"), tuple("roam-r1", "r1"), tuple("round", "guest"));
        assertThat(plan.step()).isEqualTo(Duration.ofMillis(50));
        assertThat(plan.mapName()).isEqualTo("hall.world");
        assertThat(plan.map().at(plan.map().column(4.995), plan.map().row(0))).isEqualTo(OccupancyGrid.OCCUPIED);
        assertThat(plan.stops()).isEmpty();
    }

    @Test
    void soCanWhatTheyAreGivenForTheirAgents() throws IOException {
        RunPlan plan = planned("""
                rsal: 1
                scenario: visit
                world: {file: hall.world}
                agents:
                  follow: {type: follow, robot: cart, parameters: {prey: blind}}
                faults: [{kind: dead, robots: cart, devices: localizer}]
                """);
        assertThat(plan.faults().getFirst().targets())
                .extracting(PlannedFault.Target::name)
                .containsExactly("r0/localizer", "r1/localizer");
    }

    @Test
    void robotsOfTheWorldCanHaveFaults() throws IOException {
        RunPlan plan = planned(SCENARIO
                + "faults: [{kind: dead, robots: [cart, guest], devices: RangeSensor}, {kind: lost, from: cart}]\n");
        assertThat(plan.faults().getFirst().targets())
                .extracting(PlannedFault.Target::name)
                .containsExactly("r0/laser", "r1/laser", "guest/sonar", "guest/laser");
        assertThat(plan.faults().getLast().targets())
                .singleElement()
                .extracting(PlannedFault.Target::words)
                .isEqualTo("lost (from roam-r0, roam-r1)");
    }

    @Test
    void aStepOfTheScenarioComesFirst() throws IOException {
        assertThat(planned(SCENARIO + "mrs: {step: 0.1}\n").step()).isEqualTo(Duration.ofMillis(100));
    }

    @Test
    void robotsNeedNotBeAdded() throws IOException {
        RunPlan plan = planned("rsal: 1\nscenario: visit\nworld: {file: hall.world}\n");
        assertThat(plan.robots()).hasSize(3);
        assertThat(plan.agents()).isEmpty();
    }

    @Test
    void aWorldAloneIsAScenario() {
        RunPlan plan = world();
        assertThat(plan.scenario().name()).isEqualTo("hall.world");
        assertThat(plan.scenario().isWorld()).isTrue();
        assertThat(plan.agents()).singleElement().satisfies(agent -> {
            assertThat(agent.name()).isEqualTo("r0");
            assertThat(agent.type().key()).isEqualTo("wander");
        });
        assertThat(plan.stops()).singleElement().satisfies(stop -> {
            assertThat(stop.when()).hasToString("time >= 3");
            assertThat(stop.outcome()).isEqualTo(RunPlan.Outcome.SUCCESS);
        });
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`', delimiter = '|', textBlock = """
            {file: hall.world}              | {}                               | 'world.map' is missing, or 'world.file'
            {file: hall.world}              | {file: hall.world, map: office}  | both a 'map' and a 'file'
            {file: hall.world}              | {file: hal.world}                | There is no file 'hal.world'
            {file: hall.world}              | {file: ../hall.world}            | lies outside
            {file: hall.world}              | {file: hall.wrld}                | Maybe '.world'
            {file: hall.world}              | {file: hall.yaml}                | name ends with .world.yaml
            {file: hall.world}              | {flie: hall.world}               | Maybe 'file'
            guest: {                        | cart: {                          | The world has robots called 'cart', too
            robot: cart                     | robot: crat                      | Maybe 'cart'
            robot: cart                     | robot: position                  | needs a robot with a Pilot
            {type: wander, robot: cart}     | {type: nav, robot: position}     | needs a robot with a Navigator
            """)
    void errorsAreReported(String right, String wrong, String expected) {
        assertThat(SCENARIO).contains(right);
        assertThatThrownBy(() -> planned(SCENARIO.replace(right, wrong)))
                .isInstanceOf(InvalidSettings.class)
                .hasMessageContaining(expected);
    }

    @Test
    void robotsOfTheWorldHaveWhatTheirAgentsNeed() throws IOException {
        RunPlan plan = planned(SCENARIO.replace("roam: {type: wander, robot: cart}", "go: {type: nav, robot: cart}"));
        assertThat(drivers(plan, "r0")).containsExactly("odometry", "navigator");
        assertThat(drivers(plan, "blind")).isEmpty();
        assertThat(drivers(planned(SCENARIO), "r0")).containsExactly("pilot");
        assertThat(drivers(world(), "r0")).containsExactly("pilot");
        assertThat(drivers(world(), "r1")).as("nobody needs any").isEmpty();
    }

    private static List<String> drivers(RunPlan plan, String robot) {
        return plan.robots().stream()
                .filter(planned -> planned.spec().id().equals(robot))
                .flatMap(planned -> planned.drivers().stream())
                .map(device -> device.driver().key())
                .toList();
    }

    @Test
    void everyRobotHasSparesOrAReasonWhyNot() throws IOException {
        List<PlannedRobot> robots = planned(SCENARIO).robots();
        assertThat(robots.getFirst().spares().navigation().devices())
                .extracting(device -> device.driver().key())
                .containsExactly("odometry", "navigator");
        assertThat(robots.get(2).spares().pilot().refusal()).contains("blindly");
        assertThat(robots.getLast().spares().navigation().devices())
                .extracting(device -> device.driver().key())
                .containsExactly("amcl", "navigator");
    }

    @Test
    void aWorldWithoutRobotsCanBeLookedAt() throws IOException {
        Files.writeString(folder.resolve("hall.world"), "model ( )");
        assertThat(world().robots()).isEmpty();
        assertThatThrownBy(() -> planned("rsal: 1\nscenario: visit\nworld: {file: hall.world}\n"))
                .hasMessageContaining("There are no robots.");
    }

    @Test
    void nothingIsUnknownOfAWorldThatCouldNotBeRead() throws IOException {
        Files.writeString(folder.resolve("hall.world"), "model ( size [1 2] )");
        assertThatThrownBy(() -> planned("""
                        rsal: 1
                        scenario: visit
                        world: {file: hall.world}
                        agents:
                          roam: {type: wander, robot: cart}
                        faults:
                          - {kind: gone, robots: r7, at: 2}
                        run:
                          stop:
                            - {when: allCaught(cart), outcome: success}
                        metrics:
                          - {name: way, unit: m, from: distance(cart)}
                        """))
                .isInstanceOfSatisfying(
                        InvalidSettings.class,
                        e -> assertThat(e.problems())
                                .extracting(Object::toString)
                                .singleElement()
                                .asString()
                                .startsWith("hall.world:1:"));
    }

    @Test
    void aRobotThatIsBlockedIsReportedAtItsOwnPose() {
        assertThatThrownBy(() -> planned("""
                        rsal: 1
                        scenario: visit
                        world: {map: office}
                        robots:
                          guest:
                            count: 2
                            model: pioneer2dx
                            pose:
                              - [0.2, -1, 0]
                              - [0.3, -1, 0]
                        """))
                .isInstanceOfSatisfying(
                        InvalidSettings.class,
                        e -> assertThat(e.problems())
                                .extracting(Object::toString)
                                .singleElement()
                                .asString()
                                .contains("visit.yaml:10:9: Robot 'guest-2': At its start pose"));
    }

    @Test
    void errorsOfTheWorldAreReportedWhereTheyAre() throws IOException {
        Files.writeString(folder.resolve("hall.world"), "model ( size [1 2] )");
        assertThatThrownBy(() -> planned(SCENARIO))
                .isInstanceOf(InvalidSettings.class)
                .hasMessageContaining("hall.world:1:");
    }

    private static final String SERVED = """
            driver ( name "stage" plugin "stageplugin" provides ["simulation:0"] worldfile "hall.world" )
            driver ( name "stage" provides ["position2d:0" "ranger:0"] model "r0" )
            driver ( name "rangertolaser" requires ["ranger:0"] provides ["laser:0"] )
            driver ( name "vfh" requires ["position2d:0" "laser:0"] provides ["position2d:1"] max_speed 0.3 )
            driver ( name "amcl" requires ["position2d:0" "laser:0"] provides ["localize:0"] pf_max_samples 900 )
            """;

    private RunPlan served(String text) throws IOException {
        return Scenario.load(Files.writeString(folder.resolve("hall.cfg"), text).toString())
                .plan(RunOptions.NONE);
    }

    @Test
    void robotsGetWhatAConfigurationHasServersMakeOfThem() throws IOException {
        RunPlan plan = served(SERVED);
        List<PlannedDevice> devices = plan.robots().getFirst().drivers();
        assertThat(devices)
                .extracting(PlannedDevice::name, device -> device.driver().key())
                .startsWith(tuple("localizer", "amcl"), tuple("navigator", "navigator"));
        assertThat(devices.getFirst().options().asMap().get("maxParticles")).isEqualTo(900L);
        assertThat(devices.get(1).options().asMap().get("maxSpeed")).isEqualTo(0.3);
        assertThat(devices.getFirst().seed()).isNotEqualTo(devices.get(1).seed());
        assertThat(plan.robots().get(1).drivers()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '`',
            delimiter = '|',
            value = {
                "max_speed 0.3 | max_speed 300 | hall.cfg:4: | 'navigator.maxSpeed' must be a number from 0.05 to 3 [m/s]",
                "900 | \"many\" | hall.cfg:5: | 'localizer.maxParticles' must be a whole number"
            })
    void whatItSetsIsChecked(String right, String wrong, String at, String message) {
        assertThatThrownBy(() -> served(SERVED.replace(right, wrong)))
                .isInstanceOf(InvalidSettings.class)
                .hasMessageContaining(at)
                .hasMessageContaining(message);
    }
}
