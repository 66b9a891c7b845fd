package rsal.agents.formation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.stream.Collectors;
import rsal.agent.AgentContext;
import rsal.agent.ServiceDescription;
import rsal.agent.protocol.Request;
import rsal.agent.protocol.Request.Asked;
import rsal.agents.parts.AgentWords;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Planner;
import rsal.robot.Robot;

/// Looks along a way for others who ask, by a robot's planner: where it leads, and where on it a formation has room. A
/// place of the formation is free where a way leads to it from the way's middle that is hardly longer than the straight
/// line. Where there is no room on the way there may be beside it. Asking moves nothing.
final class SurveyService {
    /// Of those who can.
    static final ServiceDescription CAPABILITY = ServiceDescription.of("survey");

    private static final double LONGER = 1.25; // than straight
    private static final double SLACK = 0.5; // m

    private final AgentContext self;
    private final Planner planner;

    private SurveyService(AgentContext self, Planner planner) {
        this.self = self;
        this.planner = planner;
    }

    /// The service by which one asks: [Wanted] → [FormationCorridor].
    static Request<Wanted, FormationCorridor> service(AgentContext self) {
        return new Request<>(self, CAPABILITY.name(), Wanted.class, FormationCorridor.class);
    }

    /// From now on answers all that ask, if the robot has a planner.
    static void begin(AgentContext self, Robot robot) {
        Optional<Planner> planner = robot.find(Planner.class);
        planner.ifPresent(device -> {
            var survey = new SurveyService(self, device);
            service(self).answer(survey::answer);
            self.offer(CAPABILITY);
        });
    }

    private void answer(Asked<Wanted, FormationCorridor> asked) {
        asked.agree(); // it may take longer than somebody waits for an answer
        way(asked.what().mapFromPlaces())
                .thenCompose(points -> lane(points, asked.what()))
                .whenComplete((lane, error) -> self.scheduler().execute(() -> {
                    if (error == null) {
                        asked.inform(lane);
                    } else {
                        Throwable cause = error.getCause() == null ? error : error.getCause();
                        asked.fail(String.valueOf(cause.getMessage()));
                    }
                }));
    }

    /// From each place to the next.
    private CompletionStage<List<Point2d>> way(List<Pose2d> mapFromPlaces) {
        CompletionStage<List<Point2d>> way = CompletableFuture.completedFuture(
                List.of(mapFromPlaces.getFirst().position()));
        for (int i = 1; i < mapFromPlaces.size(); i++) {
            Pose2d from = mapFromPlaces.get(i - 1);
            Pose2d to = mapFromPlaces.get(i);
            way = way.thenCombine(planner.plan(from, to), (before, leg) -> joined(before, leg, from, to));
        }
        return way;
    }

    private static List<Point2d> joined(List<Point2d> before, Planner.Result leg, Pose2d from, Pose2d to) {
        return switch (leg) {
            case Planner.Result.Found found -> {
                var points = new ArrayList<>(before);
                points.addAll(found.path().points());
                yield points;
            }
            case Planner.Result.NoPath(String why) ->
                throw new IllegalStateException(
                        "No way leads from %s to %s: %s".formatted(AgentWords.place(from), AgentWords.place(to), why));
        };
    }

    private CompletionStage<FormationCorridor> lane(List<Point2d> points, Wanted wanted) {
        List<Pose2d> mapFromPath = FormationCorridor.along(points, wanted.reach());
        var hasRoom = new boolean[mapFromPath.size()][1 + 2 * (int) Math.ceil(wanted.aside() / FormationCorridor.STEP)];
        for (boolean[] lanes : hasRoom) {
            Arrays.fill(lanes, true);
        }
        CompletionStage<Void> looked = CompletableFuture.completedFuture(null);
        for (Point2d offset : farthestFirst(wanted.offsets())) {
            looked = looked.thenCompose(_ -> look(mapFromPath, offset, hasRoom));
        }
        return looked.thenApply(_ -> FormationCorridor.of(mapFromPath, hasRoom));
    }

    /// They have room least often, and where one has none the others need not be looked at.
    private static List<Point2d> farthestFirst(List<Point2d> offsets) {
        return offsets.stream()
                .sorted(Comparator.comparingDouble((Point2d place) -> Math.hypot(place.x(), place.y()))
                        .reversed())
                .toList();
    }

    /// Notes where one place of the formation is not free.
    private CompletionStage<Void> look(List<Pose2d> mapFromPath, Point2d offset, boolean[][] hasRoom) {
        var looking = new ArrayList<CompletableFuture<?>>();
        for (int i = 0; i < hasRoom.length; i++) {
            boolean[] lanes = hasRoom[i];
            Pose2d from = mapFromPath.get(i);
            for (int number = 0; number < lanes.length; number++) {
                if (!lanes[number]) {
                    continue;
                }
                int lane = number;
                Point2d slot = from.transform(
                        new Point2d(offset.x(), offset.y() + FormationCorridor.aside(number, lanes.length)));
                looking.add(planner.plan(from, new Pose2d(slot.x(), slot.y(), 0))
                        .thenAccept(
                                way -> lanes[lane] = isFree(way, from.position().distanceTo(slot)))
                        .toCompletableFuture());
            }
        }
        return CompletableFuture.allOf(looking.toArray(CompletableFuture[]::new));
    }

    private static boolean isFree(Planner.Result way, double straight) {
        return switch (way) {
            case Planner.Result.Found found ->
                found.offGoal() == 0 && found.path().length() <= LONGER * straight + SLACK;
            case Planner.Result.NoPath _ -> false;
        };
    }

    /// @param mapFromPlaces at least two, to pass one after the other
    /// @param offsets places in the formation's frame [m]
    /// @param reach how far before and after a place the way counts for where the formation looks [m]
    /// @param aside how far from the way it may go to have room [m]
    record Wanted(List<Pose2d> mapFromPlaces, List<Point2d> offsets, double reach, double aside) {
        Wanted {
            mapFromPlaces = List.copyOf(mapFromPlaces);
            offsets = List.copyOf(offsets);
            if (mapFromPlaces.size() < 2) {
                throw new IllegalArgumentException("A path has at least two places, not %s.".formatted(mapFromPlaces));
            }
        }

        @Override
        public String toString() {
            return "a path for %d by %s"
                    .formatted(
                            offsets.size(),
                            mapFromPlaces.stream().map(AgentWords::place).collect(Collectors.joining(", ")));
        }
    }
}
