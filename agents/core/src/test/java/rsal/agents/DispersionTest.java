package rsal.agents;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import rsal.agent.message.NewGoal;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Navigator.Result;

class DispersionTest {
    private final Scene scene = new Scene();
    private final Map<String, FakeRobot> robots = new TreeMap<>();

    private void robot(String id, double x, double y) {
        FakeRobot robot = scene.robot(id, "nav");
        robots.put(id, robot);
        scene.start("nav", robot, Map.of("period", 0.5));
        robot.isAt(x, y);
    }

    private void dispersion(String places) {
        scene.start(
                "dispersion",
                "dispersion",
                Optional.empty(),
                Map.of("places", places, "pingInterval", 1, "dispersionInterval", 20));
    }

    /// Where each was sent last.
    private Map<String, Point2d> sent() {
        var goals = new TreeMap<String, Point2d>();
        scene.said("dispersion", NewGoal.TOPIC)
                .forEach(goal -> goals.put(goal.robot(), goal.mapFromGoal().position()));
        return goals;
    }

    @Test
    void eachRobotIsSentToAPlaceOfItsOwnThatIsNear() {
        robot("a", 0, 0);
        robot("b", 10, 0);
        dispersion("9 0; 1 0; 50 50");
        scene.advance(4);
        assertThat(sent()).isEqualTo(Map.of("a", new Point2d(1, 0), "b", new Point2d(9, 0)));
        assertThat(scene.state("dispersion")).isEqualTo("0 of 2 robots are at their place");
    }

    @Test
    void thoseWhoAreThereAreLeftInPeaceAndThoseWhoFailedAreSentAgain() {
        robot("a", 0, 0);
        robot("b", 10, 0);
        dispersion("9 0; 1 0");
        scene.advance(4);
        robots.get("a").navigator.end(new Result.Reached(new Pose2d(1, 0, 0)));
        robots.get("b").navigator.end(new Result.NoPath("A wall."));
        scene.advance(1);
        assertThat(scene.state("dispersion")).isEqualTo("1 of 2 robots are at their place");
        int before = scene.said("dispersion", NewGoal.TOPIC).size();
        scene.advance(20);
        List<NewGoal> again = scene.said("dispersion", NewGoal.TOPIC);
        assertThat(again.subList(before, again.size()).stream().map(NewGoal::robot))
                .containsExactly("b");
    }

    @Test
    void placeOfOneThatFallsSilentIsGivenToAnother() {
        robot("a", 0, 0);
        robot("b", 10, 0);
        dispersion("0 1; 10 1");
        scene.advance(4);
        scene.society.deliverBy((message, listener) ->
                message.sender().equals("b") || listener.equals("b") ? List.of() : List.of(Duration.ZERO));
        scene.advance(2);
        robot("c", 20, 0);
        scene.advance(8);
        assertThat(sent()).containsEntry("c", new Point2d(10, 1)).containsEntry("a", new Point2d(0, 1));
    }

    @Test
    void withoutPlacesItSaysWhatToSet() {
        dispersion("");
        assertThat(scene.state("dispersion")).contains("(dispersion)").contains("(places)");
    }
}
