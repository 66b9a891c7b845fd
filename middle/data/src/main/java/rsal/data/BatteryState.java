package rsal.data;

/// What is left in a robot's store of energy (`sensor_msgs/BatteryState`, Player `power`). NaN is what it can't
/// tell.
///
/// @param charge what is left [J]; +∞ when it never runs dry
/// @param capacity what it holds when it is full [J]; +∞ when it never runs dry
/// @param level share of the capacity that is left, 0–1
/// @param power what goes in less what goes out, now [W]; negative while it discharges
/// @param voltage [V]
public record BatteryState(
        double charge, double capacity, double level, double power, double voltage, Charging charging) {

    public enum Charging {
        UNKNOWN,
        /// Something outside of the robot fills it.
        CHARGING,
        DISCHARGING,
        /// The robot gives from it to another.
        GIVING,
        FULL
    }

    /// A store that knows what is in it, and no voltage.
    public static BatteryState of(double charge, double capacity, double power, Charging charging) {
        double level = capacity == Double.POSITIVE_INFINITY ? 1 : charge / capacity;
        return new BatteryState(charge, capacity, level, power, Double.NaN, charging);
    }

    public boolean empty() {
        return level <= 0;
    }
}
