package rsal.engine.world;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import rsal.data.Covariance2d;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Solid;
import rsal.device.Localizer;
import rsal.device.SimulationControl;
import rsal.device.SimulationControl.Carried;
import rsal.device.SimulationControl.Placement;
import rsal.device.SimulationControl.Standing;
import rsal.engine.communication.Faults;
import rsal.engine.event.EventLog;
import rsal.engine.metric.MetricsObserver;
import rsal.engine.report.Answer;
import rsal.engine.report.PlacedThing;
import rsal.engine.robot.RobotSystems;
import rsal.engine.robot.RobotTeam;
import rsal.model.RobotModels;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.robot.RobotSpec;
import rsal.scenario.RunPlan;
import rsal.settings.Suggestion;
import rsal.time.Scheduler;

/// The world of a run as people see and change it, if it is simulated. Where there is only reality nobody
/// knows the truth, and robots are placed in nothing but their own belief. All calls on the run's thread.
public final class SimulatedWorld {
    private static final int MOST_ADDED = 1000; // things by hand at once, and robots in a run
    private static final Covariance2d PLACED_BY_HAND = Covariance2d.ofDeviations(0.1, 0.1, Math.toRadians(5));

    private final RunPlan plan;
    private final boolean hasProxies;
    private final RobotSystems systems;
    private final Scheduler scheduler;
    private final EventLog eventLog;
    private final MetricsObserver observer;
    private final DynamicRobots dynamicRobots;
    private final RobotTeam team;
    private final Faults faults;
    private final Relocations placements = new Relocations();
    private final Set<String> props = new HashSet<>(); // things that were added by hand and are there
    private final Set<String> takenOut = new HashSet<>(); // robots, by hand
    private final Map<String, Pose2d> beginning = new LinkedHashMap<>(); // where things and robots were when it began
    private int robotsAdded; // by hand

    public SimulatedWorld(
            RunPlan plan,
            RobotSystems systems,
            Scheduler scheduler,
            EventLog eventLog,
            MetricsObserver observer,
            DynamicRobots dynamicRobots,
            RobotTeam team,
            Faults faults) {
        this.plan = plan;
        this.hasProxies = plan.robots().stream().anyMatch(RunPlan.PlannedRobot::proxy);
        this.systems = systems;
        this.scheduler = scheduler;
        this.eventLog = eventLog;
        this.observer = observer;
        this.dynamicRobots = dynamicRobots;
        this.team = team;
        this.faults = faults;
    }

    /// Remembers how it is now, when the run begins.
    public void begin() {
        systems.simulation()
                .ifPresent(world -> world.entities().stream()
                        .filter(entity -> !team.has(entity) || isSimulated(entity)) // else a proxy of a real robot
                        .forEach(entity -> world.truth(entity).ifPresent(pose -> beginning.put(entity, pose))));
    }

    /// Puts all that was there in the beginning back to where it was then, at rest, whatever is in the way.
    /// Robots believe it.
    ///
    /// @return what is not there any more
    public List<String> restore() {
        var missing = new ArrayList<String>();
        systems.simulation()
                .ifPresent(world -> beginning.forEach((entity, pose) -> {
                    if (world.placeAnyway(entity, pose) instanceof Placement.Refused) {
                        missing.add(entity);
                    } else {
                        team.robot(entity).ifPresent(robot -> believe(robot, pose));
                    }
                }));
        eventLog.event("operator", "", "put all back to where it began");
        return List.copyOf(missing);
    }

    /// Where a robot really is, in the map frame.
    public Optional<Pose2d> truth(String robot) {
        return systems.truth(robot);
    }

    /// What a robot looks like.
    Optional<Solid> body(String robot) {
        return systems.body(robot);
    }

    /// What of a robot its actuators have carried elsewhere.
    List<Carried> carried(String robot) {
        return systems.simulation(robot).map(world -> world.carried(robot)).orElse(List.of());
    }

    /// Whether a robot is in it at all; others are real.
    boolean isSimulated(String robot) {
        return systems.simulation(robot).isPresent();
    }

    /// Whether a robot is gone from it: what it believed there is not shown.
    boolean lacks(String robot) {
        return isSimulated(robot) && systems.truth(robot).isEmpty();
    }

    /// Which robots were put elsewhere in it.
    Relocations placements() {
        return placements;
    }

    /// What of it is not a robot, nor stands in for one.
    public List<Standing> things() {
        List<Standing> all = systems.simulation().map(SimulationControl::things).orElse(List.of());
        return hasProxies
                ? all.stream().filter(thing -> !team.has(thing.name())).toList()
                : all;
    }

    /// Puts a robot somewhere, in truth and in its own belief, or a thing.
    public Answer place(String id, Pose2d mapFromBase) {
        return team.robot(id).map(robot -> placeRobot(robot, mapFromBase)).orElseGet(() -> placeThing(id, mapFromBase));
    }

    /// Tells a robot's localizer where it is; the robot stays where it truly is.
    public Answer believe(String id, Pose2d mapFromBase) {
        Optional<Robot> robot = team.robot(id);
        if (robot.isEmpty()) {
            return unknown(id);
        }
        Optional<Answer> impossible = impossible(id, mapFromBase);
        if (impossible.isPresent()) {
            return impossible.get();
        }
        Optional<Localizer> localizer = team.localizer(robot.get());
        if (localizer.isEmpty()) {
            return new Answer.Refused("Robot '%s' has no localizer to get a pose.".formatted(id));
        }
        var _ = localizer.get().relocalize(PoseEstimate.of(mapFromBase, PLACED_BY_HAND));
        eventLog.event("operator", id, "told that it is at " + mapFromBase.rounded());
        return new Answer.Done();
    }

    private Optional<Answer> impossible(String robot, Pose2d mapFromBase) {
        OccupancyGrid map = plan.map();
        if (lacks(robot) || faults.isGone(robot)) {
            return Optional.of(new Answer.Refused("Robot '%s' is gone.".formatted(robot)));
        }
        return mapFromBase.isFinite() && map.contains(map.column(mapFromBase.x()), map.row(mapFromBase.y()))
                ? Optional.empty()
                : Optional.of(new Answer.Refused("%s is outside the map.".formatted(mapFromBase.rounded())));
    }

    private Answer placeRobot(Robot robot, Pose2d mapFromBase) {
        String id = robot.id();
        Optional<Answer> impossible = impossible(id, mapFromBase);
        if (impossible.isPresent()) {
            return impossible.get();
        }
        Optional<SimulationControl> overseer = systems.overseer(id);
        if (overseer.isPresent() && overseer.get().place(id, mapFromBase) instanceof Placement.Refused(String why)) {
            return new Answer.Refused(why);
        }
        believe(robot, mapFromBase);
        eventLog.event("operator", id, "placed at " + mapFromBase.rounded());
        return new Answer.Done();
    }

    /// Has a robot believe that it is where it was put.
    private void believe(Robot robot, Pose2d mapFromBase) {
        String id = robot.id();
        observer.placed(id);
        CompletableFuture<Void> believed = team.localizer(robot)
                .map(localizer -> localizer.relocalize(PoseEstimate.of(mapFromBase, PLACED_BY_HAND)))
                .map(CompletionStage::toCompletableFuture)
                .orElse(CompletableFuture.completedFuture(null));
        if (systems.overseer(id).isPresent()) {
            placements.add(id, scheduler.instant(), believed);
        }
    }

    private Answer placeThing(String name, Pose2d mapFromThing) {
        if (things().stream().noneMatch(thing -> thing.name().equals(name))) {
            return unknown(name);
        }
        return answer(
                systems.simulation().orElseThrow().place(name, mapFromThing),
                name,
                "placed at " + mapFromThing.rounded(),
                new Answer.Done());
    }

    /// Journals what an operator did to the simulated world, if it was done.
    private Answer answer(Placement placement, String name, String words, Answer done) {
        if (placement instanceof Placement.Refused(String why)) {
            return new Answer.Refused(why);
        }
        eventLog.event("operator", name, words);
        return done;
    }

    /// Puts something new into the world, under a name that nobody has.
    public Answer add(PlacedThing prop, Pose2d mapFromThing) {
        return add(prop, Optional.empty(), mapFromThing);
    }

    /// Puts something new into the world.
    ///
    /// @param wanted its name; empty for one that nobody has
    public Answer add(PlacedThing prop, Optional<String> wanted, Pose2d mapFromThing) {
        Optional<SimulationControl> simulation = systems.simulation();
        if (simulation.isEmpty()) {
            return nothingSimulated();
        }
        var taken = new HashSet<>(simulation.get().entities());
        props.retainAll(taken);
        if (props.size() == MOST_ADDED) {
            return new Answer.Refused("%d things were added already; remove some first.".formatted(MOST_ADDED));
        }
        String name = wanted.orElseGet(() -> prop.name(taken));
        Answer answer = answer(
                simulation.get().add(prop.at(name, mapFromThing)),
                name,
                "added at " + mapFromThing.rounded(),
                new Answer.Added(name));
        if (answer instanceof Answer.Added) {
            props.add(name);
        }
        return answer;
    }

    /// Puts a robot into the world that is like one that is or was there.
    public Answer addRobot(String example, Pose2d mapFromBase) {
        Optional<SimulationControl> simulation = systems.simulation();
        if (simulation.isEmpty()) {
            return nothingSimulated();
        }
        if (team.has(example) && !isSimulated(example)) {
            return isReal(example, "no other like it can be added");
        }
        if (robotsAdded == MOST_ADDED) {
            return enough();
        }
        Optional<String> id =
                dynamicRobots.expect(example, new HashSet<>(simulation.get().entities()));
        return id.map(free -> added(free, mapFromBase, simulation.get().addRobot(free, example, mapFromBase)))
                .orElseGet(() -> unknown(example));
    }

    /// Puts a robot into the world that is of a model that comes with the program, named after the model.
    ///
    /// @param model its name
    public Answer newRobot(String model, Pose2d mapFromBase) {
        return newRobot(model, Optional.empty(), mapFromBase);
    }

    /// Puts a robot into the world that is of a model that comes with the program.
    ///
    /// @param model its name
    /// @param id empty for one that nobody has
    public Answer newRobot(String model, Optional<String> id, Pose2d mapFromBase) {
        Optional<SimulationControl> simulation = systems.simulation();
        if (simulation.isEmpty()) {
            return nothingSimulated();
        }
        Optional<RobotModel> known = RobotModels.readBuiltIn().stream()
                .filter(one -> one.name().equals(model))
                .findFirst();
        if (known.isEmpty()) {
            return new Answer.Refused("There is no robot model '%s'. %s"
                    .formatted(model, Suggestion.among(model, RobotModels.builtIn())));
        }
        if (robotsAdded == MOST_ADDED) {
            return enough();
        }
        RobotSpec wanted = dynamicRobots.expect(
                known.get(), id, mapFromBase, new HashSet<>(simulation.get().entities()));
        return added(wanted.id(), mapFromBase, systems.addRobot(wanted));
    }

    /// Whether nothing has a name, and no robot had it.
    public boolean isFree(String name) {
        return !dynamicRobots.isKnown(name)
                && systems.simulation().stream()
                        .noneMatch(world -> world.entities().contains(name));
    }

    private static Answer enough() {
        return new Answer.Refused("%d robots were added already; that is enough for a run.".formatted(MOST_ADDED));
    }

    /// @param robot that was expected
    private Answer added(String robot, Pose2d mapFromBase, Placement placement) {
        Answer answer = answer(placement, robot, "added at " + mapFromBase.rounded(), new Answer.Added(robot));
        if (answer instanceof Answer.Added) {
            robotsAdded++;
        } else {
            dynamicRobots.dismiss(robot);
        }
        return answer;
    }

    /// Takes a robot or a thing out of the world.
    public Answer remove(String entity) {
        Optional<SimulationControl> simulation = systems.simulation();
        if (simulation.isEmpty()) {
            return nothingSimulated();
        }
        if (team.has(entity) && !isSimulated(entity)) {
            return isReal(entity, "it can't be taken out of the simulated world");
        }
        if (!(team.has(entity)
                ? removeRobot(simulation.get(), entity)
                : simulation.get().remove(entity))) {
            return unknown(entity);
        }
        props.remove(entity);
        eventLog.event("operator", entity, "removed");
        return new Answer.Done();
    }

    private boolean removeRobot(SimulationControl simulation, String robot) {
        takenOut.add(robot); // before the world tells
        boolean removed = simulation.removeRobot(robot);
        if (!removed) {
            takenOut.remove(robot);
        }
        return removed;
    }

    /// Whether somebody takes a robot out of the world, or has done so.
    public boolean isTakenOut(String robot) {
        return takenOut.contains(robot);
    }

    private static Answer isReal(String robot, String what) {
        return new Answer.Refused("Robot '%s' is real: %s.".formatted(robot, what));
    }

    private Answer nothingSimulated() {
        return new Answer.Refused("%s simulates no world that could be changed."
                .formatted(plan.mrs().name()));
    }

    /// Says that no robot and no thing has a name.
    public Answer unknown(String name) {
        return new Answer.Refused("There is no '%s'; there are the robots %s and %d other things."
                .formatted(name, team.robots().keySet(), things().size()));
    }
}
