package rsal.environment;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.TreeMap;
import java.util.function.Function;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.settings.Arguments;
import rsal.settings.Plugin;
import rsal.settings.Suggestion;

/// Reads what an environment is to be, from words of a program outside.
public final class Environments {
    private static final String TYPE = "type";

    private final Map<String, ObservationType> observations = byKey(ObservationType.class);
    private final Map<String, ActionType> actions = byKey(ActionType.class);

    private static <P extends Plugin> Map<String, P> byKey(Class<P> type) {
        var byKey = new TreeMap<String, P>();
        ServiceLoader.load(type).forEach(each -> byKey.put(each.key(), each));
        return byKey;
    }

    /// @param scenario name or file
    /// @param options configuration and arguments
    /// @param role of the robots that learn
    /// @param observed each with its `type` and parameters
    /// @param acted its `type` and parameters
    /// @param steps of the scenario in a step of the environment
    /// @throws rsal.settings.InvalidSettings when the scenario has errors
    /// @throws IllegalArgumentException in a sentence for people, for all other errors
    public Blueprint read(
            String scenario,
            RunOptions options,
            String role,
            List<Map<String, Object>> observed,
            Map<String, Object> acted,
            int steps) {
        return new Blueprint(Scenario.load(scenario), options, role, observations(observed), action(acted), steps);
    }

    /// @param observed each with its `type` and parameters
    /// @throws IllegalArgumentException in a sentence for people
    List<LearnerObservation> observations(List<Map<String, Object>> observed) {
        var wanted = new ArrayList<LearnerObservation>();
        for (Map<String, Object> words : observed) {
            wanted.add(make("observation", observations, words, type -> type::create));
        }
        return wanted;
    }

    /// @param acted its `type` and parameters
    /// @throws IllegalArgumentException in a sentence for people
    LearnerAction action(Map<String, Object> acted) {
        return make("action", actions, acted, type -> type::create);
    }

    private static <P extends Plugin, M> M make(
            String what, Map<String, P> known, Map<String, Object> words, Function<P, Function<Arguments, M>> maker) {
        String key = String.valueOf(words.get(TYPE));
        P type = known.get(key);
        if (type == null) {
            throw new IllegalArgumentException(
                    "There is no %s '%s'. %s".formatted(what, key, Suggestion.among(key, known.keySet())));
        }
        var rest = new TreeMap<>(words);
        rest.remove(TYPE);
        try {
            return maker.apply(type).apply(Arguments.of(type.parameters(), rest));
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("%s '%s': %s".formatted(what, key, e.getMessage()), e);
        }
    }

    /// All kinds of observations and actions, for people.
    public List<Plugin> kinds() {
        var kinds = new ArrayList<Plugin>(observations.values());
        kinds.addAll(actions.values());
        return kinds;
    }
}
