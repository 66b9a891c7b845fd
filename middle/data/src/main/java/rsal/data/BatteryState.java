package rsal.data;

/// State of a battery (`sensor_msgs/BatteryState`, Player `power`). NaN when the battery cannot measure a value.
///
/// @param charge energy that is left [J]; +∞ when it is never empty
/// @param capacity energy of the full battery [J]; +∞ when it is never empty
/// @param level share of the capacity that is left, 0–1
/// @param power charging power less consumed power [W]; negative while it discharges
/// @param voltage [V]
/// @param charging whether it is charged
public record BatteryState(
        double charge, double capacity, double level, double power, double voltage, Charging charging) {

    /// Where energy flows.
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
