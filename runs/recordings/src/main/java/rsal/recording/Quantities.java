package rsal.recording;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import rsal.data.ActuatorState;
import rsal.recording.QuantityNames.Words;

/// Numbers in what devices tell, of whatever kind that is, but for what stays the same. Records are looked through, in
/// the order of their components; of arrays it is the least, the mean and the greatest of what is finite. What a device
/// tells of a kind that recordings have none for is recorded as these, and read as these.
public record Quantities(List<RecordedQuantity> all) {
    /// Of one device.
    public static final int MOST = 40;

    private static final int DEEPEST = 4; // records within records

    public Quantities {
        all = List.copyOf(all);
    }

    /// @param value what a device tells; also what was read of it
    public static Quantities of(Object value) {
        if (value instanceof Quantities known) {
            return known;
        }
        var search = new Search();
        search.look("", Words.NONE, value, 0);
        return new Quantities(search.found.stream().limit(MOST).toList());
    }

    private static final class Search {
        private final List<RecordedQuantity> found = new ArrayList<>();

        private void look(String name, Words words, Object value, int depth) {
            switch (value) {
                case Boolean flag -> add(name, words, flag ? 1 : 0);
                case Number number -> add(name, words, number.doubleValue());
                case float[] all when all.length > 0 -> summary(name, words, all);
                case OptionalDouble number -> add(name, words, number.orElse(Double.NaN));
                case Optional<?> some -> some.ifPresent(inner -> look(name, words, inner, depth));
                case List<?> all -> add(name + ".count", words.and("how many").in(""), all.size());
                case ActuatorState actuator
                when depth < DEEPEST -> {
                    for (RecordComponent component : parts(actuator)) {
                        look(
                                inner(name, component),
                                words.and(QuantityNames.of(actuator, component)),
                                read(actuator, component),
                                depth + 1);
                    }
                }
                case Record record
                when depth < DEEPEST -> {
                    for (RecordComponent component : parts(record)) {
                        look(
                                inner(name, component),
                                words.and(QuantityNames.of(component)),
                                read(record, component),
                                depth + 1);
                    }
                }
                default -> {} // words, and what nobody can plot
            }
        }

        /// Without what stays the same.
        private static List<RecordComponent> parts(Record record) {
            return Arrays.stream(record.getClass().getRecordComponents())
                    .filter(component -> !QuantityNames.isSetting(component))
                    .toList();
        }

        private static String inner(String name, RecordComponent component) {
            return name.isEmpty() ? component.getName() : name + "." + component.getName();
        }

        private static Object read(Record record, RecordComponent component) {
            try {
                return component.getAccessor().invoke(record);
            } catch (IllegalAccessException | InvocationTargetException _) {
                return ""; // of a kind that nobody else may look into
            }
        }

        private void add(String name, Words words, double value) {
            found.add(new RecordedQuantity(
                    name, words.title(), words.unit(), Double.isFinite(value) ? value : Double.NaN));
        }

        private void summary(String name, Words words, float[] all) {
            double least = Double.POSITIVE_INFINITY;
            double greatest = Double.NEGATIVE_INFINITY;
            double sum = 0;
            int finite = 0;
            for (float one : all) {
                if (Float.isFinite(one)) {
                    least = Math.min(least, one);
                    greatest = Math.max(greatest, one);
                    sum += one;
                    finite++;
                }
            }
            add(name + ".least", words.and("least"), least);
            add(name + ".mean", words.and("mean"), sum / finite);
            add(name + ".greatest", words.and("greatest"), greatest);
        }
    }
}
