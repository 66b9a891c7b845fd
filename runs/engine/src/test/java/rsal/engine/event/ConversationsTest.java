package rsal.engine.event;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.agent.protocol.Act;
import rsal.agent.protocol.Performative;
import rsal.agent.protocol.Side;

class ConversationsTest {
    private final Conversations conversations = new Conversations();

    private static Act act(String conversation, int number) {
        return new Act(
                Performative.CFP,
                "fipa-contract-net",
                conversation,
                Side.INITIATOR,
                number,
                0,
                Optional.empty(),
                "box");
    }

    @Test
    void whatIsSaidAgainIsNotNew() {
        assertThat(conversations.isNew("zoe", "amy", act("one", 1))).isTrue();
        assertThat(conversations.isNew("zoe", "amy", act("one", 1))).isFalse();
        assertThat(conversations.isNew("zoe", "amy", act("one", 2))).isTrue();
        assertThat(conversations.isNew("zoe", "amy", act("one", 1))).isFalse();
    }

    @Test
    void othersAndOtherConversationsAreNew() {
        conversations.isNew("zoe", "amy", act("one", 1));
        assertThat(conversations.isNew("zoe", "bob", act("one", 1))).isTrue();
        assertThat(conversations.isNew("amy", "zoe", act("one", 1))).isTrue();
        assertThat(conversations.isNew("zoe", "amy", act("two", 1))).isTrue();
    }

    @Test
    void whatOnlyShowsPresenceIsNotNew() {
        assertThat(conversations.isNew("zoe", "amy", act("one", 0))).isFalse();
    }
}
