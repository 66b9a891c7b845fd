package rsal.agent.protocol;

import java.util.Objects;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;

/// One wants to be told, again and again, until it cancels or the teller fails: FIPA's Subscribe Interaction Protocol
/// (SC00035H). News arrive each once and in order, also when messages get lost.
///
/// For what all may hear, and of what only the newest counts, there are topics
/// ([rsal.agent.AgentContext#subscribe]).
///
/// @param <Q> what somebody wants to be told about
/// @param <A> news
public final class Subscribe<Q, A> {
    private final ConversationManager conversations;
    private final Class<Q> question;
    private final Class<A> news;

    /// @param name of the service; agents that use the same can subscribe to each other
    public Subscribe(AgentContext self, String name, Class<Q> question, Class<A> news) {
        this.question = question;
        this.news = news;
        this.conversations =
                new ConversationManager(self, name, ProtocolStateMachine.SUBSCRIBE, question, String.class, news);
    }

    public Conversation subscribe(
            String to, Q what, Consumer<? super A> listener, Consumer<? super ConversationResult<A>> onEnd) {
        return subscribe(to, what, RetryPolicy.DEFAULT, listener, onEnd);
    }

    /// @param listener told all news, on the agent's lane
    /// @param onEnd told once that no more will come; never as informed
    public Conversation subscribe(
            String to,
            Q what,
            RetryPolicy patience,
            Consumer<? super A> listener,
            Consumer<? super ConversationResult<A>> onEnd) {
        var outcome = new ProtocolOutcome<>(news, onEnd) {
            @Override
            public void heard(Act act) {
                if (act.performative() != Performative.INFORM) {
                    super.heard(act);
                } else if (!isReported()) { // else it answers that it was cancelled
                    listener.accept(news.cast(act.content()));
                }
            }
        };
        return PartnerConversation.begin(conversations, to, patience, outcome, Performative.SUBSCRIBE, what);
    }

    /// From now on admits subscribers.
    ///
    /// @param teller called on the agent's lane for each; agrees or refuses, then or later
    /// @throws IllegalStateException when this was called before
    public void answer(Consumer<? super Subscriber<Q, A>> teller) {
        conversations.open(dialogue -> new Interest(dialogue, teller));
    }

    /// One who wants to be told. What is said to one that has gone or cancelled does nothing.
    public interface Subscriber<Q, A> {
        /// Name of the agent that wants to be told.
        String from();

        Q what();

        void agree();

        void refuse(String why);

        /// Tells news; the first say that it agrees, too.
        void inform(A news);

        /// There will be no more.
        void fail(String why);

        /// Runs when it does not want to be told any more, or has gone.
        void whenUnwanted(Runnable stop);
    }

    private final class Interest extends Answering implements Subscriber<Q, A> {
        private final Consumer<? super Subscriber<Q, A>> teller;
        private @Nullable Q what;

        Interest(Dialogue dialogue, Consumer<? super Subscriber<Q, A>> teller) {
            super(dialogue);
            this.teller = teller;
        }

        @Override
        public void heard(Act act) {
            if (act.performative() == Performative.SUBSCRIBE) {
                what = question.cast(act.content());
                teller.accept(this);
            }
        }

        @Override
        public Q what() {
            return Objects.requireNonNull(what);
        }

        @Override
        public void inform(A reported) {
            say(Performative.INFORM, reported);
        }
    }
}
