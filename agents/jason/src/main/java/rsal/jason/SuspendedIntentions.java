package rsal.jason;

import jason.JasonException;
import jason.asSemantics.Circumstance;
import jason.asSemantics.CircumstanceListener;
import jason.asSemantics.Event;
import jason.asSemantics.Intention;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Atom;
import jason.asSyntax.LogicalFormula;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;
import jason.stdlib.suspend;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import rsal.time.Task;

/// Intentions of an agent that wait for a time, an event or a belief. They go on in the cycle after that has come.
final class SuspendedIntentions implements CircumstanceListener {
    private static final long serialVersionUID = 1;

    private final transient AgentSpeakAgent agent;
    private final transient List<Waiting> waiting = new ArrayList<>();
    private final transient Map<String, Task> limits = new HashMap<>(); // by what of Jason's they are for
    private int begun;

    SuspendedIntentions(AgentSpeakAgent agent) {
        this.agent = agent;
    }

    /// Whether any waits for an event, so that one matters for which there is no plan.
    boolean forEvents() {
        return waiting.stream().anyMatch(each -> each.event != null);
    }

    void forTime(Unifier un, Duration time) {
        begin(un, null, null, Optional.of(time), Optional.empty());
    }

    void forEvent(Unifier un, Trigger event, Optional<Duration> limit, Optional<Term> elapsed) {
        begin(un, event, null, limit, elapsed);
    }

    void forFormula(Unifier un, LogicalFormula formula, Optional<Duration> limit, Optional<Term> elapsed) {
        begin(un, null, formula, limit, elapsed); // looked at when this cycle is over
    }

    private void begin(
            Unifier un,
            @Nullable Trigger event,
            @Nullable LogicalFormula formula,
            Optional<Duration> limit,
            Optional<Term> elapsed) {
        Circumstance c = circumstance();
        Intention intention = c.getSelectedIntention();
        var one = new Waiting("wait" + ++begun, intention, un, event, formula, elapsed, agent.now());
        waiting.add(one);
        c.addPendingIntention(one.key, new Atom("wait"), intention, false);
        limit.ifPresent(time -> limit(one.key, time, () -> end(one, true)));
    }

    /// Does something after a time, unless a pending intention has gone on by then.
    ///
    /// @param key under which it is pending
    void limit(String key, Duration time, Runnable task) {
        limits.put(key, agent.after(time, task));
    }

    /// A cycle is over: some of what is waited for may be believed by now.
    void check() {
        for (Waiting one : List.copyOf(waiting)) {
            if (one.formula != null && agent.reasoner().believes(one.formula, one.un)) {
                end(one, false);
            }
        }
        Map<String, Intention> pending = circumstance().getPendingIntentions();
        waiting.removeIf(one -> !pending.containsKey(one.key)); // of dropped intentions
        limits.entrySet().removeIf(limit -> {
            boolean over = !pending.containsKey(limit.getKey());
            if (over) {
                limit.getValue().cancel();
            }
            return over;
        });
    }

    @Override
    public void eventAdded(Event added) {
        Predicate<Waiting> wanted = one -> one.event != null && one.un.unifies(one.event, added.getTrigger());
        List.copyOf(waiting).stream().filter(wanted).forEach(one -> end(one, false));
    }

    private void end(Waiting one, boolean late) {
        if (waiting.remove(one)) {
            deliberation().runAtBeginOfNextCycle(() -> goOn(one, late));
        }
    }

    private void goOn(Waiting one, boolean late) {
        Circumstance c = circumstance();
        Intention intention = c.removePendingIntention(one.key);
        if (intention == null || intention.isFinished()) {
            return; // dropped meanwhile
        }
        boolean fails = late && (one.event != null || one.formula != null) && one.elapsed.isEmpty();
        if (fails) {
            fail(intention);
            return;
        }
        intention.peek().removeCurrentStep();
        one.elapsed.ifPresent(term -> one.un.unifies(term, ASSyntax.createNumber((double)
                Duration.between(one.since, agent.now()).toMillis())));
        if (intention.isSuspended()) {
            c.addPendingIntention(suspend.SUSPENDED_INT + intention.getId(), intention);
        } else {
            c.resumeIntention(intention, null);
        }
    }

    private void fail(Intention intention) {
        try {
            deliberation()
                    .generateGoalDeletion(
                            intention,
                            JasonException.createBasicErrorAnnots("wait_timeout", "The awaited event has not come."),
                            new Atom("wait_timeout"));
        } catch (JasonException e) {
            agent.complain(String.valueOf(e.getMessage()));
        }
    }

    private TransitionSystem deliberation() {
        return agent.reasoner().getTS();
    }

    private Circumstance circumstance() {
        return deliberation().getC();
    }

    private record Waiting(
            String key,
            Intention intention,
            Unifier un,
            @Nullable Trigger event,
            @Nullable LogicalFormula formula,
            Optional<Term> elapsed,
            Instant since) {}
}
