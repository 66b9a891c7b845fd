package rsal.jason;

import jason.asSemantics.Agent;
import jason.asSyntax.Term;
import jason.asSyntax.parser.as2j;
import java.io.StringReader;
import org.jspecify.annotations.Nullable;

/// Reads what one agent is told. Keeps its parser: to make one takes longer than to read most messages.
final class TermReader {
    private final Agent agent;
    private @Nullable as2j parser;

    TermReader(Agent agent) {
        this.agent = agent;
    }

    /// @throws IllegalArgumentException when it is not a term
    Term read(String text) {
        as2j ready = parser;
        parser = null; // one that fails would go on in the middle of something
        if (ready == null) {
            ready = Terms.parser(text, agent);
        } else {
            ready.ReInit(new StringReader(text));
        }
        Term term = Terms.read(text, ready);
        parser = ready;
        return term;
    }
}
