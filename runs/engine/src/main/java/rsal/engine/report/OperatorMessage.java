package rsal.engine.report;

import java.util.List;

/// A message that a person can say field by field: of a common topic, whose fields are few and plain.
///
/// @param topic name of it
/// @param fields in order
public record OperatorMessage(String topic, List<Field> fields) {
    public OperatorMessage {
        fields = List.copyOf(fields);
    }

    /// @param name as the message has it, frames included: `mapFromPlace`
    /// @param kind what is to be written there
    /// @param choices all that may be written there; empty where that is not limited
    public record Field(String name, Kind kind, List<String> choices) {
        public Field {
            choices = List.copyOf(choices);
        }
    }

    /// What is written in a field, as a person types it.
    public enum Kind {
        WORDS,
        NUMBER,
        /// One of a few.
        CHOICE,
        /// x and y [m]: `3 4.5`.
        PLACE,
        /// Several of them: `3 4.5; 6 7`.
        PLACES,
        /// x, y [m] and heading [°]: `3 4.5 90`.
        POSE
    }
}
