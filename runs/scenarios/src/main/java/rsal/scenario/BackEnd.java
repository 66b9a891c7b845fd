package rsal.scenario;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import rsal.scenario.RunPlan.Clock;
import rsal.scenario.installed.Catalog;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.settings.Section;

/// What robots come from or agents run on: who makes it, and how it is set.
record BackEnd<P>(P provider, Arguments settings) {
    /// One of a kind.
    ///
    /// @param what it is, for messages: `robot system`
    /// @param known by key
    /// @param apart how to get those that are not installed, by key
    record Kind<P>(
            String what,
            String fallback,
            Map<String, P> known,
            Map<String, String> apart,
            Predicate<P> followsTime,
            Function<P, List<Parameter<?>>> parameters) {}

    /// @param whose it is, for messages: ` of robot (hunter)`; empty when it is that of the scenario
    static <P> Optional<BackEnd<P>> read(Kind<P> kind, Section section, String whose, Clock clock) {
        String key = section.text("use", kind.fallback);
        if (!kind.known.containsKey(key) && kind.apart.containsKey(key)) {
            section.problem(
                    "use",
                    "The %s '%s' is not part of this installation.".formatted(kind.what, key),
                    kind.apart.getOrDefault(key, ""));
            return Optional.empty();
        }
        Optional<P> provider = Catalog.find(kind.what, kind.known, key, section.locationOf("use"), section.problems());
        if (provider.isEmpty()) {
            return Optional.empty();
        }
        if (clock == Clock.SIMULATED && !kind.followsTime.test(provider.get())) {
            section.problem(
                    "use",
                    "The %s '%s'%s can't follow simulated time, which 'run.clock.mode' asks for."
                            .formatted(kind.what, key, whose),
                    "Set 'run.clock.mode' to wall, as --clock wall does, or use another %s.".formatted(kind.what));
        }
        return section.arguments(kind.parameters.apply(provider.get()))
                .map(settings -> new BackEnd<>(provider.get(), settings));
    }
}
