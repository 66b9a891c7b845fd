package rsal.agents.driving;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import rsal.agent.AgentContext;
import rsal.agent.ServiceDescription;
import rsal.agent.protocol.Request;
import rsal.agent.protocol.Request.Asked;
import rsal.agents.parts.AgentWords;
import rsal.agents.parts.PoseReporter;
import rsal.data.Pose2d;
import rsal.device.Planner;
import rsal.robot.Robot;

/// What ways cost a robot: tells others who ask, by the robot's planner. Asking moves nothing.
public final class PathCostService {
    /// Of those who can tell.
    public static final ServiceDescription CAPABILITY = ServiceDescription.of("way-costs");

    private final AgentContext self;
    private final PlannedPaths plannedPaths;
    private final PoseReporter reporter;

    private PathCostService(AgentContext self, PlannedPaths plannedPaths, PoseReporter reporter) {
        this.self = self;
        this.plannedPaths = plannedPaths;
        this.reporter = reporter;
    }

    /// The service by which one asks: [Places] → [Costs].
    public static Request<Places, Costs> service(AgentContext self) {
        return new Request<>(self, CAPABILITY.name(), Places.class, Costs.class);
    }

    /// From now on answers all that ask, if the robot has a planner.
    public static void begin(AgentContext self, Robot robot, PoseReporter reporter) {
        Optional<Planner> planner = robot.find(Planner.class);
        planner.ifPresent(_ -> {
            var travel = new PathCostService(self, new PlannedPaths(planner), reporter);
            service(self).answer(travel::answer);
            self.offer(CAPABILITY);
        });
    }

    private void answer(Asked<Places, Costs> asked) {
        Optional<Pose2d> mapFromBase = reporter.mapFromBase();
        if (mapFromBase.isEmpty()) {
            asked.refuse("I don't know where I am.");
            return;
        }
        plannedPaths
                .costs(mapFromBase.get(), asked.what().mapFromPlaces())
                .thenAccept(costs -> self.scheduler().execute(() -> asked.inform(new Costs(costs))));
    }

    /// Where somebody might go, in the map.
    public record Places(List<Pose2d> mapFromPlaces) {
        public Places {
            mapFromPlaces = List.copyOf(mapFromPlaces);
            if (!mapFromPlaces.stream().allMatch(Pose2d::isFinite)) {
                throw new IllegalArgumentException(
                        "Path costs are those to places, not to %s.".formatted(mapFromPlaces));
            }
        }

        @Override
        public String toString() {
            return AgentWords.list(mapFromPlaces, AgentWords::place);
        }
    }

    /// What the ways there cost [m, more where it is narrow], in the order of the places; +∞ where none leads.
    public record Costs(List<Double> costs) {
        public Costs {
            costs = List.copyOf(costs);
        }

        @Override
        public String toString() {
            return AgentWords.list(
                    costs, cost -> cost.isInfinite() ? "no way" : String.format(Locale.ROOT, "%.1f", cost));
        }
    }
}
