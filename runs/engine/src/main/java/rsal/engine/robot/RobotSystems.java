package rsal.engine.robot;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import java.util.random.RandomGenerator;
import rsal.data.Pose2d;
import rsal.data.Solid;
import rsal.device.SimulationControl;
import rsal.device.SimulationControl.Placement;
import rsal.device.Subscription;
import rsal.engine.report.RunBroken;
import rsal.fault.Fault;
import rsal.fault.FaultInjection;
import rsal.robot.Robot;
import rsal.robot.RobotSpec;
import rsal.scenario.RunPlan;
import rsal.scenario.RunPlan.Mrs;
import rsal.system.RobotSystem;
import rsal.time.Scheduler;

/// All robot systems of a run as one: it has the robots of all of them and the world of the one that simulates,
/// and breaks each robot by what its own system has for that. All calls on the run's thread.
public final class RobotSystems implements RobotSystem {
    private static final int MOST_NAMED = 3; // robots, in messages

    private final Scheduler scheduler;
    private final List<Part> parts = new ArrayList<>();
    private final Map<String, Part> homes = new HashMap<>(); // by robot
    private final FaultInjection faults = new OfEachSystem();
    private boolean closed;

    /// One of them.
    ///
    /// @param name as messages call it
    /// @param robots that it is to have
    private record Part(String name, List<String> robots, RobotSystem system) {}

    /// Makes them; nothing moves yet.
    ///
    /// @throws RunBroken when one of them can't be made; then none is left
    public RobotSystems(RunPlan plan, Scheduler scheduler) {
        this.scheduler = scheduler;
        List<Mrs> systems = plan.systems();
        try {
            for (Mrs mrs : systems) {
                List<String> robots =
                        mrs.own(plan.robots()).stream().map(RobotSpec::id).toList();
                String name = systems.size() == 1 ? mrs.name() : mrs.name() + words(robots);
                RobotSystem system = RunBroken.blaming(
                        name,
                        () -> mrs.provider()
                                .create(
                                        mrs.config(plan.scene(), plan.robots()),
                                        new GuardedScheduler(name, scheduler)));
                var part = new Part(name, robots, system);
                parts.add(part);
                robots.forEach(robot -> homes.put(robot, part));
            }
        } catch (RunBroken e) {
            letGo().forEach(e::addSuppressed);
            throw e;
        }
    }

    private static String words(List<String> robots) {
        String some = String.join(", ", robots.subList(0, Math.min(robots.size(), MOST_NAMED)));
        return robots.isEmpty() ? "" : " of %s%s".formatted(some, robots.size() > MOST_NAMED ? "…" : "");
    }

    /// Finds all of them at once, but for those that their systems admit later. The first failure says whose it is, and
    /// does not wait for the others.
    @Override
    public CompletionStage<List<Robot>> discover() {
        var all = new CompletableFuture<List<Robot>>();
        var searches = new ArrayList<CompletableFuture<List<Robot>>>();
        for (Part part : parts) {
            CompletableFuture<List<Robot>> search = scheduler
                    .inRealTime()
                    .within(part.system.discoveryLimit(), RunBroken.blaming(part.name, part.system::discover))
                    .toCompletableFuture();
            searches.add(search.whenComplete((found, error) -> {
                if (error != null) {
                    all.completeExceptionally(new RunBroken(part.name, error));
                } else {
                    missing(part, found).ifPresent(all::completeExceptionally);
                }
            }));
        }
        CompletionStage<Void> allFound = CompletableFuture.allOf(searches.toArray(CompletableFuture[]::new));
        allFound.thenAccept(_ -> all.complete(searches.stream()
                .map(CompletableFuture::join)
                .flatMap(Collection::stream)
                .toList()));
        return all;
    }

    private static Optional<RunBroken> missing(Part part, List<Robot> found) {
        if (part.system.admitsLateRobots()) {
            return Optional.empty();
        }
        List<String> ids = found.stream().map(Robot::id).toList();
        return part.robots.stream()
                .filter(robot -> !ids.contains(robot))
                .findFirst()
                .map(robot -> new RunBroken("%s has no robot '%s'; it has %s.".formatted(part.name, robot, ids)));
    }

    /// Of the one that drives the run's time.
    @Override
    public void onTime(Consumer<? super Instant> listener) {
        parts.forEach(part -> part.system.onTime(listener));
    }

    @Override
    public void reached(Instant time) {
        parts.forEach(part -> part.system.reached(time));
    }

    /// The longest of its systems.
    @Override
    public Duration discoveryLimit() {
        return parts.stream()
                .map(part -> part.system.discoveryLimit())
                .max(Comparator.naturalOrder())
                .orElse(Duration.ZERO);
    }

    @Override
    public boolean admitsLateRobots() {
        return parts.stream().anyMatch(part -> part.system.admitsLateRobots());
    }

    @Override
    public Subscription onChange(Consumer<? super Change> listener) {
        var all = parts.stream()
                .map(part -> part.system.onChange(change -> {
                    if (change instanceof Change.Appeared(Robot robot)) {
                        homes.putIfAbsent(robot.id(), part);
                    }
                    listener.accept(change);
                }))
                .toList();
        return () -> all.forEach(Subscription::cancel);
    }

    /// Of the one that simulates; the others have no part in it.
    @Override
    public Optional<SimulationControl> simulation() {
        return parts.stream().flatMap(part -> part.system.simulation().stream()).findFirst();
    }

    /// In the one that simulates.
    @Override
    public Placement addRobot(RobotSpec robot) {
        return parts.stream()
                .map(part -> part.system)
                .filter(system -> system.simulation().isPresent())
                .findFirst()
                .map(system -> system.addRobot(robot))
                .orElseGet(() -> RobotSystem.super.addRobot(robot));
    }

    /// That of the world in which a robot is simulated; empty for one that is real.
    public Optional<SimulationControl> simulation(String robot) {
        return Optional.ofNullable(homes.get(robot)).flatMap(part -> part.system.simulation());
    }

    /// What knows where a robot really is; empty where nobody does.
    public Optional<SimulationControl> overseer(String robot) {
        return Optional.ofNullable(homes.get(robot)).flatMap(part -> part.system.truth());
    }

    /// Where a robot really is, in the map frame.
    public Optional<Pose2d> truth(String robot) {
        return overseer(robot).flatMap(world -> world.truth(robot));
    }

    /// What a robot looks like, where that is known.
    public Optional<Solid> body(String robot) {
        return simulation(robot).flatMap(world -> world.body(robot));
    }

    @Override
    public Optional<FaultInjection> faults() {
        return Optional.of(faults);
    }

    /// Lets go of them in reverse order, of each whatever becomes of the others.
    ///
    /// @throws RunBroken when one of them fails
    @Override
    public void close() {
        List<RunBroken> failures = letGo();
        if (!failures.isEmpty()) {
            RunBroken first = failures.getFirst();
            failures.stream().skip(1).forEach(first::addSuppressed);
            throw first;
        }
    }

    private List<RunBroken> letGo() {
        var failures = new ArrayList<RunBroken>();
        List<Part> open = closed ? List.of() : parts.reversed();
        closed = true;
        for (Part part : open) {
            try {
                part.system.close();
            } catch (RuntimeException | Error e) {
                failures.add(new RunBroken(part.name, e));
            }
        }
        return failures;
    }

    private final class OfEachSystem implements FaultInjection {
        @Override
        public Optional<String> refusal(String robot, String device, Fault fault) {
            Part home = homes.get(robot);
            if (home == null) {
                return Optional.of("There is no robot '%s'.".formatted(robot));
            }
            return home.system
                    .faults()
                    .map(own -> own.refusal(robot, device, fault))
                    .orElseGet(() -> Optional.of("%s can't break robots on purpose.".formatted(home.name)));
        }

        @Override
        public Subscription begin(String robot, String device, Fault fault, RandomGenerator random) {
            return Optional.ofNullable(homes.get(robot))
                    .flatMap(home -> home.system.faults())
                    .orElseThrow(() -> new IllegalArgumentException("'%s' can't be broken.".formatted(robot)))
                    .begin(robot, device, fault, random);
        }
    }
}
