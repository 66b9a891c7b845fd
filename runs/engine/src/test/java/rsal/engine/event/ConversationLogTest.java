package rsal.engine.event;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.agent.Message;
import rsal.agent.Topic;
import rsal.agent.protocol.Act;
import rsal.agent.protocol.Performative;
import rsal.agent.protocol.Side;
import rsal.engine.report.SpeechAct;

class ConversationLogTest {
    private static final Topic<Act> DOORS = new Topic<>("doors", Act.class);

    private final ConversationLog talks = new ConversationLog(RunClock.started(() -> Instant.EPOCH));

    private static Message<Act> message(String from, String to, int number, Object content) {
        var act = new Act(
                Performative.REQUEST,
                "fipa-request",
                from + ":1",
                Side.INITIATOR,
                number,
                0,
                Optional.empty(),
                content);
        return new Message<>(DOORS, from, to, Instant.EPOCH.plusSeconds(3), act);
    }

    @Test
    void bothPartnersHaveWhatWasSaidAndHowOften() {
        Message<Act> said = message("amy", "bob", 1, "open");
        talks.said(said, said.content());
        talks.repeated(said, said.content());
        var spoken = new SpeechAct(Duration.ofSeconds(3), "amy", "bob", "amy:1", "fipa-request", "request", "open", 2);
        assertThat(talks.of("amy")).containsExactly(spoken);
        assertThat(talks.of("bob")).containsExactly(spoken);
        assertThat(talks.of("zoe")).isEmpty();
    }

    @Test
    void whatIsRepeatedIsThatOfThisPartnerOnly() {
        Message<Act> toBob = message("amy", "bob", 1, "open");
        Message<Act> toZoe = message("amy", "zoe", 1, "open");
        talks.said(toBob, toBob.content());
        talks.said(toZoe, toZoe.content());
        talks.repeated(toBob, toBob.content());
        assertThat(talks.of("amy")).extracting(SpeechAct::times).containsExactly(2, 1);
    }

    @Test
    void onlyTheNewestAreKeptAndLongWordsAreClipped() {
        for (int i = 1; i <= 3 * ConversationLog.MOST; i++) {
            Message<Act> said = message("amy", "bob", i, "x".repeat(10_000));
            talks.said(said, said.content());
        }
        assertThat(talks.of("amy"))
                .hasSize(ConversationLog.MOST)
                .allSatisfy(spoken -> assertThat(spoken.words()).hasSize(241).endsWith("…"));
    }
}
