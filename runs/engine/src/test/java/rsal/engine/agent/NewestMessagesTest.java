package rsal.engine.agent;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;

class NewestMessagesTest {
    private final NewestMessages messages = new NewestMessages();

    @Test
    void keepsTheNewestOfEachAgent() {
        for (int i = 0; i <= NewestMessages.MOST; i++) {
            messages.sent("ann", "pose: " + i, Duration.ofSeconds(i));
        }
        messages.sent("bob", "chat: hello", Duration.ofMillis(1));
        assertThat(messages.of("ann")).containsExactly("pose: 1", "pose: 2", "pose: 3", "pose: 4", "pose: 5");
        assertThat(messages.newest("ann")).contains(Duration.ofSeconds(5));
        assertThat(messages.of("bob")).containsExactly("chat: hello");
    }

    @Test
    void hasNothingOfOneThatIsSilent() {
        assertThat(messages.of("ann")).isEmpty();
        assertThat(messages.newest("ann")).isEmpty();
    }
}
