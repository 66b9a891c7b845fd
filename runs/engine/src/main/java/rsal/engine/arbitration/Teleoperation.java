package rsal.engine.arbitration;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import rsal.behavior.Pilot;
import rsal.behavior.Repertoire;
import rsal.behavior.Subsumption;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.Device;
import rsal.device.DriveBase;
import rsal.device.GoalHandle;
import rsal.device.Navigator;
import rsal.device.Navigator.Progress;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.engine.arbitration.CommandArbiter.Source;
import rsal.engine.event.EventLog;
import rsal.engine.report.Abilities;
import rsal.engine.report.Answer;
import rsal.engine.report.RunBroken;
import rsal.engine.report.Words;
import rsal.robot.Robot;
import rsal.scenario.RunPlan.PlannedDevice;
import rsal.scenario.RunPlan.Spare;
import rsal.scenario.RunPlan.Spares;

/// What people tell one robot to do. Keys come before orders (a behavior, or a place to go to), orders before what the
/// robot's agents want; of orders the newest counts. Who has to wait is paused meanwhile.
///
/// All calls on the run's thread.
public final class Teleoperation {
    /// The order to do nothing.
    static final String STAND = "stand";

    private final Robot robot;
    private final DriveBase base;
    private final CommandArbiter arbiter;
    private final Spares spares;
    private final Maker maker;
    private final EventLog eventLog;
    private final List<Runnable> resuming = new ArrayList<>(); // those who wait
    private final List<Device> made = new ArrayList<>();
    private Robot outfit; // what orders are done with
    private String behavior = "";
    private @Nullable GoalHandle<Progress, Result> trip;
    private @Nullable KeyboardDriving grip;

    /// Makes a device for a robot from those that it has.
    public interface Maker {
        Device make(PlannedDevice device, Robot robot);
    }

    /// @param robot as its agents have it
    public Teleoperation(Robot robot, CommandArbiter arbiter, Spares spares, Maker maker, EventLog eventLog) {
        this.robot = robot;
        this.base = arbiter.base();
        this.arbiter = arbiter;
        this.spares = spares;
        this.maker = maker;
        this.eventLog = eventLog;
        this.outfit = arbiter.steering(withoutDrivers(robot), Source.ORDERS);
    }

    /// The same robot without what its agents drive it by.
    private static Robot withoutDrivers(Robot robot) {
        return robot.with(robot.devices().stream()
                .filter(device -> !(device instanceof Pilot || device instanceof Navigator))
                .toList());
    }

    /// Of those who command the base, who it listens to; empty when that is somebody's hand.
    public Optional<Robot> incharge() {
        return switch (arbiter.hand()) {
            case AGENTS -> Optional.of(robot);
            case ORDERS -> Optional.of(outfit);
            case KEYS -> Optional.empty();
        };
    }

    /// The robot with what orders are done with, as far as that was made.
    public Robot outfit() {
        return outfit;
    }

    /// Devices that it has besides those of its agents.
    public List<Device> made() {
        return made;
    }

    /// Who drives it by keys; empty when nobody does.
    public String driver() {
        return grip == null ? "" : grip.driver();
    }

    /// What it was told to do; empty when nobody told it anything.
    public String behavior() {
        return behavior;
    }

    public Abilities abilities() {
        var behaviors = new ArrayList<>(List.of(STAND));
        if (spares.pilot().isPossible()) {
            behaviors.addAll(Repertoire.names());
        }
        boolean goes =
                spares.navigation().isPossible() || robot.find(Navigator.class).isPresent();
        return new Abilities(
                robot.model().drive(),
                behaviors,
                spares.pilot().refusal(),
                goes ? "" : spares.navigation().refusal());
    }

    /// Drives by hand from now on, as long as this is said again and again.
    ///
    /// @param now when it was said [ns]
    public Answer drive(String driver, Twist2d velocity, long now) {
        takeBack(now);
        boolean motors = !arbiter.isOff();
        if (grip != null && !grip.driver().equals(driver)) {
            return new Answer.Refused("Somebody else drives robot '%s' by keys.".formatted(robot.id()));
        }
        if (grip == null) {
            grip = new KeyboardDriving(driver, now, motors);
            eventLog.event("operator", robot.id(), "driven by keys");
            settle();
        }
        Twist2d before = grip.wanted();
        grip.want(velocity, now, motors);
        if (!grip.wanted().equals(before)) {
            eventLog.event("hand", robot.id(), Words.of(grip.wanted()));
        }
        base.command(grip.wanted());
        return new Answer.Done();
    }

    /// Gives it back. Nothing happens to a robot that somebody else drives, or nobody.
    public Answer letGo(String driver) {
        if (grip != null && grip.driver().equals(driver)) {
            end("no longer driven by keys");
        }
        return new Answer.Done();
    }

    private void end(String words) {
        grip = null;
        eventLog.event("operator", robot.id(), words);
        settle();
    }

    /// Goes on as its driver wants, if there is one who is still heard.
    ///
    /// @param now [ns]
    public void beat(long now) {
        takeBack(now);
        if (grip == null) {
            return;
        }
        if (grip.fadesAt(now)) {
            eventLog.event("operator", robot.id(), "stands still: its driver is not heard");
        }
        base.command(grip.wanted());
    }

    /// Ends the grip of a driver who had not been heard for long by then. Orders are judged by when they were given,
    /// since the run may come to them late: then neither does who is gone keep others out, nor is who is there
    /// taken for gone. Nobody did that, no matter who gives the order.
    private void takeBack(long then) {
        if (grip != null && grip.isOverAt(then)) {
            eventLog.byNobody(() -> end("no longer driven by keys: its driver is gone"));
        }
    }

    /// Whether its motors are off until people switch them on, and which way.
    public CommandArbiter arbiter() {
        return arbiter;
    }

    /// Switches the motors off in an emergency.
    public void stop() {
        arbiter.stop();
        halt();
    }

    /// Switches the motors of this one off.
    public void switchOff() {
        arbiter.switchOff();
        halt();
    }

    private void halt() {
        if (grip != null) {
            grip.halt();
        }
    }

    /// Does something until it is told something else.
    ///
    /// @param name of the [Repertoire], [#STAND], or empty to leave it to its agents
    /// @param given when somebody said so [ns]
    public Answer behave(String name, long given) {
        takeBack(given);
        if (grip != null) {
            return driven();
        }
        Optional<Subsumption> stack = Repertoire.stack(name, robot.model());
        if (stack.isEmpty() && !name.isEmpty() && !name.equals(STAND)) {
            return new Answer.Refused("There is no behavior '%s'; there are %s."
                    .formatted(name, abilities().behaviors()));
        }
        if (stack.isPresent() && !spares.pilot().isPossible()) {
            return new Answer.Refused("Robot '%s' can't be given a behavior. %s"
                    .formatted(robot.id(), spares.pilot().refusal()));
        }
        Optional<Pilot> pilot;
        try {
            pilot = stack.map(_ -> spare(Pilot.class, spares.pilot()));
        } catch (RunBroken e) {
            return unequipped(e);
        }
        cancel();
        behavior = name;
        pilot.ifPresent(own -> own.engage(stack.orElseThrow()));
        eventLog.event("operator", robot.id(), name.isEmpty() ? "told nothing any more" : "told to " + name);
        settle();
        return new Answer.Done();
    }

    /// Whether it can be sent somewhere now.
    public sealed interface Navigation {
        record Ready(Navigator navigator) implements Navigation {}

        record Refused(Answer why) implements Navigation {}
    }

    /// @param given when somebody wants to send it somewhere [ns]
    public Navigation navigator(long given) {
        takeBack(given);
        if (grip != null) {
            return new Navigation.Refused(driven());
        }
        if (!spares.navigation().isPossible()) {
            return new Navigation.Refused(new Answer.Refused("Robot '%s' can't be sent anywhere. %s"
                    .formatted(robot.id(), spares.navigation().refusal())));
        }
        try {
            return new Navigation.Ready(spare(Navigator.class, spares.navigation()));
        } catch (RunBroken e) {
            return new Navigation.Refused(unequipped(e));
        }
    }

    /// Goes somewhere, and then back to its agents.
    ///
    /// @param onEnd told how that ends, unless another order takes over
    public void goTo(Navigator navigator, Pose2d mapFromGoal, Consumer<Result> onEnd) {
        stopBehaving();
        trip = null; // the navigator goes on from the one before
        var going = navigator.goTo(mapFromGoal, Tolerance.DEFAULT);
        trip = going;
        eventLog.event("operator", robot.id(), "sent to " + mapFromGoal.rounded());
        settle();
        going.result().thenAccept(result -> {
            if (going.equals(trip)) { // else another order has taken over
                ended(mapFromGoal, result);
                onEnd.accept(result);
            }
        });
    }

    /// What an order needs can't be made: that is no reason for the run to end.
    private static Answer unequipped(RunBroken why) {
        return new Answer.Refused(String.valueOf(why.getMessage()));
    }

    private Answer driven() {
        return new Answer.Refused("Robot '%s' is driven by keys.".formatted(robot.id()));
    }

    /// Whether an agent of it may be asked to do something.
    ///
    /// @param given when somebody said so [ns]
    /// @return why not
    public Optional<Answer> leave(long given) {
        takeBack(given);
        if (grip != null) {
            return Optional.of(driven());
        }
        cancel();
        settle();
        return Optional.empty();
    }

    private void cancel() {
        stopBehaving();
        GoalHandle<Progress, Result> last = trip;
        trip = null;
        if (last != null) {
            last.cancel();
        }
    }

    private void stopBehaving() {
        behavior = "";
        outfit.find(Pilot.class).ifPresent(Pilot::release);
    }

    private void ended(Pose2d mapFromGoal, Result result) {
        trip = null;
        if (result instanceof Result.Reached reached && reached.isSure()) {
            eventLog.event("goal", robot.id(), "is at " + mapFromGoal.rounded());
        } else {
            eventLog.event(
                    "unreached", robot.id(), "can't get to %s: %s".formatted(mapFromGoal.rounded(), Words.of(result)));
        }
        settle();
    }

    /// A device of the outfit, made when it is wanted first.
    private <D extends Device> D spare(Class<D> type, Spare spare) {
        for (PlannedDevice device : spare.devices()) {
            if (outfit.find(device.driver().makes()).isEmpty()) {
                Device next = maker.make(device, outfit);
                outfit = outfit.with(next);
                made.add(next);
            }
        }
        return outfit.require(type);
    }

    /// Gives the helm to the first that comes, and lets the others wait. Who was paused before stays so; a pause that
    /// an agent wants meanwhile ends with the waiting.
    private void settle() {
        boolean ordered = !behavior.isEmpty() || trip != null;
        Source next = grip != null ? Source.KEYS : ordered ? Source.ORDERS : Source.AGENTS;
        if (next == arbiter.hand()) {
            return;
        }
        arbiter.give(next);
        resuming.forEach(Runnable::run);
        resuming.clear();
        if (next != Source.AGENTS) {
            pause(robot);
        }
        if (next != Source.ORDERS) {
            pause(outfit);
        }
    }

    private void pause(Robot those) {
        those.find(Pilot.class).filter(pilot -> !pilot.paused()).ifPresent(pilot -> {
            pilot.pause();
            resuming.add(pilot::resume);
        });
        those.find(Navigator.class).filter(navigator -> !navigator.paused()).ifPresent(navigator -> {
            navigator.pause();
            resuming.add(navigator::resume);
        });
    }
}
