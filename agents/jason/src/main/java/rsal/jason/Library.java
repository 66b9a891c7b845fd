package rsal.jason;

import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/// Which of Jason's internal actions agents may use: those without effects outside of the agent as they are, some in
/// another way ([Replaced]), and no others.
final class Library {
    /// Those of Jason that read and change nothing but the agent's own mind.
    private static final Set<String> AS_THEY_ARE =
            Set.of((".abolish .add_annot .add_nested_source .add_plan .asserta .assertz .atom .belief .copy_term .count"
                            + " .current_intention .delete .desire .difference .done .drop_all_desires .drop_all_events"
                            + " .drop_all_intentions .drop_desire .drop_event .drop_future_intention .drop_intention .empty"
                            + " .eval .fail .fail_goal .findall .foreach .fork .get_src_info .ground .if_then_else .intend"
                            + " .intention .intersection .join .length .list .literal .loop .lower_case .max .member .min"
                            + " .my_name .namespace .nth .number .plan_label .prefix .range .relevant_plan .relevant_plans"
                            + " .relevant_rules .remove_plan .remove_source_annot .rename_apart .replace .resume .reverse"
                            + " .setof .signal .sort .string .structure .sublist .substring .succeed_goal .suffix .suspend"
                            + " .suspended .type .union .upper_case")
                    .split(" ", -1));

    private static final Set<String> COLLECTIONS = Set.of(".map", ".queue", ".set");

    /// What to do instead, by name.
    private static final Map<String, String> REFUSED = Map.of(
            ".stopMAS", "The scenario says when a run ends (run.stop).",
            ".create_agent", "The scenario says which agents there are (agents).",
            ".clone", "The scenario says which agents there are (agents).",
            ".kill_agent", "An agent ends with its run.",
            ".include", "Write {include(\"FILE.asl\")} at the top of the file.",
            ".set_random_seed", "All randomness comes from the run's seed.",
            ".nano_time", "Maybe system.time, the run's time in milliseconds.",
            ".df_subscribe", "Maybe .df_search when it matters.",
            ".printf", "Maybe .print.",
            ".puts", "Maybe .print.");

    private Library() {}

    /// Whether Jason's own does nothing that it must not.
    static boolean isAsItIs(String name) {
        int dot = name.indexOf('.', 1);
        return AS_THEY_ARE.contains(name) || (dot > 0 && COLLECTIONS.contains(name.substring(0, dot)));
    }

    static boolean isKnown(String name) {
        return isAsItIs(name) || Replaced.NAMES.contains(name);
    }

    /// All that can be used, in the order of their names.
    static Set<String> names() {
        var names = new TreeSet<>(AS_THEY_ARE);
        names.addAll(Replaced.NAMES);
        return names;
    }

    /// What to do instead of using one that is not known; empty when nobody can tell.
    static String instead(String name) {
        return REFUSED.getOrDefault(name, "");
    }
}
