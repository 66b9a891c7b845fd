package rsal.scenario;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import rsal.data.FreeSpace;
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
                                .map(note -> "Robot '%s' has no 'pose', and '%s' does not know where it starts. %s"
                                        .formatted(robot.spec().id(), made.name(), note))
                                .stream())
                        .forEach(notes::add);
            }
        }
        List<PlannedRobot> exploring =
                plan.robots().stream().filter(Notes::findsItsWay).toList();
        if (plan.clock() == RunPlan.Clock.SIMULATED && !exploring.isEmpty()) {
            opening(plan.map(), exploring)
                    .ifPresent(place -> notes.add(String.format(
                            Locale.ROOT,
                            "The map is open at its edge, at (%.1f, %.1f) first: robots can't leave it there, and their"
                                    + " sensors see nothing that stops them.",
                            place.x(),
                            place.y())));
        }
        if (plan.clock() == RunPlan.Clock.WALL && plan.speed() != 1) {
            notes.add("A run in real time goes at speed 1, whatever 'speed' says. Maybe 'clock: {mode: simulated}'.");
        }
        Location at = plan.scenario().location();
        return Stream.of(
                        notes.stream().map(note -> new Problem(at, note, "")),
                        Destinations.misplaced(plan).stream(),
                        empty(plan).stream(),
                        plan.agents().stream().flatMap(agent -> agent.type().warnings().stream()))
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

    /// A free cell at the edge that one of the robots can get to. Others are none of its business: worlds have half a
    /// meter around their walls.
    private static Optional<Point2d> opening(OccupancyGrid map, List<PlannedRobot> robots) {
        int[] edge = edge(map)
                .filter(cell -> map.cells()[cell] == OccupancyGrid.FREE)
                .toArray();
        if (edge.length == 0) {
            return Optional.empty();
        }
        var starts = new ArrayList<Integer>();
        boolean anywhere = false;
        for (PlannedRobot robot : robots) {
            Optional<Integer> start = robot.spec()
                    .mapFromBase()
                    .filter(pose -> map.isFree(pose.x(), pose.y()))
                    .map(pose -> map.cell(pose.position()));
            start.ifPresent(starts::add);
            anywhere |= start.isEmpty();
        }
        if (anywhere) { // as the simulator chooses: all places it may take are connected
            new FreeSpace(map, FreeSpace.START_CLEARANCE)
                    .choose(new SplittableRandom(0), _ -> true)
                    .ifPresent(pose -> starts.add(map.cell(pose.position())));
        }
        BitSet reached = FreeSpace.connected(map, starts);
        return Arrays.stream(edge).filter(reached::get).mapToObj(map::middle).findFirst();
    }

    /// From the lower left on, row by row.
    private static IntStream edge(OccupancyGrid map) {
        int width = map.width();
        return IntStream.range(0, map.height())
                .flatMap(row -> row == 0 || row == map.height() - 1 || width == 1
                        ? IntStream.range(row * width, (row + 1) * width)
                        : IntStream.of(row * width, (row + 1) * width - 1));
    }
}
