package rsal.navigation.device;

import java.util.List;
import rsal.data.Covariance2d;
import rsal.data.PoseEstimate;
import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.device.Localizer;
import rsal.robot.DeviceDriver;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Makes localizers of exact odometry, such as that of a simulation's robots that have no noise.
public final class OdometryLocalizerDriver implements DeviceDriver {
    private static final Parameter<Double> DEVIATION =
            Parameter.number("deviation", 0, 0, 100, "m", "how uncertain the start position is");
    private static final Parameter<Double> ANGLE_DEVIATION =
            Parameter.number("angleDeviation", 0, 0, 360, "deg", "how uncertain the start heading is");

    @Override
    public String key() {
        return "odometry";
    }

    @Override
    public String description() {
        return "Says where the robot is by odometry alone: for robots whose odometry is exact, as no error is ever found.";
    }

    @Override
    public Class<? extends Device> makes() {
        return Localizer.class;
    }

    @Override
    public List<Class<? extends Device>> needs() {
        return List.of(DriveBase.class);
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(DEVIATION, ANGLE_DEVIATION);
    }

    @Override
    public Device create(Context context, Arguments arguments) {
        double deviation = arguments.get(DEVIATION);
        var covariance = Covariance2d.ofDeviations(deviation, deviation, arguments.radians(ANGLE_DEVIATION));
        var localizer = new OdometryLocalizer(
                new DeviceInfo(context.robot().id(), context.name(), key()),
                context.map(),
                context.mapFromBase().map(pose -> PoseEstimate.of(pose, covariance)));
        localizer.follow(context.robot().require(DriveBase.class));
        return localizer;
    }
}
