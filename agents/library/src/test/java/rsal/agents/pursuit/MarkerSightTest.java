package rsal.agents.pursuit;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import rsal.agent.message.PoseReport;
import rsal.agent.message.PoseRequest;
import rsal.agents.FakeFinder;
import rsal.agents.FakePlanner;
import rsal.agents.FakeRobot;
import rsal.agents.Scene;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.PlaceFinder;
import rsal.robot.Robot;

/// Hunters and prey that know each other by their markers.
class MarkerSightTest {
    private final Scene scene = new Scene();
    private final FakeRobot p1 = scene.robot("p1", "prey");
    private final FakeRobot h1 = scene.robot("h1", "hunter");
    private final FakeFinder preysEyes = new FakeFinder("p1");
    private final FakeFinder huntersEyes = new FakeFinder("h1");

    private static Robot wearing(int marker, Robot robot) {
        return new Robot(robot.id(), robot.role(), robot.model(), OptionalInt.of(marker), robot.devices());
    }

    private void preyAtOrigin(String type, Map<String, ?> arguments) {
        Robot body = wearing(11, p1.robot.with(preysEyes).with(p1.places).with(new FakePlanner("p1")));
        scene.start(type, "p1", Optional.of(body), arguments);
        p1.isAt(0, 0);
        scene.advance(0);
    }

    private void hunterAt(double x, String assignment) {
        h1.places.result = new PlaceFinder.Result.Found(List.of(new Point2d(50, 0), new Point2d(-50, 0)));
        Robot body = wearing(21, h1.robot.with(huntersEyes).with(h1.places).with(new FakePlanner("h1")));
        Map<String, ?> arguments = Map.of("assignment", assignment, "sees", "fiducials", "catchDistance", 1.5);
        scene.start("follow", "h1", Optional.of(body), arguments);
        h1.isAt(x, 0);
        scene.advance(1);
    }

    private void hunterSeesMarker(int marker, double ahead) {
        huntersEyes.sees(OptionalInt.of(marker), ahead, 0, scene.scheduler.instant());
        scene.advance(0);
    }

    private void preySeesMarker(int marker, double ahead) {
        preysEyes.sees(OptionalInt.of(marker), ahead, 0, scene.scheduler.instant());
        scene.advance(0);
    }

    @Test
    void preyThatDoNotWantToBeFoundReportTheirPosesToNobody() {
        preyAtOrigin("escape", Map.of("hunter", "hunter", "sees", "fiducials"));
        scene.hear("operator", PoseRequest.TOPIC, new PoseRequest("p1"));
        scene.advance(5);
        assertThat(scene.said("p1", PoseReport.TOPIC)).isEmpty();
    }

    @Test
    void preyGiveUpWhenTheySeeAHunterNearAndNotBecauseItSaysSo() {
        hunterAt(9, "bids");
        preyAtOrigin("escape", Map.of("hunter", "hunter", "sees", "fiducials", "catchDistance", 1.5));
        scene.report("h1", "hunter", 1, 0);
        preySeesMarker(21, 2);
        scene.advance(2);
        assertThat(scene.said("p1", Caught.TOPIC)).isEmpty();
        preySeesMarker(99, 1); // nobody's
        preySeesMarker(21, 1);
        assertThat(scene.said("p1", Caught.TOPIC)).containsExactly(new Caught("p1", "h1", 1));
    }

    @Test
    void aHunterThatWasSeenLongAgoCatchesNobody() {
        hunterAt(9, "bids");
        preyAtOrigin("escape", Map.of("hunter", "hunter", "sees", "fiducials", "catchDistance", 1.5));
        preySeesMarker(21, 3);
        scene.advance(2);
        p1.isAt(3, 0); // where it was
        scene.advance(1);
        assertThat(scene.said("p1", Caught.TOPIC)).isEmpty();
    }

    @Test
    void cleverPreyRunFromHuntersThatTheySeeAndInformTheOthersTwiceASecond() {
        hunterAt(9, "bids");
        p1.places.result = new PlaceFinder.Result.Found(List.of(new Point2d(20, 0), new Point2d(-20, 0)));
        preyAtOrigin("evade", Map.of("hunter", "hunter", "sees", "fiducials"));
        scene.report("h1", "hunter", 4, 0);
        scene.advance(1);
        assertThat(scene.state("p1")).isEqualTo("explore: follow the wall");
        for (int i = 0; i < 10; i++) {
            preySeesMarker(21, 4);
            scene.advance(0.1);
        }
        assertThat(scene.state("p1")).isEqualTo("not be caught: run");
        assertThat(p1.navigator.goals).containsExactly(new Pose2d(-20, 0, 0));
        assertThat(scene.said("p1", Sighting.TOPIC)).hasSize(2).contains(new Sighting("h1", "hunter", at(4)));
    }

    @Test
    void cleverPreyTakeNoPreyThatHuntersReportForAHunter() {
        preyAtOrigin("evade", Map.of("hunter", "hunter", "sees", "fiducials"));
        scene.hear("h9", Sighting.TOPIC, new Sighting("p1", "prey", at(0)));
        scene.advance(2);
        assertThat(scene.state("p1")).isEqualTo("explore: follow the wall");
    }

    @Test
    void huntersGoWhereTheyMaySeePreyUntilOneIsSeen() {
        hunterAt(0, "bids");
        scene.start("hunt", "master", Optional.empty(), Map.of());
        preyAtOrigin("escape", Map.of("hunter", "hunter", "sees", "fiducials"));
        scene.report("p1", "prey", 30, 0); // a hunter with eyes does not listen to prey
        scene.hear("x", Sighting.TOPIC, new Sighting("h7", "hunter", at(8)));
        scene.advance(3);
        assertThat(scene.state("h1")).isEqualTo("going to look around at (50.0, 0.0)");
        hunterSeesMarker(11, 7);
        scene.advance(1);
        assertThat(scene.state("h1")).isEqualTo("hunt p1");
        assertThat(h1.navigator.goals).hasSize(2);
        assertThat(scene.said("h1", Sighting.TOPIC)).containsExactly(new Sighting("p1", "prey", at(7)));
    }

    @Test
    void aPreyThatNobodySeesAnyMoreIsLookedForAndHuntedAgainWhenItIsSeen() {
        hunterAt(0, "bids");
        scene.start("hunt", "master", Optional.empty(), Map.of());
        preyAtOrigin("escape", Map.of("hunter", "hunter", "sees", "fiducials"));
        hunterSeesMarker(11, 7);
        scene.advance(1);
        assertThat(scene.state("master")).isEqualTo("hunting p1");
        scene.advance(12);
        assertThat(scene.state("master")).isEqualTo("looking for prey");
        assertThat(scene.state("h1")).startsWith("going to look around at");
        hunterSeesMarker(11, 3);
        scene.advance(1);
        assertThat(scene.state("h1")).isEqualTo("hunt p1");
        assertThat(h1.navigator.driving()).isTrue();
    }

    @Test
    void huntersThatDoNotBidLookForPreyToo() {
        hunterAt(0, "nearest");
        preyAtOrigin("escape", Map.of("hunter", "hunter", "sees", "fiducials"));
        scene.advance(3);
        assertThat(scene.state("h1")).startsWith("going to look around at");
        scene.hear("h2", Sighting.TOPIC, new Sighting("p1", "prey", at(12)));
        scene.advance(2);
        assertThat(scene.state("h1")).isEqualTo("hunting p1");
        assertThat(h1.navigator.goals).last().isEqualTo(at(12));
        scene.advance(20);
        assertThat(scene.state("h1")).startsWith("going to look around at");
    }

    private static Pose2d at(double x) {
        return new Pose2d(x, 0, 0);
    }
}
