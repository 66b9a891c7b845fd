package rsal.agents.pursuit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import org.junit.jupiter.api.Test;
import rsal.agent.message.GoalReached;
import rsal.agent.message.PoseReport;
import rsal.agents.FakeRobot;
import rsal.agents.Scene;
import rsal.data.Twist2d;

class EscapeTest {
    private final Scene scene = new Scene();
    private final FakeRobot p1 = scene.robot("p1", "prey");

    @Test
    void followsTheWallWhileHuntersAreFar() {
        preyAtOrigin(Map.of("catchDistance", 2.0));
        scene.report("h1", "hunter", 2, 0); // 2 m is not nearer than 2 m
        scene.advance(5);
        assertThat(scene.said("p1", Caught.TOPIC)).isEmpty();
        assertThat(scene.state("p1")).isEqualTo("following the wall");
        assertThat(p1.pilot.engaged()).isTrue();
    }

    @Test
    void givesUpOnceWhenAHunterIsNear() {
        preyAtOrigin(Map.of());
        scene.report("h1", "hunter", 1.9, 0);
        scene.report("h2", "hunter", 1, 0);
        scene.report("h1", "hunter", 1.5, 0);
        assertThat(scene.said("p1", Caught.TOPIC)).containsExactly(new Caught("p1", "h1", 1.9));
        assertThat(scene.state("p1")).isEqualTo("caught by h1");
    }

    @Test
    void needsAsManyHuntersAtOnceAsItIsAsked() {
        preyAtOrigin(Map.of("catchers", 2));
        scene.report("h1", "hunter", 1, 0);
        scene.report("h1", "hunter", 1.2, 0);
        scene.report("h2", "hunter", 3, 0);
        assertThat(scene.said("p1", Caught.TOPIC)).isEmpty();
        scene.report("h2", "hunter", 1.8, 0);
        assertThat(scene.said("p1", Caught.TOPIC)).containsExactly(new Caught("p1", "h1", 1.2));
    }

    @Test
    void noticesThatItHasRunIntoAHunter() {
        preyAtOrigin(Map.of());
        scene.report("h1", "hunter", 5, 0);
        scene.report("h2", "hunter", 4.5, 0);
        p1.isAt(4, 0);
        scene.advance(1);
        assertThat(scene.said("p1", Caught.TOPIC)).containsExactly(new Caught("p1", "h2", 0.5));
    }

    @Test
    void caughtPreySpins40DegreesASecondFor15SecondsAndThenStandsStill() {
        p1.wakeBase();
        preyAtOrigin(Map.of());
        scene.advance(1);
        scene.report("h1", "hunter", 1, 0);
        p1.base.commands.clear();
        scene.advance(14.9);
        assertThat(p1.base.commands)
                .hasSize(149)
                .allSatisfy(twist -> assertThat(twist.omega()).isCloseTo(Math.toRadians(40), within(1e-12)))
                .allSatisfy(twist -> assertThat(twist.speed()).isZero());
        scene.advance(0.1);
        assertThat(p1.base.commands.getLast()).isEqualTo(Twist2d.STOP);
        int commands = p1.base.commands.size();
        scene.advance(60);
        assertThat(p1.base.commands).hasSize(commands);
        assertThat(scene.state("p1")).isEqualTo("caught by h1");
    }

    @Test
    void caughtPreyKeepsReportingItsPose() {
        preyAtOrigin(Map.of());
        scene.report("h1", "hunter", 1, 0);
        int before = scene.said("p1", PoseReport.TOPIC).size();
        p1.isAt(0.1, 0);
        scene.advance(1);
        assertThat(scene.said("p1", PoseReport.TOPIC)).hasSize(before + 1);
    }

    @Test
    void caughtPreyDropsItsErrandAndTakesNoMore() {
        preyAtOrigin(Map.of());
        scene.order("p1", 5, 5);
        scene.report("h1", "hunter", 1, 0);
        assertThat(p1.navigator.driving()).isFalse();
        assertThat(scene.said("p1", GoalReached.TOPIC))
                .extracting(GoalReached::ending)
                .containsExactly("cancelled");
        scene.order("p1", 6, 6);
        scene.advance(20);
        assertThat(p1.navigator.goals).hasSize(1);
        assertThat(p1.pilot.engaged()).isFalse();
        assertThat(scene.state("p1")).isEqualTo("caught by h1");
    }

    @Test
    void isCaughtByItsHuntersOnlyWhenItKnowsThem() {
        preyAtOrigin(Map.of("hunter", "hunter"));
        scene.report("p2", "prey", 1, 0);
        assertThat(scene.said("p1", Caught.TOPIC)).isEmpty();
        scene.report("h1", "hunter", 1, 0);
        assertThat(scene.said("p1", Caught.TOPIC)).hasSize(1);
    }

    @Test
    void hunterNotHeardOfForLongCatchesNobody() {
        preyAtOrigin(Map.of());
        scene.report("h1", "hunter", 5, 0);
        scene.advance(10);
        p1.isAt(5, 0);
        scene.advance(1);
        assertThat(scene.said("p1", Caught.TOPIC)).isEmpty();
    }

    @Test
    void aHuntEndsWithAHunterAtRestAndAPreyThatSpins() {
        FakeRobot h1 = scene.robot("h1", "hunter");
        scene.start("follow", h1, Map.of());
        preyAtOrigin(Map.of());
        h1.isAt(10, 0);
        scene.advance(1);
        assertThat(h1.navigator.driving()).isTrue();
        h1.isAt(1.5, 0);
        scene.advance(1);
        assertThat(h1.navigator.driving()).isFalse();
        assertThat(scene.said("p1", Caught.TOPIC)).containsExactly(new Caught("p1", "h1", 1.5));
        assertThat(scene.state("h1")).isEqualTo("looking for more prey");
        assertThat(p1.pilot.engaged()).isTrue(); // to spin
    }

    private void preyAtOrigin(Map<String, ?> arguments) {
        scene.start("escape", p1, arguments);
        p1.isAt(0, 0);
        scene.advance(0);
    }
}
