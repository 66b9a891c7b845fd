package rsal.experiment.report;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Function;
import rsal.experiment.statistics.Effect;
import rsal.experiment.statistics.Holm;

/// One comparison of several that are shown together.
///
/// @param subject what is compared, as text by its `toString`
/// @param corrected its p-value, corrected by [Holm] for all that are shown together; empty when there is none
record Compared<T>(T subject, Effect effect, OptionalDouble corrected) {
    private static final double ALARM = 0.05; // probability of a false one among all

    static <T> List<Compared<T>> together(List<T> subjects, Function<T, Effect> effect) {
        List<Effect> effects = subjects.stream().map(effect).toList();
        double[] corrected = Holm.corrected(effects.stream()
                .map(Effect::pValue)
                .filter(OptionalDouble::isPresent)
                .mapToDouble(OptionalDouble::getAsDouble)
                .toArray());
        var all = new ArrayList<Compared<T>>();
        int known = 0;
        for (int i = 0; i < subjects.size(); i++) {
            boolean isKnown = effects.get(i).pValue().isPresent();
            all.add(new Compared<>(
                    subjects.get(i),
                    effects.get(i),
                    isKnown ? OptionalDouble.of(corrected[known++]) : OptionalDouble.empty()));
        }
        return List.copyOf(all);
    }

    /// Whether there can be said anything.
    boolean isKnown() {
        return corrected.isPresent();
    }

    /// Whether it would be rare if there were no difference at all in what is shown together.
    boolean isClear() {
        return corrected.isPresent() && corrected.getAsDouble() < ALARM;
    }

    /// The mean difference.
    double difference() {
        return effect.difference().orElseThrow().value();
    }
}
