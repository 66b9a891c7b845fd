package rsal.agent.bdi;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.time.Scheduler;

/// An agent's beliefs, goals and intentions, and the cycle that chooses among them: whenever a belief changes,
/// a plan ends, or time is up, the most urgent goal that is wanted is pursued. One that is pursued and no more
/// wanted is given up; one that is still wanted, but less urgent, waits with its plan and goes on later.
///
/// All on the agent's lane. What it believes, wants and does is shown to people, and to those who look into the
/// agent ([rsal.agent.platform.AgentPlatform#look]).
public final class Mind {
    private final AgentContext self;
    private final Scheduler scheduler;
    private final Map<String, Belief<?>> beliefs = new LinkedHashMap<>();
    private final List<Goal> goals = new ArrayList<>();
    private final Map<Goal, Intention> intentions = new LinkedHashMap<>();
    private final Map<Goal, Instant> resting = new HashMap<>(); // until when
    private final Map<Goal, String> failures = new HashMap<>(); // of the last plan, in words
    private @Nullable Intention pursued;
    private boolean begun;
    private boolean due;
    private boolean over;

    public Mind(AgentContext self) {
        this.self = self;
        this.scheduler = self.scheduler();
        self.reveal(View.class, this::view);
        self.atEnd(this::end);
    }

    /// A new belief.
    ///
    /// @throws IllegalArgumentException when there is one of that name
    public <T> Belief<T> belief(String name, T value) {
        var belief = new Belief<>(this, name, value);
        if (beliefs.putIfAbsent(name, belief) != null) {
            throw new IllegalArgumentException("Agent '%s' has two beliefs '%s'.".formatted(self.name(), name));
        }
        believes(belief);
        return belief;
    }

    /// A new goal, wanted from now on.
    public Goal goal(String name) {
        var goal = new Goal(this, name);
        goals.add(goal);
        think();
        return goal;
    }

    /// A goal that is pursued only as a step of a plan ([PlanContext#achieve]).
    public Goal step(String name) {
        return new Goal(this, name);
    }

    /// Begins to choose.
    public void begin() {
        begun = true;
        think();
    }

    /// Begins to choose, and chooses again in between, for conditions that hang on more than beliefs.
    public void begin(Duration period) {
        begin();
        scheduler.every(period, this::think);
    }

    /// Chooses again, after what is running now.
    public void think() {
        if (begun && !due && !over) {
            due = true;
            scheduler.execute(() -> {
                due = false;
                choose();
            });
        }
    }

    private void choose() {
        if (over) {
            return;
        }
        for (Intention intention : List.copyOf(intentions.values())) {
            if (!intention.goal().isWanted()) {
                giveUp(intention);
            }
        }
        goals.removeIf(goal -> goal.isOnce() && goal.isReached());
        Optional<Goal> best = mostUrgent();
        Intention before = pursued;
        if (best.isEmpty() || (before != null && before.goal().equals(best.get()))) {
            return;
        }
        if (before != null) {
            before.suspend();
        }
        pursue(best.get());
    }

    private Optional<Goal> mostUrgent() {
        Goal best = null;
        double most = Double.NEGATIVE_INFINITY;
        for (Goal goal : goals) {
            if (!goal.isWanted() || isResting(goal)) {
                continue;
            }
            double urgency = goal.urgency();
            boolean stays = urgency == most && pursued != null && pursued.goal().equals(goal);
            if (best == null || urgency > most || stays) {
                best = goal;
                most = urgency;
            }
        }
        return Optional.ofNullable(best);
    }

    private boolean isResting(Goal goal) {
        Instant until = resting.get(goal);
        return until != null && scheduler.instant().isBefore(until);
    }

    private void pursue(Goal goal) {
        Intention known = intentions.get(goal);
        if (known != null) {
            pursued = known;
            known.resume();
        } else {
            var intention = new Intention(this, goal);
            intentions.put(goal, intention);
            pursued = intention;
            intention.begin();
        }
        changed();
    }

    private void giveUp(Intention intention) {
        forget(intention);
        intention.abort();
        changed();
    }

    private void forget(Intention intention) {
        intentions.remove(intention.goal(), intention);
        if (intention.equals(pursued)) {
            pursued = null;
        }
    }

    /// All plans of an intention have been tried, or one has worked.
    void ended(Intention intention, boolean reached) {
        forget(intention);
        Goal goal = intention.goal();
        if (reached) {
            failures.remove(goal);
        }
        if (goal.isOnce()) {
            goals.remove(goal);
        } else if (!reached || !goal.hasTarget()) {
            resting.put(goal, scheduler.instant().plus(goal.pause()));
            scheduler.after(goal.pause(), this::think);
        }
        changed();
        think();
    }

    void drop(Goal goal) {
        goals.remove(goal);
        resting.remove(goal);
        Intention intention = intentions.get(goal);
        if (intention != null) {
            giveUp(intention);
        }
        think();
    }

    /// For people.
    private static String words(Object value) {
        return value instanceof Double number && number == Double.POSITIVE_INFINITY ? "∞" : String.valueOf(value);
    }

    void believes(Belief<?> belief) {
        self.show(belief.name(), words(belief.get()));
        think();
    }

    /// A plan has failed.
    void note(Goal goal, String plan, String why) {
        failures.put(goal, "%s: %s".formatted(plan, why));
        changed();
    }

    /// Shows what it does.
    void changed() {
        if (pursued != null) {
            self.state(String.join(" > ", pursued.steps()));
        } else {
            self.state("nothing to do");
        }
    }

    private void end() {
        over = true;
        List.copyOf(intentions.values()).reversed().forEach(Intention::abort);
        intentions.clear();
    }

    /// What is in it now, for people.
    public View view() {
        var believed = new LinkedHashMap<String, String>();
        beliefs.forEach((name, belief) -> believed.put(name, words(belief.get())));
        List<GoalView> wanted = goals.stream()
                .map(goal -> new GoalView(
                        goal.name(),
                        state(goal),
                        goal.urgency(),
                        goal.plans().stream().map(Goal.Plan::name).toList(),
                        intentions.containsKey(goal) ? intentions.get(goal).steps() : List.of(),
                        failures.getOrDefault(goal, "")))
                .toList();
        return new View(Collections.unmodifiableMap(believed), wanted);
    }

    private GoalState state(Goal goal) {
        if (pursued != null && pursued.goal().equals(goal)) {
            return GoalState.PURSUED;
        }
        if (intentions.containsKey(goal)) {
            return GoalState.SUSPENDED;
        }
        if (!goal.isWanted()) {
            return goal.isReached() ? GoalState.REACHED : GoalState.NOT_WANTED;
        }
        return isResting(goal) ? GoalState.RESTING : GoalState.WAITING;
    }

    /// @param beliefs values in words by name
    /// @param goals in the order in which they were declared
    public record View(Map<String, String> beliefs, List<GoalView> goals) {}

    /// What an agent goes by that is written in a language for agents, as it is written there.
    ///
    /// @param rules by which it believes more than it is told
    /// @param plans by name, as [GoalView#plans] has them; of several with one name, one below the other
    public record Program(List<String> rules, Map<String, String> plans) {
        public Program {
            rules = List.copyOf(rules);
            plans = Collections.unmodifiableMap(new LinkedHashMap<>(plans));
        }
    }

    /// @param plans names of the ways to reach it, in the order in which they are tried
    /// @param steps what is or was done for it, from the goal inward: `collect: fetch`, `open the door: push`
    /// @param failure which plan failed last, and why; empty when none has
    public record GoalView(
            String name, GoalState state, double urgency, List<String> plans, List<String> steps, String failure) {}

    public enum GoalState {
        /// Its context does not hold.
        NOT_WANTED,
        REACHED,
        /// Something else is more urgent.
        WAITING,
        PURSUED,
        /// It was pursued until something else was more urgent, and will go on.
        SUSPENDED,
        /// All its plans have failed, or it was reached and will be wanted again.
        RESTING
    }
}
