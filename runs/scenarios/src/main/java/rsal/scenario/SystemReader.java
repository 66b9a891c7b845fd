package rsal.scenario;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.scenario.RunPlan.Clock;
import rsal.scenario.RunPlan.Mrs;
import rsal.scenario.installed.Catalog;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.settings.Section;
import rsal.settings.Value;
import rsal.system.RobotSystemProvider;

/// Reads which robot systems robots are of: that of the scenario, or one that their role, or they themselves,
/// name.
final class SystemReader {
    static final String KEY = "mrs";
    private static final String STEP = "step"; // of systems that have one [s]

    private final BackEnd.Kind<RobotSystemProvider> kind;
    private final Value.Mapping scenarios;
    private final Clock clock;
    private final Seeds seeds;
    private final Optional<Duration> worldStep;
    private final Optional<Mrs> fallback;

    /// @param section of the scenario's
    /// @param worldStep that of the world, if it has one
    SystemReader(Section section, Catalog catalog, Clock clock, Seeds seeds, Optional<Duration> worldStep) {
        this.kind = new BackEnd.Kind<>(
                "robot system",
                Format.DEFAULT_MRS,
                catalog.systems(),
                Map.of(),
                RobotSystemProvider::followsSchedulerTime,
                RobotSystemProvider::parameters);
        this.scenarios = named(section);
        this.clock = clock;
        this.seeds = seeds;
        this.worldStep = worldStep;
        this.fallback = read(section, "").map(chosen -> new Mrs(chosen.provider(), chosen.settings(), seeds.of(KEY)));
    }

    /// The scenario's settings, with the system's name also where nobody wrote it.
    private static Value.Mapping named(Section section) {
        var use = new Value.Scalar(section.location(), Format.DEFAULT_MRS);
        return new Value.Mapping(section.location(), Map.of("use", use), Map.of()).merge(section.mapping());
    }

    /// That of robots which say nothing; empty when it can't be read.
    Optional<Mrs> scenarios() {
        return fallback;
    }

    /// That of robots: the scenario's, with what they say otherwise of it, or another one altogether.
    ///
    /// @param whose it is, for messages: `robot (hunter)`
    Optional<Mrs> of(Section robots, String whose) {
        if (!robots.has(KEY)) {
            return fallback;
        }
        var merged = new Section(
                robots.path(KEY), scenarios.overlaid(robots.section(KEY).mapping()), robots.problems());
        return read(merged, " of " + whose).map(this::mrs);
    }

    private Optional<BackEnd<RobotSystemProvider>> read(Section section, String whose) {
        boolean ownStep = section.has(STEP);
        return BackEnd.read(kind, section, whose, clock).map(chosen -> ownStep ? chosen : inSteps(chosen));
    }

    /// With the world's own step, if there are such.
    private BackEnd<RobotSystemProvider> inSteps(BackEnd<RobotSystemProvider> chosen) {
        List<Parameter<?>> parameters = chosen.provider().parameters();
        if (worldStep.isEmpty() || parameters.stream().noneMatch(p -> p.name().equals(STEP))) {
            return chosen;
        }
        var values = new LinkedHashMap<>(chosen.settings().asMap());
        values.put(STEP, worldStep.get().toNanos() / 1e9);
        return new BackEnd<>(chosen.provider(), Arguments.of(parameters, values));
    }

    /// Robots that say the same are of one system, also those that say in other words what the scenario does.
    private Mrs mrs(BackEnd<RobotSystemProvider> chosen) {
        return fallback.filter(mrs -> mrs.provider().equals(chosen.provider())
                        && mrs.settings().equals(chosen.settings()))
                .orElseGet(() -> new Mrs(
                        chosen.provider(),
                        chosen.settings(),
                        seeds.of("mrs/" + chosen.provider().key() + chosen.settings())));
    }

    /// How long a step of a robot system is; empty of one that has no steps.
    static Optional<Duration> step(Arguments settings) {
        return settings.asMap().get(STEP) instanceof Double seconds
                ? Optional.of(Duration.ofNanos(Math.round(seconds * 1e9)))
                : Optional.empty();
    }
}
