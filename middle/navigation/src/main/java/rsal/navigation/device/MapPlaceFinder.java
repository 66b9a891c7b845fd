package rsal.navigation.device;

import java.util.SplittableRandom;
import java.util.concurrent.CompletionStage;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.PlaceFinder;
import rsal.navigation.spread.ReachableSpace;
import rsal.navigation.spread.Spreader;
import rsal.time.Scheduler;

/// Spreads places over the run's map, on the scheduler's threads for what takes long. Each question begins the same
/// stream of random numbers, so that answers do not depend on what was asked before.
final class MapPlaceFinder extends DeviceCore implements PlaceFinder {
    /// What a ground is kept for.
    record Key(OccupancyGrid map, double clearance) {}

    private final OccupancyGrid map;
    private final ComputedOnce<Key, ReachableSpace> grounds;
    private final long seed;
    private final Scheduler scheduler;

    /// @param grounds around where a team asked first; other parts of a map are looked at when they are asked for
    MapPlaceFinder(
            DeviceInfo info,
            OccupancyGrid map,
            ComputedOnce<Key, ReachableSpace> grounds,
            long seed,
            Scheduler scheduler) {
        super(info);
        this.map = map;
        this.grounds = grounds;
        this.seed = seed;
        this.scheduler = scheduler;
    }

    @Override
    public CompletionStage<Result> find(Pose2d mapFromStart, int count, double clearance) {
        return scheduler.compute(() -> places(mapFromStart.position(), count, clearance));
    }

    private Result places(Point2d start, int count, double clearance) {
        if (!Double.isFinite(start.x()) || !Double.isFinite(start.y())) {
            return new Result.None("The start (%s, %s) is no place.".formatted(start.x(), start.y()));
        }
        try {
            var spreader = new Spreader(ground(start, clearance), count);
            return new Result.Found(
                    spreader.spread(new SplittableRandom(seed), _ -> {}).places());
        } catch (IllegalArgumentException e) { // what can't be: each says why
            return new Result.None(String.valueOf(e.getMessage()));
        }
    }

    private ReachableSpace ground(Point2d start, double clearance) {
        ReachableSpace kept = grounds.of(new Key(map, clearance), _ -> ReachableSpace.around(map, clearance, start));
        return kept.contains(start) ? kept : ReachableSpace.around(map, clearance, start);
    }
}
