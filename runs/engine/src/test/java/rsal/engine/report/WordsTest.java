package rsal.engine.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.agent.Message;
import rsal.agent.Topic;
import rsal.agent.message.GoalReached;
import rsal.agent.message.Hello;
import rsal.agent.message.NewGoal;
import rsal.agent.message.PoseReport;
import rsal.agent.message.PoseRequest;
import rsal.agent.message.Text;
import rsal.agent.protocol.Act;
import rsal.agent.protocol.Performative;
import rsal.agent.protocol.Side;
import rsal.agents.charging.ChargerTaken;
import rsal.agents.exploration.Lookout;
import rsal.agents.foraging.CollectGoal;
import rsal.agents.foraging.Collected;
import rsal.agents.foraging.Depot;
import rsal.agents.patrol.Alarm;
import rsal.agents.patrol.Visited;
import rsal.agents.patrol.Watch;
import rsal.agents.pursuit.Caught;
import rsal.agents.pursuit.Chase;
import rsal.agents.pursuit.Sighting;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.device.Navigator.Result;

class WordsTest {
    private static final Pose2d PLACE = Pose2d.ofDegrees(1, -2.5, 90);

    static List<Record> messages() {
        return List.of(
                new Caught("prey-1", "hunter-1", 1.234),
                new Chase("hunter-1", "prey-1"),
                new Chase("hunter-1", ""),
                new CollectGoal(Rgb.of(0x2ca02c), PLACE.position()),
                new Collected("r-1", new CollectGoal(Rgb.of(0x2ca02c), PLACE.position()), PLACE.position()),
                new Depot("r-1", PLACE.position(), 1.5),
                new Lookout("r-1", PLACE.position(), true),
                new Lookout("r-1", PLACE.position(), false),
                new Sighting("hunter-1", "hunter", PLACE),
                new Visited("r-1", PLACE.position()),
                new Alarm("r-1", PLACE.position()),
                new ChargerTaken("r-1", PLACE.position()),
                new Watch(List.of(PLACE.position(), PLACE.position())),
                new GoalReached("hunter-1", PLACE, "stuck", "A box is ahead."),
                new Hello("hunter-1", Hello.Kind.PONG, "prey-1"),
                new NewGoal("hunter-1", PLACE),
                new PoseReport("hunter-1", "hunter", PLACE),
                new PoseRequest("hunter-1"),
                new Text("Where is everybody?"));
    }

    @ParameterizedTest
    @MethodSource("messages")
    void ourOwnMessagesReadAsSentences(Record content) {
        var message = new Message<>(new Topic<>("any", Record.class), "follow-1", "", Instant.EPOCH, content);
        assertThat(Words.of(message)).doesNotContain("[", "=").isNotBlank();
    }

    @Test
    void whatIsSaidInConversationsSaysToWhom() {
        var content = new Act(
                Performative.REQUEST,
                "fipa-request",
                "x",
                Side.INITIATOR,
                1,
                0,
                Optional.empty(),
                new NewGoal("r1", PLACE));
        var request = new Message<>(new Topic<>("go", Act.class), "zoe", "nav-1", Instant.EPOCH, content);
        assertThat(Words.of(request)).isEqualTo("nav-1, request: r1, go to (1.00, -2.50, 90°)");
        var agree = new Act(Performative.AGREE, "fipa-request", "x", Side.PARTICIPANT, 1, 1, Optional.empty(), "");
        assertThat(Words.of(new Message<>(new Topic<>("go", Act.class), "nav-1", "zoe", Instant.EPOCH, agree)))
                .isEqualTo("zoe, agree");
    }

    @Test
    void goalsThatAreNotReachedSayWhy() {
        assertThat(Words.of(new Result.Stuck(PLACE, Duration.ofMinutes(2), "A box is ahead.")))
                .isEqualTo("stuck. A box is ahead.");
        assertThat(Words.of(new Result.NoPath("It is in a wall."))).isEqualTo("no path. It is in a wall.");
    }
}
