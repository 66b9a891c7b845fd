package rsal.environment;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import rsal.robot.RobotSpec;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.RunPlan.PlannedAgent;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.scenario.Scenario;

/// What all episodes of an environment have in common. Immutable.
///
/// @param options configuration and arguments; its seed is that of each episode
/// @param role of the robots that learn: their agents are replaced, all others take part as they are. Empty for none:
///     then the scenario's own agents can be measured as learners are
/// @param observations of each learner, one after the other
/// @param steps of the scenario in a step of the environment
public record Blueprint(
        Scenario scenario,
        RunOptions options,
        String role,
        List<LearnerObservation> observations,
        LearnerAction action,
        int steps) {
    private static final int MOST_STEPS = 10_000;

    /// @throws IllegalArgumentException in a sentence for people
    public Blueprint {
        observations = List.copyOf(observations);
        if (observations.isEmpty()) {
            throw new IllegalArgumentException("A learner needs at least one observation, such as 'ranges'.");
        }
        if (steps < 1 || steps > MOST_STEPS) {
            throw new IllegalArgumentException(
                    "A step has 1 to %d steps of the scenario, not '%d'.".formatted(MOST_STEPS, steps));
        }
    }

    /// How many numbers a learner observes.
    public int observed() {
        return observations.stream().mapToInt(each -> each.fields().size()).sum();
    }

    /// How many numbers an action has.
    public int acted() {
        return action.fields().size();
    }

    /// The run of an episode.
    ///
    /// @throws rsal.settings.InvalidSettings when the scenario has errors
    /// @throws IllegalArgumentException when no robot has the role of the learners
    RunPlan plan(long seed, LearnerType learners) {
        RunPlan plan = scenario.plan(options.withSeed(seed).withSpeed(Double.POSITIVE_INFINITY));
        if (role.isEmpty()) {
            return plan;
        }
        List<String> ids = plan.robots().stream()
                .map(PlannedRobot::spec)
                .filter(robot -> robot.role().equals(role))
                .map(RobotSpec::id)
                .toList();
        if (ids.isEmpty()) {
            throw new IllegalArgumentException("No robot has the role '%s'. Roles are: %s."
                    .formatted(
                            role,
                            String.join(
                                    ", ",
                                    plan.robots().stream()
                                            .map(robot -> robot.spec().role())
                                            .distinct()
                                            .toList())));
        }
        var agents = new ArrayList<PlannedAgent>();
        plan.agents().stream()
                .filter(agent -> agent.robot().filter(ids::contains).isEmpty())
                .forEach(agents::add);
        ids.forEach(id -> agents.add(learners.plan(id, seed)));
        return plan.with(agents);
    }

    /// What there is to know of it, without an episode.
    ///
    /// @param learners ids of the robots that learn
    /// @param robots roles of all robots, by id
    /// @param colors of all robots, by id: `#rrggbb`, as on the page
    /// @param period simulated time of a step [s]
    public record Layout(
            List<String> learners, Map<String, String> robots, Map<String, String> colors, double period) {}
}
