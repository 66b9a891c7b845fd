package rsal.engine.agent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import rsal.agent.message.Hello;
import rsal.agent.message.PoseReport;
import rsal.agent.message.Text;
import rsal.agents.exploration.Lookout;
import rsal.agents.patrol.Watch;
import rsal.agents.rescue.VictimHelped;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.engine.report.OperatorMessage;
import rsal.engine.report.OperatorMessage.Field;
import rsal.engine.report.OperatorMessage.Kind;

class OperatorMessagesTest {
    private static Object read(String topic, Map<String, String> typed) {
        return OperatorMessages.read(topic, typed).message();
    }

    @Test
    void whatCanBeTypedCanBeSaid() {
        assertThat(OperatorMessages.ALL)
                .contains(
                        new OperatorMessage("text", List.of(new Field("words", Kind.WORDS, List.of()))),
                        new OperatorMessage(
                                "lookout",
                                List.of(
                                        new Field("robot", Kind.WORDS, List.of()),
                                        new Field("mapFromPlace", Kind.PLACE, List.of()),
                                        new Field("done", Kind.CHOICE, List.of("true", "false")))))
                .extracting(OperatorMessage::topic)
                .doesNotContain("ranks", "map-ends", "collected");
    }

    @Test
    void eachKindOfFieldIsRead() {
        assertThat(read("text", Map.of("words", " Go home! "))).isEqualTo(new Text("Go home!"));
        assertThat(read("lookout", Map.of("robot", "r1", "mapFromPlace", "3, -4.5", "done", "true")))
                .isEqualTo(new Lookout("r1", new Point2d(3, -4.5), true));
        assertThat(read("watch", Map.of("mapFromPlaces", "1 2; 3 4")))
                .isEqualTo(new Watch(List.of(new Point2d(1, 2), new Point2d(3, 4))));
        assertThat(read("pose", Map.of("robot", "r1", "role", "scout", "mapFromBase", "1 2 90")))
                .isEqualTo(new PoseReport("r1", "scout", new Pose2d(1, 2, Math.PI / 2)));
        assertThat(read("victim-helped", Map.of("victim", "7"))).isEqualTo(new VictimHelped(7));
        assertThat(read("hello", Map.of("robot", "r1", "kind", "PING", "to", "")))
                .isEqualTo(new Hello("r1", Hello.Kind.PING, ""));
    }

    @Test
    void whatDoesNotFitIsReportedByField() {
        assertThatThrownBy(() -> read("lookout", Map.of("robot", "r1", "mapFromPlace", "3", "done", "true")))
                .hasMessage("Field 'mapFromPlace' takes x and y [m]: 3 4.5, not '3'.");
        assertThatThrownBy(() -> read("lookout", Map.of("robot", "r1", "mapFromPlace", "3 NaN", "done", "true")))
                .hasMessageContaining("'mapFromPlace' takes x and y");
        assertThatThrownBy(() -> read("lookout", Map.of("robot", "r1", "mapFromPlace", "3 4", "done", "maybe")))
                .hasMessage("Field 'done' takes one of [true, false], not 'maybe'.");
        assertThatThrownBy(() -> read("victim-helped", Map.of("victim", "7.5")))
                .hasMessage("Field 'victim' takes a whole number, not '7.5'.");
        assertThatThrownBy(() -> read("victim-helped", Map.of())).hasMessageContaining("'victim'");
        assertThatThrownBy(() -> read("caught", Map.of("prey", "p", "hunter", "h", "distance", "-1")))
                .hasMessage("This is not a 'caught': A hunter must be at some distance, not '-1.0'.");
        assertThatThrownBy(() -> read("text", Map.of("words", " ")))
                .hasMessage("Field 'words' takes words, and is empty.");
        assertThatThrownBy(() -> read("pose-request", Map.of())).hasMessage("Field 'robot' takes words, and is empty.");
        assertThatThrownBy(() -> read("ranks", Map.of())).hasMessageStartingWith("People can't send messages on topic");
    }
}
