package rsal.agent.bdi;

import java.util.function.Consumer;

/// A plan under way. Its body hooks in here what is to be done when it has to wait or ends, and says how it ended; what
/// it says after its end is not heard. On the agent's lane.
public final class PlanContext {
    private final Intention intention;
    private final Goal goal;
    private final String plan;
    private Runnable suspended = () -> {};
    private Runnable resumed = () -> {};
    private Runnable ended = () -> {};
    private boolean over;

    PlanContext(Intention intention, Goal goal, String plan) {
        this.intention = intention;
        this.goal = goal;
        this.plan = plan;
    }

    /// The plan has worked.
    public void succeed() {
        finish(() -> intention.succeeded(this));
    }

    /// The plan has not worked; another may be tried. Said while it is suspended, that happens when the goal is pursued
    /// again.
    public void fail(String why) {
        finish(() -> intention.failed(this, why));
    }

    /// Pursues something else first, as a step of this plan; it is part of the same intention.
    ///
    /// @param step made by [Mind#step]; its context and priority do not matter
    /// @param then told whether it was reached
    public void achieve(Goal step, Consumer<Boolean> then) {
        if (!over) {
            intention.push(step, then);
        }
    }

    /// Runs when something more urgent comes: lets go of the robot.
    public PlanContext onSuspend(Runnable pause) {
        suspended = pause;
        return this;
    }

    /// Runs when it may go on.
    public PlanContext onResume(Runnable goOn) {
        resumed = goOn;
        return this;
    }

    /// Runs once when it is over, however it ended: lets go of the robot for good.
    public PlanContext onEnd(Runnable lettingGo) {
        ended = lettingGo;
        if (over) {
            lettingGo.run();
        }
        return this;
    }

    public boolean isOver() {
        return over;
    }

    Goal goal() {
        return goal;
    }

    String plan() {
        return plan;
    }

    void suspend() {
        suspended.run();
    }

    void resume() {
        resumed.run();
    }

    /// Ends it from outside.
    void abort() {
        finish(() -> {});
    }

    private void finish(Runnable andThen) {
        if (!over) {
            over = true;
            ended.run();
            andThen.run();
        }
    }
}
