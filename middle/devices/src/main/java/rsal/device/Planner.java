package rsal.device;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import rsal.data.Path2d;
import rsal.data.Pose2d;
import rsal.data.Stamped;

/// Plans paths. A request moves no robot, so agents can compare costs, and check whether a place can be
/// reached.
public interface Planner extends Device {
    CompletionStage<Result> plan(Pose2d mapFromStart, Pose2d mapFromGoal);

    /// The costs of the paths from one place to several, in their order; +∞ if there is no path. Takes less
    /// than to plan them one by one, where that can be.
    ///
    /// @param near how far from its goal a way may end [m], at least 0; +∞ for as far as the planner ever has it
    default CompletionStage<List<Double>> costs(Pose2d mapFromStart, List<Pose2d> mapFromGoals, double near) {
        CompletionStage<List<Double>> costs = CompletableFuture.completedStage(List.of());
        for (Pose2d mapFromGoal : mapFromGoals) {
            costs = costs.thenCombine(plan(mapFromStart, mapFromGoal), (before, result) -> {
                var all = new ArrayList<>(before);
                all.add(
                        result instanceof Result.Found found && found.offGoal() <= near
                                ? found.cost()
                                : Double.POSITIVE_INFINITY);
                return all;
            });
        }
        return costs;
    }

    /// The last request and its answer, for display. Its time is the time of the request, and its frame is that
    /// of the map. Empty before, and of one that does not tell. On the scheduler's thread.
    default Optional<Stamped<Asked>> latest() {
        return Optional.empty();
    }

    /// A question about one place, or about what ways to several cost, and the result.
    ///
    /// @param mapFromStart where the way begins
    /// @param mapFromGoal the place; of several the one that it costs least to get to, or the first where no
    /// way leads anywhere
    /// @param places how many were asked about; at least 1
    /// @param reachable to how many of them a way leads
    /// @param cost of the way to the goal [m]; empty when there is none
    /// @param length of that way [m]; empty when there is none, or when only costs were asked for
    /// @param why there is none, for people; empty when there is one, or when only costs were asked for
    record Asked(
            Pose2d mapFromStart,
            Pose2d mapFromGoal,
            int places,
            int reachable,
            OptionalDouble cost,
            OptionalDouble length,
            String why) {
        /// For a way.
        public static Asked of(Pose2d mapFromStart, Pose2d mapFromGoal, Result result) {
            return switch (result) {
                case Result.Found(var path, var cost, var _) ->
                    new Asked(
                            mapFromStart,
                            mapFromGoal,
                            1,
                            1,
                            OptionalDouble.of(cost),
                            OptionalDouble.of(path.length()),
                            "");
                case Result.NoPath(var why) ->
                    new Asked(mapFromStart, mapFromGoal, 1, 0, OptionalDouble.empty(), OptionalDouble.empty(), why);
            };
        }

        /// For what ways cost.
        ///
        /// @param mapFromGoals at least one
        /// @param costs in their order; +∞ where no way leads
        public static Asked of(Pose2d mapFromStart, List<Pose2d> mapFromGoals, List<Double> costs) {
            int least = 0;
            int reachable = 0;
            for (int i = 0; i < costs.size(); i++) {
                least = costs.get(i) < costs.get(least) ? i : least;
                reachable += Double.isFinite(costs.get(i)) ? 1 : 0;
            }
            OptionalDouble cost = reachable == 0 ? OptionalDouble.empty() : OptionalDouble.of(costs.get(least));
            return new Asked(
                    mapFromStart,
                    mapFromGoals.get(least),
                    mapFromGoals.size(),
                    reachable,
                    cost,
                    OptionalDouble.empty(),
                    "");
        }
    }

    sealed interface Result {
        /// There is a path.
        ///
        /// @param cost length of the way [m], more where it is narrow: what to compare ways by
        /// @param offGoal how far from the goal it ends [m], when the robot can't be there but near it; else 0
        record Found(Path2d path, double cost, double offGoal) implements Result {}

        /// No path leads there.
        ///
        /// @param why for people
        record NoPath(String why) implements Result {}
    }
}
