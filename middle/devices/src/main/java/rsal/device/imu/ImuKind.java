package rsal.device.imu;

import java.util.List;
import rsal.robot.DeviceKind;
import rsal.settings.Parameter;

/// IMUs as parts of robots. The model of their errors is that of Kalibr (ETH Zurich, *IMU Noise Model*): white
/// noise by its density, and an offset. Defaults are of the data sheet of a Bosch BMI088, of offsets a tenth,
/// as after calibration.
public final class ImuKind implements DeviceKind {
    public static final Parameter<Boolean> COMPASS = Parameter.flag(
            "compass", false, "whether its orientation is absolute, by a magnetometer, and so does not drift");
    public static final Parameter<Double> COMPASS_NOISE =
            Parameter.number("compassNoise", 2, 0, 90, "deg", "standard deviation of the orientation by a compass");
    public static final Parameter<Double> GYROSCOPE_NOISE =
            Parameter.number("gyroscopeNoise", 0.014, 0, 10, "deg/s/√Hz", "noise density of the angular velocity");
    public static final Parameter<Double> GYROSCOPE_BIAS = Parameter.number(
            "gyroscopeBias", 0.1, 0, 90, "deg/s", "standard deviation of the angular velocity's offset, drawn once");
    public static final Parameter<Double> ACCELEROMETER_NOISE =
            Parameter.number("accelerometerNoise", 0.0017, 0, 10, "m/s²/√Hz", "noise density of the acceleration");
    public static final Parameter<Double> ACCELEROMETER_BIAS = Parameter.number(
            "accelerometerBias", 0.02, 0, 10, "m/s²", "standard deviation of the acceleration's offset, drawn once");

    @Override
    public String key() {
        return "imu";
    }

    @Override
    public String description() {
        return "Measures the robot's angular velocity and acceleration.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(
                COMPASS, COMPASS_NOISE, GYROSCOPE_NOISE, GYROSCOPE_BIAS, ACCELEROMETER_NOISE, ACCELEROMETER_BIAS);
    }

    @Override
    public Class<Imu> makes() {
        return Imu.class;
    }

    @Override
    public Class<ImuReading> reads() {
        return ImuReading.class;
    }
}
