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
            Parameter.number("deviation", 0, 0, 100, "m", "standard deviation of the start position");
    private static final Parameter<Double> ANGLE_DEVIATION =
            Parameter.number("angleDeviation", 0, 0, 360, "deg", "standard deviation of the start heading");

    @Override
    public String key() {
        return "odometry";
    }

    @Override
    public String description() {
        return "Estimates the robot's pose by odometry alone. It detects no errors, so it is for robots with exact"
                + " odometry.";
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
