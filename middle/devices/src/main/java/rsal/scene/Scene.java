package rsal.scene;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.OccupancyGrid;
import rsal.robot.RobotSpec;
import rsal.settings.Problem;

/// A world before anything moves in it.
///
/// @param title for people; may be empty
/// @param map what a robot would know of it that has been told: for localizers, planners and people
/// @param step time between two states, when the world says so
/// @param walls what is solid for good, as cells
/// @param things all else that is no robot; those that are moved don't count as walls
/// @param robots that the world brings along
/// @param robotBodies by id, of robots whose bodies are more than their models tell
/// @param warnings about what of its file has no effect
public record Scene(
        String title,
        OccupancyGrid map,
        Optional<Duration> step,
        List<Raster> walls,
        List<Entity> things,
        List<RobotSpec> robots,
        Map<String, Entity> robotBodies,
        List<Problem> warnings) {

    public Scene {
        walls = List.copyOf(walls);
        things = List.copyOf(things);
        robots = List.copyOf(robots);
        robotBodies = Map.copyOf(robotBodies);
        warnings = List.copyOf(warnings);
    }

    /// The world of a map: its walls, as high as you like, and nothing else.
    public static Scene of(OccupancyGrid map) {
        return new Scene("", map, Optional.empty(), List.of(Raster.of(map)), List.of(), List.of(), Map.of(), List.of());
    }
}
