package rsal.agent.protocol;

import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
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
        decide(pending -> pending.decide(judge.apply(new Offer<>(pending.from(), pending.what()))));
    }

    /// As [#answer], by one that decides now or later.
    ///
    /// @param judge called on the agent's lane for each proposal
    /// @throws IllegalStateException when this or [#answer] was called before
    public void decide(Consumer<? super Pending<P>> judge) {
        conversations.open(dialogue -> new Deciding(dialogue, judge));
    }

    /// A proposal about which is not decided yet. The first decision counts.
    public interface Pending<P> {
        /// Name of the agent that proposes.
        String from();

        P what();

        void decide(Verdict verdict);
    }

    private final class Deciding extends Answering implements Pending<P> {
        private final Consumer<? super Pending<P>> judge;
        private @Nullable P what;
        private boolean decided;

        Deciding(Dialogue dialogue, Consumer<? super Pending<P>> judge) {
            super(dialogue);
            this.judge = judge;
        }

        @Override
        public void heard(Act act) {
            if (act.performative() == Performative.PROPOSE) {
                what = proposal.cast(act.content());
                judge.accept(this);
            }
        }

        @Override
        public P what() {
            return Objects.requireNonNull(what);
        }

        @Override
        public void decide(Verdict verdict) {
            if (!decided) {
                decided = true;
                say(verdict.accepted() ? Performative.ACCEPT_PROPOSAL : Performative.REJECT_PROPOSAL, verdict.why());
            }
        }
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
