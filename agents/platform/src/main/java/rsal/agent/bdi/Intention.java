package rsal.agent.bdi;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;

/// A goal that is pursued: the plan for it, the steps that this wants first, and which plans have been tried. On the
/// agent's lane.
final class Intention {
    private static final int DEEPEST = 100; // steps within steps

    private final Mind mind;
    private final Goal goal;
    private final Deque<Level> levels = new ArrayDeque<>(); // the innermost first
    private boolean running = true;
    private boolean deferred; // a plan ended while it was suspended
    private boolean over;

    Intention(Mind mind, Goal goal) {
        this.mind = mind;
        this.goal = goal;
    }

    Goal goal() {
        return goal;
    }

    /// What is done now, from the goal inward, as `collect: fetch > open the door: push`.
    List<String> steps() {
        return List.copyOf(levels).reversed().stream().map(Level::words).toList();
    }

    void begin() {
        push(goal, reached -> mind.ended(this, reached));
    }

    void push(Goal step, Consumer<Boolean> then) {
        if (levels.size() == DEEPEST) {
            throw new IllegalStateException(
                    "Goal '%s' wants more than %d steps within steps.".formatted(goal.name(), DEEPEST));
        }
        levels.push(new Level(step, then));
        tryNext();
    }

    /// Tries the innermost goal's next plan.
    private void tryNext() {
        if (!running) {
            deferred = true; // until it may go on
            return;
        }
        Level level = levels.element();
        Optional<Goal.Plan> next = level.goal.plans().stream()
                .filter(plan -> !level.tried.contains(plan) && plan.applicable().getAsBoolean())
                .findFirst();
        if (next.isEmpty()) {
            leave(false);
            return;
        }
        Goal.Plan plan = next.get();
        level.tried.add(plan);
        var doing = new PlanContext(this, level.goal, plan.name());
        level.doing = Optional.of(doing);
        mind.changed();
        plan.body().accept(doing);
    }

    void succeeded(PlanContext doing) {
        if (isInnermost(doing)) {
            if (!doing.goal().hasTarget() || doing.goal().isReached()) {
                leave(true);
            } else {
                tryNext();
            }
        }
    }

    void failed(PlanContext doing, String why) {
        mind.note(doing.goal(), doing.plan(), why);
        if (isInnermost(doing)) {
            tryNext();
        } else if (!over) {
            abortDownTo(doing);
            tryNext();
        }
    }

    private boolean isInnermost(PlanContext doing) {
        return !over && levels.element().doing.filter(doing::equals).isPresent();
    }

    /// A plan that waits for a step has failed: the step is not wanted any more.
    private void abortDownTo(PlanContext doing) {
        while (levels.element().doing.filter(doing::equals).isEmpty()) {
            levels.pop().doing.ifPresent(PlanContext::abort);
        }
    }

    private void leave(boolean reached) {
        Level level = levels.pop();
        over = levels.isEmpty();
        level.then.accept(reached);
    }

    void suspend() {
        running = false;
        innermost().ifPresent(PlanContext::suspend);
    }

    void resume() {
        running = true;
        if (deferred) {
            deferred = false;
            tryNext();
        } else {
            innermost().ifPresent(PlanContext::resume);
        }
    }

    private Optional<PlanContext> innermost() {
        return over ? Optional.empty() : levels.element().doing.filter(doing -> !doing.isOver());
    }

    /// Ends all that is under way, the innermost first.
    void abort() {
        over = true;
        while (!levels.isEmpty()) {
            levels.pop().doing.ifPresent(PlanContext::abort);
        }
    }

    private static final class Level {
        private final Goal goal;
        private final Consumer<Boolean> then;
        private final Set<Goal.Plan> tried = new HashSet<>();
        private Optional<PlanContext> doing = Optional.empty();

        Level(Goal goal, Consumer<Boolean> then) {
            this.goal = goal;
            this.then = then;
        }

        String words() {
            return goal.name() + doing.map(now -> ": " + now.plan()).orElse("");
        }
    }
}
