package rsal.jason;

import jason.asSyntax.Literal;
import jason.asSyntax.PlanBody.BodyType;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;
import jason.asSyntax.VarTerm;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rsal.settings.Problem;
import rsal.settings.Suggestion;

/// Finds what an author may have mistyped: goals that no plan handles, and events that nothing in the agent
/// raises but that are called nearly like one that is. Others may raise events, so of these nothing is said
/// that looks like none.
final class Hints {
    private final Program program;
    private final List<Literal> wanted = new ArrayList<>(); // goals, where they are set
    private final Set<String> handled = new LinkedHashSet<>(); // goals, as `guard/1`
    private final List<Literal> awaited = new ArrayList<>(); // beliefs, where plans wait for them
    private final Set<String> known = new LinkedHashSet<>(); // names of beliefs
    private boolean handlesAll;

    Hints(Program program) {
        this.program = program;
        known.add(TopicEvents.FUNCTOR);
        Stream.of(PerceptBelief.values()).map(PerceptBelief::functor).forEach(known::add);
    }

    void wants(Literal goal) {
        if (!(goal instanceof VarTerm)) {
            wanted.add(goal);
        }
    }

    void believes(Literal belief) {
        known.add(belief.getFunctor());
    }

    void handles(Trigger trigger) {
        Literal literal = trigger.getLiteral();
        if (trigger.getType() == Trigger.TEType.belief) {
            if (!literal.hasAnnot() && !(literal instanceof VarTerm)) { // else it says from whom it comes
                awaited.add(literal);
            }
        } else if (literal instanceof VarTerm) {
            handlesAll = true;
        } else if (trigger.getType() == Trigger.TEType.achieve && trigger.isAddition()) {
            handled.add(signature(literal));
        }
    }

    void does(BodyType how, Term term) {
        if (!(term instanceof Literal literal) || term instanceof VarTerm) {
            return;
        }
        switch (how) {
            case achieve, achieveNF -> wants(literal);
            case addBel, addBelBegin, addBelEnd, addBelNewFocus, delAddBel, delBel, delBelNewFocus -> believes(literal);
            default -> {}
        }
    }

    List<Problem> all() {
        Stream<Problem> unhandled = handlesAll
                ? Stream.of()
                : wanted.stream()
                        .filter(goal -> !handled.contains(signature(goal)))
                        .map(this::unhandled);
        Stream<Problem> unraised = awaited.stream()
                .filter(belief -> !known.contains(belief.getFunctor()))
                .map(this::unraised)
                .flatMap(Optional::stream);
        return Stream.concat(unhandled, unraised).distinct().toList();
    }

    private Problem unhandled(Literal goal) {
        String sameName = handled.stream()
                .filter(each -> each.startsWith(goal.getFunctor() + "/"))
                .collect(Collectors.joining(", "));
        Set<String> names = handled.stream()
                .map(each -> each.substring(0, each.lastIndexOf('/')))
                .collect(Collectors.toCollection(LinkedHashSet::new));
        String remedy = sameName.isEmpty()
                ? Suggestion.closest(goal.getFunctor(), names)
                        .map("Maybe '!%s' was meant."::formatted)
                        .orElse("Maybe a plan '+!%s' is missing.".formatted(goal.getFunctor()))
                : "There are plans for %s. Maybe a term is missing, or one too many.".formatted(sameName);
        return new Problem(
                program.locationOf(goal),
                "No plan handles goal '!%s'.".formatted(Terms.masked(Terms.written(goal))),
                remedy);
    }

    private Optional<Problem> unraised(Literal belief) {
        return Suggestion.closest(belief.getFunctor(), known)
                .map(near -> new Problem(
                        program.locationOf(belief),
                        "Nothing here raises event '+%s'.".formatted(belief.getFunctor()),
                        "Maybe '+%s' was meant. Agents that receive '%s' from others may ignore this."
                                .formatted(near, belief.getFunctor())));
    }

    private static String signature(Literal goal) {
        return goal.getFunctor() + "/" + goal.getArity();
    }
}
