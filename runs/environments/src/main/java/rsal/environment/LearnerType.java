package rsal.environment;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.scenario.RunPlan.PlannedAgent;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Makes the learners of one episode.
final class LearnerType implements AgentType {
    private static final Parameter<String> ROBOT = Parameter.text("robot", "Id of its robot.");

    private final List<LearnerObservation> observations;
    private final Map<String, Learner> byRobot = new LinkedHashMap<>();

    /// @param observations what each of them observes
    LearnerType(List<LearnerObservation> observations) {
        this.observations = observations;
    }

    @Override
    public String key() {
        return "learner";
    }

    @Override
    public String description() {
        return "Is driven by a program outside of the run.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(ROBOT);
    }

    /// Plans the learner of a robot.
    PlannedAgent plan(String robot, long seed) {
        byRobot.put(robot, new Learner(observations));
        var arguments = Arguments.of(parameters(), Map.of(ROBOT.name(), robot));
        return new PlannedAgent(key() + "-" + robot, key(), this, arguments, Optional.of(robot), seed);
    }

    /// Those that were planned, in that order.
    Map<String, Learner> byRobot() {
        return Collections.unmodifiableMap(byRobot);
    }

    @Override
    public Agent create(Arguments arguments) {
        return Objects.requireNonNull(byRobot.get(arguments.get(ROBOT)), "Each learner was planned.");
    }
}
