package rsal.device.gnss;

import java.util.List;
import rsal.robot.DeviceKind;
import rsal.settings.Parameter;

/// Receivers of satellite navigation as parts of robots. The model of their errors is one that changes slowly
/// (a first-order Gauss–Markov process, J. Rankin, *An Error Model for Sensor Simulation: GPS and Differential
/// GPS*, 1994), and white noise. Defaults are of a common receiver under open sky.
public final class GnssKind implements DeviceKind {
    public static final Parameter<Double> DEVIATION = Parameter.number(
            "deviation", 1.2, 0, 1000, "m", "standard deviation of the error that changes slowly, of x and of y");
    public static final Parameter<Double> CORRELATION_TIME =
            Parameter.number("correlationTime", 60, 0.1, 1e6, "s", "time after which little of that error is left");
    public static final Parameter<Double> NOISE =
            Parameter.number("noise", 0.1, 0, 1000, "m", "standard deviation of the noise of each reading");
    public static final Parameter<Double> LATITUDE =
            Parameter.number("latitude", 53.599, -89, 89, "deg", "of the map's origin, north");
    public static final Parameter<Double> LONGITUDE =
            Parameter.number("longitude", 9.933, -180, 180, "deg", "of the map's origin, east");

    @Override
    public String key() {
        return "gnss";
    }

    @Override
    public String description() {
        return "Measures the robot's position by satellites.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(DEVIATION, CORRELATION_TIME, NOISE, LATITUDE, LONGITUDE);
    }

    @Override
    public Class<Gnss> makes() {
        return Gnss.class;
    }

    @Override
    public Class<GnssFix> reads() {
        return GnssFix.class;
    }
}
