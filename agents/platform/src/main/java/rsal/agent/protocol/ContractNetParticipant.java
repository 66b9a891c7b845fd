package rsal.agent.protocol;

import java.time.Duration;
import java.time.Instant;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import rsal.agent.protocol.ContractNet.Call;
import rsal.agent.protocol.ContractNet.Contract;
import rsal.agent.protocol.ContractNet.Contractor;
import rsal.time.Scheduler;
import rsal.time.Task;

/// A contractor's side of a contract net: one call that it answers, and the contract if it gets it.
final class ContractNetParticipant<T, B, R> extends Answering implements Call<T, B>, Contract<T, R> {
    /// How long after the round the manager's answer may come, also if it has to be said several times.
    private static final Duration GRACE = RetryPolicy.DEFAULT.silence();

    private final Scheduler scheduler;
    private final Class<T> taskType;
    private final Contractor<T, B, R> contractor;
    private @Nullable T task;
    private Instant replyBy = Instant.MAX;
    private @Nullable Task deadline;
    private boolean open; // has bid, and the manager has not decided

    ContractNetParticipant(Scheduler scheduler, Dialogue dialogue, Class<T> taskType, Contractor<T, B, R> contractor) {
        super(dialogue);
        this.scheduler = scheduler;
        this.taskType = taskType;
        this.contractor = contractor;
    }

    @Override
    public void heard(Act act) {
        switch (act.performative()) {
            case CFP -> called(taskType.cast(act.content()), act.replyBy().orElseGet(scheduler::instant));
            case ACCEPT_PROPOSAL -> accepted(taskType.cast(act.content()));
            case REJECT_PROPOSAL, NOT_UNDERSTOOD -> rejected(ProtocolOutcome.words(act));
            default -> {} // the grammar lets nothing else through
        }
    }

    private void called(T what, Instant until) {
        close(); // a manager that calls again wants another bid
        task = what;
        replyBy = until;
        contractor.called(this);
    }

    private void accepted(T what) {
        if (open) {
            close();
            task = what;
            contractor.accepted(this);
        } else {
            fail("It is too late: nothing was heard for so long that the bid counted as rejected.");
        }
    }

    private void rejected(String why) {
        if (open) {
            close();
            contractor.rejected(this, why);
        }
    }

    private void close() {
        open = false;
        if (deadline != null) {
            deadline.cancel();
        }
    }

    @Override
    public void lost(String why) {
        rejected(why);
        super.lost(why);
    }

    @Override
    public T task() {
        return Objects.requireNonNull(task);
    }

    @Override
    public Instant replyBy() {
        return replyBy;
    }

    @Override
    public void propose(B bid) {
        open = true;
        say(Performative.PROPOSE, bid);
        Duration left = Duration.between(scheduler.instant(), replyBy);
        Duration patience = (left.isNegative() ? Duration.ZERO : left).plus(GRACE);
        deadline = scheduler.after(patience, () -> rejected("Nothing was heard of '%s'.".formatted(from())));
    }

    @Override
    public void inform(R result) {
        say(Performative.INFORM, result);
    }
}
