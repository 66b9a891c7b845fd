package rsal.jason;

import jason.asSemantics.DefaultInternalAction;
import jason.asSemantics.InternalAction;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.NumberTerm;
import jason.asSyntax.Term;
import jason.asSyntax.UnnamedVar;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Iterator;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;

/// Numbers of an agent's intentions, counted as it asks for them. Jason counts them for the whole process, so that two
/// equal runs in one would differ.
final class Intentions {
    private final Map<Integer, Integer> numbers = new HashMap<>(); // by Jason's
    private int last;

    /// An internal action of Jason's that tells such a number, as `.intention(N, …)`, with ours in its place.
    ///
    /// @param at which of its terms that is
    InternalAction numbered(DefaultInternalAction jasons, int at) {
        return new InternalActionOverrides.Simple(jasons.getMinArgs(), jasons.getMaxArgs(), (ts, un, terms) -> {
            if (terms.length <= at) {
                return jasons.execute(ts, un, terms);
            }
            forgetThoseThatEnded(ts);
            Term[] own = terms.clone();
            own[at] = new UnnamedVar();
            return solutions(jasons.execute(ts, un, own), un)
                    .filter(one -> number(one, own[at])
                            .map(number -> one.unifies(terms[at], ASSyntax.createNumber(number)))
                            .orElse(true))
                    .iterator();
        });
    }

    @SuppressWarnings("unchecked") // what Jason's actions return
    private static Stream<Unifier> solutions(Object result, Unifier un) {
        if (result instanceof Iterator<?> all) {
            Iterable<Unifier> each = () -> (Iterator<Unifier>) all;
            return StreamSupport.stream(each.spliterator(), false);
        }
        return Boolean.TRUE.equals(result) ? Stream.of(un) : Stream.empty();
    }

    /// Empty for an event that no intention waits for.
    private Optional<Integer> number(Unifier solution, Term variable) {
        return Optional.of(variable.capply(solution))
                .filter(NumberTerm.class::isInstance)
                .map(id -> numbers.computeIfAbsent((int) Terms.number(id), _ -> ++last));
    }

    private void forgetThoseThatEnded(TransitionSystem ts) {
        Set<Integer> there = new HashSet<>();
        ts.getC().getAllIntentions().forEachRemaining(one -> there.add(one.getId()));
        numbers.keySet().retainAll(there);
    }
}
