package rsal.agents.formation;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.junit.jupiter.api.Test;
import rsal.agent.Topic;
import rsal.agent.platform.AgentPlatform.Status;
import rsal.agent.protocol.Act;
import rsal.agents.FakeRobot;
import rsal.agents.Scene;
import rsal.data.Path2d;
import rsal.data.Pose2d;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.Planner;

class FormationTest {
    private final Scene scene = new Scene();
    private final Map<String, FakeRobot> robots = new TreeMap<>();

    /// Ways are straight, but nobody can be beside the way between two places.
    private static final class Corridor extends DeviceCore implements Planner {
        private final double from;
        private final double to;

        Corridor(String robot, double from, double to) {
            super(new DeviceInfo(robot, "planner", "fake"));
            this.from = from;
            this.to = to;
        }

        @Override
        public CompletionStage<Result> plan(Pose2d mapFromStart, Pose2d mapFromGoal) {
            boolean inWall = mapFromGoal.x() > from && mapFromGoal.x() < to && Math.abs(mapFromGoal.y()) > 0.5;
            var path = new Path2d(List.of(mapFromStart.position(), mapFromGoal.position()));
            return CompletableFuture.completedFuture(
                    inWall ? new Result.NoPath("a wall") : new Result.Found(path, path.length(), 0));
        }
    }

    private void robot(String id, double x, double y, double wallFrom, double wallTo) {
        FakeRobot robot = scene.robot(id, "rover");
        robots.put(id, robot);
        scene.start(
                "swarm", id, Optional.of(robot.robot.with(new Corridor(id, wallFrom, wallTo))), Map.of("idle", "wait"));
        robot.isAt(x, y);
    }

    private void formation(String shape, String route) {
        scene.start(
                "formation",
                "formation",
                Optional.empty(),
                Map.of("shape", shape, "route", route, "spacing", 2, "speed", 0.5));
    }

    private FormationSlots ranks() {
        return scene.said("formation", FormationSlots.TOPIC).getLast();
    }

    /// All are where they should be, for a while.
    private void march(double seconds) {
        for (double t = 0;
                t < seconds
                        && scene.said("formation", new Topic<>("go", Act.class)).isEmpty();
                t += 0.5) {
            ranks().slots()
                    .forEach((id, slot) -> robots.get(id)
                            .isAt(slot.mapFromAim().x(), slot.mapFromAim().y()));
            scene.advance(0.5);
        }
    }

    @Test
    void eachGetsThePlaceThatIsBestForAllAndDrivesThere() {
        robot("a", 0, 5, 99, 99);
        robot("b", 0, -5, 99, 99);
        robot("c", 0, 0.1, 99, 99);
        formation("line", "0 0; 20 0");
        scene.advance(4);
        assertThat(ranks().shape()).isEqualTo("line");
        assertThat(ranks().formed()).isFalse();
        assertThat(ranks().slots().get("a").mapFromSlot().y()).isEqualTo(2);
        assertThat(ranks().slots().get("b").mapFromSlot().y()).isEqualTo(-2);
        assertThat(ranks().slots().get("c").mapFromSlot().y()).isZero();
        assertThat(robots.get("a").navigator.goals.getLast().position())
                .isEqualTo(ranks().slots().get("a").mapFromAim().position());
        assertThat(scene.state("a")).isEqualTo("keeping its place in a line");
    }

    @Test
    void waitsForThoseWhoLagAndThenGoes() {
        robot("a", 0, 5, 99, 99);
        robot("b", 0, -5, 99, 99);
        formation("line", "0 0; 20 0");
        scene.advance(10);
        assertThat(ranks().slots().get("a").mapFromSlot().x()).isZero();
        march(10);
        assertThat(ranks().formed()).isTrue();
        assertThat(ranks().slots().get("a").mapFromSlot().x()).isBetween(3.0, 5.0);
    }

    @Test
    void goesInAColumnWhereItIsNarrowAndTakesItsShapeAgainBehind() {
        robot("a", 0, 2, 12, 20);
        robot("b", 0, 0, 12, 20);
        robot("c", 0, -2, 12, 20);
        formation("line", "0 0; 40 0");
        scene.advance(3);
        assertThat(ranks().shape()).isEqualTo("line");
        march(30);
        FormationSlots narrow = ranks();
        assertThat(narrow.shape()).isEqualTo("column");
        assertThat(narrow.slots().values())
                .extracting(slot -> slot.mapFromSlot().y())
                .containsOnly(0.0);
        march(40);
        assertThat(ranks().shape()).isEqualTo("line");
        march(60);
        assertThat(scene.state("formation")).isEqualTo("has arrived");
        scene.advance(1);
        assertThat(robots.values())
                .extracting(robot -> robot.navigator.goals.getLast().x())
                .containsOnly(40.0);
    }

    @Test
    void closesRanksWhenOneFallsSilentAndTakesItInAgain() {
        for (int i = 0; i < 4; i++) {
            robot("r" + i, 0, 2 * i - 3, 99, 99);
        }
        formation("line", "0 0; 100 0");
        scene.advance(3);
        march(5);
        assertThat(ranks().slots()).hasSize(4);
        scene.platform.deliverBy((message, listener) ->
                message.sender().equals("r1") || listener.equals("r1") ? List.of() : List.of(Duration.ZERO));
        march(4.5);
        assertThat(ranks().slots().keySet()).containsExactly("r0", "r2", "r3");
        assertThat(ranks().slots().values())
                .extracting(slot -> slot.mapFromSlot().y())
                .containsExactlyInAnyOrder(-2.0, 0.0, 2.0);
        scene.platform.deliverBy((_, _) -> List.of(Duration.ZERO));
        robots.get("r1").isAt(4, -1);
        march(2);
        assertThat(ranks().slots()).hasSize(4);
    }

    @Test
    void robotStopsWhenNothingIsHeardOfTheFormationAnyMore() {
        robot("a", 0, 5, 99, 99);
        formation("line", "0 0; 20 0");
        scene.advance(4);
        assertThat(robots.get("a").navigator.driving()).isTrue();
        scene.platform.stop("formation");
        scene.advance(5);
        assertThat(robots.get("a").navigator.driving()).isFalse();
        assertThat(scene.state("a")).isEqualTo("waiting for a goal");
    }

    @Test
    void errandsComeFirst() {
        robot("a", 0, 5, 99, 99);
        formation("line", "0 0; 20 0");
        scene.advance(4);
        scene.order("a", 7, 7);
        scene.advance(2);
        assertThat(robots.get("a").navigator.goals.getLast()).isEqualTo(new Pose2d(7, 7, 0));
        robots.get("a").navigator.reach();
        scene.advance(1);
        assertThat(scene.state("a")).isEqualTo("keeping its place in a line");
    }

    @Test
    void saysWhyThereIsNoWay() {
        robot("a", 0, 0, 10, 30);
        formation("line", "0 0; 20 5");
        scene.advance(3);
        assertThat(scene.state("formation")).contains("has no way", "(20.0, 5.0)", "a wall");
    }

    @Test
    void needsARoute() {
        formation("line", "0 0");
        assertThat(scene.view("formation").status()).isEqualTo(Status.FAILED);
        assertThat(scene.state("formation")).contains("'formation'", "at least two places");
    }
}
