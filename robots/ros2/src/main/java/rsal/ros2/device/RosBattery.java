package rsal.ros2.device;

import rsal.data.BatteryState;
import rsal.data.BatteryState.Charging;
import rsal.device.Battery;
import rsal.device.DeviceInfo;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.message.RosMessages;

/// A battery that publishes `sensor_msgs/BatteryState`.
final class RosBattery extends RosSensor<BatteryState> implements Battery {
    private static final double SECONDS_PER_HOUR = 3_600;

    private final Frames frames;
    private final RobotClock clock;

    RosBattery(DeviceInfo info, String topic, Frames frames, RobotClock clock) {
        super(info, info.robot() + "/base_link", topic);
        this.frames = frames;
        this.clock = clock;
    }

    void take(RosMessage message) {
        double voltage = message.number("voltage");
        double capacity = message.number("capacity");
        double whole = Double.isNaN(capacity) ? message.number("design_capacity") : capacity;
        heard(frames.now());
        publish(
                clock.time(RosMessages.stamp(message.message("header"))),
                new BatteryState(
                        message.number("charge") * SECONDS_PER_HOUR * voltage,
                        whole * SECONDS_PER_HOUR * voltage,
                        message.number("percentage"),
                        message.number("current") * voltage,
                        voltage,
                        charging((int) message.integer("power_supply_status"))));
    }

    /// Constants of the message.
    private static Charging charging(int status) {
        return switch (status) {
            case 1 -> Charging.CHARGING;
            case 2, 3 -> Charging.DISCHARGING;
            case 4 -> Charging.FULL;
            default -> Charging.UNKNOWN;
        };
    }
}
