package rsal.player.bridge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Pose2d;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.player.message.Interface;
import rsal.player.message.Localize;
import rsal.player.message.PlannerInterface;
import rsal.player.message.Pose;
import rsal.player.message.Position2d;
import rsal.player.wire.Address;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.robot.DeviceDriver;
import rsal.system.RobotSystemProvider;
import rsal.testkit.fake.FakeLocalizer;
import rsal.testkit.fake.FakeNavigator;
import rsal.testkit.fake.FakeProvider;

/// A robot that knows where it is and gets about by itself, as a Player client sees it.
@Timeout(60)
class NavigatedBridgeTest extends BridgeBench {
    private static final double[] SURE = {0.04, 0.09, 0.01, 0.01, 0.002, 0.001};
    private static final Pose2d A = WORLD.pose('a', 0);
    private static final Pose2d B = WORLD.pose('b', 0);

    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }

    @Override
    protected List<DeviceDriver> drivers() {
        return List.of(new FakeLocalizer.Driver(), new FakeNavigator.Driver());
    }

    private static Pose wire(Pose2d pose) {
        return new Pose(pose.x(), pose.y(), pose.theta());
    }

    private void goal(Pose2d goal) {
        client().command(Packet.of(
                Address.of(Interface.PLANNER.code(), 0),
                MessageKind.COMMAND,
                PlannerInterface.GOAL,
                0,
                new PlannerInterface.Place(wire(goal))));
    }

    private PlannerInterface.State state() {
        return newest(Interface.PLANNER, PlannerInterface.State.class);
    }

    private Navigator navigator() {
        return robot().require(Navigator.class);
    }

    private void enable(int on) throws InterruptedException {
        ask(Interface.PLANNER, PlannerInterface.ENABLE, new PlannerInterface.Enable(on));
    }

    @Test
    void whereItIsIsReportedAndCanBeSet() throws Exception {
        var reported = reported(Interface.LOCALIZE, Localize.Hypotheses.class).hypotheses();
        assertThat(reported).hasSize(1);
        assertThat(reported.getFirst().mapFromBase()).isEqualTo(wire(START));
        assertThat(reported.getFirst().weight()).isEqualTo(1);
        ask(Interface.LOCALIZE, Localize.SET_POSE, new Localize.SetPose(wire(A), SURE));
        ask(Interface.LOCALIZE, Localize.SET_POSE, new Localize.SetPose(wire(B), SURE));
        var localizer = robot().require(Localizer.class);
        until(() -> localizer.latest().orElseThrow().value().mapFromBase().isNear(B, 1e-6, 1e-6));
        until(() -> newest(Interface.LOCALIZE, Localize.Hypotheses.class)
                .hypotheses()
                .getFirst()
                .mapFromBase()
                .equals(wire(B)));
        assertThat(newest(Interface.LOCALIZE, Localize.Hypotheses.class)
                        .hypotheses()
                        .getFirst()
                        .covariance())
                .containsExactly(SURE);
    }

    @ParameterizedTest
    @CsvSource({
        "NaN, 0, 1, 1, 1, 0",
        "1e300, 0, 1, 1, 1, 0",
        "0, 0, -1, 1, 1, 0",
        "0, 0, 1, Infinity, 1, 0",
        "0, 0, 1, 1, NaN, 0",
    })
    void whatNobodyCanBelieveIsRefused(double x, double y, double xx, double yy, double aa, double xy) {
        var covariance = new double[] {xx, yy, aa, xy, 0, 0};
        refused(Interface.LOCALIZE, Localize.SET_POSE, new Localize.SetPose(new Pose(x, y, 0), covariance));
    }

    /// playernav hands over three numbers where Player's library reads six.
    @ParameterizedTest
    @CsvSource({
        "1e100, 0, 0",
        "0.1, NaN, 0",
        "0, 0, -Infinity",
        "0, 0.04, 0", // more than its variances allow
        "0.05, 0.02, -0.018", // each of them could be, but not all of them
    })
    void productsThatCanNotBeCountAsNone(double xy, double ya, double xa) throws Exception {
        var covariance = new double[] {0.04, 0.09, 0.01, xy, ya, xa};
        ask(Interface.LOCALIZE, Localize.SET_POSE, new Localize.SetPose(wire(A), covariance));
        subscribe(Interface.LOCALIZE);
        until(() -> Arrays.equals(
                newest(Interface.LOCALIZE, Localize.Hypotheses.class)
                        .hypotheses()
                        .getFirst()
                        .covariance(),
                new double[] {0.04, 0.09, 0.01, 0, 0, 0}));
    }

    /// As our own client has it: it stands, motors and planner are switched off, and on again.
    @Test
    void afterAnEmergencyStopItGoesOn() throws Exception {
        goal(A);
        until(() -> truth().distanceTo(START) > 0.3);
        command(Position2d.VELOCITY, new Position2d.Velocity(new Pose(0, 0, 0), 1));
        ask(Interface.POSITION2D, Position2d.MOTORS, new Position2d.Motors(0));
        enable(0);
        advance(2);
        Pose2d there = truth();
        advance(2);
        assertThat(truth()).isEqualTo(there);
        ask(Interface.POSITION2D, Position2d.MOTORS, new Position2d.Motors(1));
        goal(A); // which the velocity has ended
        enable(1);
        until(() -> truth().isNear(A, 0.5, Math.PI));
    }

    @Test
    void itGoesWhereAClientWantsItAndReportsIt() throws Exception {
        assertThat(state())
                .isEqualTo(new PlannerInterface.State(0, 0, wire(START), new Pose(0, 0, 0), new Pose(0, 0, 0), -1, 0));
        goal(A);
        until(() -> state().valid() == 1);
        assertThat(state().mapFromGoal()).isEqualTo(wire(A));
        assertThat(state().waypointIndex()).isZero();
        assertThat(state().done()).isZero();
        var wavefront = asked(Interface.PLANNER, PlannerInterface.WAYPOINTS, PlannerInterface.Waypoints.class);
        assertThat(wavefront.distance()).isBetween(1.0, START.distanceTo(A) + 0.01);
        assertThat(wavefront.waypoints().getLast()).isEqualTo(new Pose(A.x(), A.y(), 0));
        until(() -> state().done() == 1);
        assertThat(state().waypointIndex()).isEqualTo(-1);
        assertThat(state().mapFromBase().x()).isCloseTo(A.x(), within(0.5));
        goal(WORLD.pose('x', 0)); // nothing leads there
        until(() -> state().done() == 0);
        assertThat(state().valid()).isZero();
    }

    @Test
    void theSameGoalAgainIsNoneAndOneThatIsNoNumberNeither() throws Exception {
        for (int i = 0; i < 5; i++) {
            goal(A);
            goal(new Pose2d(Double.NaN, 0, 0));
            answer(client().devices());
            advance(0.2);
        }
        goal(A);
        until(() -> navigator().goal().isPresent());
        assertThat(robot().require(FakeNavigator.class).goals()).containsOnlyOnce(A);
    }

    @Test
    void itWaitsWhileAClientWantsThat() throws Exception {
        goal(A);
        until(() -> state().valid() == 1);
        enable(0);
        assertThat(navigator().paused()).isTrue();
        advance(1);
        Pose2d before = truth();
        advance(5);
        assertThat(truth()).isEqualTo(before);
        enable(1);
        until(() -> state().done() == 1);
    }

    @Test
    void whoPausesAndLeavesKeepsNobodyWaiting() throws Exception {
        subscribe(Interface.PLANNER);
        navigator().goTo(B); // an agent's
        enable(0);
        client().close();
        until(() -> !navigator().paused());
        assertThat(navigator().goal()).contains(B);
    }

    @Test
    void aClientsGoalEndsWhenItIsGone() throws Exception {
        goal(A);
        until(() -> navigator().goal().isPresent());
        client().close();
        until(() -> navigator().goal().isEmpty());
    }

    @Test
    void whoeverCommandsLastDrives() throws Exception {
        goal(A);
        until(() -> navigator().goal().isPresent());
        command(Position2d.VELOCITY, new Position2d.Velocity(new Pose(0, 0, 0.5), 1));
        until(() -> navigator().goal().isEmpty());
        goal(B);
        until(() -> state().done() == 1);
        assertThat(truth().isNear(B, 0.5, 0.3)).isTrue();
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void whoeverBabblesDisturbsNobody(long seed) throws Exception {
        assertBabbleDisturbsNobody(seed, "fake");
    }
}
