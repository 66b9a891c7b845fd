package rsal.agent.protocol;

import java.util.function.Consumer;

/// Waits for what a partner says at last, and tells it once.
class ProtocolOutcome<A> implements Dialogue.Listener {
    private final Class<A> result;
    private final Consumer<? super ConversationResult<A>> onEnd;
    private boolean reported;

    ProtocolOutcome(Class<A> result, Consumer<? super ConversationResult<A>> onEnd) {
        this.result = result;
        this.onEnd = onEnd;
    }

    @Override
    public void heard(Act act) {
        if (reported) {
            return; // an answer to what was cancelled
        }
        switch (act.performative()) {
            case INFORM, ACCEPT_PROPOSAL -> end(new ConversationResult.Informed<>(result.cast(act.content())));
            case REFUSE, REJECT_PROPOSAL -> end(new ConversationResult.Refused<>(words(act)));
            case FAILURE -> end(new ConversationResult.Failed<>(words(act)));
            case NOT_UNDERSTOOD -> end(new ConversationResult.NotUnderstood<>(words(act)));
            default -> {} // it goes on
        }
    }

    @Override
    public void lost(String why) {
        end(new ConversationResult.Silent<>(why));
    }

    void end(ConversationResult<A> how) {
        if (!reported) {
            reported = true;
            onEnd.accept(how);
        }
    }

    boolean isReported() {
        return reported;
    }

    static String words(Act act) {
        return act.content().toString();
    }
}
