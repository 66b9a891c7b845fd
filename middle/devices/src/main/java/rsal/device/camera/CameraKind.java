package rsal.device.camera;

import java.util.List;
import java.util.Optional;
import rsal.robot.DeviceKind;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Cameras as parts of robots. Errors of their depth grow with its square, as those of structured light and of
/// stereo do (K. Khoshelham, S. Oude Elberink, *Accuracy and Resolution of Kinect Depth Data for Indoor Mapping
/// Applications*, 2012, equation 10: 1.4 mm at 1 m).
public final class CameraKind implements DeviceKind {
    public static final Parameter<Integer> COLUMNS =
            Parameter.integer("columns", 160, 1, 1920, "px", "width of the image");
    public static final Parameter<Integer> ROWS = Parameter.integer("rows", 120, 1, 1080, "px", "height of the image");
    public static final Parameter<Double> FIELD_OF_VIEW =
            Parameter.number("fieldOfView", 60, 1, 150, "deg", "from the left edge of the image to its right");
    public static final Parameter<Double> RANGE =
            Parameter.number("range", 8, 0.1, 65, "m", "maximum distance for which it measures depth");
    public static final Parameter<Double> VIEW =
            Parameter.number("view", 30, 0.1, 1000, "m", "maximum distance at which it sees colors");
    public static final Parameter<Double> DEPTH_NOISE = Parameter.number(
            "depthNoise", 0.0014, 0, 1, "1/m", "standard deviation of depth, times the square of the depth");

    @Override
    public String key() {
        return "camera";
    }

    @Override
    public String description() {
        return "Takes images in color, with depth.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(COLUMNS, ROWS, FIELD_OF_VIEW, RANGE, VIEW, DEPTH_NOISE);
    }

    @Override
    public Optional<String> refusal(Arguments arguments) {
        return arguments.get(RANGE) > arguments.get(VIEW)
                ? Optional.of("Its 'range' must not be greater than its 'view'.")
                : Optional.empty();
    }

    @Override
    public Class<Camera> makes() {
        return Camera.class;
    }

    @Override
    public Class<CameraImage> reads() {
        return CameraImage.class;
    }

    /// [px]
    public static double focalLength(Arguments arguments) {
        return arguments.get(COLUMNS) / 2.0 / Math.tan(arguments.radians(FIELD_OF_VIEW) / 2);
    }
}
