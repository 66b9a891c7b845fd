package rsal.jason;

import jason.JasonException;
import jason.asSemantics.DefaultInternalAction;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.Term;

/// An internal action of ours that takes so many terms.
abstract class OwnAction extends DefaultInternalAction {
    private static final long serialVersionUID = 1;

    private final int least;
    private final int most;
    private final boolean inConditions;

    /// @param inConditions whether it is of use there, as it has no effects
    OwnAction(int least, int most, boolean inConditions) {
        this.least = least;
        this.most = most;
        this.inConditions = inConditions;
    }

    /// @throws IllegalArgumentException when it can't be done with such terms
    abstract Object act(TransitionSystem ts, Unifier un, Term[] terms) throws Exception;

    @Override
    public final int getMinArgs() {
        return least;
    }

    @Override
    public final int getMaxArgs() {
        return most;
    }

    @Override
    public final boolean canBeUsedInContext() {
        return inConditions;
    }

    @Override
    public final Object execute(TransitionSystem ts, Unifier un, Term[] terms) throws Exception {
        checkArguments(terms);
        try {
            return act(ts, un, terms);
        } catch (IllegalArgumentException e) { // with a sentence, for plans that ask for error_msg
            throw new JasonException(String.valueOf(e.getMessage()));
        }
    }
}
