package rsal.ros2.type;

import java.util.List;

/// A type of messages.
///
/// @param name in full: `sensor_msgs/msg/LaserScan`, `std_srvs/srv/SetBool_Request`, `nav2_msgs/action/Spin_Goal`
/// @param fields in their order on the wire; a type without any has one that means nothing, as ROS 2 wants it
public record RosType(String name, List<Field> fields) {
    static final Field NOTHING = new Field(
            "structure_needs_at_least_one_member", new FieldType(Primitive.UINT8, FieldType.Repeat.ONE, 0), "");

    public RosType {
        fields = fields.isEmpty() ? List.of(NOTHING) : List.copyOf(fields);
    }

    /// Its name in DDS: `sensor_msgs::msg::dds_::LaserScan_`.
    public String ddsName() {
        int last = name.lastIndexOf('/');
        return name.substring(0, last).replace("/", "::") + "::dds_::" + name.substring(last + 1) + "_";
    }
}
