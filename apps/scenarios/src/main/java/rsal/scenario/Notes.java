package rsal.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.device.Mapper;
import rsal.device.Navigator;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.settings.Location;
import rsal.settings.Problem;

/// What is right in a run, but may not be what people think.
final class Notes {
    private Notes() {}

    /// Each only once.
    static List<Problem> of(RunPlan plan) {
        var notes = new ArrayList<String>();
        for (PlannedRobot robot : plan.robots()) {
            if (robot.spec().mapFromBase().isEmpty()) {
                robot.drivers().stream()
                        .flatMap(made -> made
                                .driver()
                                .noteWithoutStart()
                                .map(note -> "Robot (%s) has no (pose), and (%s) is not told where it starts. %s"
                                        .formatted(robot.spec().id(), made.name(), note))
                                .stream())
                        .forEach(notes::add);
            }
        }
        if (plan.clock() == RunPlan.Clock.SIMULATED && plan.robots().stream().anyMatch(Notes::findsItsWay)) {
            opening(plan.map())
                    .ifPresent(place -> notes.add(String.format(
                            Locale.ROOT,
                            "The map is open at its edge, at (%.1f, %.1f) first: robots can't leave it there, and their"
                                    + " sensors see nothing that stops them.",
                            place.x(),
                            place.y())));
        }
        if (plan.clock() == RunPlan.Clock.WALL && plan.speed() != 1) {
            notes.add("A run in real time goes at speed 1, whatever (speed) says. Maybe (clock: {mode: simulated}).");
        }
        Location at = plan.scenario().location();
        return Stream.of(
                        notes.stream().map(note -> new Problem(at, note, "")),
                        Destinations.misplaced(plan).stream(),
                        empty(plan).stream())
                .flatMap(each -> each)
                .distinct()
                .toList();
    }

    /// Of a world that is run by itself; a scenario may have its reasons.
    private static Optional<Problem> empty(RunPlan plan) {
        if (!plan.scenario().isWorld()
                || !plan.robots().isEmpty()
                || !plan.scene().services().isEmpty()) {
            return Optional.empty();
        }
        Location at = plan.scenario().location();
        return Optional.of(
                plan.scene().isEmpty()
                        ? nothingIn(at)
                        : new Problem(
                                at,
                                "There is no robot in this world, so that nothing moves.",
                                "Put robots into its file, or run it without --headless and add them on the page."));
    }

    static Problem nothingIn(Location world) {
        return new Problem(
                world,
                "There is nothing in this world: no wall, no thing, no robot.",
                "Maybe it is another file, or an include is missing.");
    }

    private static boolean findsItsWay(PlannedRobot robot) {
        return robot.drivers().stream()
                .map(made -> made.driver().makes())
                .anyMatch(made -> Navigator.class.isAssignableFrom(made) || Mapper.class.isAssignableFrom(made));
    }

    /// A free cell at the edge.
    private static Optional<Point2d> opening(OccupancyGrid map) {
        for (int row = 0; row < map.height(); row++) {
            boolean end = row == 0 || row == map.height() - 1;
            for (int column = 0; column < map.width(); column += end || map.width() == 1 ? 1 : map.width() - 1) {
                if (map.at(column, row) == OccupancyGrid.FREE) {
                    return Optional.of(new Point2d(map.x(column), map.y(row)));
                }
            }
        }
        return Optional.empty();
    }
}
