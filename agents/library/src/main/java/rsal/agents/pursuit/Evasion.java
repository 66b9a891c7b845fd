package rsal.agents.pursuit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import rsal.agent.AgentContext;
import rsal.agents.driving.PlannedPaths;
import rsal.agents.parts.AgentWords;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.PlaceFinder;
import rsal.device.Planner;
import rsal.robot.Robot;

/// Knows where prey run to: of places spread over the map the one that a prey reaches with the greatest lead over those
/// that are after it, by a way that leads past none of them. For prey that choose, and for hunters that guess.
final class Evasion {
    /// Hunters than prey, as these fear.
    private static final double FASTER = 1.5;

    private static final int PLACES = 24;
    private static final double CLEARANCE = 0.4; // m
    private static final double FAR = 1000; // m, where no way leads
    private static final double STRIDE = 1.5; // m between two places where prey may be met
    private static final int MOST_MEETINGS = 12;
    private static final double BERTH = 2.0; // m from hunters on its way

    private final AgentContext self;
    private final Planner planner;
    private final PlannedPaths plannedPaths;
    private final Optional<PlaceFinder> finder;
    private List<Pose2d> mapFromRefuges = List.of();
    private boolean looking;

    Evasion(AgentContext self, Robot robot) {
        this.self = self;
        this.planner = robot.require(Planner.class);
        this.plannedPaths = new PlannedPaths(Optional.of(planner), Double.POSITIVE_INFINITY);
        this.finder = robot.find(PlaceFinder.class);
    }

    /// Has places found that a prey may run to, once.
    void learn(Pose2d mapFromBase) {
        if (looking || finder.isEmpty()) {
            return;
        }
        looking = true;
        finder.get()
                .find(mapFromBase, PLACES, CLEARANCE)
                .thenAccept(result -> self.scheduler().execute(() -> {
                    if (result instanceof PlaceFinder.Result.Found(List<Point2d> places)) {
                        mapFromRefuges = AgentWords.poses(places);
                    }
                }));
    }

    /// @param mapFromPrey where it is
    /// @param mapFromHunters where they are
    /// @param reported on the agent's lane: the way that it takes; empty when there is nowhere to run to
    void flee(Pose2d mapFromPrey, Collection<Pose2d> mapFromHunters, Consumer<Optional<Path2d>> reported) {
        var own = new double[mapFromRefuges.size()];
        var theirs = new double[own.length]; // the nearest hunter's
        Arrays.fill(theirs, FAR);
        List<Pose2d> refuges = mapFromRefuges;
        var asked = new Object() {
            private int waitsFor = 1 + mapFromHunters.size();

            void answered() {
                waitsFor--;
                if (waitsFor == 0) {
                    Iterator<Pose2d> byLead = IntStream.range(0, own.length)
                            .filter(i -> Double.isFinite(own[i]))
                            .boxed()
                            .sorted(Comparator.comparingDouble(i -> FASTER * own[i] - theirs[i]))
                            .map(refuges::get)
                            .iterator();
                    choose(mapFromPrey, mapFromHunters, byLead, reported);
                }
            }
        };
        costs(mapFromPrey, refuges, costs -> {
            Arrays.setAll(own, costs::get);
            asked.answered();
        });
        for (Pose2d hunter : mapFromHunters) {
            costs(hunter, refuges, costs -> {
                Arrays.setAll(theirs, i -> Math.min(theirs[i], costs.get(i)));
                asked.answered();
            });
        }
    }

    /// The first refuge to which a way leads that keeps clear of hunters.
    private void choose(
            Pose2d mapFromPrey,
            Collection<Pose2d> mapFromHunters,
            Iterator<Pose2d> refuges,
            Consumer<Optional<Path2d>> reported) {
        if (!refuges.hasNext()) {
            reported.accept(Optional.empty());
            return;
        }
        planner.plan(mapFromPrey, refuges.next())
                .handle((result, _) -> Optional.ofNullable(result))
                .thenAccept(result -> self.scheduler().execute(() -> {
                    if (result.orElse(null) instanceof Planner.Result.Found found
                            && keepsClear(found.path(), mapFromHunters)) {
                        reported.accept(Optional.of(found.path()));
                    } else {
                        choose(mapFromPrey, mapFromHunters, refuges, reported);
                    }
                }));
    }

    /// Where a hunter gets to before a prey that takes a way, as early on it as can be.
    ///
    /// @param reported on the agent's lane; empty when there is no such place
    void intercept(Pose2d mapFromHunter, Path2d way, Consumer<Optional<Pose2d>> reported) {
        List<Pose2d> meetings = meetings(way);
        costs(mapFromHunter, meetings, costs -> {
            int first = 0;
            while (first < costs.size() && costs.get(first) > FASTER * STRIDE * (first + 1)) {
                first++;
            }
            reported.accept(meetings.stream().skip(first).findFirst());
        });
    }

    /// Places along a way, one every [#STRIDE].
    private static List<Pose2d> meetings(Path2d way) {
        var meetings = new ArrayList<Pose2d>();
        double before = 0; // m, length of the legs until here
        List<Point2d> points = way.points();
        for (int i = 1; i < points.size(); i++) {
            Point2d from = points.get(i - 1);
            Point2d to = points.get(i);
            double leg = from.distanceTo(to);
            while (meetings.size() < MOST_MEETINGS && STRIDE * (meetings.size() + 1) <= before + leg) {
                double share = (STRIDE * (meetings.size() + 1) - before) / leg;
                meetings.add(
                        new Pose2d(from.x() + share * (to.x() - from.x()), from.y() + share * (to.y() - from.y()), 0));
            }
            before += leg;
        }
        return meetings;
    }

    /// @param reported on the agent's lane: what the ways cost [m]; +∞ where that is not known
    private void costs(Pose2d mapFromStart, List<Pose2d> mapFromGoals, Consumer<List<Double>> reported) {
        plannedPaths
                .costs(mapFromStart, mapFromGoals)
                .thenAccept(costs -> self.scheduler().execute(() -> reported.accept(costs)));
    }

    private static boolean keepsClear(Path2d way, Collection<Pose2d> mapFromHunters) {
        List<Point2d> points = way.points();
        for (int i = 1; i < points.size(); i++) {
            for (Pose2d hunter : mapFromHunters) {
                if (distance(hunter, points.get(i - 1), points.get(i)) < BERTH) {
                    return false;
                }
            }
        }
        return true;
    }

    /// From a leg of a way [m].
    private static double distance(Pose2d mapFromHunter, Point2d from, Point2d to) {
        double dx = to.x() - from.x();
        double dy = to.y() - from.y();
        double square = dx * dx + dy * dy;
        double along = (mapFromHunter.x() - from.x()) * dx + (mapFromHunter.y() - from.y()) * dy;
        double share = square == 0 ? 0 : Math.clamp(along / square, 0.0, 1.0);
        return mapFromHunter.position().distanceTo(new Point2d(from.x() + share * dx, from.y() + share * dy));
    }
}
