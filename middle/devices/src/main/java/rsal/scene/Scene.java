package rsal.scene;

import java.time.Duration;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.robot.RobotSpec;
import rsal.settings.Problem;

/// A world before anything moves in it.
///
/// @param title for people; may be empty
/// @param map what a robot would know of it that has been told: for localizers, planners and people
/// @param step time between two states, when the world says so
/// @param end how long a run of it takes, when the world says so
/// @param touch what becomes of robots that drive into something
/// @param walls what is solid for good, as cells
/// @param things all else that is no robot; those that are moved don't count as walls
/// @param robots that the world brings along
/// @param robotBodies by id, of robots whose bodies are more than their models tell
/// @param odomFromBase where their odometry says they are at first, by id; of those not named it is the origin
/// @param programs what drives robots where the world comes from, by id: a word of its file, `wander`
/// @param contents how many of which kind its file has, as the file calls them
/// @param services that its file asks servers to offer
/// @param warnings about what of its file has no effect
public record Scene(
        String title,
        OccupancyGrid map,
        Optional<Duration> step,
        Optional<Duration> end,
        Touch touch,
        List<SolidRaster> walls,
        List<Entity> things,
        List<RobotSpec> robots,
        Map<String, Entity> robotBodies,
        Map<String, Pose2d> odomFromBase,
        Map<String, String> programs,
        SortedMap<String, Integer> contents,
        List<RobotService> services,
        List<Problem> warnings) {

    public Scene {
        walls = List.copyOf(walls);
        things = List.copyOf(things);
        robots = List.copyOf(robots);
        robotBodies = Map.copyOf(robotBodies);
        odomFromBase = Map.copyOf(odomFromBase);
        programs = Map.copyOf(programs);
        contents = Collections.unmodifiableSortedMap(new TreeMap<>(contents));
        services = List.copyOf(services);
        warnings = List.copyOf(warnings);
    }

    /// The world of a map: its walls, as high as you like, and nothing else.
    public static Scene of(OccupancyGrid map) {
        return of(map, List.of());
    }

    /// As [#of(OccupancyGrid)].
    ///
    /// @param warnings about the map's files
    public static Scene of(OccupancyGrid map, List<Problem> warnings) {
        return new Scene(
                "",
                map,
                Optional.empty(),
                Optional.empty(),
                Touch.STALL,
                List.of(SolidRaster.of(map)),
                List.of(),
                List.of(),
                Map.of(),
                Map.of(),
                Map.of(),
                Collections.emptySortedMap(),
                List.of(),
                warnings);
    }

    /// The same, where robots that drive into something stall or slide.
    public Scene with(Touch other) {
        return new Scene(
                title,
                map,
                step,
                end,
                other,
                walls,
                things,
                robots,
                robotBodies,
                odomFromBase,
                programs,
                contents,
                services,
                warnings);
    }

    /// The same with other things and robots in it.
    public Scene with(List<Entity> otherThings, List<RobotSpec> otherRobots) {
        return new Scene(
                title,
                map,
                step,
                end,
                touch,
                walls,
                otherThings,
                otherRobots,
                robotBodies,
                odomFromBase,
                programs,
                contents,
                services,
                warnings);
    }

    /// The same, of which robots that have been told know something else.
    public Scene known(OccupancyGrid as) {
        return with(as, services, warnings);
    }

    /// Whether there is nothing in it: nothing that is solid, nothing that moves, nothing that is served.
    public boolean isEmpty() {
        return walls.isEmpty() && things.isEmpty() && robots.isEmpty() && services.isEmpty();
    }

    /// The same, of which servers are to offer something.
    ///
    /// @param others instead of the warnings
    public Scene serving(List<RobotService> offered, List<Problem> others) {
        return with(map, offered, others);
    }

    private Scene with(OccupancyGrid as, List<RobotService> offered, List<Problem> others) {
        return new Scene(
                title,
                as,
                step,
                end,
                touch,
                walls,
                things,
                robots,
                robotBodies,
                odomFromBase,
                programs,
                contents,
                offered,
                others);
    }
}
