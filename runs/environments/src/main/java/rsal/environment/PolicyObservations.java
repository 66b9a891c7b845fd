package rsal.environment;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import rsal.agent.AgentContext;
import rsal.data.Pose2d;
import rsal.device.SimulationControl;
import rsal.python.ObservationService;
import rsal.robot.Robot;

/// Observations and actions of environments for agents in Python: the same code as for learners.
///
/// Of the truth of a simulation, an agent observes its own pose only.
public final class PolicyObservations implements ObservationService {
    @Override
    public Observed of(AgentContext self, List<Map<String, Object>> observe, Map<String, Object> act) {
        var environments = new Environments();
        List<LearnerObservation> observations = environments.observations(observe);
        LearnerAction action = environments.action(act);
        Robot robot = self.robot()
                .orElseThrow(() -> new IllegalArgumentException(
                        "Agent '%s' needs a robot. Maybe 'robot: ROLE'?".formatted(self.name())));
        var learner = new Learner(observations);
        learner.start(self);
        var world = new SimulatedTruth(self);
        List<LearnerObservation.Reader> readers = learner.readers(world);
        int[] sizes = observations.stream()
                .mapToInt(observation -> observation.fields().size())
                .toArray();
        return new Own(robot.id(), readers, sizes, action, action.of(learner));
    }

    private record Own(
            String robot,
            List<LearnerObservation.Reader> readers,
            int[] sizes,
            LearnerAction action,
            LearnerAction.Actor actor)
            implements Observed {
        @Override
        public float[] observe() {
            var all = new float[Arrays.stream(sizes).sum()];
            int next = 0;
            for (int i = 0; i < sizes.length; i++) {
                readers.get(i).read(all, next);
                next += sizes[i];
            }
            return all;
        }

        @Override
        public void act(float[] given) {
            List<String> fields = action.fields();
            if (given.length != fields.size()) {
                throw new IllegalArgumentException("An action has %d numbers (%s), not %d."
                        .formatted(fields.size(), String.join(", ", fields), given.length));
            }
            float[] low = action.low();
            float[] high = action.high();
            var within = new float[given.length];
            for (int i = 0; i < given.length; i++) {
                action.check(i, given[i], robot);
                within[i] = Math.clamp(given[i], low[i], high[i]);
            }
            actor.act(within, 0);
        }
    }

    /// The truth as an agent can ask for it.
    private static final class SimulatedTruth implements Truth {
        private final AgentContext self;
        private final Map<String, Integer> numbers = new HashMap<>();
        private final List<String> ids = new ArrayList<>();
        private final List<Pose2d> newest = new ArrayList<>();

        SimulatedTruth(AgentContext self) {
            this.self = self;
        }

        private SimulationControl simulation() {
            return self.simulation()
                    .orElseThrow(() -> new IllegalArgumentException(
                            "Agent '%s' observes the truth of a simulation, and its robot is real. Observe by sensors, or pose and place by the localizer."
                                    .formatted(self.name())));
        }

        @Override
        public int number(String robot) {
            simulation();
            return numbers.computeIfAbsent(robot, id -> {
                ids.add(id);
                newest.add(Pose2d.ORIGIN);
                return ids.size() - 1;
            });
        }

        @Override
        public int[] numbers(String role) {
            throw new IllegalArgumentException(
                    "As an agent, a policy cannot observe the truth about other robots. Maybe observe 'markers'?");
        }

        @Override
        public Pose2d truth(int robot) {
            simulation().truth(ids.get(robot)).ifPresent(pose -> newest.set(robot, pose));
            return newest.get(robot);
        }
    }
}
