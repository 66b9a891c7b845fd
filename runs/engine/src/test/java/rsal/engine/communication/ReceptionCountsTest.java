package rsal.engine.communication;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import rsal.engine.report.Reception;

class ReceptionCountsTest {
    private final ReceptionCounts hearings = new ReceptionCounts();

    private void allReportToAll(int agents, String... topics) {
        for (String topic : topics) {
            for (int i = 0; i < agents; i++) {
                for (int j = 0; j < agents; j++) {
                    if (i != j) {
                        hearings.heard("agent-" + i, "agent-" + j, topic);
                        hearings.heard("agent-" + i, "agent-" + j, topic);
                    }
                }
                hearings.lost("agent-" + i, "agent-0", topic);
            }
        }
    }

    @Test
    void pairsAreReportedWhileTheyAreFew() {
        allReportToAll(3, "pose");
        assertThat(hearings.all())
                .hasSize(7)
                .contains(new Reception("agent-1", "agent-0", "pose", 2, 1))
                .contains(new Reception("agent-0", "agent-0", "pose", 0, 1));
    }

    @Test
    void ofTooManyPairsEachSenderIsSummedUp() {
        allReportToAll(200, "hello", "pose");
        assertThat(hearings.all())
                .hasSize(400)
                .contains(new Reception("agent-7", "", "hello", 398, 1))
                .contains(new Reception("agent-0", "", "pose", 398, 1));
    }

    @Test
    void ofTooManySendersEachTopicIsSummedUp() {
        for (int i = 0; i <= ReceptionCounts.MOST; i++) {
            hearings.heard("agent-" + i, "amy", "pose");
        }
        assertThat(hearings.all()).containsExactly(new Reception("", "", "pose", ReceptionCounts.MOST + 1, 0));
    }

    @Test
    void ofOneAgentThoseComeFirstOfWhichMostWasLost() {
        allReportToAll(100, "pose");
        for (int i = 0; i < 5; i++) {
            hearings.lost("agent-3", "agent-50", "pose");
        }
        assertThat(hearings.of("agent-50"))
                .hasSize(ReceptionCounts.MOST_OF_ONE)
                .first()
                .isEqualTo(new Reception("agent-3", "agent-50", "pose", 2, 5));
        assertThat(hearings.of("nobody")).isEmpty();
    }
}
