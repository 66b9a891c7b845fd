package rsal.navigation.device;

import java.util.List;
import java.util.Optional;
import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.device.Mapper;
import rsal.device.Planner;
import rsal.robot.DeviceDriver;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Makes planners for robots with an [Explorer], on the map as far as it is drawn. They keep off walls as it does.
public final class ExploredDriver implements DeviceDriver {
    @Override
    public String key() {
        return "explored";
    }

    @Override
    public String description() {
        return "Plans paths over the map that the robot's explorer has drawn so far.";
    }

    @Override
    public Class<? extends Device> makes() {
        return Planner.class;
    }

    @Override
    public List<Class<? extends Device>> needs() {
        return List.of(Mapper.class);
    }

    @Override
    public Optional<String> refusal(List<DeviceDriver> before) {
        return before.stream().anyMatch(driver -> driver instanceof ExplorerDriver)
                ? Optional.empty()
                : Optional.of("It needs a device of type 'explorer' that is written before it.");
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(WavefrontDriver.GOAL_DISTANCE);
    }

    @Override
    public Device create(Context context, Arguments arguments) {
        if (!(context.robot().require(Mapper.class) instanceof Explorer explorer)) {
            throw new IllegalArgumentException(
                    "'%s' has no explorer.".formatted(context.robot().id()));
        }
        double goalDistance = arguments.get(WavefrontDriver.GOAL_DISTANCE);
        return new MapPlanner(
                new DeviceInfo(context.robot().id(), context.name(), key()),
                () -> new WavefrontDriver.Waves(explorer.wavefront(), goalDistance),
                context.scheduler());
    }
}
