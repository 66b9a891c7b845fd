package rsal.bench.navigation;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import rsal.bench.place.Floorplan;
import rsal.bench.place.NavigatedPioneers;
import rsal.bench.place.Office;
import rsal.bench.place.Pioneers;
import rsal.data.Footprint;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.CostMap.Clearance;
import rsal.navigation.wavefront.Plan;
import rsal.navigation.wavefront.Wavefront;

/// A Pioneer that is sent somewhere from where it has little room.
///
/// @param floor that it stands on
/// @param believed the map that it is given of it
/// @param seed of what sensors and wheels err by, and of what it does by chance
record TightTrip(OccupancyGrid floor, OccupancyGrid believed, Pose2d start, Point2d goal, long seed) {
    private static final Duration PERIOD = Duration.ofMillis(500);
    private static final Tolerance NEAR = Tolerance.position(0.4); // m

    /// @param seconds that it took
    /// @param contacts how often it touched something
    record Outcome(boolean reached, double seconds, int contacts) {}

    /// @param planner the navigator's local one
    Outcome drive(String planner, Duration longest) {
        var results = new ArrayList<Result>();
        try (var pioneer = new NavigatedPioneers(
                floor,
                believed,
                List.of(start),
                Map.of("controller", planner),
                seed,
                new SplittableRandom(seed),
                Runnable::run)) {
            NavigatedPioneers.navigator(pioneer.robots.getFirst())
                    .goTo(new Pose2d(goal.x(), goal.y(), 0), NEAR)
                    .result()
                    .thenAccept(results::add);
            while (results.isEmpty() && pioneer.time.elapsed().compareTo(longest) < 0) {
                pioneer.time.advance(PERIOD);
            }
            return new Outcome(
                    results.stream().anyMatch(Result.Reached.class::isInstance),
                    pioneer.time.elapsed().toMillis() * 1e-3,
                    pioneer.contacts());
        }
    }

    /// To what is behind the end of a nook of 1.7 m × 2.6 m that is not on its map, from before the nook and from in
    /// it.
    static List<TightTrip> outOfANook(long seed) {
        var hall = Floorplan.room(9, 6);
        var nook = hall.with(3, 1.95, 5.8, 2.15).with(3, 3.85, 5.8, 4.05).with(5.6, 1.95, 5.8, 4.05);
        OccupancyGrid floor = nook.grid();
        OccupancyGrid believed = hall.grid();
        return Stream.of(new Pose2d(1.4, 3, 0), new Pose2d(4.7, 3, 0))
                .map(start -> new TightTrip(floor, believed, start, new Point2d(7.4, 3), seed))
                .toList();
    }

    /// From 1 to 12 cm beside something anywhere on the office floor, looking anywhere, to a place 2 to 11 m away.
    static List<TightTrip> besideThings(int count, long seed) {
        var random = new SplittableRandom(seed);
        var toNotFree = DistanceField.toNotFree(Office.MAP);
        var wavefront = new Wavefront(CostMap.of(Office.MAP, toNotFree, new Clearance(0.35, 0.35, 0)));
        List<Point2d> body = body(Pioneers.model(Pioneers.LASER).footprint());
        var trips = new ArrayList<TightTrip>();
        while (trips.size() < count) {
            Pose2d start = Office.place(random, _ -> true);
            double room = room(body, start);
            if (room < 0.01 || room > 0.12) {
                continue;
            }
            Point2d goal = Office.place(random, wavefront.map()::isPassable).position();
            double far = start.position().distanceTo(goal);
            if (far >= 2 && far <= 11 && wavefront.plan(start.position(), goal, 0) instanceof Plan.Found) {
                trips.add(new TightTrip(Office.MAP, Office.MAP, start, goal, random.nextLong()));
            }
        }
        return trips;
    }

    /// How far the nearest cell that is not free is from a body, up to 0.2 m [m].
    private static double room(List<Point2d> body, Pose2d mapFromBase) {
        OccupancyGrid map = Office.MAP;
        double half = map.resolution() / 2;
        double least = 0.2;
        int reach = (int) Math.ceil(least / map.resolution());
        for (Point2d point : body) {
            Point2d place = mapFromBase.transform(point);
            int column = map.column(place.x());
            int row = map.row(place.y());
            for (int r = row - reach; r <= row + reach; r++) {
                for (int c = column - reach; c <= column + reach; c++) {
                    if (map.at(c, r) != OccupancyGrid.FREE) {
                        double beside = Math.max(0, Math.abs(map.x(c) - place.x()) - half);
                        double above = Math.max(0, Math.abs(map.y(r) - place.y()) - half);
                        least = Math.min(least, Math.hypot(beside, above));
                    }
                }
            }
        }
        return least;
    }

    /// Points all over a footprint, 2 cm apart at most.
    private static List<Point2d> body(Footprint footprint) {
        var points = new ArrayList<Point2d>();
        List<Point2d> corners = footprint.corners();
        for (int i = 0; i < corners.size(); i++) {
            Point2d from = corners.get(i);
            Point2d to = corners.get((i + 1) % corners.size());
            int steps = (int) Math.ceil(from.distanceTo(to) / 0.02);
            for (int step = 0; step < steps; step++) {
                double x = from.x() + (to.x() - from.x()) * step / steps;
                double y = from.y() + (to.y() - from.y()) * step / steps;
                for (int inwards = 0; inwards <= 20; inwards++) { // towards the base, which it is around
                    points.add(new Point2d(x * inwards / 20, y * inwards / 20));
                }
            }
        }
        return points;
    }
}
