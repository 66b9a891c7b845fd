package own;

import java.util.List;
import rsal.data.Point2d;
import rsal.robot.DeviceKind;
import rsal.settings.Parameter;

/// Light meters as parts of robots.
public final class LightMeterKind implements DeviceKind {
    static final Parameter<List<Point2d>> LAMP = Parameter.points("lamp", "where the lamp hangs");
    static final Parameter<Double> NOISE =
            Parameter.number("noise", 1, 0, 1000, "lx", "standard deviation of its readings");

    @Override
    public String key() {
        return "light-meter";
    }

    @Override
    public String description() {
        return "Measures how bright it is.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(LAMP, NOISE);
    }

    @Override
    public Class<LightMeter> makes() {
        return LightMeter.class;
    }

    @Override
    public Class<Illuminance> reads() {
        return Illuminance.class;
    }
}
