package rsal.player.bridge;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.data.Pose2d;
import rsal.device.DriveBase;
import rsal.device.Navigator;
import rsal.device.Navigator.Tolerance;
import rsal.player.message.Interface;
import rsal.player.message.PlannerInterface;
import rsal.player.message.Pose;
import rsal.player.message.Position2d;
import rsal.player.wire.Address;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.robot.DeviceDriver;
import rsal.scene.RobotService;
import rsal.settings.Location;
import rsal.system.ExportedDevice;
import rsal.system.RobotSystemProvider;
import rsal.testkit.fake.FakeLocalizer;
import rsal.testkit.fake.FakeNavigator;
import rsal.testkit.fake.FakeProvider;

/// What the file of a world asks for, as a Player client sees it: interfaces and indices as the file has them,
/// and nothing else.
@Timeout(60)
class ServedBridgeTest extends BridgeBench {
    private static final Pose2d A = WORLD.pose('a', 0);
    private static final Address AVOIDING = Address.of(Interface.POSITION2D.code(), 1);
    private static final Tolerance NEAR = new Tolerance(0.1, 0.1);

    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }

    @Override
    protected List<DeviceDriver> drivers() {
        return List.of(new FakeLocalizer.Driver(), new FakeNavigator.Driver());
    }

    private static RobotService service(String driver, int port, Map<String, String> sources) {
        return new RobotService(
                driver,
                Location.of("test.cfg"),
                port,
                sources.keySet().stream().sorted().toList(),
                List.of(),
                Optional.of("r1"),
                sources,
                List.of(),
                NEAR,
                Optional.empty());
    }

    @Override
    List<RobotService> services() {
        return List.of(
                service("stage", 6665, Map.of("position2d:0", "base")),
                service("amcl", 6665, Map.of("localize:4", "fake-localizer", "position2d:2", "fake-localizer")),
                service("vfh", 6665, Map.of("position2d:1", "fake-navigator")),
                service("wavefront", 6665, Map.of("planner:3", "fake-navigator")),
                service("rangertolaser", 6668, Map.of("laser:7", "laser", "sonar:0", "laser", "log:0", "nothing")),
                service("mapfile", 6668, Map.of("map:2", RobotService.MAP, "own:0", RobotService.MAP)),
                service("stage", 6668, Map.of("simulation:1", RobotService.SIMULATION)));
    }

    @Test
    void portsInterfacesAndIndicesAreThoseOfTheFile() throws InterruptedException {
        assertThat(offers())
                .extracting(ExportedDevice::name)
                .containsExactly(
                        "position2d:0",
                        "localize:4",
                        "position2d:2",
                        "position2d:1",
                        "planner:3",
                        "laser:7", // there is no sonar in a laser, and nothing that is nothing
                        "map:2",
                        "simulation:1");
        List<Integer> ports = offers().stream().map(ExportedDevice::port).toList();
        assertThat(ports.subList(0, 5)).containsOnly(port());
        assertThat(ports.subList(5, 8)).containsOnly(ports.getLast()).doesNotContain(port());
        assertThat(answer(client().devices())).hasSize(5);
        assertThat(answer(client().driver(AVOIDING))).isEqualTo("vfh");
    }

    @Test
    void whereItBelievesToBeIsAPositionThatTakesNoCommands() throws Exception {
        var believed = Address.of(Interface.POSITION2D.code(), 2);
        answer(client().subscribe(believed));
        until(() -> newestOf(believed, Position2d.State.class)
                .filter(state -> state.odomFromBase().equals(new Pose(START.x(), START.y(), START.theta())))
                .isPresent());
        client().command(Packet.of(
                believed, MessageKind.COMMAND, Position2d.VELOCITY, 0, new Position2d.Velocity(new Pose(1, 0, 0), 1)));
        answer(client().devices());
        advance(1);
        assertThat(truth()).isEqualTo(START);
    }

    @Test
    void aBaseThatAvoidsGoesToGoalsOfItsOdometryByItsNavigator() throws Exception {
        robot().require(DriveBase.class).resetOdometry(new Pose2d(1, 2, Math.PI / 2));
        advance(0.3);
        Pose2d startFromA = START.inverse().compose(A);
        Pose2d goal = new Pose2d(1, 2, Math.PI / 2).compose(startFromA);
        var reported = new Position2d.Goal(new Pose(goal.x(), goal.y(), goal.theta()), new Pose(0, 0, 0), 1);
        for (int i = 0; i < 5; i++) { // as others say it again and again
            client().command(Packet.of(AVOIDING, MessageKind.COMMAND, Position2d.GOAL, 0, reported));
            answer(client().devices());
            advance(0.2);
        }
        until(() -> truth().isNear(A, 0.15, 0.15));
        assertThat(robot().require(FakeNavigator.class).goals()).hasSize(1);
    }

    @Test
    void aGoalFartherAwayThanNumbersReachIsNone() throws Exception {
        robot().require(DriveBase.class).resetOdometry(new Pose2d(0, 0, Math.PI / 4));
        advance(0.3);
        double far = Double.MAX_VALUE; // finite, but not once it is turned by 45°
        var goal = new Position2d.Goal(new Pose(far, far, 0), new Pose(0, 0, 0), 1);
        client().command(Packet.of(AVOIDING, MessageKind.COMMAND, Position2d.GOAL, 0, goal));
        answer(client().devices());
        advance(1);
        assertThat(robot().require(Navigator.class).goal()).isEmpty();
        assertThat(truth()).isEqualTo(START);
    }

    @Test
    void aVelocityEndsItsGoalAndSoDoesOneOfThePlanner() throws Exception {
        var goal = new Position2d.Goal(new Pose(3, 0, 0), new Pose(0, 0, 0), 1);
        var navigator = robot().require(Navigator.class);
        client().command(Packet.of(AVOIDING, MessageKind.COMMAND, Position2d.GOAL, 0, goal));
        until(() -> navigator.goal().isPresent());
        client().command(Packet.of(
                AVOIDING,
                MessageKind.COMMAND,
                Position2d.VELOCITY,
                0,
                new Position2d.Velocity(new Pose(0, 0, 0.3), 1)));
        until(() -> navigator.goal().isEmpty());
        client().command(Packet.of(AVOIDING, MessageKind.COMMAND, Position2d.GOAL, 0, goal));
        until(() -> navigator.goal().isPresent());
        var there = new PlannerInterface.Place(new Pose(A.x(), A.y(), 0));
        client().command(Packet.of(
                Address.of(Interface.PLANNER.code(), 3), MessageKind.COMMAND, PlannerInterface.GOAL, 0, there));
        until(() -> truth().isNear(A, 0.15, 0.15));
    }

    @Test
    void babbleDisturbsNobody() throws Exception {
        babble(4);
        assertThat(truth().isFinite()).isTrue();
        assertThat(answer(client().devices())).hasSize(5);
    }
}
