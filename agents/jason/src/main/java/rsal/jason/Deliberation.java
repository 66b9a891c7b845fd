package rsal.jason;

import jason.JasonException;
import jason.architecture.AgArch;
import jason.asSemantics.Agent;
import jason.asSemantics.Circumstance;
import jason.asSemantics.Event;
import jason.asSemantics.IntendedMeans;
import jason.asSemantics.Intention;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.PlanBody;
import jason.asSyntax.SourceInfo;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;
import jason.bb.BeliefBase;
import jason.runtime.Settings;
import jason.stdlib.fail_goal;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.time.Task;

/// Jason's reasoning cycle with deadlines of goals in the run's time.
final class Deliberation extends TransitionSystem {
    private static final long serialVersionUID = 1;

    private static final int MOST_VALUES = 100; // characters

    private final AgArch architecture;
    private final transient List<Deadline> deadlines = new ArrayList<>();
    private transient @Nullable Diagnostics complaints;

    /// @param size of the intention without the goal
    private record Deadline(Task task, Intention intention, int size) {
        boolean isOver() {
            return intention.isFinished() || intention.size() < size;
        }
    }

    Deliberation(Agent agent, Circumstance circumstance, AgArch architecture) {
        super(agent, circumstance, new Settings(), architecture);
        this.architecture = architecture;
    }

    /// To be told before the first cycle.
    void complainTo(Diagnostics whom) {
        complaints = whom;
        setLogger(whom.logger());
    }

    @Override
    public void reasoningCycle() {
        super.reasoningCycle();
        deadlines.removeIf(deadline -> {
            if (deadline.isOver()) {
                deadline.task.cancel();
            }
            return deadline.isOver();
        });
    }

    /// What fails next when a goal has failed. Jason would try a failure plan that fails for ever where no goal is left
    /// below it, and knows no intention without goals, as `.fail_goal` leaves them.
    @Override
    public @Nullable Event findEventForFailure(@Nullable Intention intention, Trigger failed) {
        Event next = failureOf(intention, failed);
        if (next == null) {
            reportUnplanned(intention, failed);
        }
        return next;
    }

    private @Nullable Event failureOf(@Nullable Intention intention, Trigger failed) {
        if (intention == null || intention.isFinished()) {
            return super.findEventForFailure(Intention.EmptyInt, failed);
        }
        Event next = super.findEventForFailure(intention, failed);
        return next == null || failed.isAddition() || !isTried(intention, next.getTrigger()) ? next : null;
    }

    /// Says which goal had no plan and where it was set, when nobody has a plan for that failure either.
    ///
    /// @param intention that the goal is to be part of
    @SuppressWarnings("ReferenceEquality") // that very goal, not one like it
    private void reportUnplanned(@Nullable Intention intention, Trigger goal) {
        Event selected = getC().getSelectedEvent();
        boolean pursued =
                intention != null && !intention.isFinished() && intention.peek().getTrigger() == goal;
        if (selected != null && selected.getTrigger() == goal && goal.isGoal() && goal.isAddition() && !pursued) {
            Literal literal = goal.getLiteral();
            String which = Terms.written(literal.copy().clearAnnots());
            String whence = literal.getSources().stream()
                    .filter(source -> !source.equals(BeliefBase.ASelf))
                    .findFirst()
                    .map(source -> ", which '%s' asked for".formatted(Terms.unquoted(source.toString())))
                    .orElseGet(() -> literal.getSrcInfo() == null ? "" : " at " + literal.getSrcInfo());
            String words = getAg().getPL().hasCandidatePlan(goal)
                    ? "No plan for goal '%s'%s applies now."
                    : "There is no plan for goal '%s'%s.";
            getLogger().warning(words.formatted(which, whence));
            if (!getAg().getPL().hasCandidatePlan(goal) && getAgArch() instanceof Architecture own) {
                own.unhandled(
                        which,
                        literal.getSrcInfo() == null ? "" : literal.getSrcInfo().toString());
            }
        }
    }

    /// Whether as many plans for the failure of a goal are under way as there are such goals.
    private static boolean isTried(Intention intention, Trigger failure) {
        int goals = 0;
        int failures = 0;
        for (IntendedMeans means : intention) {
            Trigger trigger = means.getTrigger();
            boolean same = trigger.isGoal() && new Unifier().unifies(failure.getLiteral(), trigger.getLiteral());
            goals += same && trigger.isAddition() ? 1 : 0;
            failures += same && !trigger.isAddition() ? 1 : 0;
        }
        return failures >= goals;
    }

    /// Says what has failed where, when nobody has a plan for that. Plans for it learn, too, what an internal action
    /// threw; Jason leaves that out where it is no `JasonException`.
    @Override
    public boolean generateGoalDeletion(Intention intention, List<Term> annotations, Term reason)
            throws JasonException {
        IntendedMeans failed = intention.peek();
        String thrown = complaints == null ? "" : complaints.takeThrownInAction();
        List<Term> about = thrown.isEmpty()
                ? constraint(failed)
                        .map(words -> (List<Term>) JasonException.createBasicErrorAnnots("constraint_failed", words))
                        .orElse(annotations)
                : JasonException.createBasicErrorAnnots("ia_failed", thrown);
        boolean goesOn = super.generateGoalDeletion(intention, about, reason);
        if (!goesOn) {
            getLogger().warning(words(failed, about));
        }
        return goesOn;
    }

    /// Which constraint does not hold, and what stood in it, where that is short; empty where something else
    /// has failed. Jason would tell the rest of the plan, and the values of all variables.
    private static Optional<String> constraint(IntendedMeans failed) {
        PlanBody step = step(failed);
        if (step == null || step.getBodyType() != PlanBody.BodyType.constraint) {
            return Optional.empty();
        }
        String written = Terms.masked(step.getBodyTerm().toString());
        String values = Terms.masked(step.getBodyTerm().capply(failed.getUnif()).toString());
        String then = values.equals(written) || values.length() > MOST_VALUES ? "" : ": " + values;
        return Optional.of("Constraint %s does not hold%s at %s".formatted(written, then, step.getSrcInfo()));
    }

    /// Where it has failed; null when at its end.
    private static @Nullable PlanBody step(IntendedMeans failed) {
        return failed.isFinished() ? null : failed.getCurrentStep();
    }

    private static String words(IntendedMeans failed, @Nullable List<Term> annotations) {
        PlanBody step = step(failed);
        SourceInfo place =
                step == null || step.getSrcInfo() == null ? failed.getPlan().getSrcInfo() : step.getSrcInfo();
        String what = step == null ? "" : ": " + step.getBodyType() + Terms.written(step.getBodyTerm());
        Trigger event = failed.getTrigger();
        String words = !event.isGoal()
                ? "A plan for '%s' has failed at %s%s%s."
                : event.isAddition()
                        ? "Goal '%s' has failed at %s%s%s. There is no plan for that."
                        : "Goal '%s' has failed, and so has the plan for that at %s%s%s.";
        return words.formatted(Terms.written(event.getLiteral().copy().clearAnnots()), place, what, why(annotations));
    }

    private static String why(@Nullable List<Term> annotations) {
        return annotations == null
                ? ""
                : annotations.stream()
                        .filter(each -> each instanceof Literal about
                                && about.getFunctor().equals("error_msg")
                                && about.getArity() == 1)
                        .map(each -> Terms.words(((Literal) each).getTerm(0)))
                        .filter(words -> !words.isBlank())
                        .map(words -> " (" + words + ")")
                        .findFirst()
                        .orElse("");
    }

    @Override
    protected void checkHardDeadline(Event event) {
        Literal goal = event.getTrigger().getLiteral();
        Literal deadline = goal.getAnnot(ASSyntax.hardDeadLineStr);
        if (deadline == null || !(architecture instanceof Architecture own)) {
            return;
        }
        if (deadline.getArity() != 1) {
            getLogger().warning("A deadline must be a number of milliseconds, not '%s'.".formatted(deadline));
            return;
        }
        Optional<Intention> intention = Optional.ofNullable(event.getIntention());
        int size = intention.map(Intention::size).orElse(0);
        try {
            Task task = own.after(
                    Terms.millis(deadline.getTerm(0)),
                    () -> runAtBeginOfNextCycle(() -> fail(goal, event.getIntention(), size, event)));
            intention.ifPresent(waiting -> deadlines.add(new Deadline(task, waiting, size)));
        } catch (IllegalArgumentException e) {
            getLogger().warning("A deadline of goal '%s': %s".formatted(Terms.written(goal), e.getMessage()));
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
                getLogger().warning("Goal '%s' could not be ended: %s".formatted(goal, e.getMessage()));
            }
        }
    }
}
