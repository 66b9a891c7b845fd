package rsal.sim;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiPredicate;
import java.util.function.Consumer;
import java.util.function.Predicate;
import rsal.data.Fan;
import rsal.data.Pose2d;
import rsal.data.Prism;
import rsal.data.Solid;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.Health;
import rsal.device.SimulationControl;
import rsal.robot.RobotSpec;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.scene.Surface;
import rsal.settings.Suggestion;
import rsal.sim.world.Body;
import rsal.sim.world.CollisionShape;
import rsal.sim.world.Extent;
import rsal.sim.world.SensorRays;
import rsal.sim.world.World;
import rsal.system.RobotSystem;

/// The truth of the simulated world. Its entities are the robots and the things.
final class SimControl extends DeviceCore implements SimulationControl {
    private static final int LONGEST_NAME = 100;

    private final World world;
    private final Things things;
    private final SimulatedRobots team;
    private final RobotSpawner recruiting;
    private final ContactTracker touches;
    private final Consumer<RobotSystem.Change> changes;
    private final Map<String, List<ActuatorLoad>> loads = new HashMap<>(); // by robot, of those that were asked for
    private boolean closed;

    /// @param changes told which robots come and go
    SimControl(
            World world,
            Things things,
            SimulatedRobots team,
            RobotSpawner recruiting,
            ContactTracker touches,
            Consumer<RobotSystem.Change> changes) {
        super(new DeviceInfo("", "simulation", SimProvider.KEY));
        this.world = world;
        this.things = things;
        this.team = team;
        this.recruiting = recruiting;
        this.touches = touches;
        this.changes = changes;
    }

    @Override
    public List<String> entities() {
        var names = new ArrayList<String>();
        team.all().stream().filter(robot -> robot.body().isThere()).forEach(robot -> names.add(robot.id()));
        names.addAll(things.names());
        return List.copyOf(names);
    }

    @Override
    public List<Standing> things() {
        return things.standing();
    }

    @Override
    public Optional<Solid> body(String entity) {
        return team.find(entity)
                .filter(robot -> robot.body().isThere())
                .flatMap(robot -> recruiting.kind(robot.id()))
                .map(RobotSpawner.Kind::blocks)
                .or(() -> things.find(entity).map(Things.Item::blocks))
                .flatMap(Entity::look);
    }

    @Override
    public List<Carried> carried(String robot) {
        return team.find(robot)
                .filter(one -> one.body().isThere())
                .map(one -> ActuatorLoad.carried(loads.computeIfAbsent(robot, _ -> load(one))))
                .orElse(List.of());
    }

    private List<ActuatorLoad> load(SimRobot robot) {
        List<Block> blocks =
                recruiting.kind(robot.id()).map(RobotSpawner.Kind::blocks).orElse(List.of());
        return ActuatorLoad.of(robot, Entity.lowestFirst(blocks));
    }

    @Override
    public Optional<Pose2d> truth(String entity) {
        return entity(entity).map(Body::pose);
    }

    private Optional<Body> entity(String name) {
        return team.find(name)
                .map(SimRobot::body)
                .filter(Body::isThere)
                .or(() -> things.find(name).map(Things.Item::body));
    }

    @Override
    public Placement place(String entity, Pose2d mapFromEntity) {
        return place(entity, mapFromEntity, this::put);
    }

    @Override
    public Placement placeAnyway(String entity, Pose2d mapFromEntity) {
        return place(entity, mapFromEntity, this::putAnyway);
    }

    @Override
    public Placement placeAnyway(String thing, Pose2d mapFromThing, double height) {
        if (things.find(thing).isEmpty()) {
            return new Placement.Refused(
                    "There is no thing '%s'. %s".formatted(thing, Suggestion.among(thing, things.names())));
        }
        return place(thing, mapFromThing, (body, there) -> {
            putAnyway(body, there);
            world.put(body, there, height);
            return true;
        });
    }

    /// @param putting says whether there was room
    private Placement place(String entity, Pose2d mapFromEntity, BiPredicate<Body, Pose2d> putting) {
        Optional<Body> body = entity(entity);
        if (body.isEmpty()) {
            return new Placement.Refused(
                    "Nothing is called '%s'. %s".formatted(entity, Suggestion.among(entity, entities())));
        }
        Optional<Placement> outside = outside(mapFromEntity);
        if (outside.isPresent()) {
            return outside.get();
        }
        if (!putting.test(body.get(), mapFromEntity)) {
            return obstructing(entity, mapFromEntity);
        }
        team.find(entity).ifPresent(robot -> {
            robot.drive().standStill();
            grippersOf(robot).forEach(SimGripper::carry);
        });
        touches.update(world);
        return new Placement.Placed();
    }

    private boolean put(Body body, Pose2d there) {
        for (SimGripper gripper : team.grippers()) {
            if (gripper.holds(body)) {
                boolean room = world.putDown(body, there, 0);
                if (room) {
                    gripper.lose(body);
                }
                return room;
            }
        }
        return world.place(body, there);
    }

    private boolean putAnyway(Body body, Pose2d there) {
        for (SimGripper gripper : team.grippers()) {
            if (gripper.holds(body)) {
                gripper.lose(body);
                world.drop(body, 0);
            }
        }
        world.put(body, there);
        return true;
    }

    private static List<SimGripper> grippersOf(SimRobot robot) {
        return robot.parts().stream()
                .filter(SimGripper.class::isInstance)
                .map(SimGripper.class::cast)
                .toList();
    }

    private Optional<Placement> outside(Pose2d pose) {
        if (!pose.isFinite()) {
            return Optional.of(new Placement.Refused("A pose must be finite, not '%s'.".formatted(pose)));
        }
        Extent bounds = world.bounds();
        return bounds.contains(pose.x(), pose.y())
                ? Optional.empty()
                : Optional.of(new Placement.Refused("%s is outside of the world, which reaches from %s to %s."
                        .formatted(
                                SpawnPlacement.at(pose.x(), pose.y()),
                                SpawnPlacement.at(bounds.left(), bounds.bottom()),
                                SpawnPlacement.at(bounds.right(), bounds.top()))));
    }

    private Placement obstructing(String entity, Pose2d pose) {
        return new Placement.Refused("'%s' does not fit at %s: '%s' is in the way."
                .formatted(
                        entity,
                        SpawnPlacement.at(pose.x(), pose.y()),
                        world.obstacle().map(Body::name).orElse(World.WALL)));
    }

    @Override
    public Placement add(Thing thing) {
        return add(thing, chunks -> world.hasRoom(chunks, thing.mapFromThing(), 0));
    }

    @Override
    public Placement addAnyway(Thing thing) {
        return add(thing, _ -> true);
    }

    /// @param room whether there is any for it
    private Placement add(Thing thing, Predicate<List<CollisionShape>> room) {
        String name = thing.name();
        Optional<Placement> misnamed = misnamed(name);
        if (misnamed.isPresent()) {
            return misnamed.get();
        }
        if (thing.marker().filter(marker -> marker.id() == 0).isPresent()) {
            return new Placement.Refused(
                    "The marker of '%s' can't have the id 0, which stands for none.".formatted(name));
        }
        Optional<Placement> outside = outside(thing.mapFromThing());
        if (outside.isPresent()) {
            return outside.get();
        }
        List<Block> blocks = blocks(thing);
        List<CollisionShape> chunks = CollisionShape.of(blocks);
        if (!room.test(chunks)) {
            return obstructing(name, thing.mapFromThing());
        }
        things.add(world.add(name, chunks, thing.mapFromThing(), 0), blocks, thing.givingPower());
        return new Placement.Placed();
    }

    private Optional<Placement> misnamed(String name) {
        if (name.isBlank() || name.length() > LONGEST_NAME) {
            return Optional.of(new Placement.Refused("A name has from 1 to %d letters, not %d."
                    .formatted(LONGEST_NAME, name.strip().length())));
        }
        return name.equals(World.WALL)
                        || team.find(name).isPresent()
                        || entity(name).isPresent()
                ? Optional.of(new Placement.Refused("Something else is called '%s'; names are unique.".formatted(name)))
                : Optional.empty();
    }

    private static List<Block> blocks(Thing thing) {
        var blocks = new ArrayList<Block>();
        for (Prism piece : thing.body().pieces()) {
            var surface = new Surface(
                    piece.color().orElse(thing.color()),
                    thing.obstacle(),
                    Surface.PLAIN.reflectance(),
                    true,
                    thing.marker().map(Marker::id).orElse(0),
                    thing.marker().map(Marker::key).orElse(0),
                    thing.grippable());
            blocks.add(new Block(piece, surface));
        }
        return blocks;
    }

    @Override
    public boolean remove(String thing) {
        Optional<Body> gone = things.remove(thing);
        gone.ifPresent(body -> {
            team.grippers().forEach(gripper -> gripper.lose(body));
            touches.forget(body);
            world.remove(body);
        });
        return gone.isPresent();
    }

    @Override
    public double[] ranges(List<Fan> fans, Pose2d mapFromBase, double height, double reach, Set<String> through) {
        return new SensorRays(fans, height)
                .castThroughWalls(world, mapFromBase, reach, body -> through.contains(body.name()));
    }

    @Override
    public Placement addRobot(String id, String like, Pose2d mapFromBase) {
        Optional<RobotSpawner.Kind> kind = recruiting.kind(like);
        if (kind.isEmpty()) {
            return refusal(id)
                    .orElseGet(() -> new Placement.Refused("There never was a robot '%s' to add one like. %s"
                            .formatted(like, Suggestion.among(like, recruiting.known()))));
        }
        return recruit(RobotSpawner.like(kind.get(), id, mapFromBase), mapFromBase);
    }

    /// As [RobotSystem#addRobot].
    Placement addRobot(RobotSpec robot) {
        List<String> problems = RobotFactory.problems(robot.model());
        if (!problems.isEmpty()) {
            return new Placement.Refused(String.join(" ", problems));
        }
        return robot.mapFromBase()
                .map(there -> recruit(RobotSpawner.Kind.of(robot), there))
                .orElseGet(() -> new Placement.Refused("Robot '%s' has no pose.".formatted(robot.id())));
    }

    /// Why no robot of an id can be added.
    private Optional<Placement> refusal(String id) {
        if (closed) {
            return Optional.of(new Placement.Refused("The simulation was closed."));
        }
        Optional<Placement> misnamed = misnamed(id);
        if (misnamed.isPresent()) {
            return misnamed;
        }
        if (recruiting.kind(id).isPresent()) {
            return Optional.of(
                    new Placement.Refused("A robot was called '%s' before; ids are used once.".formatted(id)));
        }
        return id.indexOf('/') < 0
                ? Optional.empty()
                : Optional.of(new Placement.Refused(
                        "A slash separates robots from devices, so no robot can be called '%s'.".formatted(id)));
    }

    private Placement recruit(RobotSpawner.Kind kind, Pose2d mapFromBase) {
        String id = kind.spec().id();
        Optional<Placement> refusal = refusal(id).or(() -> outside(mapFromBase));
        if (refusal.isPresent()) {
            return refusal.get();
        }
        Optional<SimRobot> robot = recruiting.recruit(kind, mapFromBase);
        if (robot.isEmpty()) {
            return obstructing(id, mapFromBase);
        }
        team.add(robot.get());
        changes.accept(new RobotSystem.Change.Appeared(robot.get().robot()));
        return new Placement.Placed();
    }

    @Override
    public boolean removeRobot(String id) {
        Optional<SimRobot> robot = closed ? Optional.empty() : team.find(id);
        robot.ifPresent(this::remove);
        return robot.isPresent();
    }

    private void remove(SimRobot robot) {
        team.remove(robot);
        loads.remove(robot.id());
        touches.forget(robot.body());
        world.remove(robot.body());
        robot.leaveBehind();
        changes.accept(new RobotSystem.Change.Removed(robot.id()));
        robot.close(new Health.Lost("It was taken out of the world."));
    }

    @Override
    public List<Contact> contacts() {
        return touches.contacts();
    }

    void close(Health.Lost why) {
        closed = true;
        health(why);
    }
}
