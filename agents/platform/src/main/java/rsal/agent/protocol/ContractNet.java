package rsal.agent.protocol;

import java.time.Duration;
import java.time.Instant;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Set;
import rsal.agent.AgentContext;

/// A manager calls for proposals, contractors bid or refuse, the manager accepts some and rejects the others, and those
/// whose bid was accepted tell the result of the task: FIPA's Contract Net Interaction Protocol (SC00029H) and its
/// iterated form (SC00030H), after R. G. Smith, "The Contract Net Protocol" (1980).
///
/// @param <T> task
/// @param <B> bid
/// @param <R> result
public final class ContractNet<T, B, R> {
    private final AgentContext self;
    private final ConversationManager conversations;
    private final Class<T> task;
    private final Class<B> bid;
    private final Class<R> result;

    /// @param name of the service; agents that use the same can call each other
    public ContractNet(AgentContext self, String name, Class<T> task, Class<B> bid, Class<R> result) {
        this(self, name, ProtocolStateMachine.CONTRACT_NET, task, bid, result);
    }

    /// One in which the manager may call again, with a revised task, before it decides.
    public static <T, B, R> ContractNet<T, B, R> iterated(
            AgentContext self, String name, Class<T> task, Class<B> bid, Class<R> result) {
        return new ContractNet<>(self, name, ProtocolStateMachine.ITERATED_CONTRACT_NET, task, bid, result);
    }

    private ContractNet(
            AgentContext self,
            String name,
            ProtocolStateMachine grammar,
            Class<T> task,
            Class<B> bid,
            Class<R> result) {
        this.self = self;
        this.task = task;
        this.bid = bid;
        this.result = result;
        this.conversations = new ConversationManager(self, name, grammar, task, bid, result);
    }

    /// Calls for proposals.
    ///
    /// @param to names of those called; itself, too, if it also bids
    /// @param replyWithin after this the round is over, even when not all have answered
    public ContractNetInitiator<T, B, R> call(
            Collection<String> to, T what, Duration replyWithin, Manager<T, B, R> manager) {
        return call(to, what, replyWithin, RetryPolicy.DEFAULT, manager);
    }

    /// @param patience with each partner, and with those whose bid was accepted until the task is done
    public ContractNetInitiator<T, B, R> call(
            Collection<String> to, T what, Duration replyWithin, RetryPolicy patience, Manager<T, B, R> manager) {
        var tender = new ContractNetInitiator<>(
                self.scheduler(), conversations, bid, result, replyWithin, patience, manager);
        tender.begin(Set.copyOf(to), what);
        return tender;
    }

    /// From now on answers calls.
    ///
    /// @throws IllegalStateException when this was called before
    public void answer(Contractor<T, B, R> contractor) {
        conversations.open(dialogue -> new ContractNetParticipant<>(self.scheduler(), dialogue, task, contractor));
    }

    /// The initiator, which has something done. Called on its agent's lane.
    public interface Manager<T, B, R> {
        /// Decides when all have answered or the time for that is over. Called once for each round.
        Verdict<T> decide(Round<B> round);

        /// Told once for each bid that was accepted.
        default void ended(Proposal<B> accepted, ConversationResult<R> how) {}
    }

    /// A participant, which can do something. Called on its agent's lane.
    public interface Contractor<T, B, R> {
        /// Proposes or refuses, now or later.
        void called(Call<T, B> call);

        /// Its bid was accepted: does the task, now or later, and tells the result.
        void accepted(Contract<T, R> contract);

        /// Its bid was rejected, or nothing was heard of the manager.
        default void rejected(Call<T, B> call, String why) {}
    }

    /// A task that somebody may bid for.
    public interface Call<T, B> {
        /// Name of the manager.
        String from();

        T task();

        /// Later bids are of no use.
        Instant replyBy();

        void propose(B bid);

        void refuse(String why);
    }

    /// A task to be done. What is said after the manager has gone or cancelled it does nothing.
    public interface Contract<T, R> {
        /// Name of the manager.
        String from();

        /// What was accepted: the task that it bid for, or its share of that.
        T task();

        void inform(R result);

        void fail(String why);

        /// Runs when nobody waits for it any more: it was cancelled, or the manager has gone.
        void whenUnwanted(Runnable stop);
    }

    /// @param from name of the one who bids
    public record Proposal<B>(String from, B bid) {}

    /// The result of a call.
    ///
    /// @param number from 1; more than 1 only where the manager calls again
    /// @param proposals by name of those who bid, in the alphabet's order
    /// @param refusals why, by name of those who refused, did not understand or went
    /// @param silent names of those who have not answered
    public record Round<B>(int number, List<Proposal<B>> proposals, Map<String, String> refusals, Set<String> silent) {}

    public sealed interface Verdict<T> {
        /// Accepts these bids and rejects all others; that may be all.
        record Award<T>(Set<String> names) implements Verdict<T> {}

        /// Accepts these bids, each for a share of the task, and rejects all others.
        ///
        /// @param shares by name of those who get one
        record Share<T>(Map<String, T> shares) implements Verdict<T> {
            public Share {
                shares = Map.copyOf(shares);
            }
        }

        /// Calls those who bid once more.
        record Again<T>(T revised) implements Verdict<T> {}

        static <T> Verdict<T> award(Proposal<?> proposal) {
            return new Award<>(Set.of(proposal.from()));
        }

        static <T> Verdict<T> none() {
            return new Award<>(Set.of());
        }

        static <T> Verdict<T> again(T revised) {
            return new Again<>(revised);
        }
    }
}
