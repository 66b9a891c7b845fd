package rsal.jason;

import jason.asSyntax.ArithExpr;
import jason.asSyntax.ArithFunctionTerm;
import jason.asSyntax.InternalActionLiteral;
import jason.asSyntax.ListTerm;
import jason.asSyntax.Literal;
import jason.asSyntax.LogExpr;
import jason.asSyntax.Plan;
import jason.asSyntax.PlanBody;
import jason.asSyntax.PlanBody.BodyType;
import jason.asSyntax.RelExpr;
import jason.asSyntax.Rule;
import jason.asSyntax.Structure;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;
import jason.asSyntax.VarTerm;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import rsal.agent.Topic;
import rsal.agent.Topics;
import rsal.device.Device;
import rsal.settings.Problem;
import rsal.settings.Problems;
import rsal.settings.Suggestion;

/// Looks through what an agent is made of: which percepts it asks for, which topics it listens to, what its actions
/// need, and what it names that there is not.
final class StaticChecker {
    private final Program program;
    private final Problems problems = new Problems();
    private final Set<PerceptBelief> percepts = EnumSet.noneOf(PerceptBelief.class);
    private final Set<Topic<?>> topics = new LinkedHashSet<>();
    private final Set<Class<? extends Device>> devices = new LinkedHashSet<>();
    private final List<Literal> said = new ArrayList<>();
    private final Hints hints;

    private StaticChecker(Program program) {
        this.program = program;
        this.hints = new Hints(program);
    }

    static StaticChecker of(Program program, Reasoner reasoner) {
        var review = new StaticChecker(program);
        reasoner.getPL().getPlans().forEach(review::plan);
        reasoner.getInitialBels().forEach(review::belief);
        reasoner.getInitialGoals().forEach(review.hints::wants);
        review.percepts.forEach(percept -> review.devices.add(percept.device()));
        return review;
    }

    Problems problems() {
        return problems;
    }

    /// What may not be meant.
    List<Problem> warnings() {
        return hints.all();
    }

    Set<PerceptBelief> percepts() {
        return percepts;
    }

    Set<Topic<?>> topics() {
        return topics;
    }

    List<Class<? extends Device>> devices() {
        return List.copyOf(devices);
    }

    /// Where it says something to others.
    List<Literal> said() {
        return said;
    }

    private void belief(Literal belief) {
        if (!belief.isRule() && countsWithAVariable(belief)) {
            problems.add(
                    program.locationOf(belief),
                    "Belief '%s' counts with a variable, which has no value here.".formatted(belief.getFunctor()),
                    "Write a number in its place, or a rule that says where the value comes from: %s(Y) :- …."
                            .formatted(belief.getFunctor()));
        }
        hints.believes(belief);
        formula(belief);
    }

    private static boolean countsWithAVariable(Term term) {
        return switch (term) {
            case VarTerm _ -> false; // which is a list and a number, too, as long as nobody knows
            case ArithFunctionTerm counted -> !counted.isGround();
            case ListTerm list -> list.getAsList().stream().anyMatch(StaticChecker::countsWithAVariable);
            case Structure structure ->
                structure.hasTerm() && structure.getTerms().stream().anyMatch(StaticChecker::countsWithAVariable);
            default -> false;
        };
    }

    private void plan(Plan plan) {
        Trigger trigger = plan.getTrigger();
        hints.handles(trigger);
        if (trigger.getType() == Trigger.TEType.belief) {
            event(trigger.getLiteral());
        }
        Optional.ofNullable(plan.getContext()).ifPresent(this::formula);
        body(plan.getBody());
        if (plan.hasSubPlans()) {
            plan.getSubPlans().getPlans().forEach(this::plan);
        }
    }

    private void event(Literal literal) {
        if (literal.getFunctor().equals(TopicEvents.FUNCTOR) && literal.getArity() == TopicEvents.ARITY) {
            heard(literal);
        } else {
            formula(literal);
        }
    }

    private void heard(Literal literal) {
        Term topic = literal.getTerm(0);
        if (topic.isVar()) {
            topics.addAll(Topics.installed());
            return;
        }
        String name = Terms.words(topic);
        TopicEvents.topic(name)
                .ifPresentOrElse(
                        topics::add,
                        () -> problems.add(
                                program.locationOf(literal),
                                "There is no topic '%s'.".formatted(name),
                                Suggestion.among(
                                        name,
                                        Topics.installed().stream()
                                                .map(TopicEvents::name)
                                                .toList())));
    }

    private void body(PlanBody body) {
        for (PlanBody step = body; step != null && !step.isEmptyBody(); step = step.getBodyNext()) {
            Term term = step.getBodyTerm();
            hints.does(step.getBodyType(), term);
            if (term instanceof PlanBody inner) {
                body(inner);
            } else if (step.getBodyType() == BodyType.action && term instanceof Literal literal) {
                action(literal);
            } else if (term instanceof InternalActionLiteral
                    || step.getBodyType() == BodyType.test
                    || step.getBodyType() == BodyType.constraint) {
                formula(term);
            }
        }
    }

    private void action(Literal literal) {
        if (literal instanceof VarTerm) {
            return; // told when it is done
        }
        Action.of(literal.getFunctor())
                .ifPresentOrElse(
                        action -> {
                            action.device().ifPresent(devices::add);
                            if (!action.takes(literal.getArity())) {
                                problems.add(
                                        program.locationOf(literal),
                                        "Action '%s' takes %s terms, not %d."
                                                .formatted(literal.getFunctor(), action.size(), literal.getArity()),
                                        "");
                            }
                            if (action == Action.PUBLISH && literal.getArity() > 0) {
                                said.add(literal);
                                published(literal);
                            }
                        },
                        () -> problems.add(
                                program.locationOf(literal),
                                "There is no action '%s'.".formatted(literal.getFunctor()),
                                Suggestion.among(literal.getFunctor(), Action.names())));
    }

    private void published(Literal literal) {
        if (!literal.getTerm(0).isVar()) {
            String name = Terms.words(literal.getTerm(0));
            if (TopicEvents.topic(name).isEmpty()) {
                problems.add(
                        program.locationOf(literal),
                        "There is no topic '%s'.".formatted(name),
                        Suggestion.among(
                                name,
                                Topics.installed().stream()
                                        .map(TopicEvents::name)
                                        .toList()));
            }
        }
    }

    /// A condition, or what stands in one.
    private void formula(Term term) {
        switch (term) {
            case Rule rule -> formula(rule.getBody());
            case LogExpr formula -> formula.getTerms().forEach(this::formula);
            case RelExpr _, ArithExpr _, VarTerm _ -> {}
            case PlanBody body -> body(body);
            case Trigger event -> event(event.getLiteral());
            case InternalActionLiteral action -> internal(action);
            case Literal literal -> PerceptBelief.of(literal).ifPresent(percepts::add);
            default -> {}
        }
    }

    private void internal(InternalActionLiteral action) {
        String name = action.getFunctor();
        if (!Library.isKnown(name)) {
            problems.add(
                    program.locationOf(action),
                    "Internal action '%s' can't be used here.".formatted(name),
                    Library.instead(name));
        }
        if (Library.isSaying(name)) {
            said.add(action);
        }
        if (action.hasTerm()) {
            boolean asks = Library.asks(name);
            action.getTerms().stream().filter(term -> asks || !isPlain(term)).forEach(this::formula);
        }
    }

    /// Whether it is only a term, as what is said to others: nothing that is believed, done or waited for.
    private static boolean isPlain(Term term) {
        return term instanceof Literal
                && !(term instanceof InternalActionLiteral
                        || term instanceof PlanBody
                        || term instanceof Rule
                        || term instanceof LogExpr);
    }
}
