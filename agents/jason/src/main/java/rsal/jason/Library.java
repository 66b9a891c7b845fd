package rsal.jason;

import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import rsal.settings.Suggestion;

/// Which of Jason's internal actions agents may use: those without effects outside of the agent as they are,
/// some in another way ([InternalActionOverrides]), and no others.
final class Library {
    /// Those of Jason that read and change nothing but the agent's own mind.
    private static final Set<String> AS_THEY_ARE =
            Set.of((".abolish .add_annot .add_nested_source .asserta .assertz .atom .belief .copy_term"
                            + " .count .difference .done .drop_all_desires .drop_all_events .drop_all_intentions"
                            + " .drop_desire .drop_event .drop_future_intention .drop_intention .empty .eval .fail"
                            + " .findall .foreach .fork .get_src_info .ground .if_then_else .intersection .join"
                            + " .length .list .literal .loop .max .member .min .my_name .namespace .nth .number"
                            + " .plan_label .prefix .range .relevant_plan .relevant_plans .relevant_rules"
                            + " .remove_plan .remove_source_annot .rename_apart .resume .reverse .setof .signal"
                            + " .sort .string .structure .sublist .succeed_goal .suffix .suspend .suspended .type"
                            + " .union")
                    .split(" ", -1));

    /// Those whose terms are conditions.
    private static final Set<String> ASKING = Set.of(
            ".wait",
            ".at",
            ".belief",
            ".count",
            ".eval",
            ".findall",
            ".setof",
            ".if_then_else",
            ".foreach",
            ".loop",
            ".fork");

    private static final Set<String> COLLECTIONS = Set.of(".map", ".queue", ".set");

    /// What to do instead, by name.
    private static final Map<String, String> REFUSED = Map.ofEntries(
            Map.entry(".stopMAS", "The scenario says when a run ends (run.stop)."),
            Map.entry(".create_agent", "The scenario says which agents there are (agents)."),
            Map.entry(".clone", "The scenario says which agents there are (agents)."),
            Map.entry(".kill_agent", "An agent ends with its run."),
            Map.entry(".include", "Write {include(\"FILE.asl\")} at the top of the file."),
            Map.entry(".current_intention", "Maybe .intention(Id, State, Stack, current)."),
            Map.entry(".set_random_seed", "All randomness comes from the run's seed."),
            Map.entry(".nano_time", "Maybe system.time, the run's time in milliseconds."),
            Map.entry(".df_subscribe", "Maybe .df_search when it matters."),
            Map.entry(".printf", "Maybe .print."),
            Map.entry(".puts", "Maybe .print."));

    private Library() {}

    /// Whether Jason's own does nothing that it must not.
    static boolean isAsItIs(String name) {
        int dot = name.indexOf('.', 1);
        return AS_THEY_ARE.contains(name) || (dot > 0 && COLLECTIONS.contains(name.substring(0, dot)));
    }

    static boolean isKnown(String name) {
        return isAsItIs(name) || InternalActionOverrides.NAMES.contains(name);
    }

    private static Set<String> names() {
        var names = new TreeSet<>(AS_THEY_ARE);
        names.addAll(InternalActionOverrides.NAMES);
        return names;
    }

    /// Whether what stands in it is asked for, and not only named.
    static boolean asks(String name) {
        return ASKING.contains(name);
    }

    /// Whether it says something to others.
    static boolean isSaying(String name) {
        return name.equals(".send") || name.equals(".broadcast");
    }

    /// What to do instead of using one that is not known.
    static String instead(String name) {
        return Optional.ofNullable(REFUSED.get(name))
                .or(() -> Suggestion.closest(name, names()).map("Maybe '%s' was meant?"::formatted))
                .orElse("docs/reference/agentspeak.md lists those that can.");
    }
}
