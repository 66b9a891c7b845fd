package rsal.agent.bdi;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.DoubleSupplier;

/// Something an agent wants. It is wanted while its context holds and what it is for has not been reached; of all that
/// is wanted the most urgent is pursued. On the agent's lane.
///
/// Conditions and priorities are asked whenever the mind thinks: quick, without effects.
public final class Goal {
    private final Mind mind;
    private final String name;
    private final List<Plan> plans = new ArrayList<>();
    private DoubleSupplier priority = () -> 0;
    private BooleanSupplier context = () -> true;
    private BooleanSupplier reached = () -> false;
    private boolean hasTarget;
    private boolean once;
    private Duration pause = Duration.ofSeconds(1);

    Goal(Mind mind, String name) {
        this.mind = mind;
        this.name = name;
    }

    public String name() {
        return name;
    }

    /// How urgent it is; 0 when nothing is said. Of goals that are equally urgent the one that is pursued stays,
    /// else the one that was declared first comes first.
    public Goal priority(DoubleSupplier urgency) {
        priority = urgency;
        return this;
    }

    /// It is wanted only while this holds.
    public Goal when(BooleanSupplier wanted) {
        context = wanted;
        return this;
    }

    /// It is reached when this holds, however that came; it is wanted again when it holds no more. Without this it is
    /// reached when a plan succeeds, and wanted again at once, after a pause.
    public Goal until(BooleanSupplier target) {
        reached = target;
        hasTarget = true;
        return this;
    }

    /// It ends for good when it has been reached or all plans have failed.
    public Goal once() {
        once = true;
        return this;
    }

    /// How long it rests before it is tried again after all its plans have failed, or, without a target, after it was
    /// reached; 1 s when nothing is said.
    public Goal pause(Duration rest) {
        pause = rest;
        return this;
    }

    /// A way to reach it. Plans are tried in the order in which they are given.
    ///
    /// @param body begins it, and says how it ended
    public Goal plan(String planName, Consumer<PlanContext> body) {
        return plan(planName, () -> true, body);
    }

    /// @param applicable whether it can be tried now
    public Goal plan(String planName, BooleanSupplier applicable, Consumer<PlanContext> body) {
        plans.add(new Plan(planName, applicable, body));
        return this;
    }

    /// Does not want it any more.
    public void drop() {
        mind.drop(this);
    }

    double urgency() {
        return priority.getAsDouble();
    }

    boolean isWanted() {
        return context.getAsBoolean() && !isReached();
    }

    boolean isReached() {
        return hasTarget && reached.getAsBoolean();
    }

    boolean hasTarget() {
        return hasTarget;
    }

    boolean isOnce() {
        return once;
    }

    Duration pause() {
        return pause;
    }

    List<Plan> plans() {
        return plans;
    }

    record Plan(String name, BooleanSupplier applicable, Consumer<PlanContext> body) {}
}
