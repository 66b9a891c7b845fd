package rsal.scenario.example;

import java.time.Duration;
import java.util.List;
import rsal.device.Device;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.robot.DeviceDriver;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.time.Phase;

/// Fails after a second, or at once.
public final class BrokenDevice implements DeviceDriver {
    @Override
    public String key() {
        return "broken";
    }

    @Override
    public Class<? extends Device> makes() {
        return Device.class;
    }

    @Override
    public List<Class<? extends Device>> needs() {
        return List.of();
    }

    @Override
    public List<Parameter> parameters() {
        return List.of(Parameter.flag("atOnce", false, "Whether it can't even be made."));
    }

    @Override
    public Device create(Context context, Arguments arguments) {
        if (arguments.flag("atOnce")) {
            throw new IllegalStateException("no batteries included");
        }
        context.scheduler().after(Duration.ofSeconds(1), Phase.DEVICES, () -> {
            throw new IllegalStateException("smoke comes out");
        });
        return new DeviceCore(new DeviceInfo(context.robot().id(), context.name(), key())) {};
    }
}
