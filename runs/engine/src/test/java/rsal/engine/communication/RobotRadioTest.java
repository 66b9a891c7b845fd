package rsal.engine.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import rsal.agent.Message;
import rsal.agent.message.Text;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.engine.report.RunBroken;
import rsal.engine.robot.GuardedScheduler;
import rsal.robot.TeamLink;
import rsal.scenario.Communication;
import rsal.scenario.fault.Span;
import rsal.time.LockstepScheduler;

class RobotRadioTest {
    private final LockstepScheduler scheduler = new LockstepScheduler();
    private final OccupancyGrid map = new OccupancyGrid(1, 1, 1, 0, 0, new byte[1]);
    private final Set<String> gone = new HashSet<>();
    private final List<String> heard = new ArrayList<>();

    private record Said(String text) {}

    private record Other(int number) {}

    private static Communication limits(double loss, double delay) {
        return new Communication(
                Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, loss, Span.of(delay, delay), Optional.empty(), 5);
    }

    private RobotRadio radio(Optional<Communication> limits) {
        return new RobotRadio(limits, map, scheduler, _ -> Optional.of(new Point2d(0, 0)), gone::contains);
    }

    private TeamLink listening(RobotRadio radio, String robot) {
        TeamLink link = radio.link(robot, UnaryOperator.identity());
        link.onMessage(Said.class, (sender, said) -> heard.add("%s to %s: %s".formatted(sender, robot, said.text)));
        return link;
    }

    @Test
    void allOthersThatAreThereHearWhatTheyListenFor() {
        RobotRadio radio = radio(Optional.empty());
        TeamLink a = listening(radio, "a");
        listening(radio, "b");
        listening(radio, "c");
        a.publish(new Said("hi"));
        a.publish(new Other(1));
        a.send("c", new Said("you"));
        assertThat(heard).containsExactly("a to b: hi", "a to c: hi", "a to c: you");
        heard.clear();
        radio.leave("b");
        gone.add("c");
        a.publish(new Said("nobody"));
        gone.add("a");
        a.send("b", new Said("nobody"));
        assertThat(heard).isEmpty();
    }

    @Test
    void lateMessageIsHeardLater() {
        RobotRadio radio = radio(Optional.of(limits(0, 2)));
        TeamLink a = listening(radio, "a");
        listening(radio, "b");
        a.publish(new Said("hi"));
        scheduler.advance(Duration.ofMillis(1900));
        assertThat(heard).isEmpty();
        scheduler.advance(Duration.ofMillis(200));
        assertThat(heard).containsExactly("a to b: hi");
    }

    @Test
    void deviceThatFailsWhenItHearsSomethingIsToBlameAndNotTheSpeaker() {
        for (double delay : new double[] {0, 1}) {
            RobotRadio radio = radio(Optional.of(limits(0, delay)));
            var laneOfA = new GuardedScheduler("Device 'a/x'", scheduler);
            var laneOfB = new GuardedScheduler("Device 'b/x'", scheduler);
            TeamLink a = radio.link("a", laneOfA::guarded);
            radio.link("b", laneOfB::guarded).onMessage(Said.class, (_, _) -> {
                throw new IllegalStateException("Broken.");
            });
            laneOfA.execute(() -> a.publish(new Said("hi")));
            assertThatThrownBy(() -> scheduler.advance(Duration.ofSeconds(2)))
                    .isInstanceOf(RunBroken.class)
                    .hasMessageStartingWith("Device 'b/x'");
        }
    }

    @Test
    void deviceThatHasLeftHearsNothing() {
        RobotRadio radio = radio(Optional.empty());
        var lane = new GuardedScheduler("Device 'b/x'", scheduler);
        radio.link("b", lane::guarded).onMessage(Said.class, (_, said) -> heard.add(said.text));
        TeamLink a = radio.link("a", UnaryOperator.identity());
        a.publish(new Said("first"));
        lane.end();
        a.publish(new Said("second"));
        assertThat(heard).containsExactly("first");
    }

    @Test
    void lossesAreNotThoseOfTheAgents() {
        RobotRadio radio = radio(Optional.of(limits(0.5, 0)));
        var agents = new Radio(limits(0.5, 0), map, UnaryOperator.identity(), _ -> Optional.of(new Point2d(0, 0)));
        TeamLink a = listening(radio, "a");
        listening(radio, "b");
        var byDevices = new ArrayList<Boolean>();
        var byAgents = new ArrayList<Boolean>();
        for (int i = 0; i < 200; i++) {
            heard.clear();
            a.publish(new Said("hi"));
            byDevices.add(!heard.isEmpty());
            var message = new Message<>(Text.TOPIC, "a", "", scheduler.instant(), new Text("hi"));
            byAgents.add(!agents.copies(message, "b").isEmpty());
        }
        assertThat(byDevices).contains(true, false).isNotEqualTo(byAgents);
    }
}
