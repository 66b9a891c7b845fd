package rsal.agents;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import rsal.agent.Topic;
import rsal.agent.message.NewGoal;
import rsal.agent.protocol.Act;
import rsal.agent.protocol.Performative;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Navigator.Result;

class DispersionTest {
    private final Scene scene = new Scene();
    private final Set<String> isFirst = new HashSet<>(); // conversations, seen once
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

    private List<NewGoal> orders() {
        return scene.said("dispersion", new Topic<>("go", Act.class)).stream()
                .filter(act -> act.performative() == Performative.REQUEST && isFirst.add(act.conversation()))
                .map(act -> (NewGoal) act.content())
                .toList();
    }

    /// Where each was sent last.
    private Map<String, Point2d> sent() {
        var goals = new TreeMap<String, Point2d>();
        orders().forEach(goal -> goals.put(goal.robot(), goal.mapFromGoal().position()));
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
    void thoseWhoAreThereAreLeftInPeaceAndThoseWhoFailedAreSentElsewhere() {
        robot("a", 0, 0);
        robot("b", 10, 0);
        dispersion("9 0; 1 0; 12 0");
        scene.advance(4);
        robots.get("a").navigator.end(new Result.Reached(new Pose2d(1, 0, 0)));
        robots.get("b").navigator.end(new Result.NoPath("A wall."));
        scene.advance(1);
        assertThat(scene.state("dispersion")).isEqualTo("1 of 2 robots are at their place");
        orders();
        scene.advance(20);
        assertThat(orders()).containsExactly(new NewGoal("b", new Pose2d(12, 0, 0)));
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
