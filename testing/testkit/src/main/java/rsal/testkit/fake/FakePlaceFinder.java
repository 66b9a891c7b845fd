package rsal.testkit.fake;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import rsal.data.OccupancyGrid;
import rsal.data.PlaceObjective;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Device;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.PlaceFinder;
import rsal.robot.DeviceDriver;
import rsal.settings.Arguments;
import rsal.time.Scheduler;

/// Takes places each as far as can be, as the crow flies, from those before, whatever the objective is.
public final class FakePlaceFinder extends DeviceCore implements PlaceFinder {
    private final OccupancyGrid map;
    private final Scheduler scheduler;

    private FakePlaceFinder(DeviceInfo info, OccupancyGrid map, Scheduler scheduler) {
        super(info);
        this.map = map;
        this.scheduler = scheduler;
    }

    @Override
    public CompletionStage<Result> find(Pose2d mapFromStart, int count, double clearance, PlaceObjective objective) {
        var result = new CompletableFuture<Result>();
        scheduler.execute(() -> result.complete(farApart(mapFromStart.position(), count, clearance)));
        return result;
    }

    private Result farApart(Point2d start, int count, double clearance) {
        List<Point2d> left = reachable(start, clearance);
        var places = new ArrayList<Point2d>();
        while (places.size() < count && !left.isEmpty()) {
            Point2d farthest = left.getFirst();
            for (Point2d place : left) {
                farthest = nearest(place, places, start) > nearest(farthest, places, start) ? place : farthest;
            }
            places.add(farthest);
            Point2d taken = farthest;
            left.removeIf(place -> place.distanceTo(taken) < 2 * clearance);
        }
        return count > 0 && places.size() == count
                ? new Result.Found(places)
                : new Result.None("There are %d such places, not '%d'.".formatted(places.size(), count));
    }

    private static double nearest(Point2d place, List<Point2d> places, Point2d otherwise) {
        return places.stream().mapToDouble(place::distanceTo).min().orElse(place.distanceTo(otherwise));
    }

    /// Middles of the cells with that clearance to which such cells lead.
    private List<Point2d> reachable(Point2d start, double clearance) {
        var reached = new ArrayList<Point2d>();
        boolean isQuestion = clearance >= 0 && Double.isFinite(start.x()) && Double.isFinite(start.y());
        if (!isQuestion || !map.isFree(start.x(), start.y())) {
            return reached;
        }
        Set<Integer> seen = new LinkedHashSet<>();
        var queue = new ArrayDeque<Integer>();
        queue.add(map.row(start.y()) * map.width() + map.column(start.x()));
        while (!queue.isEmpty()) {
            int cell = queue.remove();
            Point2d middle = map.middle(cell);
            if (seen.add(cell) && isClear(middle, clearance)) {
                reached.add(middle);
                queue.addAll(List.of(cell - 1, cell + 1, cell - map.width(), cell + map.width()));
            }
        }
        return reached;
    }

    private boolean isClear(Point2d place, double clearance) {
        int steps = 1 + (int) Math.ceil(clearance / map.resolution());
        for (int i = -steps; i <= steps; i++) {
            for (int j = -steps; j <= steps; j++) {
                if (!map.isFree(place.x() + clearance * i / steps, place.y() + clearance * j / steps)) {
                    return false;
                }
            }
        }
        return true;
    }

    /// Makes it for any robot.
    public static final class Driver implements DeviceDriver {
        @Override
        public String key() {
            return "fake-places";
        }

        @Override
        public String description() {
            return "Finds places that are far apart.";
        }

        @Override
        public Class<? extends Device> makes() {
            return PlaceFinder.class;
        }

        @Override
        public FakePlaceFinder create(Context context, Arguments arguments) {
            return new FakePlaceFinder(
                    new DeviceInfo(context.robot().id(), context.name(), key()), context.map(), context.scheduler());
        }
    }
}
