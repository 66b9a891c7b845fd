package rsal.server;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.server.Messages.Mistake;
import rsal.server.Messages.Restart;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;

/// Plans another run of a scenario as somebody wishes. Goes on after a mistake, so that all are reported together,
/// each with the field that it was typed into.
final class RestartReader {
    private final RunPlan present;
    private final double speed;
    private final List<Mistake> mistakes = new ArrayList<>();

    /// @param present the plan that what is left out is taken from
    /// @param speed likewise
    RestartReader(RunPlan present, double speed) {
        this.present = present;
        this.speed = speed;
    }

    /// @throws Refusal with every mistake
    RunPlan read(Restart wish) {
        RunOptions options = present.options()
                .withConfiguration(wish.configuration().orElse(present.configuration()))
                .withArguments(wish.arguments().orElse(present.options().arguments()))
                .withSeed(wish.seed().flatMap(this::seed).orElse(present.seed()))
                .withSpeed(wish.speed().flatMap(this::speed).orElse(speed));
        try {
            RunPlan plan = present.scenario().plan(options);
            if (mistakes.isEmpty()) {
                return plan;
            }
        } catch (InvalidSettings e) {
            e.problems().forEach(problem -> mistakes.add(mistake(problem, options)));
        }
        throw new Refusal(422, "This can't be run as it is.", List.copyOf(mistakes));
    }

    private Optional<Long> seed(String typed) {
        try {
            return Optional.of(Long.parseLong(typed.strip()));
        } catch (NumberFormatException _) {
            mistakes.add(new Mistake(
                    "seed", "(seed) must be a whole number, not (%s).".formatted(Refusal.shortened(typed)), "Try 42."));
            return Optional.empty();
        }
    }

    private Optional<Double> speed(String typed) {
        try {
            return Optional.of(SpeedFactor.of(typed));
        } catch (Refusal refusal) {
            mistakes.add(new Mistake("speed", refusal.sentence(), ""));
            return Optional.empty();
        }
    }

    private static Mistake mistake(Problem problem, RunOptions options) {
        String where = options.arguments().keySet().stream()
                .filter(name -> options.locationOf(name).equals(problem.location()))
                .findFirst()
                .map(name -> "arguments." + name)
                .orElse(problem.location().toString());
        return new Mistake(where, problem.message(), problem.remedy());
    }
}
