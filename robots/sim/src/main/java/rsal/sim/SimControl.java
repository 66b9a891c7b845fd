package rsal.sim;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.Pose2d;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.Health;
import rsal.device.SimulationControl;
import rsal.sim.world.Body;
import rsal.sim.world.World;

/// The truth of the simulated world. Its entities are the robots.
final class SimControl extends DeviceCore implements SimulationControl {
    private final World world;
    private final Map<String, SimRobot> robots;
    private final Touches touches;

    /// @param robots by id, in id order
    SimControl(World world, Map<String, SimRobot> robots, Touches touches) {
        super(new DeviceInfo("", "simulation", SimProvider.KEY));
        this.world = world;
        this.robots = robots;
        this.touches = touches;
    }

    @Override
    public List<String> entities() {
        return List.copyOf(robots.keySet());
    }

    @Override
    public Optional<Pose2d> truth(String entity) {
        return Optional.ofNullable(robots.get(entity)).map(robot -> robot.body().pose());
    }

    @Override
    public Placement place(String entity, Pose2d mapFromEntity) {
        SimRobot robot = robots.get(entity);
        if (robot == null) {
            return new Placement.Refused("Nothing is called (%s); there are %s.".formatted(entity, entities()));
        }
        if (!mapFromEntity.isFinite()) {
            return new Placement.Refused("A pose must be finite, not (%s).".formatted(mapFromEntity));
        }
        if (!world.place(robot.body(), mapFromEntity)) {
            return new Placement.Refused("(%s) does not fit at %s: (%s) is in the way."
                    .formatted(
                            entity,
                            Lineup.at(mapFromEntity.x(), mapFromEntity.y()),
                            world.obstacle().map(Body::name).orElse(World.WALL)));
        }
        robot.drive().standStill();
        touches.update(world);
        return new Placement.Placed();
    }

    @Override
    public List<Contact> contacts() {
        return touches.contacts();
    }

    void close(Health.Lost why) {
        health(why);
    }
}
