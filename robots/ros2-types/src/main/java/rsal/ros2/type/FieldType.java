package rsal.ros2.type;

/// The type of a field.
///
/// @param element of what it holds one or several
/// @param repeat one or several
/// @param count of an array how many, of a bounded sequence at most; else 0
public record FieldType(Element element, Repeat repeat, int count) {
    /// How many elements a field has.
    public enum Repeat {
        ONE,
        /// Always [FieldType#count].
        ARRAY,
        /// At most [FieldType#count].
        BOUNDED,
        ANY
    }

    /// Whether its bytes begin with the number of elements.
    public boolean isSequence() {
        return repeat == Repeat.BOUNDED || repeat == Repeat.ANY;
    }
}
