package rsal.agents.coverage;

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
import rsal.agents.FakeRobot;
import rsal.agents.Scene;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Navigator.Result;
import rsal.device.PlaceFinder;

class DeploymentAgentTest {
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
                "deployment",
                "deployment",
                Optional.empty(),
                Map.of("places", places, "pingInterval", 1, "allocationInterval", 20));
    }

    private List<NewGoal> orders() {
        return scene.said("deployment", new Topic<>("go", Act.class)).stream()
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
        assertThat(scene.state("deployment")).isEqualTo("0 of 2 robots have reached their place");
    }

    @Test
    void thoseWhoAreThereAreLeftInPeaceAndThoseWhoFailedAreSentElsewhere() {
        robot("a", 0, 0);
        robot("b", 10, 0);
        dispersion("9 0; 1 0; 12 0");
        scene.advance(4);
        robots.get("a").isAt(1, 0);
        robots.get("a").navigator.end(new Result.Reached(new Pose2d(1, 0, 0)));
        robots.get("b").navigator.end(new Result.NoPath("A wall."));
        scene.advance(1);
        assertThat(scene.state("deployment")).isEqualTo("1 of 2 robots have reached their place");
        orders();
        scene.advance(20);
        assertThat(orders()).containsExactly(new NewGoal("b", new Pose2d(12, 0, 0)));
    }

    @Test
    void thoseWhoHaveLeftTheirPlaceAreSentBackTheNextTime() {
        robot("a", 0, 0);
        robot("b", 10, 0);
        dispersion("9 0; 1 0");
        scene.advance(4);
        robots.get("a").isAt(1.2, 0);
        robots.get("a").navigator.end(new Result.Reached(new Pose2d(1, 0, 0)));
        robots.get("b").isAt(9, 0);
        robots.get("b").navigator.end(new Result.Reached(new Pose2d(9, 0, 0)));
        scene.advance(2);
        robots.get("b").isAt(14, 3); // back at work
        orders();
        scene.advance(10);
        assertThat(orders()).isEmpty(); // it is left to work until it is time
        scene.advance(8);
        assertThat(orders()).containsExactly(new NewGoal("b", new Pose2d(9, 0, 0)));
    }

    @Test
    void placeOfOneThatFallsSilentIsGivenToAnother() {
        robot("a", 0, 0);
        robot("b", 10, 0);
        dispersion("0 1; 10 1");
        scene.advance(4);
        scene.platform.deliverBy((message, listener) ->
                message.sender().equals("b") || listener.equals("b") ? List.of() : List.of(Duration.ZERO));
        scene.advance(2);
        robot("c", 20, 0);
        scene.advance(8);
        assertThat(sent()).containsEntry("c", new Point2d(10, 1)).containsEntry("a", new Point2d(0, 1));
    }

    private FakeRobot finder(String id, double x) {
        FakeRobot robot = scene.robot(id, "nav");
        robots.put(id, robot);
        scene.start("nav", id, Optional.of(robot.robot.with(robot.places)), Map.of("period", 0.5));
        robot.isAt(x, 0);
        return robot;
    }

    private static PlaceFinder.Result found(Point2d... places) {
        return new PlaceFinder.Result.Found(List.of(places));
    }

    @Test
    void placesAreFoundByARobotThatCanAsManyAsThereAreRobots() {
        FakeRobot a = finder("a", 0);
        robot("b", 10, 0);
        a.places.result = found(new Point2d(9, 0), new Point2d(1, 0));
        dispersion("");
        scene.advance(4);
        assertThat(a.places.asked).containsExactly("2 from (0.0, 0.0), 0.4 m, rooms");
        assertThat(sent()).isEqualTo(Map.of("a", new Point2d(1, 0), "b", new Point2d(9, 0)));
    }

    @Test
    void anotherRobotIsAskedWhenOneFails() {
        FakeRobot a = finder("a", 0);
        FakeRobot b = finder("b", 10);
        a.places.result = new PlaceFinder.Result.None("There is no room.");
        b.places.result = found(new Point2d(9, 0), new Point2d(1, 0));
        dispersion("");
        scene.advance(4);
        assertThat(a.places.asked).hasSize(1);
        assertThat(sent()).isEqualTo(Map.of("a", new Point2d(1, 0), "b", new Point2d(9, 0)));
    }

    @Test
    void anotherRobotIsAskedWhenOneIsSilent() {
        FakeRobot a = finder("a", 0);
        FakeRobot b = finder("b", 10);
        b.places.result = found(new Point2d(9, 0), new Point2d(1, 0));
        dispersion("");
        scene.platform.deliverBy(
                (message, _) -> // its poses are heard, so that it counts as there
                message.sender().equals("a") && message.content() instanceof Act ? List.of() : List.of(Duration.ZERO));
        scene.advance(10);
        assertThat(a.places.asked).isNotEmpty();
        assertThat(b.places.asked).isNotEmpty();
        assertThat(sent()).containsEntry("b", new Point2d(9, 0));
    }

    @Test
    void placesAreFoundAgainWhenTheNumberOfRobotsChanges() {
        FakeRobot a = finder("a", 0);
        a.places.result = found(new Point2d(1, 0));
        dispersion("");
        scene.advance(4);
        assertThat(sent()).isEqualTo(Map.of("a", new Point2d(1, 0)));
        scene.advance(25); // they are not looked for each time that they are allotted
        assertThat(a.places.asked).hasSize(1);
        a.places.result = found(new Point2d(-5, 0), new Point2d(5, 0));
        robot("b", 10, 0);
        scene.advance(4);
        assertThat(a.places.asked).hasSize(2);
        assertThat(sent()).isEqualTo(Map.of("a", new Point2d(-5, 0), "b", new Point2d(5, 0)));
        assertThat(scene.state("deployment")).isEqualTo("0 of 2 robots have reached their place");
    }

    @Test
    void withoutPlacesItSaysWhatItWaitsFor() {
        dispersion("");
        scene.advance(4);
        assertThat(scene.state("deployment")).isEqualTo("waiting for robots");
        robot("b", 10, 0);
        scene.advance(4);
        assertThat(scene.state("deployment")).isEqualTo("waiting for a robot that can find places");
        FakeRobot a = finder("a", 0);
        a.places.result = new PlaceFinder.Result.None("There is no room.");
        scene.advance(4);
        assertThat(scene.state("deployment")).isEqualTo("found no places: There is no room.");
    }
}
