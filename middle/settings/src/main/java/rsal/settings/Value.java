package rsal.settings;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.UnaryOperator;

/// What a YAML file holds, each value with the place it came from.
public sealed interface Value {
    Location location();

    /// `a number (3)`, `a list of 2`: how to name it in a message.
    String describe();

    /// @param value String, Long, Double or Boolean; an empty value is the empty string
    record Scalar(Location location, Object value) implements Value {
        @Override
        public String describe() {
            return value.toString().isEmpty() ? "nothing" : "'" + shortened(value.toString()) + "'";
        }

        private static String shortened(String text) {
            return text.length() <= 80 ? text : text.substring(0, 77) + "...";
        }
    }

    record Sequence(Location location, List<Value> items) implements Value {
        public Sequence {
            items = List.copyOf(items);
        }

        @Override
        public String describe() {
            return "a list of " + items.size();
        }
    }

    /// @param keys where each key was written
    record Mapping(Location location, Map<String, Value> entries, Map<String, Location> keys) implements Value {
        public Mapping {
            entries = Collections.unmodifiableMap(new LinkedHashMap<>(entries));
            keys = Collections.unmodifiableMap(new LinkedHashMap<>(keys));
        }

        public static Mapping empty(Location location) {
            return new Mapping(location, Map.of(), Map.of());
        }

        public Optional<Value> find(String key) {
            return Optional.ofNullable(entries.get(key));
        }

        @Override
        public String describe() {
            return "a group of " + entries.size() + " settings";
        }

        /// This with `over` laid on top: groups are [#overlaid], all else is replaced.
        public Mapping merge(Mapping over) {
            var merged = new LinkedHashMap<>(entries);
            var places = new LinkedHashMap<>(keys);
            over.entries.forEach((key, value) -> {
                merged.merge(
                        key,
                        value,
                        (below, above) ->
                                below instanceof Mapping a && above instanceof Mapping b ? a.overlaid(b) : above);
                Location place = over.keys.get(key);
                if (place != null) {
                    places.put(key, place);
                }
            });
            return new Mapping(location, merged, places);
        }

        /// This with `over` laid on top key by key; but when that says it is of another `type`, or makes `use` of
        /// another thing, that alone, as the options of one make no sense for another.
        public Mapping overlaid(Mapping over) {
            return over.differs("type", this) || over.differs("use", this) ? over : merge(over);
        }

        private boolean differs(String key, Mapping below) {
            return find(key)
                    .flatMap(own -> below.find(key).filter(other -> !isSame(own, other)))
                    .isPresent();
        }

        private static boolean isSame(Value one, Value other) {
            return one instanceof Scalar a && other instanceof Scalar b && Objects.equals(a.value(), b.value());
        }

        public Mapping without(String key) {
            var rest = new LinkedHashMap<>(entries);
            rest.remove(key);
            return new Mapping(location, rest, keys);
        }
    }

    /// The same tree with every scalar replaced.
    default Value map(UnaryOperator<Scalar> replace) {
        return switch (this) {
            case Scalar scalar -> replace.apply(scalar);
            case Sequence sequence -> {
                var items = new ArrayList<Value>();
                for (Value item : sequence.items) {
                    items.add(item.map(replace));
                }
                yield new Sequence(sequence.location, items);
            }
            case Mapping mapping -> {
                var entries = new LinkedHashMap<String, Value>();
                mapping.entries.forEach((key, value) -> entries.put(key, value.map(replace)));
                yield new Mapping(mapping.location, entries, mapping.keys);
            }
        };
    }
}
