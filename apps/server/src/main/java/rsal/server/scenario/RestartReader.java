package rsal.server.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.engine.SpeedFactor;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;
import rsal.server.message.Messages.FieldError;
import rsal.server.message.Messages.Restart;
import rsal.server.message.Refusal;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;

/// Plans another run, of the same scenario or another one, as somebody wishes. Goes on after an error, so that all are
/// reported together, each with the field that it was typed into.
public final class RestartReader {
    private final ScenarioCatalog catalog;
    private final RunPlan present;
    private final double speed;
    private final List<FieldError> errors = new ArrayList<>();

    /// @param catalog where other scenarios are
    /// @param present the plan that what is left out is taken from, when its scenario stays
    /// @param speed the same
    public RestartReader(ScenarioCatalog catalog, RunPlan present, double speed) {
        this.catalog = catalog;
        this.present = present;
        this.speed = speed;
    }

    /// @throws Refusal with every error
    public RunPlan read(Restart wish) {
        RunOptions options = wish.scenario().isPresent() ? RunOptions.NONE : asNow();
        options = wish.configuration().map(options::withConfiguration).orElse(options);
        options = wish.arguments().map(options::withArguments).orElse(options);
        options = wish.seed().flatMap(this::seed).map(options::withSeed).orElse(options);
        options = wish.speed().flatMap(this::speed).map(options::withSpeed).orElse(options);
        options = onHost(options, wish.mas());
        try {
            RunPlan plan = scenario(wish).plan(options);
            if (errors.isEmpty()) {
                return plan;
            }
        } catch (InvalidSettings e) {
            for (Problem problem : e.problems()) {
                errors.add(error(problem, options));
            }
        }
        throw new Refusal(422, "This can't be run as it is.", List.copyOf(errors));
    }

    private Scenario scenario(Restart wish) {
        return wish.text()
                .map(text -> catalog.edited(wish.scenario(), text, present.scenario()))
                .orElseGet(() -> wish.scenario().map(catalog::load).orElse(present.scenario()));
    }

    private RunOptions asNow() {
        return present.options()
                .withConfiguration(present.configuration())
                .withSeed(present.seed())
                .withSpeed(speed);
    }

    /// In real time where the host knows no other.
    private static RunOptions onHost(RunOptions options, Optional<String> wish) {
        if (wish.isEmpty() || wish.equals(options.mas().or(() -> Optional.of("")))) {
            return options;
        }
        String key = wish.get();
        if (key.isEmpty()) {
            return options.onItsHost();
        }
        if (ScenarioCatalog.livesInRealTime(key)) {
            return options.inRealTimeOn(key);
        }
        boolean leavesRealTime =
                options.mas().filter(ScenarioCatalog::livesInRealTime).isPresent();
        return (leavesRealTime ? options.onItsHost() : options).withHost(key);
    }

    private Optional<Long> seed(String typed) {
        try {
            return Optional.of(Long.parseLong(typed.strip()));
        } catch (NumberFormatException _) {
            errors.add(new FieldError(
                    "seed", "'seed' must be a whole number, not '%s'.".formatted(Refusal.shortened(typed)), "Try 42."));
            return Optional.empty();
        }
    }

    private Optional<Double> speed(String typed) {
        try {
            return Optional.of(SpeedFactor.parse(typed));
        } catch (IllegalArgumentException e) {
            errors.add(new FieldError("speed", String.valueOf(e.getMessage()), ""));
            return Optional.empty();
        }
    }

    private static FieldError error(Problem problem, RunOptions options) {
        String where = options.arguments().keySet().stream()
                .filter(name -> options.locationOf(name).equals(problem.location()))
                .findFirst()
                .map(name -> "arguments." + name)
                .orElse(problem.location().toString());
        return new FieldError(where, problem.message(), problem.remedy());
    }
}
