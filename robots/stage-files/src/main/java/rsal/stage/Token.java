package rsal.stage;

import rsal.settings.Location;
import rsal.settings.Value;

/// A piece of a world file.
sealed interface Token {
    Location location();

    /// How messages call it.
    String text();

    /// A name: of a property, a type, or a statement.
    record Word(Location location, String text) implements Token {}

    /// A number or a string.
    record Literal(Location location, Object value) implements Token {
        @Override
        public String text() {
            return scalar().describe();
        }

        /// As it could be written in a file.
        String source() {
            return value instanceof String ? "\"" + value + "\"" : value.toString();
        }

        Value.Scalar scalar() {
            return new Value.Scalar(location, value);
        }
    }

    /// One of `( ) [ ]`.
    record Bracket(Location location, char kind) implements Token {
        @Override
        public String text() {
            return Character.toString(kind);
        }
    }

    static boolean isBracket(Token token, char kind) {
        return token instanceof Bracket bracket && bracket.kind == kind;
    }
}
