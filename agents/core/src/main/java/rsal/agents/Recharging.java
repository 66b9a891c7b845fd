package rsal.agents;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.message.ChargerTaken;
import rsal.data.BatteryState;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Battery;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Minds a robot's battery: takes it to a charger when it runs low, and gives it back when it is full. The nearest
/// charger first that no other says it goes to, then, when it gets to none or is not charged there, the next. Who is
/// sent
/// elsewhere meanwhile soon goes back. It waits until the robot can leave what it does. Without a battery or chargers
/// it
/// does nothing.
final class Recharging {
    static final Parameter CHARGERS = Parameter.places(
            "chargers", "Where robots are charged; none when they are not. Whoever charges stands there.");
    static final Parameter LOW =
            Parameter.number("lowBattery", 0.3, 0, 1, "", "Share of its battery below which it goes to a charger.");
    static final Parameter FULL =
            Parameter.number("fullBattery", 0.9, 0, 1, "", "Share of its battery at which it goes on.");

    static final Parameter RANGE = Parameter.number(
            "batteryRange",
            150,
            1,
            1e6,
            "m",
            "How far it drives on a full battery, with all that it does meanwhile; what takes more it does not begin.");

    private static final double SPARE = 0.1; // share of the battery that no plan may use
    static final Tolerance DOCKED = Tolerance.position(0.15);
    private static final Duration LOOK = Duration.ofSeconds(5);
    private static final Duration MEMORY = LOOK.multipliedBy(2); // of what others say, every so often

    private final AgentContext self;
    private final String robot;
    private final Driver driver;
    private final Optional<Battery> battery;
    private final Supplier<Optional<Pose2d>> mapFromBase;
    private final List<Pose2d> mapFromChargers;
    private final double least;
    private final double full;
    private final BooleanSupplier canLeave;
    private final Runnable before;
    private final Runnable after;
    private final List<Pose2d> tried = new ArrayList<>();
    private final Map<Point2d, Instant> takenUntil = new HashMap<>(); // chargers, by others
    private @Nullable Pose2d mapFromOwn; // the charger that it goes to
    private boolean charging;

    /// @param canLeave whether the robot can go to a charger now
    /// @param before lets go of the robot; called when its battery is low
    /// @param after takes it back; called when it is full
    Recharging(
            AgentContext self,
            Robot robot,
            Driver driver,
            Supplier<Optional<Pose2d>> mapFromBase,
            Arguments arguments,
            BooleanSupplier canLeave,
            Runnable before,
            Runnable after) {
        this.canLeave = canLeave;
        this.self = self;
        this.robot = robot.id();
        this.driver = driver;
        this.battery = robot.find(Battery.class);
        this.mapFromBase = mapFromBase;
        this.mapFromChargers = Words.poses(arguments.places(CHARGERS.name()));
        this.least = arguments.number(LOW.name());
        this.full = arguments.number(FULL.name());
        this.before = before;
        this.after = after;
    }

    void begin() {
        if (!mapFromChargers.isEmpty() && battery.isPresent()) {
            self.subscribe(battery.get(), reading -> note(reading.value()));
            self.subscribe(ChargerTaken.TOPIC, message -> note(message.content()));
            self.scheduler().every(LOOK, this::tell);
        }
    }

    boolean isCharging() {
        return charging;
    }

    /// Whether the battery is being charged, or is so low that it must be.
    boolean isNeeded() {
        boolean low = battery.flatMap(Battery::latest)
                .filter(reading -> reading.value().level() < least)
                .isPresent();
        return charging || (low && !mapFromChargers.isEmpty());
    }

    /// How far the robot can drive before it must have been charged [m]; +∞ when it never is.
    ///
    /// @param range on a full battery [m]
    double reach(double range) {
        return mapFromChargers.isEmpty()
                ? Double.POSITIVE_INFINITY
                : battery.flatMap(Battery::latest)
                        .map(reading -> (reading.value().level() - SPARE) * range)
                        .filter(reach -> !reach.isNaN())
                        .orElse(Double.POSITIVE_INFINITY);
    }

    private void note(BatteryState state) {
        if (!charging && state.level() < least && canLeave.getAsBoolean()) {
            charging = true;
            tried.clear();
            before.run();
            goToNext();
        } else if (charging && state.level() >= full) {
            charging = false;
            driver.stop();
            self.state("charged");
            after.run();
        }
    }

    private void note(ChargerTaken said) {
        if (!said.robot().equals(robot)) {
            takenUntil.put(said.mapFromCharger(), self.scheduler().instant().plus(MEMORY));
        }
    }

    private void tell() {
        if (charging && mapFromOwn != null) {
            self.publish(ChargerTaken.TOPIC, new ChargerTaken(robot, mapFromOwn.position()));
        }
    }

    private boolean isTaken(Pose2d mapFromCharger) {
        Instant until = takenUntil.get(mapFromCharger.position());
        return until != null && self.scheduler().instant().isBefore(until);
    }

    private void goToNext() {
        if (!charging) {
            return;
        }
        if (tried.size() == mapFromChargers.size()) {
            tried.clear();
        }
        Pose2d here = mapFromBase.get().orElse(Pose2d.ORIGIN);
        Pose2d mapFromCharger = mapFromChargers.stream()
                .filter(charger -> !tried.contains(charger))
                .min(Comparator.comparing(this::isTaken).thenComparingDouble(here::distanceTo))
                .orElseThrow(); // not all are tried
        tried.add(mapFromCharger);
        mapFromOwn = mapFromCharger;
        tell();
        self.state("going to the charger at " + Words.place(mapFromCharger));
        driver.goTo(mapFromCharger, DOCKED, result -> arrived(mapFromCharger, result));
    }

    private void arrived(Pose2d mapFromCharger, Result result) {
        if (!charging) {
            return;
        }
        if (result instanceof Result.Cancelled) {
            tried.remove(mapFromCharger); // it was sent elsewhere
        }
        if (result instanceof Result.Reached) {
            self.state("charging at " + Words.place(mapFromCharger));
        }
        self.scheduler().after(LOOK, this::lookWhetherItIsCharged);
    }

    private void lookWhetherItIsCharged() {
        boolean fills = battery.flatMap(Battery::latest)
                .filter(reading -> reading.value().charging() == BatteryState.Charging.CHARGING)
                .isPresent();
        if (fills) {
            self.scheduler().after(LOOK, this::lookWhetherItIsCharged);
        } else {
            goToNext();
        }
    }
}
