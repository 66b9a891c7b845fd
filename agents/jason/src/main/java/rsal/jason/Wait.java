package rsal.jason;

import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.LogicalFormula;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;
import java.time.Duration;
import java.util.Optional;

/// `.wait(1000)`, `.wait({+event})`, `.wait(formula)`, the latter two with a limit in milliseconds that they fail
/// after, or don't when they are asked for the time that it took.
final class Wait extends OwnAction {
    private static final long serialVersionUID = 1;

    private final transient SuspendedIntentions waits;

    Wait(SuspendedIntentions waits) {
        super(1, 3, false);
        this.waits = waits;
    }

    @Override
    public boolean suspendIntention() {
        return true;
    }

    @Override
    Object act(TransitionSystem ts, Unifier un, Term[] terms) throws Exception {
        if (terms[0].isNumeric()) {
            waits.forTime(un, Terms.millis(terms[0]));
            return true;
        }
        Optional<Duration> limit = terms.length > 1 ? Optional.of(Terms.millis(terms[1])) : Optional.empty();
        Optional<Term> elapsed = terms.length > 2 ? Optional.of(terms[2]) : Optional.empty();
        Trigger event = Trigger.tryToGetTrigger(terms[0]);
        if (event != null) {
            waits.forEvent(un, event, limit, elapsed);
        } else if (terms[0] instanceof LogicalFormula formula) {
            waits.forFormula(un, formula, limit, elapsed);
        } else {
            throw new IllegalArgumentException(
                    "'.wait' takes a number of milliseconds, an event {+e} or a formula, not '%s'."
                            .formatted(Terms.written(terms[0])));
        }
        return true;
    }
}
