package rsal.sim;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import rsal.data.Pose2d;
import rsal.robot.RobotSpec;
import rsal.scene.Block;
import rsal.sim.world.Body;
import rsal.sim.world.CollisionShape;
import rsal.sim.world.World;

/// Makes robots while the world goes on, of any model, or after one that the world has or began with; but no two of
/// these wear the same marker.
final class RobotSpawner {
    private final World world;
    private final RobotFactory assembly;
    private final Map<String, Kind> kinds = new TreeMap<>();
    private final Map<List<Block>, List<CollisionShape>> chunks = new HashMap<>();

    /// @param spec of the robot that others are made after
    /// @param blocks of its body
    /// @param height of its base above the floor [m]
    /// @param odometryKnowsMap whether its odometry begins with where it is in the map, else at the origin
    record Kind(RobotSpec spec, List<Block> blocks, double height, boolean odometryKnowsMap) {
        /// That of a robot that stands on the floor and looks as its model says.
        static Kind of(RobotSpec spec) {
            return new Kind(spec, SpawnPlacement.blocks(spec), 0, false);
        }
    }

    RobotSpawner(World world, RobotFactory assembly, List<Kind> kinds) {
        this.world = world;
        this.assembly = assembly;
        kinds.forEach(kind -> this.kinds.put(kind.spec().id(), kind));
    }

    /// Of a robot that is there or was.
    Optional<Kind> kind(String id) {
        return Optional.ofNullable(kinds.get(id));
    }

    Set<String> known() {
        return kinds.keySet();
    }

    /// A robot's kind, but for another robot.
    static Kind like(Kind example, String id, Pose2d mapFromBase) {
        RobotSpec like = example.spec();
        List<Block> blocks = like.marker().isEmpty() ? example.blocks() : SpawnPlacement.marked(example.blocks(), 0);
        var spec = new RobotSpec(id, like.role(), like.model(), Optional.of(mapFromBase), like.color());
        return new Kind(spec, blocks, example.height(), example.odometryKnowsMap());
    }

    /// @param mapFromBase where it is to be
    /// @return empty when there is no room for it; [World#obstacle] says why
    Optional<SimRobot> recruit(Kind kind, Pose2d mapFromBase) {
        List<CollisionShape> body = chunks.computeIfAbsent(kind.blocks(), CollisionShape::of);
        if (!world.hasRoom(body, mapFromBase, kind.height(), 0)) {
            return Optional.empty();
        }
        String id = kind.spec().id();
        Body added = world.add(id, body, mapFromBase, kind.height());
        SimRobot robot = assembly.robot(kind.spec(), added);
        if (kind.odometryKnowsMap()) {
            robot.drive().resetOdometry(mapFromBase);
        }
        kinds.putIfAbsent(id, kind);
        return Optional.of(robot);
    }
}
