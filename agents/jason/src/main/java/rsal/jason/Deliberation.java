package rsal.jason;

import jason.JasonException;
import jason.NoValueException;
import jason.architecture.AgArch;
import jason.asSemantics.Agent;
import jason.asSemantics.Circumstance;
import jason.asSemantics.Event;
import jason.asSemantics.Intention;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.NumberTerm;
import jason.runtime.Settings;
import jason.stdlib.fail_goal;
import java.time.Duration;

/// Jason's reasoning cycle with deadlines of goals in the run's time.
final class Deliberation extends TransitionSystem {
    private static final long serialVersionUID = 1;

    private final AgArch architecture;

    Deliberation(Agent agent, Circumstance circumstance, AgArch architecture) {
        super(agent, circumstance, new Settings(), architecture);
        this.architecture = architecture;
    }

    @Override
    protected void checkHardDeadline(Event event) {
        Literal goal = event.getTrigger().getLiteral();
        Literal deadline = goal.getAnnot(ASSyntax.hardDeadLineStr);
        if (deadline == null || !(architecture instanceof Architecture own)) {
            return;
        }
        if (deadline.getArity() != 1 || !(deadline.getTerm(0) instanceof NumberTerm millis)) {
            getLogger().warning("A deadline must be a number of milliseconds, not (%s).".formatted(deadline));
            return;
        }
        Intention intention = event.getIntention();
        int size = intention == null ? 0 : intention.size();
        try {
            own.after(
                    Duration.ofNanos(Math.round(millis.solve() * 1e6)),
                    () -> runAtBeginOfNextCycle(() -> fail(goal, intention, size, event)));
        } catch (NoValueException e) {
            getLogger().warning(e.getMessage());
        }
    }

    private void fail(Literal goal, Intention intention, int size, Event event) {
        boolean pursued = intention == null
                || (intention.size() >= size && intention.hasTrigger(event.getTrigger(), new Unifier()));
        if (pursued) {
            try {
                new fail_goal() {
                    private static final long serialVersionUID = 1;

                    @Override
                    protected void addAnnotsToFailEvent(Event failed) {
                        failed.getTrigger()
                                .getLiteral()
                                .addAnnots(JasonException.createBasicErrorAnnots("deadline_reached", ""));
                    }
                }.drop(this, goal, new Unifier());
            } catch (Exception e) { // all that it declares
                getLogger().warning("Goal (%s) could not be ended: %s".formatted(goal, e.getMessage()));
            }
        }
    }
}
