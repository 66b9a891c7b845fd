package rsal.navigation.device;

import java.util.List;
import java.util.Optional;
import rsal.data.Point2d;
import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.device.Planner;
import rsal.navigation.jumppoint.JumpPoints;
import rsal.navigation.wavefront.Plan;
import rsal.robot.DeviceDriver;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Makes planners that use [JumpPoints] on the run's map.
public final class JumpPointDriver implements DeviceDriver {
    private final GlobalPlanners planners = new GlobalPlanners();

    @Override
    public String key() {
        return "jumppoint";
    }

    @Override
    public String description() {
        return "Plans shortest paths over the map quickly, to compare distances. Paths pass obstacles as closely as"
                + " is allowed.";
    }

    @Override
    public Class<? extends Device> makes() {
        return Planner.class;
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(GlobalPlanners.WALL_DISTANCE, WavefrontDriver.GOAL_DISTANCE);
    }

    @Override
    public Optional<String> advice(String option) {
        return ForeignOptions.OF_PLANNERS.advice(option, parameters());
    }

    @Override
    public Device create(Context context, Arguments arguments) {
        JumpPoints jumps =
                planners.shortest(context.map(), context.robot().model().footprint(), arguments);
        var search = new Jumps(jumps, arguments.get(WavefrontDriver.GOAL_DISTANCE));
        return new MapPlanner(
                new DeviceInfo(context.robot().id(), context.name(), key()), () -> search, context.scheduler());
    }

    /// @param goalDistance how far from the goal a way may end [m]
    private record Jumps(JumpPoints jumps, double goalDistance) implements MapPlanner.Search {
        @Override
        public Plan plan(Point2d start, Point2d goal) {
            return jumps.plan(start, goal, goalDistance);
        }

        @Override
        public List<Double> costs(Point2d start, List<Point2d> goals, double near) {
            double slack = Math.min(near, goalDistance);
            return goals.stream()
                    .map(goal -> cost(jumps.plan(start, goal, slack)))
                    .toList();
        }

        private static double cost(Plan plan) {
            return plan instanceof Plan.Found found ? found.cost() : Double.POSITIVE_INFINITY;
        }
    }
}
