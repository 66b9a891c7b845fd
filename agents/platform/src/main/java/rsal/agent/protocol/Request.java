package rsal.agent.protocol;

import java.util.Objects;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;

/// One asks, another does it and tells the result: FIPA's Request Interaction Protocol (SC00026H). The one asked
/// refuses, or agrees and then informs or fails; what is quick needs no agreement. Who needs longer than the asker's
/// patience agrees first, else it counts as silent.
///
/// @param <Q> what is asked for
/// @param <A> what comes of it
public final class Request<Q, A> {
    private final ConversationManager conversations;
    private final Class<Q> question;
    private final Class<A> answer;

    /// @param name of the service; agents that use the same can ask each other
    public Request(AgentContext self, String name, Class<Q> question, Class<A> answer) {
        this.question = question;
        this.answer = answer;
        this.conversations =
                new ConversationManager(self, name, ProtocolStateMachine.REQUEST, question, String.class, answer);
    }

    public Conversation ask(String to, Q what, Consumer<? super ConversationResult<A>> onEnd) {
        return ask(to, what, RetryPolicy.DEFAULT, onEnd);
    }

    /// @param onEnd told once, on the agent's lane; at once when it is cancelled
    public Conversation ask(String to, Q what, RetryPolicy patience, Consumer<? super ConversationResult<A>> onEnd) {
        return PartnerConversation.begin(
                conversations, to, patience, new ProtocolOutcome<>(answer, onEnd), Performative.REQUEST, what);
    }

    /// From now on answers all that ask.
    ///
    /// @param responder called on the agent's lane; answers then or later
    /// @throws IllegalStateException when this was called before
    public void answer(Consumer<? super Asked<Q, A>> responder) {
        conversations.open(dialogue -> new Question(dialogue, responder));
    }

    /// Something another agent asks for. What is said after that agent has gone or cancelled it does nothing; a second
    /// answer is an error of the one who gives it ([IllegalStateException]).
    public interface Asked<Q, A> {
        /// Name of the agent that asks.
        String from();

        Q what();

        /// It will be done, but not now.
        void agree();

        void refuse(String why);

        void inform(A result);

        void fail(String why);

        /// Runs when nobody waits for it any more: it was cancelled, or who asked has gone.
        void whenUnwanted(Runnable stop);
    }

    private final class Question extends Answering implements Asked<Q, A> {
        private final Consumer<? super Asked<Q, A>> responder;
        private @Nullable Q what;

        Question(Dialogue dialogue, Consumer<? super Asked<Q, A>> responder) {
            super(dialogue);
            this.responder = responder;
        }

        @Override
        public void heard(Act act) {
            if (act.performative() == Performative.REQUEST) {
                what = question.cast(act.content());
                responder.accept(this);
            }
        }

        @Override
        public Q what() {
            return Objects.requireNonNull(what);
        }

        @Override
        public void inform(A result) {
            say(Performative.INFORM, result);
        }
    }
}
