package rsal.player.bridge;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.data.Pose2d;
import rsal.device.Localizer;
import rsal.player.message.Interface;
import rsal.player.message.Localize;
import rsal.player.message.MapInterface;
import rsal.player.message.PlannerInterface;
import rsal.player.message.Pose;
import rsal.player.message.Protocol;
import rsal.player.message.Version30;
import rsal.player.wire.Address;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.robot.DeviceDriver;
import rsal.system.RobotSystemProvider;
import rsal.testkit.fake.FakeLocalizer;
import rsal.testkit.fake.FakeNavigator;
import rsal.testkit.fake.FakeProvider;

/// A robot as clients of Player 3.0 see it, who can't read some of what is said since.
@Timeout(60)
class OldBridgeTest extends BridgeBench {
    private static final Pose A = Pose.of(WORLD.pose('a', 0));

    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }

    @Override
    protected List<DeviceDriver> drivers() {
        return List.of(new FakeLocalizer.Driver(), new FakeNavigator.Driver());
    }

    @Override
    Protocol protocol() {
        return Protocol.V3_0;
    }

    @Test
    void itSaysWhichVersionItIsOf() {
        assertThat(client().protocol()).isSameAs(Protocol.V3_0);
    }

    @Test
    void hypothesesHaveThreeVariancesBeforeTheClientHasSaidAnything() throws Exception {
        var reported = reported(Interface.LOCALIZE, Version30.Hypotheses.class).hypotheses();
        assertThat(reported.getFirst().mapFromBase()).isEqualTo(Pose.of(START));
        assertThat(reported.getFirst().covariance()).hasSize(3);
        assertThat(reported.getFirst().weight()).isEqualTo(1);
    }

    @Test
    void aPoseWithThreeVariancesIsBelieved() throws Exception {
        double[] variances = {0.04, 0.09, 0.01};
        ask(Interface.LOCALIZE, Localize.SET_POSE, new Version30.SetPose(A, variances));
        Pose2d a = A.to2d();
        var localizer = robot().require(Localizer.class);
        until(() -> localizer.latest().orElseThrow().value().mapFromBase().isNear(a, 1e-6, 1e-6));
        subscribe(Interface.LOCALIZE);
        until(() -> newest(Interface.LOCALIZE, Version30.Hypotheses.class)
                        .hypotheses()
                        .getFirst()
                        .covariance()[1]
                == variances[1]);
    }

    @Test
    void tilesHaveNoRangeAndWaysNoLength() throws Exception {
        var tile = new Version30.Tile(0, 0, 5, 5, new byte[0]);
        assertThat(ask(Interface.MAP, MapInterface.TILE, tile)
                        .body(Version30.Tile.class)
                        .cells())
                .isNotEmpty();
        client().command(Packet.of(
                Address.of(Interface.PLANNER.code(), 0),
                MessageKind.COMMAND,
                PlannerInterface.GOAL,
                0,
                new PlannerInterface.Place(A)));
        until(() -> newest(Interface.PLANNER, PlannerInterface.State.class).valid() == 1);
        assertThat(asked(Interface.PLANNER, PlannerInterface.WAYPOINTS, Version30.Waypoints.class)
                        .waypoints()
                        .getLast())
                .isEqualTo(new Pose(A.x(), A.y(), 0));
    }

    /// A client of Player 3.1 is known by what it asks.
    @Test
    void whoAsksAsPlayer31DoesIsAnsweredSo() throws Exception {
        var asked = new MapInterface.Tile(0, 0, 5, 5, 0, 0, new byte[0]);
        assertThat(ask(Interface.MAP, MapInterface.TILE, asked)
                        .body(MapInterface.Tile.class)
                        .range())
                .isEqualTo(1);
        assertThat(reported(Interface.LOCALIZE, Localize.Hypotheses.class).hypotheses())
                .hasSize(1);
    }
}
