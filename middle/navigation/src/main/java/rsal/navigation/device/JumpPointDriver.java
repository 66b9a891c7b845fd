package rsal.navigation.device;

import java.util.List;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.device.Planner;
import rsal.device.Planner.Result;
import rsal.navigation.jumppoint.JumpPoints;
import rsal.robot.DeviceDriver;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Makes planners that use [JumpPoints] on the run's map.
public final class JumpPointDriver implements DeviceDriver {
    private final Ways ways = new Ways();

    @Override
    public String key() {
        return "jumppoint";
    }

    @Override
    public String description() {
        return "Finds shortest ways over the map, quickly, as near to obstacles as is allowed: to compare distances.";
    }

    @Override
    public Class<? extends Device> makes() {
        return Planner.class;
    }

    @Override
    public List<Parameter> parameters() {
        return List.of(Ways.WALL_DISTANCE);
    }

    @Override
    public Device create(Context context, Arguments arguments) {
        JumpPoints jumps = ways.shortest(context.map(), context.robot().model().footprint(), arguments);
        var search = new Jumps(jumps);
        return new MapPlanner(
                new DeviceInfo(context.robot().id(), context.name(), key()), () -> search, context.scheduler());
    }

    private record Jumps(JumpPoints jumps) implements MapPlanner.Search {
        @Override
        public Result plan(Point2d start, Point2d goal) {
            return jumps.plan(start, goal)
                    .<Result>map(path -> new Result.Found(path, path.length(), 0))
                    .orElseGet(() -> new Result.NoPath(
                            "Nothing this robot fits through leads from %s to %s.".formatted(start, goal)));
        }

        @Override
        public List<Double> costs(Point2d start, List<Point2d> goals, double near) {
            return goals.stream()
                    .map(goal -> jumps.plan(start, goal).map(Path2d::length).orElse(Double.POSITIVE_INFINITY))
                    .toList();
        }
    }
}
