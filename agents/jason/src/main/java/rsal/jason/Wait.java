package rsal.jason;

import jason.JasonException;
import jason.asSemantics.DefaultInternalAction;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.LogicalFormula;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;
import java.time.Duration;
import java.util.Optional;

/// `.wait(1000)`, `.wait({+event})`, `.wait(formula)`, the latter two with a limit in milliseconds that they fail
/// after, or don't when they are asked for the time that it took.
final class Wait extends DefaultInternalAction {
    private static final long serialVersionUID = 1;

    private final transient Waits waits;

    Wait(Waits waits) {
        this.waits = waits;
    }

    @Override
    public int getMinArgs() {
        return 1;
    }

    @Override
    public int getMaxArgs() {
        return 3;
    }

    @Override
    public boolean canBeUsedInContext() {
        return false;
    }

    @Override
    public boolean suspendIntention() {
        return true;
    }

    @Override
    public Object execute(TransitionSystem ts, Unifier un, Term[] terms) throws Exception {
        checkArguments(terms);
        if (terms[0].isNumeric()) {
            waits.forTime(un, millis(terms[0]));
            return true;
        }
        Optional<Duration> limit = terms.length > 1 ? Optional.of(millis(terms[1])) : Optional.empty();
        Optional<Term> elapsed = terms.length > 2 ? Optional.of(terms[2]) : Optional.empty();
        Trigger event = Trigger.tryToGetTrigger(terms[0]);
        if (event != null) {
            waits.forEvent(un, event, limit, elapsed);
        } else if (terms[0] instanceof LogicalFormula formula) {
            waits.forFormula(un, formula, limit, elapsed);
        } else {
            throw new JasonException("(.wait) takes a number of milliseconds, an event {+e} or a formula, not (%s)."
                    .formatted(terms[0]));
        }
        return true;
    }

    private static Duration millis(Term term) {
        double millis = Terms.number(term);
        if (!(millis >= 0)) {
            throw new IllegalArgumentException("One can't wait (%s) ms.".formatted(millis));
        }
        return Duration.ofNanos(Math.round(millis * 1e6));
    }
}
