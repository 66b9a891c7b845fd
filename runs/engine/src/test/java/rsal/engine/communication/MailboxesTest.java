package rsal.engine.communication;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import org.junit.jupiter.api.Test;
import rsal.agent.Message;
import rsal.agent.Topic;
import rsal.engine.event.RunClock;
import rsal.engine.report.ReceivedMessage;

class MailboxesTest {
    private static final Instant BEGAN = Instant.EPOCH.plusSeconds(100);

    private final Mailboxes mailboxes = new Mailboxes(RunClock.started(() -> BEGAN));

    private void hear(String listener, String topic, String to, int millis, String words) {
        mailboxes.heard(
                new Message<>(new Topic<>(topic, String.class), "ann", to, BEGAN.plusMillis(millis), words), listener);
    }

    @Test
    void reportsWhatReachedAnAgentInTheOrderOfArrival() {
        hear("bob", "pose", "", 20, "late");
        hear("cid", "pose", "", 30, "not for bob");
        hear("bob", "ask", "bob", 10, "later");

        assertThat(mailboxes.of("bob"))
                .containsExactly(
                        new ReceivedMessage(Duration.ofMillis(20), "ann", true, "pose", "late"),
                        new ReceivedMessage(Duration.ofMillis(10), "ann", false, "ask", "later"));
        assertThat(mailboxes.of("nobody")).isEmpty();
    }

    @Test
    void muchOfOneTopicLeavesWhatIsRareInOthers() {
        hear("bob", "ask", "bob", 0, "once");
        for (int i = 1; i <= 1000; i++) {
            hear("bob", "pose", "", i, "pose " + i);
        }

        assertThat(mailboxes.of("bob"))
                .hasSize(1 + Mailboxes.MOST_OF_A_TOPIC)
                .startsWith(new ReceivedMessage(Duration.ZERO, "ann", false, "ask", "once"))
                .endsWith(new ReceivedMessage(Duration.ofSeconds(1), "ann", true, "pose", "pose 1000"));
    }

    @Test
    void manyTopicsPushOutThoseNotHeardOfForLongest() {
        for (int i = 0; i < 10 * Mailboxes.MOST_TOPICS; i++) {
            hear("bob", "topic " + i, "", i, "");
            hear("bob", "pose", "", i, "");
        }

        assertThat(mailboxes.of("bob").stream().map(ReceivedMessage::topic).distinct())
                .hasSize(Mailboxes.MOST_TOPICS)
                .contains("pose", "topic " + (10 * Mailboxes.MOST_TOPICS - 1))
                .doesNotContain("topic 0");
    }

    @Test
    void longWordsAreClipped() {
        hear("bob", "ask", "bob", 0, "x".repeat(1_000_000));

        assertThat(mailboxes.of("bob").getFirst().words()).hasSizeLessThan(1000);
    }
}
