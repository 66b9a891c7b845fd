package rsal.experiment;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/// What an experiment compares: every configuration with every level of every factor, each with all of the
/// seeds.
///
/// @param configurations names, each once; effects are told beside the first
/// @param settings arguments that are the same in all runs, as typed
/// @param seeds each once; the same for all that is compared, so that differences are not those between seeds
/// @param limit simulated time after which runs end; empty when only the scenario says
public record Design(
        List<String> configurations,
        List<Factor> factors,
        Map<String, String> settings,
        List<Long> seeds,
        Optional<Duration> limit) {
    /// What configurations are called where they are listed as a factor.
    public static final String CONFIGURATION = "configuration";

    public Design {
        configurations = List.copyOf(configurations);
        factors = List.copyOf(factors);
        settings = Collections.unmodifiableMap(new LinkedHashMap<>(settings));
        seeds = List.copyOf(seeds);
    }

    /// How many there are; `Long.MAX_VALUE` for more than can be counted.
    public long runs() {
        long runs = (long) configurations.size() * seeds.size();
        for (Factor factor : factors) {
            runs = runs > Integer.MAX_VALUE
                    ? Long.MAX_VALUE
                    : runs * factor.levels().size();
        }
        return runs;
    }

    /// All combinations, those of the first configuration first; the last factor changes fastest.
    public List<Combination> combinations() {
        var combinations = new ArrayList<Combination>();
        for (String configuration : configurations) {
            var levels = List.<Map<String, String>>of(Map.of());
            for (Factor factor : factors) {
                levels = levels.stream()
                        .flatMap(known -> factor.levels().stream().map(level -> with(known, factor, level)))
                        .toList();
            }
            for (Map<String, String> each : levels) {
                combinations.add(new Combination(combinations.size() + 1, configuration, each));
            }
        }
        return List.copyOf(combinations);
    }

    private static Map<String, String> with(Map<String, String> known, Factor factor, String level) {
        var more = new LinkedHashMap<>(known);
        more.put(factor.argument(), level);
        return more;
    }

    /// The runs, numbered from 1, seed by seed: wherever the experiment is broken off, all combinations have
    /// had about the same seeds.
    public List<Trial> trials() {
        List<Combination> combinations = combinations();
        var trials = new ArrayList<Trial>();
        for (long seed : seeds) {
            for (Combination combination : combinations) {
                trials.add(new Trial(trials.size() + 1, combination, seed));
            }
        }
        return List.copyOf(trials);
    }

    /// What tells combinations apart: configurations, if there are several, and all factors with several
    /// levels.
    public List<Factor> compared() {
        var compared = new ArrayList<Factor>();
        if (configurations.size() > 1) {
            compared.add(new Factor(CONFIGURATION, configurations));
        }
        factors.stream().filter(factor -> factor.levels().size() > 1).forEach(compared::add);
        return compared;
    }
}
