package rsal.jason;

import jason.asSemantics.Unifier;
import jason.asSyntax.Literal;
import jason.asSyntax.Rule;
import jason.bb.DefaultBeliefBase;
import java.util.Iterator;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/// An agent's beliefs and rules. It knows what it was asked for last, as a search without an end breaks off anywhere.
final class Beliefs extends DefaultBeliefBase {
    private static final long serialVersionUID = 1;

    private transient @Nullable Literal asked;

    @Override
    public Iterator<Literal> getCandidateBeliefs(Literal literal, Unifier un) {
        asked = literal;
        return super.getCandidateBeliefs(literal, un);
    }

    /// A rule for what it was asked for last.
    Optional<Rule> askedRule() {
        Iterator<Literal> candidates = asked == null ? null : super.getCandidateBeliefs(asked, new Unifier());
        while (candidates != null && candidates.hasNext()) {
            if (candidates.next() instanceof Rule rule) {
                return Optional.of(rule);
            }
        }
        return Optional.empty();
    }
}
