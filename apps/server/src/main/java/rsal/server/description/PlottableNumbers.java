package rsal.server.description;

import java.util.List;
import java.util.Optional;
import rsal.engine.report.Answer;
import rsal.recording.Quantities;
import rsal.recording.RecordedQuantity;
import rsal.server.message.Messages.DeviceNumbers;
import rsal.server.message.Messages.NumberInfo;
import rsal.server.message.Messages.PlottedNumbers;

/// Numbers in what devices tell, of whatever kind that is, to be plotted: as [Quantities], with angles in degrees.
public final class PlottableNumbers {
    private static final String ANGLE = "rad";
    private static final String TURN = "rad/s";

    private PlottableNumbers() {}

    public static PlottedNumbers of(Answer.Read reported) {
        return new PlottedNumbers(
                reported.time().toNanos() / 1e9,
                reported.readings().stream()
                        .map(reading -> new DeviceNumbers(
                                reading.device(), of(reading.value().value())))
                        .filter(device -> !device.numbers().isEmpty())
                        .toList());
    }

    /// Each with its name: `velocity.vx`.
    public static List<NumberInfo> of(Object value) {
        return Quantities.of(value).all().stream().map(PlottableNumbers::info).toList();
    }

    private static NumberInfo info(RecordedQuantity quantity) {
        boolean angle = quantity.unit().equals(ANGLE) || quantity.unit().equals(TURN);
        double value = angle ? Math.toDegrees(quantity.value()) : quantity.value();
        return new NumberInfo(
                quantity.name(),
                quantity.title(),
                angle ? quantity.unit().replace("rad", "°") : quantity.unit(),
                Double.isNaN(value) ? Optional.empty() : Optional.of(value));
    }
}
