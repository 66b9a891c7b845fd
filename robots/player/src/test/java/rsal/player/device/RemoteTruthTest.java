package rsal.player.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.data.Pose2d;
import rsal.player.message.Chars;
import rsal.player.message.Interface;
import rsal.player.message.Pose;
import rsal.player.message.Simulation;
import rsal.player.wire.Address;
import rsal.player.wire.Packet;

/// Simulations of servers that say what a test has them say.
@Timeout(60)
class RemoteTruthTest extends ScriptedBench {
    private static final Address SIMULATION = Address.of(Interface.SIMULATION.code(), 0);

    private RemoteTruth truth;

    RemoteTruthTest() {
        super(SIMULATION);
    }

    @BeforeEach
    void begin() throws IOException {
        meet(IDENT);
        awaitKnown();
        truth = on(() -> {
            RemoteTruth its = RemoteTruth.in(List.of(remote), Map.of("r1", "robot1"), time)
                    .orElseThrow();
            its.start();
            return its;
        });
        start();
    }

    private Optional<Pose2d> look() {
        return on(() -> truth.truth("r1"));
    }

    /// Waits for the next question.
    private Packet asked() throws IOException {
        Packet asked = client.next(SIMULATION, Simulation.POSE);
        assertThat(Chars.text(asked.body(Simulation.Placed.class).name())).isEqualTo("robot1");
        return asked;
    }

    private void publish(String name, double x) throws IOException {
        client.acknowledge(asked(), new Simulation.Placed(Chars.of(name), new Pose(x, 2, 0.5)));
    }

    private void untilSeen(double x) {
        until(() -> truth.truth("r1"), pose -> pose.isPresent() && pose.get().x() == x);
    }

    @Test
    void nobodyIsAskedUnlessSomebodyLooks() throws IOException {
        client.socket().setSoTimeout(400);
        assertThat(asks(() -> {})).isZero();
        client.socket().setSoTimeout(10_000);
        look();
        publish("robot1", 1);
        untilSeen(1);
    }

    @Test
    void itIsAskedNoMoreThanOnceBeforeItAnswers() throws IOException {
        look();
        asked();
        client.socket().setSoTimeout(500);
        assertThat(asks(this::look)).as("without an answer").isZero();
    }

    /// Questions until none comes for a while.
    private int asks(Runnable meanwhile) {
        int asks = 0;
        try {
            while (true) {
                meanwhile.run();
                Packet next = client.next();
                asks += next.header().address().equals(SIMULATION) ? 1 : 0;
            }
        } catch (IOException e) {
            return asks;
        }
    }

    @Test
    void whatIsNoAnswerSaysNothing() throws IOException {
        look();
        publish("robot1", 1);
        untilSeen(1);
        publish("robot2", 5);
        untilLost();
        publish("robot1", 1);
        untilSeen(1);
        publish("robot1", Double.NaN);
        untilLost();
        publish("robot1", 1);
        untilSeen(1);
        client.refuse(asked());
        untilLost();
        publish("robot1", 3);
        untilSeen(3);
    }

    private void untilLost() {
        until(() -> truth.truth("r1"), Optional::isEmpty);
    }

    @Test
    void whatIsOnItsWayWhileARobotIsPlacedCountsNoMore() throws IOException {
        look();
        Packet before = asked();
        run(() -> truth.place("r1", new Pose2d(7, 2, 0.5)));
        Packet place = client.next(SIMULATION, Simulation.SET_POSE);
        assertThat(place.body(Simulation.Placed.class).pose()).isEqualTo(new Pose(7, 2, 0.5));
        client.acknowledge(before, new Simulation.Placed(Chars.of("robot1"), new Pose(1, 2, 0.5)));
        client.acknowledge(place);
        assertThat(look()).isEmpty();
        publish("robot1", 7);
        untilSeen(7);
    }
}
