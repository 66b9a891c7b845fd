package rsal.server;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import rsal.data.ActuatorState;
import rsal.scenario.run.Answer;
import rsal.server.Messages.DeviceNumbers;
import rsal.server.Messages.NumberInfo;
import rsal.server.Messages.PlottedNumbers;
import rsal.server.Quantity.Words;

/// Numbers in what devices tell, of whatever kind that is: to be plotted, but for what stays the same. Records are
/// looked through, in the order of their components; of arrays it is the least, the mean and the greatest of what is
/// finite. Angles become degrees.
/// [Quantity] says what people call them.
final class Numbers {
    /// Of one device.
    static final int MOST = 40;

    private static final int DEEPEST = 4; // records within records

    private final List<NumberInfo> found = new ArrayList<>();

    private Numbers() {}

    static PlottedNumbers of(Answer.Read told) {
        return new PlottedNumbers(
                told.time().toNanos() / 1e9,
                told.readings().stream()
                        .map(reading -> new DeviceNumbers(
                                reading.device(), of(reading.value().value())))
                        .filter(device -> !device.numbers().isEmpty())
                        .toList());
    }

    /// Each with its name: `velocity.vx`.
    static List<NumberInfo> of(Object value) {
        var numbers = new Numbers();
        numbers.look("", Words.NONE, value, 0);
        return numbers.found.stream().limit(MOST).toList();
    }

    private void look(String name, Words words, Object value, int depth) {
        switch (value) {
            case Boolean flag -> add(name, words, flag ? 1 : 0);
            case Number number -> add(name, words, number.doubleValue());
            case float[] all when all.length > 0 -> summary(name, words, all);
            case Optional<?> some -> some.ifPresent(inner -> look(name, words, inner, depth));
            case List<?> all -> add(name + ".count", words.and("how many").in(""), all.size());
            case ActuatorState actuator
            when depth < DEEPEST -> {
                for (RecordComponent component : parts(actuator)) {
                    look(
                            inner(name, component),
                            words.and(Quantity.of(actuator, component)),
                            read(actuator, component),
                            depth + 1);
                }
            }
            case Record record
            when depth < DEEPEST -> {
                for (RecordComponent component : parts(record)) {
                    look(inner(name, component), words.and(Quantity.of(component)), read(record, component), depth + 1);
                }
            }
            default -> {} // words, and what nobody can plot
        }
    }

    /// Without what stays the same.
    private static List<RecordComponent> parts(Record record) {
        return Arrays.stream(record.getClass().getRecordComponents())
                .filter(component -> !Quantity.isSetting(component))
                .toList();
    }

    private static String inner(String name, RecordComponent component) {
        return name.isEmpty() ? component.getName() : name + "." + component.getName();
    }

    private static Object read(Record record, RecordComponent component) {
        try {
            return component.getAccessor().invoke(record);
        } catch (IllegalAccessException | InvocationTargetException e) {
            throw new LinkageError("Values of devices are public, and their parts can always be read.", e);
        }
    }

    private void add(String name, Words words, double value) {
        boolean angle = words.unit().equals(Quantity.ANGLE) || words.unit().equals(Quantity.TURN);
        double shown = angle ? Math.toDegrees(value) : value;
        String unit = angle ? words.unit().replace("rad", "°") : words.unit();
        found.add(new NumberInfo(
                name, words.title(), unit, Double.isFinite(shown) ? Optional.of(shown) : Optional.empty()));
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
