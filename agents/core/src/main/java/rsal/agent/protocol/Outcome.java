package rsal.agent.protocol;

import java.util.function.Consumer;

/// Waits for what a partner says at last, and tells it once.
class Outcome<A> implements Dialogue.Listener {
    private final Class<A> result;
    private final Consumer<? super Ending<A>> onEnd;
    private boolean told;

    Outcome(Class<A> result, Consumer<? super Ending<A>> onEnd) {
        this.result = result;
        this.onEnd = onEnd;
    }

    @Override
    public void heard(Act act) {
        if (told) {
            return; // an answer to what was cancelled
        }
        switch (act.performative()) {
            case INFORM, ACCEPT_PROPOSAL -> end(new Ending.Informed<>(result.cast(act.content())));
            case REFUSE, REJECT_PROPOSAL -> end(new Ending.Refused<>(words(act)));
            case FAILURE -> end(new Ending.Failed<>(words(act)));
            case NOT_UNDERSTOOD -> end(new Ending.NotUnderstood<>(words(act)));
            default -> {} // it goes on
        }
    }

    @Override
    public void lost(String why) {
        end(new Ending.Silent<>(why));
    }

    void end(Ending<A> how) {
        if (!told) {
            told = true;
            onEnd.accept(how);
        }
    }

    boolean isTold() {
        return told;
    }

    static String words(Act act) {
        return act.content().toString();
    }
}
