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
import rsal.sim.world.Chunk;
import rsal.sim.world.World;

/// Makes robots while the world goes on, each after one that the world has or began with; but no two wear the same
/// marker.
final class Recruiting {
    private final World world;
    private final Assembly assembly;
    private final Map<String, Kind> kinds = new TreeMap<>();
    private final Map<List<Block>, List<Chunk>> chunks = new HashMap<>();

    /// @param spec of the robot that others are made after
    /// @param blocks of its body
    /// @param height of its base above the floor [m]
    /// @param odometryKnowsMap whether its odometry begins with where it is in the map, else at the origin
    record Kind(RobotSpec spec, List<Block> blocks, double height, boolean odometryKnowsMap) {}

    Recruiting(World world, Assembly assembly, List<Kind> kinds) {
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

    /// @return empty when there is no room for it; [World#obstacle] says why
    Optional<SimRobot> recruit(String id, Kind like, Pose2d mapFromBase) {
        List<Block> blocks = like.spec().marker().isEmpty() ? like.blocks() : Lineup.marked(like.blocks(), 0);
        List<Chunk> body = chunks.computeIfAbsent(blocks, Chunk::of);
        if (!world.hasRoom(body, mapFromBase, like.height(), 0)) {
            return Optional.empty();
        }
        var spec = new RobotSpec(
                id,
                like.spec().role(),
                like.spec().model(),
                Optional.of(mapFromBase),
                like.spec().color());
        Body added = world.add(id, body, mapFromBase, like.height());
        SimRobot robot = assembly.robot(spec, added);
        if (like.odometryKnowsMap()) {
            robot.drive().resetOdometry(mapFromBase);
        }
        kinds.putIfAbsent(id, new Kind(spec, blocks, like.height(), like.odometryKnowsMap()));
        return Optional.of(robot);
    }
}
