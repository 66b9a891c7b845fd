package rsal.jason;

import jason.asSemantics.Circumstance;
import jason.asSemantics.IntendedMeans;
import jason.asSemantics.Intention;
import jason.asSemantics.Unifier;
import jason.asSyntax.BinaryStructure;
import jason.asSyntax.ListTerm;
import jason.asSyntax.Literal;
import jason.asSyntax.Plan;
import jason.asSyntax.PlanBody;
import jason.asSyntax.Pred;
import jason.asSyntax.Rule;
import jason.asSyntax.SourceInfo;
import jason.asSyntax.Structure;
import jason.asSyntax.Term;
import jason.bb.BeliefBase;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.Stream;
import rsal.agent.bdi.Mind;
import rsal.agent.bdi.Mind.GoalState;
import rsal.agent.bdi.Mind.GoalView;

/// What is in an agent's mind, for people: its beliefs by name, each as it is written and with who told it, its
/// intentions as goals with the plans and steps by which it pursues them, and the rules and plans that it has.
final class Thoughts {
    private static final int MOST_BELIEFS = 20; // of one name

    private static final String KQML = "kqmlPlans.asl:";

    private Thoughts() {}

    static Mind.View of(Reasoner reasoner, String complaint) {
        Circumstance c = reasoner.getTS().getC();
        return new Mind.View(beliefs(reasoner), goals(reasoner, complaint, intention -> isInProgress(c, intention)));
    }

    private static Map<String, String> beliefs(Reasoner reasoner) {
        var all = new TreeMap<String, List<String>>();
        for (Literal belief : reasoner.getBB()) {
            if (!belief.isRule() && belief.getNS().equals(Literal.DefaultNS)) {
                all.computeIfAbsent(belief.getFunctor(), _ -> new ArrayList<>()).add(Terms.written(belief));
            }
        }
        var words = new TreeMap<String, String>();
        all.forEach((name, each) -> words.put(
                name,
                each.size() <= MOST_BELIEFS
                        ? String.join("; ", each)
                        : "%s; and %d more"
                                .formatted(
                                        String.join("; ", each.subList(0, MOST_BELIEFS)), each.size() - MOST_BELIEFS)));
        return Collections.unmodifiableMap(words);
    }

    static Mind.Program program(Reasoner reasoner) {
        var rules = new ArrayList<String>();
        for (Literal belief : reasoner.getBB()) {
            if (belief instanceof Rule rule && belief.getNS().equals(Literal.DefaultNS)) {
                rules.add(TermText.typed(rule));
            }
        }
        var plans = new LinkedHashMap<String, String>();
        for (Plan plan : reasoner.getPL().getPlans()) {
            if (!isJasons(plan)) {
                plans.merge(name(plan), TermText.typed(plan), "%s\n%s"::formatted); // several may begin in one line
            }
        }
        return new Mind.Program(rules, plans);
    }

    /// Jason goes on to hold the intention that it did a step of last, even one that has failed by that.
    private static boolean isInProgress(Circumstance c, Intention intention) {
        return c.getRunningIntentions().contains(intention)
                || c.getPendingIntentions().containsValue(intention)
                || c.getPendingActions().containsKey(intention.getId())
                || Stream.concat(c.getEvents().stream(), c.getPendingEvents().values().stream())
                        .anyMatch(event -> intention.equals(event.getIntention()));
    }

    private static List<GoalView> goals(Reasoner reasoner, String complaint, Predicate<Intention> shown) {
        var goals = new ArrayList<GoalView>();
        Circumstance c = reasoner.getTS().getC();
        Iterator<Intention> all = c.getAllIntentions();
        while (all.hasNext()) {
            Intention intention = all.next();
            if (intention.isFinished() || !shown.test(intention)) {
                continue;
            }
            boolean waits = c.getPendingIntentions().containsValue(intention);
            goals.add(new GoalView(
                    goal(intention.getBottom().getTrigger().getLiteral()),
                    waits ? GoalState.SUSPENDED : GoalState.PURSUED,
                    0,
                    plans(intention),
                    steps(intention),
                    complaint));
        }
        return List.copyOf(goals);
    }

    /// Whose source is told only when that is another.
    private static String goal(Literal own) {
        Literal reported = own.copy();
        reported.delSource(BeliefBase.ASelf);
        return Terms.written(reported);
    }

    /// Of the plans under way, the outermost first.
    private static List<String> plans(Intention intention) {
        var names = new ArrayList<String>();
        for (IntendedMeans means : intention) {
            names.add(name(means.getPlan()));
        }
        return names.reversed();
    }

    /// Whether it is one of those by which all agents take messages.
    private static boolean isJasons(Plan plan) {
        return place(plan).filter(place -> place.startsWith(KQML)).isPresent();
    }

    /// Its label; where its author gave it none, where it is written.
    private static String name(Plan plan) {
        Optional<Pred> label = Optional.ofNullable(plan.getLabel());
        return label.filter(own -> !Plans.isCounted(own) || place(plan).isEmpty())
                .map(Pred::getFunctor)
                .or(() -> place(plan))
                .orElse("");
    }

    private static Optional<String> place(Plan plan) {
        return Optional.ofNullable(plan.getSrcInfo())
                .filter(source -> source.getSrcFile() != null)
                .map(SourceInfo::toString);
    }

    private static List<String> steps(Intention intention) {
        var steps = new ArrayList<String>();
        for (IntendedMeans means : intention) {
            PlanBody step = means.isFinished() ? null : means.getCurrentStep();
            String goal = means.getTrigger().getOperator() + ""
                    + means.getTrigger().getType() + goal(means.getTrigger().getLiteral());
            steps.add(
                    step == null || step.getBodyTerm() == null
                            ? goal
                            : "%s: %s%s"
                                    .formatted(goal, step.getBodyType(), bound(step.getBodyTerm(), means.getUnif())));
        }
        return steps.reversed();
    }

    /// A term with what its variables stand for. Where something is computed, it is left to be.
    private static String bound(Term term, Unifier unifier) {
        return isComputed(term) ? TermText.of(term, unifier) : Terms.written(term.capply(unifier));
    }

    private static boolean isComputed(Term term) {
        if (term.isVar()) {
            return false;
        }
        if (term instanceof ListTerm list) {
            return list.stream().anyMatch(Thoughts::isComputed);
        }
        return term.isArithExpr()
                || term instanceof BinaryStructure
                || (term instanceof Structure structure
                        && structure.getTerms() != null
                        && structure.getTerms().stream().anyMatch(Thoughts::isComputed));
    }

    /// What it is about now, for messages.
    static String newest(Reasoner reasoner) {
        List<GoalView> goals = goals(reasoner, "", _ -> true);
        return goals.isEmpty()
                ? "nothing but events"
                : "%s (%s)"
                        .formatted(
                                goals.getFirst().name(),
                                goals.getFirst().plans().getLast());
    }
}
