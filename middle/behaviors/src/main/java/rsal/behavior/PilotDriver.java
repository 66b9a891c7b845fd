package rsal.behavior;

import java.util.List;
import java.util.Optional;
import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.robot.DeviceDriver;
import rsal.robot.RobotModel;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.time.Phase;

/// Makes a [Pilot] (`pilot: {type: pilot}`) from a drive base, and from a laser and sonars where there are any.
public final class PilotDriver implements DeviceDriver {
    private static final Parameter<Double> MAX_RANGE =
            Parameter.number("maxRange", 5, 0.5, 100, "m", "Behaviors ignore obstacles farther away than this.");

    @Override
    public String key() {
        return "pilot";
    }

    @Override
    public String description() {
        return "Drives the robot by layers of behaviors that its agent chooses.";
    }

    @Override
    public Class<? extends Device> makes() {
        return Pilot.class;
    }

    @Override
    public List<Class<? extends Device>> needs() {
        return List.of(DriveBase.class);
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(MAX_RANGE);
    }

    @Override
    public Optional<String> refusal(RobotModel model) {
        return model.drive().turnsInPlace()
                ? Optional.empty()
                : Optional.of("Behaviors turn robots in place, which a car '%s' can't.".formatted(model.name()));
    }

    @Override
    public Pilot create(Context context, Arguments arguments) {
        var pilot = new Pilot(
                new DeviceInfo(context.robot().id(), context.name(), key()),
                context.robot(),
                new SectorFusion(arguments.get(MAX_RANGE)),
                context.scheduler());
        context.scheduler().every(Pilot.PERIOD, Phase.THINK, pilot::update);
        return pilot;
    }
}
