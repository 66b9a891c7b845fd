package rsal.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.Pose2d;
import rsal.data.Prism;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.Health;
import rsal.device.SimulationControl;
import rsal.scene.Block;
import rsal.scene.Surface;
import rsal.sim.world.Body;
import rsal.sim.world.Chunk;
import rsal.sim.world.World;

/// The truth of the simulated world. Its entities are the robots and the things.
final class SimControl extends DeviceCore implements SimulationControl {
    private final World world;
    private final Things things;
    private final Map<String, SimRobot> robots;
    private final List<SimGripper> grippers;
    private final Touches touches;

    /// @param robots by id, in id order
    SimControl(World world, Things things, Map<String, SimRobot> robots, List<SimGripper> grippers, Touches touches) {
        super(new DeviceInfo("", "simulation", SimProvider.KEY));
        this.world = world;
        this.things = things;
        this.robots = robots;
        this.grippers = grippers;
        this.touches = touches;
    }

    @Override
    public List<String> entities() {
        var names = new ArrayList<>(robots.keySet());
        names.addAll(things.names());
        return List.copyOf(names);
    }

    @Override
    public Optional<Pose2d> truth(String entity) {
        return body(entity).map(Body::pose);
    }

    private Optional<Body> body(String entity) {
        SimRobot robot = robots.get(entity);
        return robot == null ? things.find(entity) : Optional.of(robot.body());
    }

    @Override
    public Placement place(String entity, Pose2d mapFromEntity) {
        Optional<Body> body = body(entity);
        if (body.isEmpty()) {
            return new Placement.Refused("Nothing is called (%s); there are %s.".formatted(entity, entities()));
        }
        Optional<Placement> outside = outside(mapFromEntity);
        if (outside.isPresent()) {
            return outside.get();
        }
        if (!put(body.get(), mapFromEntity)) {
            return inTheWay(entity, mapFromEntity);
        }
        SimRobot robot = robots.get(entity);
        if (robot != null) {
            robot.drive().standStill();
            grippersOf(robot).forEach(SimGripper::carry);
        }
        touches.update(world);
        return new Placement.Placed();
    }

    private boolean put(Body body, Pose2d there) {
        for (SimGripper gripper : grippers) {
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

    private static List<SimGripper> grippersOf(SimRobot robot) {
        return robot.parts().stream()
                .filter(SimGripper.class::isInstance)
                .map(SimGripper.class::cast)
                .toList();
    }

    private Optional<Placement> outside(Pose2d pose) {
        if (!pose.isFinite()) {
            return Optional.of(new Placement.Refused("A pose must be finite, not (%s).".formatted(pose)));
        }
        return world.contains(pose.x(), pose.y())
                ? Optional.empty()
                : Optional.of(
                        new Placement.Refused("%s is outside of the world.".formatted(Lineup.at(pose.x(), pose.y()))));
    }

    private Placement inTheWay(String entity, Pose2d pose) {
        return new Placement.Refused("(%s) does not fit at %s: (%s) is in the way."
                .formatted(
                        entity,
                        Lineup.at(pose.x(), pose.y()),
                        world.obstacle().map(Body::name).orElse(World.WALL)));
    }

    @Override
    public Placement add(Thing thing) {
        String name = thing.name();
        if (name.isBlank() || name.equals(World.WALL) || body(name).isPresent()) {
            return new Placement.Refused("A thing can't be called (%s), as others are: %s and (%s)."
                    .formatted(name, entities(), World.WALL));
        }
        if (thing.marker().filter(marker -> marker.id() == 0).isPresent()) {
            return new Placement.Refused(
                    "The marker of (%s) can't have the id 0, which stands for none.".formatted(name));
        }
        Optional<Placement> outside = outside(thing.mapFromThing());
        if (outside.isPresent()) {
            return outside.get();
        }
        List<Chunk> chunks = Chunk.of(blocks(thing));
        if (!world.hasRoom(chunks, thing.mapFromThing(), 0)) {
            return inTheWay(name, thing.mapFromThing());
        }
        things.add(world.add(name, chunks, thing.mapFromThing(), 0), thing.givingPower());
        return new Placement.Placed();
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
            grippers.forEach(gripper -> gripper.lose(body));
            touches.forget(body);
            world.remove(body);
        });
        return gone.isPresent();
    }

    @Override
    public List<Contact> contacts() {
        return touches.contacts();
    }

    void close(Health.Lost why) {
        health(why);
    }
}
