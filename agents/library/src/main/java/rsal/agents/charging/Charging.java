package rsal.agents.charging;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.bdi.Belief;
import rsal.agent.bdi.Goal;
import rsal.agent.bdi.Mind;
import rsal.agent.bdi.PlanContext;
import rsal.agents.driving.NavigationClient;
import rsal.agents.parts.AgentWords;
import rsal.data.BatteryState;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Battery;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.robot.Robot;
import rsal.time.Task;

/// Has a robot charged, whenever its agent lets it: at the nearest charger first that no other says it goes to, then,
/// when it gets to none or is not charged there, at the next. It is needed from when the battery is low until it is
/// full. Without a battery or chargers it is never needed.
public final class Charging {
    private static final double SPARE = 0.1; // share of the battery that no plan may use
    private static final Tolerance DOCKED = Tolerance.position(0.15);
    private static final Duration LOOK = Duration.ofSeconds(5);
    private static final Duration MEMORY = LOOK.multipliedBy(2); // of what others say, every so often

    private final AgentContext self;
    private final String robot;
    private final NavigationClient driver;
    private final Optional<Battery> battery;
    private final Supplier<Optional<Pose2d>> mapFromBase;
    private final List<Pose2d> mapFromChargers;
    private final double low;
    private final double full;
    private final Map<Point2d, Instant> takenUntil = new HashMap<>(); // chargers, by others
    private final List<Pose2d> tried = new ArrayList<>();
    private @Nullable Pose2d mapFromOwn; // the charger that it goes to
    private boolean needed;
    private boolean atIt;
    private @Nullable Task look; // that is due

    /// @param driver the robot's, which is used only from [#start] to [#stop]
    /// @param low share of the battery below which it is needed
    /// @param full share of the battery from which on it is not
    public Charging(
            AgentContext self,
            Robot robot,
            NavigationClient driver,
            Supplier<Optional<Pose2d>> mapFromBase,
            List<Point2d> mapFromChargers,
            double low,
            double full) {
        this.self = self;
        this.robot = robot.id();
        this.driver = driver;
        this.battery = robot.find(Battery.class);
        this.mapFromBase = mapFromBase;
        this.mapFromChargers = AgentWords.poses(mapFromChargers);
        this.low = low;
        this.full = full;
    }

    /// @param onLevel told at each reading of the battery
    void begin(Runnable onLevel) {
        if (!mapFromChargers.isEmpty() && battery.isPresent()) {
            self.subscribe(battery.get(), reading -> {
                note(reading.value());
                onLevel.run();
            });
            self.subscribe(ChargerTaken.TOPIC, message -> note(message.content()));
            self.scheduler().every(LOOK, this::publish);
        }
    }

    /// The goal to have a full battery, of an agent with a mind; how urgent it is its agent says.
    public Goal goal(Mind mind) {
        battery.ifPresent(device -> {
            Belief<Double> charge = mind.belief("charge", 1.0);
            self.subscribe(
                    device, reading -> charge.set(Math.round(reading.value().level() * 100) / 100.0));
        });
        begin(mind::think);
        return mind.goal("recharge").when(this::isNeeded).plan("stand at a charger", this::start);
    }

    private void start(PlanContext doing) {
        doing.onSuspend(this::stop).onResume(this::start).onEnd(this::stop);
        start();
    }

    boolean isNeeded() {
        return needed;
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

    /// Takes the robot to a charger and keeps it there.
    void start() {
        atIt = true;
        tried.clear();
        goToNext();
    }

    /// Lets go of the robot.
    void stop() {
        atIt = false;
        cancelLook();
        driver.stop();
    }

    private void cancelLook() {
        if (look != null) {
            look.cancel();
        }
    }

    private void lookSoon() {
        cancelLook();
        look = self.scheduler().after(LOOK, this::lookWhetherItIsCharged);
    }

    private void note(BatteryState state) {
        needed = state.level() < (needed ? full : low);
    }

    private void note(ChargerTaken said) {
        if (!said.robot().equals(robot)) {
            takenUntil.put(said.mapFromCharger(), self.scheduler().instant().plus(MEMORY));
        }
    }

    private void publish() {
        if (atIt && mapFromOwn != null) {
            self.publish(ChargerTaken.TOPIC, new ChargerTaken(robot, mapFromOwn.position()));
        }
    }

    private boolean isTaken(Pose2d mapFromCharger) {
        Instant until = takenUntil.get(mapFromCharger.position());
        return until != null && self.scheduler().instant().isBefore(until);
    }

    private void goToNext() {
        if (!atIt) {
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
        publish();
        self.state("going to the charger at " + AgentWords.place(mapFromCharger));
        driver.goTo(mapFromCharger, DOCKED, result -> arrived(mapFromCharger, result));
    }

    private void arrived(Pose2d mapFromCharger, Result result) {
        if (!atIt) {
            return;
        }
        if (result instanceof Result.Cancelled) {
            tried.remove(mapFromCharger); // it was sent elsewhere
        }
        if (result instanceof Result.Reached) {
            self.state("charging at " + AgentWords.place(mapFromCharger));
        }
        lookSoon();
    }

    private void lookWhetherItIsCharged() {
        boolean fills = battery.flatMap(Battery::latest)
                .filter(reading -> reading.value().charging() == BatteryState.Charging.CHARGING)
                .isPresent();
        if (fills) {
            lookSoon();
        } else {
            goToNext();
        }
    }
}
