package rsal.navigation.device;

import java.util.SplittableRandom;
import java.util.concurrent.CompletionStage;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.PlaceFinder;
import rsal.device.PlaceObjective;
import rsal.navigation.spread.ReachableSpace;
import rsal.navigation.spread.Spreader;
import rsal.navigation.spread.TeamPlaces;
import rsal.time.Scheduler;

/// Spreads places over the run's map, on the scheduler's threads for what takes long. Each question begins the same
/// stream of random numbers, so that answers do not depend on what was asked before.
final class MapPlaceFinder extends DeviceCore implements PlaceFinder {
    /// What is kept for a team, since all of its robots ask for it: the ground around where it asked first, and what
    /// is computed of that for each number of places. Other parts of a map are looked at when they are asked for.
    static final class Kept {
        private record Ground(OccupancyGrid map, double clearance) {}

        private record Places(ReachableSpace ground, int count) {}

        private final ComputedOnce<Ground, ReachableSpace> grounds = new ComputedOnce<>();
        private final ComputedOnce<Places, Spreader> spreaders = new ComputedOnce<>();
        private final ComputedOnce<ReachableSpace, TeamPlaces> choices = new ComputedOnce<>();

        /// @throws IllegalArgumentException when there is no place with so much clearance
        private TeamPlaces choices(OccupancyGrid map, double clearance, Point2d start) {
            ReachableSpace ground =
                    grounds.of(new Ground(map, clearance), _ -> ReachableSpace.around(map, clearance, start));
            return ground.contains(start)
                    ? choices.of(ground, TeamPlaces::new)
                    : new TeamPlaces(ReachableSpace.around(map, clearance, start));
        }

        /// @throws IllegalArgumentException when there is no room for so many
        private Spreader spreader(OccupancyGrid map, double clearance, Point2d start, int count) {
            ReachableSpace ground =
                    grounds.of(new Ground(map, clearance), _ -> ReachableSpace.around(map, clearance, start));
            return ground.contains(start)
                    ? spreaders.of(new Places(ground, count), _ -> new Spreader(ground, count))
                    : new Spreader(ReachableSpace.around(map, clearance, start), count);
        }
    }

    private final OccupancyGrid map;
    private final Kept kept;
    private final long seed;
    private final Scheduler scheduler;

    MapPlaceFinder(DeviceInfo info, OccupancyGrid map, Kept kept, long seed, Scheduler scheduler) {
        super(info);
        this.map = map;
        this.kept = kept;
        this.seed = seed;
        this.scheduler = scheduler;
    }

    @Override
    public CompletionStage<Result> find(Pose2d mapFromStart, int count, double clearance, PlaceObjective objective) {
        return scheduler.compute(() -> places(mapFromStart.position(), count, clearance, objective));
    }

    private Result places(Point2d start, int count, double clearance, PlaceObjective objective) {
        if (!Double.isFinite(start.x()) || !Double.isFinite(start.y())) {
            return new Result.None("The start (%s, %s) is no place.".formatted(start.x(), start.y()));
        }
        try {
            if (objective != PlaceObjective.EVENLY) {
                return new Result.Found(kept.choices(map, clearance, start).choose(count, objective));
            }
            Spreader spreader = kept.spreader(map, clearance, start, count);
            return new Result.Found(
                    spreader.spread(new SplittableRandom(seed), _ -> {}).places());
        } catch (IllegalArgumentException e) { // what can't be: each says why
            return new Result.None(String.valueOf(e.getMessage()));
        }
    }
}
