package rsal.agents.driving;

import java.util.List;
import java.util.Optional;
import rsal.agent.AgentContext;
import rsal.agent.ServiceDescription;
import rsal.agent.protocol.Request;
import rsal.agent.protocol.Request.Asked;
import rsal.agents.parts.AgentWords;
import rsal.agents.parts.PoseReporter;
import rsal.data.PlaceObjective;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.PlaceFinder;
import rsal.robot.Robot;

/// Finds places that a robot can get to, for others who ask, by the robot's place finder. Asking moves nothing.
public final class PlaceSearch {
    /// Of those who can.
    static final ServiceDescription CAPABILITY = ServiceDescription.of("places");

    private final AgentContext self;
    private final PlaceFinder finder;
    private final PoseReporter reporter;

    private PlaceSearch(AgentContext self, PlaceFinder finder, PoseReporter reporter) {
        this.self = self;
        this.finder = finder;
        this.reporter = reporter;
    }

    /// The service by which one asks: [Wanted] → [Found].
    static Request<Wanted, Found> service(AgentContext self) {
        return new Request<>(self, CAPABILITY.name(), Wanted.class, Found.class);
    }

    /// From now on answers all that ask, if the robot has a place finder.
    public static void begin(AgentContext self, Robot robot, PoseReporter reporter) {
        Optional<PlaceFinder> finder = robot.find(PlaceFinder.class);
        finder.ifPresent(device -> {
            var search = new PlaceSearch(self, device, reporter);
            service(self).answer(search::answer);
            self.offer(CAPABILITY);
        });
    }

    private void answer(Asked<Wanted, Found> asked) {
        Optional<Pose2d> mapFromBase = reporter.mapFromBase();
        if (mapFromBase.isEmpty()) {
            asked.refuse("I don't know where I am.");
            return;
        }
        asked.agree(); // it may take longer than somebody waits for an answer
        Wanted wanted = asked.what();
        PlaceObjective objective = PlaceObjective.of(wanted.objective()).orElse(PlaceObjective.EVENLY);
        finder.find(mapFromBase.get(), wanted.count(), wanted.clearance(), objective)
                .whenComplete((result, error) -> self.scheduler().execute(() -> {
                    switch (result) {
                        case PlaceFinder.Result.Found(List<Point2d> places) -> asked.inform(new Found(places));
                        case PlaceFinder.Result.None(String why) -> asked.fail(why);
                        case null -> asked.fail("Looking for places failed: %s".formatted(error));
                    }
                }));
    }

    /// @param clearance to all that is not free [m]
    /// @param objective one of [PlaceObjective#keys]
    public record Wanted(int count, double clearance, String objective) {
        /// Evenly distributed places.
        public Wanted(int count, double clearance) {
            this(count, clearance, PlaceObjective.EVENLY.key());
        }

        @Override
        public String toString() {
            String what = "%d with %s of clearance".formatted(count, AgentWords.distance(clearance));
            return objective.equals(PlaceObjective.EVENLY.key()) ? what : what + ", objective " + objective;
        }
    }

    /// As many as were wanted, in the map.
    record Found(List<Point2d> mapFromPlaces) {
        Found {
            mapFromPlaces = List.copyOf(mapFromPlaces);
        }

        @Override
        public String toString() {
            return new PathCostService.Places(AgentWords.poses(mapFromPlaces)).toString();
        }
    }
}
