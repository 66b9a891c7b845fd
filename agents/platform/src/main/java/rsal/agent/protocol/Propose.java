package rsal.agent.protocol;

import java.util.function.Consumer;
import java.util.function.Function;
import rsal.agent.AgentContext;

/// One says what it would like to do, another accepts or rejects that: FIPA's Propose Interaction Protocol (SC00036H).
///
/// @param <P> what is proposed
public final class Propose<P> {
    private final ConversationManager conversations;
    private final Class<P> proposal;

    /// @param name of the service; agents that use the same can propose to each other
    public Propose(AgentContext self, String name, Class<P> proposal) {
        this.proposal = proposal;
        this.conversations =
                new ConversationManager(self, name, ProtocolStateMachine.PROPOSE, proposal, String.class, String.class);
    }

    public Conversation propose(String to, P what, Consumer<? super ConversationResult<String>> onEnd) {
        return propose(to, what, RetryPolicy.DEFAULT, onEnd);
    }

    /// @param onEnd told once, on the agent's lane: informed when it was accepted, refused when it was rejected, with
    /// the words of the one who did
    public Conversation propose(
            String to, P what, RetryPolicy patience, Consumer<? super ConversationResult<String>> onEnd) {
        return PartnerConversation.begin(
                conversations, to, patience, new ProtocolOutcome<>(String.class, onEnd), Performative.PROPOSE, what);
    }

    /// From now on decides about what others propose.
    ///
    /// @param judge called on the agent's lane
    /// @throws IllegalStateException when this was called before
    public void answer(Function<? super Offer<P>, Verdict> judge) {
        conversations.open(dialogue -> new Answering(dialogue) {
            @Override
            public void heard(Act act) {
                if (act.performative() == Performative.PROPOSE) {
                    Verdict verdict = judge.apply(new Offer<>(from(), proposal.cast(act.content())));
                    say(
                            verdict.accepted() ? Performative.ACCEPT_PROPOSAL : Performative.REJECT_PROPOSAL,
                            verdict.why());
                }
            }
        });
    }

    /// @param from name of the agent that proposes
    public record Offer<P>(String from, P what) {}

    /// @param why in words
    public record Verdict(boolean accepted, String why) {
        public static Verdict accept() {
            return new Verdict(true, "");
        }

        public static Verdict reject(String why) {
            return new Verdict(false, why);
        }
    }
}
