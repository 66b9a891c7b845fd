package rsal.device;

/// Who a device is.
///
/// @param robot id of the robot it belongs to (`hunter-1`); empty for devices of a whole robot system
/// @param name unique within the robot (`laser`, `localizer`)
/// @param driver what makes it work (`sim`, `amcl`, `player`)
public record DeviceInfo(String robot, String name, String driver) {
    /// Unique in a run: `hunter-1/laser`.
    public String id() {
        return robot.isEmpty() ? name : robot + "/" + name;
    }
}
