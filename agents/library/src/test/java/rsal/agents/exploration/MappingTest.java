package rsal.agents.exploration;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rsal.agents.FakeMapper;
import rsal.agents.FakeRobot;
import rsal.agents.Scene;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Mapper.End;
import rsal.device.Navigator.Result;

/// Two workers in the west and the east with one map, and the agent that has them go where it ends.
class MappingTest {
    private final Scene scene = new Scene();
    private final FakeRobot west = scene.robot("west", "robot");
    private final FakeRobot east = scene.robot("east", "robot");
    private final FakeMapper westMap = new FakeMapper("west", false);
    private final FakeMapper eastMap = new FakeMapper("east", false);

    @BeforeEach
    void begins() {
        scene.start("worker", "west", Optional.of(west.robot.with(westMap)), Map.of());
        scene.start("worker", "east", Optional.of(east.robot.with(eastMap)), Map.of());
        scene.start("mapping", "master", Optional.empty(), Map.of());
        west.isAt(0, 0);
        east.isAt(20, 0);
    }

    /// The map ends at these places on the x axis [m], where robots can stand half a meter before it.
    private void mapEndsAt(double... places) {
        westMap.draws(ends(0, places), scene.scheduler.instant());
        eastMap.draws(ends(20, places), scene.scheduler.instant());
        scene.advance(5);
    }

    private static List<End> ends(double from, double... places) {
        var ends = new ArrayList<End>();
        for (double x : places) {
            ends.add(new End(new Point2d(x, 0), new Pose2d(x - 0.5, 0, 0), 2, Math.abs(x - from)));
        }
        return ends;
    }

    @Test
    void theirMappersLeaveTheDrivingToThemOnceTheTeamMaps() {
        assertThat(eastMap.paused()).isFalse();
        mapEndsAt(26);
        assertThat(eastMap.paused()).isTrue();
    }

    @Test
    void eachGoesToTheEndThatIsNearestForTheTeam() {
        mapEndsAt(-5, 26);
        assertThat(west.navigator.goals).containsExactly(new Pose2d(-5.5, 0, 0));
        assertThat(east.navigator.goals).containsExactly(new Pose2d(25.5, 0, 0));
        assertThat(scene.state("master")).isEqualTo("places where the map ends: 2");
    }

    @Test
    void whereTheMapGoesOnNobodyGoesAnyMore() {
        mapEndsAt(-5, 26);
        mapEndsAt(31);
        assertThat(west.navigator.driving()).isFalse();
        assertThat(east.navigator.goals).last().isEqualTo(new Pose2d(30.5, 0, 0));
        mapEndsAt();
        assertThat(east.navigator.driving()).isFalse();
        assertThat(scene.state("master")).isEqualTo("all is mapped");
    }

    @Test
    void anEndThatMovesABitIsTheSame() {
        mapEndsAt(26);
        mapEndsAt(26.6);
        assertThat(east.navigator.goals).hasSize(1);
        assertThat(scene.state("master")).isEqualTo("places where the map ends: 1");
    }

    @Test
    void whatOneGetsNoWayToAnotherTries() {
        mapEndsAt(26);
        east.navigator.end(new Result.NoPath("A wall."));
        scene.advance(5);
        assertThat(west.navigator.goals).containsExactly(new Pose2d(25.5, 0, 0));
        assertThat(eastMap.leftAlone).extracting(End::mapFromMiddle).containsExactly(new Point2d(26, 0));
    }

    @Test
    void anotherGoesWhenOneHasGone() {
        mapEndsAt(26);
        scene.platform.stop("east");
        scene.advance(3);
        assertThat(west.navigator.goals).containsExactly(new Pose2d(25.5, 0, 0));
    }

    @Test
    void anEndThatIsStillThereWhenSomebodyWasThereIsOpenAgain() {
        mapEndsAt(26);
        east.navigator.reach();
        scene.advance(0);
        assertThat(eastMap.leftAlone).hasSize(1);
        mapEndsAt(26);
        assertThat(east.navigator.goals).hasSize(2);
    }

    @Test
    void noMoreEndsAreReportedThanOthersCanMind() {
        var places = new double[2 * MapEnds.MOST];
        for (int i = 0; i < places.length; i++) {
            places[i] = 100 + 3 * i;
        }
        mapEndsAt(places);
        assertThat(scene.said("east", MapEnds.TOPIC))
                .last()
                .satisfies(said -> assertThat(said.ends()).hasSize(MapEnds.MOST));
        assertThat(east.navigator.goals).containsExactly(new Pose2d(99.5, 0, 0));
    }
}
