package rsal.agent.protocol;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.agent.AgentContext;
import rsal.agent.platform.Run;
import rsal.agent.protocol.Propose.Verdict;

class ProposeTest {
    private final Run run = new Run();

    private static Propose<String> plans(AgentContext self) {
        return new Propose<>(self, "plans", String.class);
    }

    @Test
    void whatIsProposedIsAcceptedOrRejected() {
        var endings = new ArrayList<ConversationResult<String>>();
        List<String> said = run.transcript();
        run.start(
                "amy",
                self -> plans(self)
                        .answer(offer -> offer.what().equals("rest") ? Verdict.accept() : Verdict.reject("too far")));
        run.start("zoe", self -> {
            Propose<String> plans = plans(self);
            plans.propose("amy", "rest", endings::add);
            plans.propose("amy", "walk", endings::add);
        });
        run.advance(0);
        assertThat(endings)
                .containsExactly(new ConversationResult.Informed<>(""), new ConversationResult.Refused<>("too far"));
        assertThat(said)
                .containsExactly(
                        "zoe -> amy: propose: rest",
                        "zoe -> amy: propose: walk",
                        "amy -> zoe: accept-proposal",
                        "amy -> zoe: reject-proposal: too far");
    }
}
