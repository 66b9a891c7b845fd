package rsal.navigation.device;

import java.util.List;
import java.util.Optional;
import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.device.LaserScanner;
import rsal.device.Localizer;
import rsal.navigation.slam.Slam;
import rsal.robot.DeviceDriver;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Makes localizers that map while they go.
public final class SlamDriver implements DeviceDriver {
    private static final Parameter<Double> MAX_RANGE =
            Parameter.number("maxRange", 25, 0.5, 200, "m", "longer ranges are not matched");
    private static final Parameter<Double> KEYFRAME_DISTANCE =
            Parameter.number("keyframeDistance", 0.5, 0.05, 5, "m", "distance between two scans that are kept");
    private static final Parameter<Double> KEYFRAME_ANGLE =
            Parameter.number("keyframeAngle", 20, 1, 180, "deg", "angle between two scans that are kept");
    private static final Parameter<Integer> MAX_SCANS = Parameter.integer(
            "maxScans",
            10_000,
            2,
            100_000,
            "",
            "maximum number of scans that are kept; with this number it only localizes");

    @Override
    public String key() {
        return "slam";
    }

    @Override
    public String description() {
        return "Estimates the robot's pose on a map that it draws from laser and odometry (graph SLAM).";
    }

    @Override
    public Class<? extends Device> makes() {
        return Localizer.class;
    }

    @Override
    public List<Class<? extends Device>> needs() {
        return List.of(DriveBase.class, LaserScanner.class);
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(MAX_RANGE, KEYFRAME_DISTANCE, KEYFRAME_ANGLE, MAX_SCANS);
    }

    @Override
    public Optional<String> noteWithoutStart() {
        return Optional.of("Its map lies in a frame of its own, so that its error against the truth is not known, and"
                + " it shares no map with others.");
    }

    @Override
    public Device create(Context context, Arguments arguments) {
        Slam.Settings usual = Slam.Settings.DEFAULT;
        var localizer = new SlamLocalizer(
                new DeviceInfo(context.robot().id(), context.name(), key()),
                new Slam.Settings(
                        arguments.get(MAX_RANGE),
                        arguments.get(KEYFRAME_DISTANCE),
                        arguments.radians(KEYFRAME_ANGLE),
                        usual.odometry(),
                        usual.recent(),
                        usual.closesLoops(),
                        arguments.get(MAX_SCANS)),
                context.mapFromBase(),
                context.scheduler());
        localizer.follow(
                context.robot().require(DriveBase.class), context.robot().require(LaserScanner.class));
        return localizer;
    }
}
