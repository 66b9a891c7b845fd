package rsal.scenario;

import java.util.Optional;
import rsal.scenario.fault.Span;
import rsal.settings.Parameter;
import rsal.settings.Section;

/// Reads how communication between agents is limited.
final class CommunicationReader {
    private static final String KEY = "communication";

    private CommunicationReader() {}

    /// @param root of the whole scenario
    /// @return empty when nothing is said of it, and everybody hears everything
    static Optional<Communication> read(Section root, Seeds seeds) {
        if (!root.has(KEY)) {
            return Optional.empty();
        }
        Section section = root.section(KEY);
        double range = number(section, Format.RANGE).orElse(Double.POSITIVE_INFINITY);
        double behindWalls = number(section, Format.BEHIND_WALLS).orElse(range);
        if (behindWalls > range) {
            section.problem(
                    "behindWalls",
                    "'%s' must be at most 'range', %s m, not '%s'."
                            .formatted(section.path("behindWalls"), range, behindWalls),
                    "Maybe the other way round?");
        }
        double loss = (Double) section.value(Format.LOSS).orElse(0.0);
        Span delay = Format.span(section, "delay", Format.RADIO_DELAY, 0).orElse(Span.of(0, 0));
        Optional<Double> bandwidth = number(section, Format.BANDWIDTH);
        section.done();
        return Optional.of(new Communication(range, behindWalls, loss, delay, bandwidth, seeds.of(KEY)));
    }

    /// Nothing when it isn't given, which is no error.
    private static Optional<Double> number(Section section, Parameter<?> parameter) {
        return section.has(parameter.name()) ? section.value(parameter).map(Double.class::cast) : Optional.empty();
    }
}
