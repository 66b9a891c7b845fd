package rsal.navigation.device;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.data.Point2d;
import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.device.Planner;
import rsal.navigation.wavefront.Plan;
import rsal.navigation.wavefront.Wavefront;
import rsal.robot.DeviceDriver;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Makes planners that use [Wavefront] on the run's map.
public final class WavefrontDriver implements DeviceDriver {
    static final Parameter<Double> GOAL_DISTANCE = Parameter.number(
            "goalDistance", 0.4, 0, 10, "m", "how far from the goal a path may end if the robot does not fit there");

    private final GlobalPlanners ways = new GlobalPlanners();

    @Override
    public String key() {
        return "wavefront";
    }

    @Override
    public String description() {
        return "Plans paths over the map.";
    }

    @Override
    public Class<? extends Device> makes() {
        return Planner.class;
    }

    @Override
    public List<Parameter<?>> parameters() {
        var parameters = new ArrayList<>(GlobalPlanners.parameters());
        parameters.add(GOAL_DISTANCE);
        return parameters;
    }

    @Override
    public Optional<String> advice(String option) {
        return ForeignOptions.OF_PLANNERS.advice(option, parameters());
    }

    @Override
    public Device create(Context context, Arguments arguments) {
        Wavefront wavefront = ways.of(context.map(), context.robot().model().footprint(), arguments);
        var search = new Waves(wavefront, arguments.get(GOAL_DISTANCE));
        return new MapPlanner(
                new DeviceInfo(context.robot().id(), context.name(), key()), () -> search, context.scheduler());
    }

    /// @param goalDistance how far from the goal a way may end [m]
    record Waves(Wavefront ways, double goalDistance) implements MapPlanner.Search {
        @Override
        public Plan plan(Point2d start, Point2d goal) {
            return ways.plan(start, goal, goalDistance);
        }

        @Override
        public List<Double> costs(Point2d start, List<Point2d> goals, double near) {
            return ways.costs(start, goals, Math.min(near, goalDistance));
        }
    }
}
