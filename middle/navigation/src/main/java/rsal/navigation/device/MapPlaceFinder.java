package rsal.navigation.device;

import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CompletionStage;
import rsal.data.OccupancyGrid;
import rsal.data.PlaceObjective;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.PlaceFinder;
import rsal.navigation.spread.ReachableSpace;
import rsal.navigation.spread.Spreader;
import rsal.navigation.spread.TeamPlaces;
import rsal.time.Scheduler;

/// Spreads places over the run's map, on the scheduler's threads for what takes long. Each question begins the same
/// stream of random numbers, so that answers do not depend on what was asked before.
final class MapPlaceFinder extends DeviceCore implements PlaceFinder {
    /// What is kept for a team, since all of its robots ask for it: the ground around where it asked first,
    /// and what is computed of that for each number of places; for objectives that need no random numbers,
    /// the answers, too. Other parts of a map are looked at when they are asked for.
    static final class Kept {
        private record Ground(OccupancyGrid map, double clearance) {}

        private record Places(ReachableSpace ground, int count) {}

        private record Chosen(ReachableSpace ground, int count, PlaceObjective objective) {}

        private final ComputedOnce<Ground, ReachableSpace> grounds = new ComputedOnce<>();
        private final ComputedOnce<Places, Spreader> spreaders = new ComputedOnce<>();
        private final ComputedOnce<ReachableSpace, TeamPlaces> teams = new ComputedOnce<>();
        private final ComputedOnce<Chosen, List<Point2d>> answers = new ComputedOnce<>();

        /// @throws IllegalArgumentException when there is no place with so much clearance, or no room for
        /// so many
        List<Point2d> chosen(OccupancyGrid map, double clearance, Point2d start, int count, PlaceObjective objective) {
            ReachableSpace ground = ground(map, clearance, start);
            return ground.isReachedFrom(start)
                    ? answers.of(
                            new Chosen(ground, count, objective),
                            _ -> teams.of(ground, TeamPlaces::new).choose(count, objective))
                    : new TeamPlaces(ReachableSpace.around(map, clearance, start)).choose(count, objective);
        }

        private ReachableSpace ground(OccupancyGrid map, double clearance, Point2d start) {
            return grounds.of(new Ground(map, clearance), _ -> ReachableSpace.around(map, clearance, start));
        }

        /// @throws IllegalArgumentException when there is no room for so many
        private Spreader spreader(OccupancyGrid map, double clearance, Point2d start, int count) {
            ReachableSpace ground = ground(map, clearance, start);
            return ground.isReachedFrom(start)
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
                return new Result.Found(kept.chosen(map, clearance, start, count, objective));
            }
            Spreader spreader = kept.spreader(map, clearance, start, count);
            return new Result.Found(
                    spreader.spread(new SplittableRandom(seed), _ -> {}).places());
        } catch (IllegalArgumentException e) { // what can't be: each says why
            return new Result.None(String.valueOf(e.getMessage()));
        }
    }
}
