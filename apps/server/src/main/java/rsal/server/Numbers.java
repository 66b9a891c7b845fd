package rsal.server;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import rsal.scenario.run.Reading;
import rsal.server.Messages.DeviceNumbers;
import rsal.server.Messages.NumberInfo;
import rsal.server.Messages.PlottedNumbers;

/// Numbers in what devices tell, of whatever kind that is: to be plotted. Records are looked through, in the order of
/// their components; of arrays it is the least, the mean and the greatest of what is finite. Angles become degrees.
final class Numbers {
    /// Of one device.
    static final int MOST = 40;

    private static final int DEEPEST = 4; // records within records

    private Numbers() {}

    static PlottedNumbers of(List<Reading> readings) {
        return new PlottedNumbers(readings.stream()
                .map(reading ->
                        new DeviceNumbers(reading.device(), of(reading.value().value())))
                .filter(device -> !device.numbers().isEmpty())
                .toList());
    }

    /// Each with its name: `velocity.vx`.
    static List<NumberInfo> of(Object value) {
        var numbers = new ArrayList<NumberInfo>();
        look("", value, 0, numbers);
        return numbers.stream().limit(MOST).toList();
    }

    private static void look(String name, Object value, int depth, List<NumberInfo> found) {
        switch (value) {
            case Boolean flag -> found.add(new NumberInfo(name, Optional.of(flag ? 1.0 : 0.0)));
            case Number number -> found.add(number(name, number.doubleValue()));
            case float[] all when all.length > 0 -> found.addAll(summary(name, all));
            case Optional<?> some -> some.ifPresent(inner -> look(name, inner, depth, found));
            case List<?> all -> found.add(number(name + ".count", all.size()));
            case Record record
            when depth < DEEPEST -> {
                for (RecordComponent component : record.getClass().getRecordComponents()) {
                    String inner = name.isEmpty() ? component.getName() : name + "." + component.getName();
                    look(inner, read(record, component), depth + 1, found);
                }
            }
            default -> {} // words, and what nobody can plot
        }
    }

    private static Object read(Record record, RecordComponent component) {
        try {
            return component.getAccessor().invoke(record);
        } catch (IllegalAccessException | InvocationTargetException e) {
            throw new LinkageError("Values of devices are public, and their parts can always be read.", e);
        }
    }

    private static NumberInfo number(String name, double value) {
        String last = name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
        boolean angle =
                last.equals("theta") || last.equals("omega") || last.contains("angle") || last.equals("bearing");
        DoubleUnaryOperator shown = angle ? Math::toDegrees : DoubleUnaryOperator.identity();
        return new NumberInfo(
                name, Double.isFinite(value) ? Optional.of(shown.applyAsDouble(value)) : Optional.empty());
    }

    private static List<NumberInfo> summary(String name, float[] all) {
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
        return List.of(
                number(name + ".least", least),
                number(name + ".mean", sum / finite),
                number(name + ".greatest", greatest));
    }
}
