package rsal.ros2.type;

/// What a field holds one or several of.
public sealed interface Element permits Element.Text, Element.Nested, Primitive {
    /// A text.
    ///
    /// @param isWide whether of 16 bits a character
    /// @param most characters; 0 when nothing bounds it
    record Text(boolean isWide, int most) implements Element {}

    /// A message within a message.
    ///
    /// @param type its full name, `std_msgs/msg/Header`
    record Nested(String type) implements Element {}
}
