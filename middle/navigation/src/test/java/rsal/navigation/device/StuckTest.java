package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Prism;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.device.SimulationControl.Placement;
import rsal.device.SimulationControl.Thing;
import rsal.map.Maps;
import rsal.model.RobotModels;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.testkit.DrawnMap;
import rsal.testkit.Trials;

/// A robot before something across its way that the map does not know. Behind it is a pillar, which its laser does
/// not see.
class StuckTest {
    private static final DrawnMap CORRIDOR = DrawnMap.grid(0.1, """
            ##################################################
            #................................................#
            #................................................#
            #................................................#
            #................................................#
            #................................................#
            #.......#........................................#
            #...........r.................................g..#
            #................................................#
            #................................................#
            #................................................#
            #................................................#
            #................................................#
            #................................................#
            ##################################################""");

    private static final DrawnMap OPEN = DrawnMap.grid(0.1, """
            #########################
            #........................
            #........................
            #........................
            #........................
            #........................
            #...r...................g
            #........................
            #........................
            #........................
            #........................
            #........................
            #########################""");

    private static final DrawnMap HALL = DrawnMap.grid(0.1, """
            ##################################################
            #................................................#
            #................................................#
            #................................................#
            #................................................#
            #................................................#
            #................................................#
            #................................................#
            #................................................#
            #...................r.........................g..#
            #................................................#
            #................................................#
            #................................................#
            #................................................#
            #................................................#
            #................................................#
            #................................................#
            #................................................#
            ##################################################""");

    private static final DrawnMap NOOK = DrawnMap.grid(0.1, """
            ######################
            #....................#
            #....................#
            #....................#
            #..........g.........#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            ##############.......#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....r...............#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            ######################""");

    /// It is held up before a board, and somebody comes up from behind, where its laser doesn't look.
    @Trials(
            value = {"vfh", "nd", "snd", "dwa", "mpc"},
            landing = 2)
    void drivesBackIntoNobodyWhomItDidNotSeeCome(String planner) {
        Pose2d start = HALL.pose('r', 0);
        NavigationRun run = alone(HALL, planner);
        add(run, "board", new Pose2d(start.x() + 0.6, start.y(), 0), 0.05, 0.82);
        run.navigator("r").goTo(HALL.pose('g', 0));
        run.advance(6);
        add(run, "person", run.truth("r").compose(new Pose2d(-0.5, 0, 0)), 0.1, 0.1);
        run.advance(25);
        assertThat(run.simulation.contacts()).isEmpty();
    }

    /// Near walls of the office where its corners would touch if it turned in place.
    @ParameterizedTest
    @CsvSource({
        "27.633, 5.165, -0.245, 25.997, -1.219",
        "-14.895, 7.222, -0.432, -17.705, 6.761",
        "28.687, -2.109, -0.342, 27.568, 0.868",
        "-25.696, -4.495, 2.803, -18.161, -4.115",
        "-3.817, -2.882, 0.336, -1.000, -4.717"
    })
    void turnsToAndFroWhereItHasNoRoomToTurn(double x, double y, double theta, double goalX, double goalY) {
        OccupancyGrid office = new Maps(FileSource.resources(StuckTest.class, "/")).read("office", Location.of("test"));
        var spec = NavigationRun.robot("r", NavigationRun.pioneer("urg04lx"), new Pose2d(x, y, theta));
        NavigationRun run = new NavigationRun(office, 1, Runnable::run, List.of(spec))
                .with(new AmclDriver(), Map.of())
                .with(new NavigatorDriver(), Map.of());
        var results = new ArrayList<Result>();
        run.navigator("r")
                .goTo(new Pose2d(goalX, goalY, 0), Tolerance.position(0.4))
                .result()
                .thenAccept(results::add);
        for (int second = 0; second < 200 && results.isEmpty(); second++) {
            run.advance(1);
        }
        assertThat(results).singleElement().isInstanceOf(Result.Reached.class);
        assertThat(run.simulation.contacts()).isEmpty();
    }

    /// A long robot in a nook that it can only leave through a gap of 0.7 m, for which its local planner wants more
    /// room.
    @ParameterizedTest
    @ValueSource(strings = {"vfh", "nd", "snd"})
    void goesOnThroughGapsThatItFitsThrough(String planner, @TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("long.yaml"), """
                title: Long rectangle, its axis behind the middle
                body: {length: 0.7, width: 0.44, center: [0.1, 0], height: 0.3}
                drive: {maxSpeed: [-0.4, 0.8], maxTurnRate: 120, maxAcceleration: 0.6, maxTurnAcceleration: 150,
                        odometryNoise: {distancePerMeter: 0.02, headingPerMeter: 1.0, headingPerDegree: 0.2}}
                mounts: {laser: [0.4, 0, 0]}
                """);
        Location here = Location.of("test");
        var model = new RobotModels(FileSource.folder(folder))
                .read("long.yaml", here, Map.of("laser", new RobotModels.Choice("urg04lx", here)));
        var spec = NavigationRun.robot("r", model, NOOK.pose('r', 0));
        NavigationRun run = new NavigationRun(NOOK.grid(), 1, Runnable::run, List.of(spec))
                .with(new AmclDriver(), Map.of())
                .with(new NavigatorDriver(), Map.of("controller", planner));
        var results = new ArrayList<Result>();
        run.navigator("r")
                .goTo(NOOK.pose('g', 0), Tolerance.position(0.4))
                .result()
                .thenAccept(results::add);
        for (int second = 0; second < 300 && results.isEmpty(); second++) {
            run.advance(1);
        }
        assertThat(results).singleElement().isInstanceOf(Result.Reached.class);
        assertThat(run.simulation.contacts()).isEmpty();
    }

    /// One robot whose laser does not look behind it.
    private static NavigationRun alone(DrawnMap map, String planner) {
        return new NavigationRun(
                        map.grid(),
                        1,
                        Runnable::run,
                        List.of(NavigationRun.robot("r", NavigationRun.pioneer("urg04lx"), map.pose('r', 0))))
                .with(new AmclDriver(), Map.of())
                .with(new NavigatorDriver(), Map.of("controller", planner));
    }

    private static void add(NavigationRun run, String name, Pose2d mapFromMiddle, double halfLength, double halfWidth) {
        var outline = new Shape.Polygon(List.of(
                new Point2d(-halfLength, -halfWidth),
                new Point2d(halfLength, -halfWidth),
                new Point2d(halfLength, halfWidth),
                new Point2d(-halfLength, halfWidth)));
        var solid = new Solid(List.of(Prism.standing(outline, 1)));
        assertThat(run.simulation.add(Thing.of(name, mapFromMiddle, solid, new Rgb(90, 60, 30))
                        .asObstacle()))
                .isInstanceOf(Placement.Placed.class);
    }

    @Test
    void leavesAGoalAloneThatIsBehindWhatItDoesNotSee() {
        var model = NavigationRun.pioneer("urg04lx");
        OccupancyGrid real = OPEN.grid();
        byte[] wider = new byte[2 * real.cells().length]; // the robot believes that it goes on
        for (int row = 0; row < real.height(); row++) {
            for (int column = 0; column < 2 * real.width(); column++) {
                wider[row * 2 * real.width() + column] =
                        real.cells()[row * real.width() + Math.min(column, real.width() - 1)];
            }
        }
        var believed = new OccupancyGrid(
                2 * real.width(), real.height(), real.resolution(), real.originX(), real.originY(), wider);
        NavigationRun run = new NavigationRun(
                        real, 1, Runnable::run, List.of(NavigationRun.robot("r", model, OPEN.pose('r', 0))))
                .on(believed)
                .with(new AmclDriver(), Map.of())
                .with(new NavigatorDriver(), Map.of());
        var results = new ArrayList<Result>();
        Pose2d edge = OPEN.pose('g', 0);
        run.navigator("r")
                .goTo(new Pose2d(edge.x() + 1.5, edge.y(), 0))
                .result()
                .thenAccept(results::add);
        for (int second = 0; second < 100 && results.isEmpty(); second++) {
            run.advance(1);
        }
        assertThat(results)
                .singleElement()
                .isInstanceOfSatisfying(
                        Result.Stuck.class, stuck -> assertThat(stuck.why()).contains("3 collisions", "does not see"));
        assertThat(run.simulation.contacts()).hasSizeLessThanOrEqualTo(3);
    }

    @Trials(
            value = {"vfh", "nd", "snd", "dwa", "mpc"},
            landing = 2)
    void saysWhatKeptItAndTouchesNothing(String planner) {
        NavigationRun run = alone(CORRIDOR, planner);
        var board = Prism.standing(
                new Shape.Polygon(List.of(
                        new Point2d(0, -0.62), new Point2d(0.1, -0.62), new Point2d(0.1, 0.62), new Point2d(0, 0.62))),
                1);
        Point2d middle =
                new Point2d(CORRIDOR.pose('r', 0).x() + 0.55, CORRIDOR.grid().originY() + 0.75);
        run.simulation.add(
                Thing.of("board", new Pose2d(middle.x(), middle.y(), 0), new Solid(List.of(board)), new Rgb(90, 60, 30))
                        .asObstacle());
        var results = new ArrayList<Result>();
        run.navigator("r").goTo(CORRIDOR.pose('g', 0)).result().thenAccept(results::add);
        for (int second = 0; second < 400 && results.isEmpty(); second++) {
            run.advance(1);
        }
        assertThat(run.simulation.contacts()).isEmpty();
        assertThat(results)
                .singleElement()
                .isInstanceOfSatisfying(
                        Result.Stuck.class,
                        stuck -> assertThat(stuck.why())
                                .satisfiesAnyOf(
                                        why -> assertThat(why)
                                                .contains(
                                                        "45 s",
                                                        "m of its path are left",
                                                        "tried '",
                                                        "The nearest obstacle is"),
                                        why -> assertThat(why) // the other end of the corridor looks alike
                                                .contains("45 s", "places fit what it sees")));
    }
}
