package rsal.agent;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.random.RandomGenerator;
import rsal.data.Stamped;
import rsal.device.Sensor;
import rsal.device.SimulationControl;
import rsal.device.Subscription;
import rsal.robot.Robot;
import rsal.time.Scheduler;

/// What an agent is given at its start. May be used only on the agent's lane: another thread may ask for its name, its
/// role and the time (`scheduler().instant()`), and hand over what is to be done (`scheduler().execute(...)`). Anything
/// else it is refused by an [IllegalStateException], and the agent is ended, as equal runs would differ.
///
/// When the agent ends, so do all its subscriptions, tasks and notes.
public interface AgentContext {
    /// Unique in a run.
    String name();

    /// What the scenario calls agents of its kind (`follow`).
    String role();

    /// The robot it acts for; empty for those without a body.
    Optional<Robot> robot();

    /// Time and timers. Tasks run on the agent's lane; one that throws ends the agent. Hand it to what comes
    /// later from elsewhere, too: `goal.result().thenAccept(r -> self.scheduler().execute(() -> onArrival(r)))`.
    /// Without this, or by `thenAcceptAsync`, the stage would keep to itself what `onArrival` throws.
    Scheduler scheduler();

    /// A stream of this agent's own, from the run's seed and the agent's name.
    RandomGenerator random();

    /// Tells all who listen, but for itself, in the order in which they subscribed, at this instant, after what
    /// is running now.
    <M> void publish(Topic<M> topic, M message);

    /// Tells one agent, itself too, if it listens, at this instant, after what is running now. Nobody learns whether
    /// it did: who must know has a conversation ([rsal.agent.protocol]).
    ///
    /// @param to name of that agent
    <M> void send(String to, Topic<M> topic, M message);

    /// Tells of each message for all or for this agent, on its lane. A listener that throws ends the agent.
    default <M> Subscription subscribe(Topic<M> topic, Consumer<? super Message<M>> listener) {
        return subscribe(topic, Interest.all(), listener);
    }

    /// Tells of those messages that it is interested in.
    <M> Subscription subscribe(Topic<M> topic, Interest<M> interest, Consumer<? super Message<M>> listener);

    /// Tells of each reading of a device, on the agent's lane, when it is the agents' turn at that instant
    /// ([rsal.time.Phase#THINK]). A listener that throws ends the agent.
    <T> Subscription subscribe(Sensor<T> sensor, Consumer<? super Stamped<T>> listener);

    /// Who else is there.
    Directory directory();

    /// Lets the others know what it can do for them, until it withdraws that or ends. Offering something under the same
    /// name again replaces it.
    Subscription offer(ServiceDescription capability);

    /// This agent's own notes.
    Blackboard blackboard();

    /// The truth of the simulated world, for agents that stage or display; empty where all is real.
    Optional<SimulationControl> simulation();

    /// Says in a few words what it is doing, for people (`hunting prey-1`).
    void state(String words);

    /// Prints a line, for people. Each line is an event of the run, also when it is equal to the last; the
    /// newest is what it says it is doing ([#state]).
    void print(String line);

    /// Publishes a value for the run's results: a measure of the scenario names it as `metric(name)`.
    ///
    /// @param name up to 100 characters
    /// @param value finite; in the unit that the measure has
    /// @throws IllegalArgumentException when the name is empty or too long, or the value is not finite
    void metric(String name, double value);

    /// Says that it wants a goal for which it has no plan at all: an error of its author, which the outcome
    /// of the run tells.
    ///
    /// @param goal in its own language: `guard(1)`
    /// @param where in its file; empty when nobody knows
    void unhandled(String goal, String where);

    /// Shows something it believes, for people; replaces what it showed under this name.
    void show(String name, String belief);

    /// Lets people look into it: when somebody does, `view` says what is there now, quickly and without
    /// effects. Costs nothing while nobody looks. What it revealed of that type before is replaced.
    ///
    /// @param view asked on the run's thread; what it throws is told to those who look, and does the agent no harm
    <T> void reveal(Class<T> type, Supplier<? extends T> view);

    /// Says that the agent's own code runs in another process: who looks whether it returns asks there.
    void outside(OutsideCode code);

    /// Does something when the agent ends, however it ends: for letting go of what would go on without it. The
    /// last thing asked for is done first.
    void atEnd(Runnable lettingGo);
}
