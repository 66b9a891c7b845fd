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
import java.util.stream.Stream;
import rsal.agent.AgentContext;
import rsal.agents.driving.PlannedPaths;
import rsal.agents.parts.AgentWords;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.PlaceFinder;
import rsal.device.Planner;
import rsal.robot.Robot;

/// Knows where prey run to: the place that hunters reach last, by a path on which the prey is before them, or stays
/// ahead for the longest time. Prey choose by it, and hunters predict by it what prey choose.
///
/// The rule is that of TrailMax: a prey maximizes the time until hunters that answer as well as they can stop it (C.
/// Moldenhauer and N. R. Sturtevant, "Evaluating strategies for running from the cops", IJCAI 2009). Where we depart
/// from it: it does not search all cells of the map, but a number of places that are spread over it, the shortest path
/// to each, and such a path is checked every [#STRIDE]. Times are measured in meters of the prey's path.
final class Evasion {
    /// Hunters than prey, as these fear.
    private static final double FASTER = 1.5;

    private static final int PLACES = 48;
    private static final int MOST_PATHS = 10; // that are planned and checked for one decision
    private static final double CLEARANCE = 0.4; // m
    private static final int MOST_STEPS = 100; // of a path that are checked
    private static final double STRIDE = 1.0; // m between two places where hunters may be sooner
    private static final double MARGIN = 1.0; // m of the prey's path, by which it has to be sooner
    private static final double BETTER = 1.1; // times as long, before it runs to another place than it runs to now
    private static final double SAME = 0.5; // m
    private static final double FIRST = 1e6; // m; more than any lead
    private static final double MEETING = 1.5; // m between two places where prey may be met
    private static final int MOST_MEETINGS = 12;

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

    /// A path to a place, with where hunters may stop it.
    ///
    /// @param steps one every [#STRIDE], without its start; at most [#MOST_STEPS]
    /// @param stride what the prey's path costs from step to step [m]; more than [#STRIDE] where it is narrow
    private record Candidate(Path2d path, List<Pose2d> steps, double stride) {
        static Candidate of(Planner.Result.Found found) {
            double length = found.path().length();
            double costPerMeter = length == 0 ? 1 : Math.max(1, found.cost() / length);
            return new Candidate(found.path(), along(found.path(), STRIDE, MOST_STEPS), STRIDE * costPerMeter);
        }

        /// When hunters stop the prey on it [m]: at the end, or before the first step at which they are sooner.
        ///
        /// @param theirs when hunters may be at the steps
        double end(double[] theirs) {
            for (int i = 0; i < theirs.length; i++) {
                if (stride * (i + 1) + MARGIN > theirs[i]) {
                    return Math.max(stride * i, theirs[i]);
                }
            }
            return theirs.length == 0 ? 0 : theirs[theirs.length - 1];
        }
    }

    /// @param mapFromPrey where it is
    /// @param mapFromHunters where they are
    /// @param mapFromAim where it runs to now, if it runs
    /// @param reported on the agent's thread: the path that it takes, of one point where it is best to stay;
    /// empty when it knows no path
    void flee(
            Pose2d mapFromPrey,
            Collection<Pose2d> mapFromHunters,
            Optional<Pose2d> mapFromAim,
            Consumer<Optional<Path2d>> reported) {
        List<Pose2d> places =
                Stream.concat(Stream.of(mapFromPrey), mapFromRefuges.stream()).toList();
        costs(
                mapFromPrey,
                places,
                own -> arrivals(mapFromHunters, places, theirs -> {
                    List<Pose2d> best = IntStream.range(1, places.size())
                            .filter(i -> Double.isFinite(own.get(i)))
                            .boxed()
                            .sorted(Comparator.comparingDouble(i -> rank(own.get(i), theirs[i])))
                            .limit(MOST_PATHS)
                            .map(places::get)
                            .toList();
                    plan(mapFromPrey, best, candidates -> {
                        if (candidates.isEmpty()) {
                            reported.accept(Optional.empty());
                        } else {
                            var stays = new Path2d(List.of(mapFromPrey.position()));
                            choose(
                                    stays,
                                    theirs[0],
                                    candidates,
                                    mapFromHunters,
                                    mapFromAim,
                                    path -> reported.accept(Optional.of(path)));
                        }
                    });
                }));
    }

    /// Less for places that are worth a plan before others: those that it reaches first, the latest for hunters before;
    /// then by its lead.
    private static double rank(double own, double theirs) {
        return own + MARGIN <= theirs ? -FIRST - theirs : own - theirs;
    }

    /// The path on which hunters stop it last.
    ///
    /// @param stays its path if no other one is better
    /// @param ifItStays when hunters stop it then [m of its path]
    private void choose(
            Path2d stays,
            double ifItStays,
            List<Candidate> candidates,
            Collection<Pose2d> mapFromHunters,
            Optional<Pose2d> mapFromAim,
            Consumer<Path2d> reported) {
        List<Pose2d> steps =
                candidates.stream().flatMap(each -> each.steps.stream()).toList();
        arrivals(mapFromHunters, steps, theirs -> {
            Path2d best = stays;
            double longest = ifItStays;
            int from = 0;
            for (Candidate candidate : candidates) {
                int until = from + candidate.steps.size();
                double end = candidate.end(Arrays.copyOfRange(theirs, from, until));
                double worth = isAt(mapFromAim, candidate.path) ? BETTER * end : end;
                if (worth > longest) {
                    longest = worth;
                    best = candidate.path;
                }
                from = until;
            }
            reported.accept(best);
        });
    }

    private static boolean isAt(Optional<Pose2d> mapFromAim, Path2d path) {
        return mapFromAim
                .filter(aim -> aim.position().distanceTo(path.points().getLast()) < SAME)
                .isPresent();
    }

    /// When the first hunter may be at places [m of the prey's path]; straight ahead where the planner knows no path
    /// for it.
    private void arrivals(Collection<Pose2d> mapFromHunters, List<Pose2d> places, Consumer<double[]> reported) {
        var first = new double[places.size()];
        Arrays.fill(first, Double.POSITIVE_INFINITY);
        var asked = new Object() {
            private int waitsFor = mapFromHunters.size();
        };
        if (asked.waitsFor == 0 || places.isEmpty()) {
            reported.accept(first);
            return;
        }
        for (Pose2d hunter : mapFromHunters) {
            costs(hunter, places, costs -> {
                Arrays.setAll(first, i -> {
                    double cost = Double.isFinite(costs.get(i)) ? costs.get(i) : hunter.distanceTo(places.get(i));
                    return Math.min(first[i], cost / FASTER);
                });
                asked.waitsFor--;
                if (asked.waitsFor == 0) {
                    reported.accept(first);
                }
            });
        }
    }

    /// Paths from one place to others, as far as there are any, in the places' order.
    private void plan(Pose2d mapFromStart, List<Pose2d> mapFromGoals, Consumer<List<Candidate>> reported) {
        var candidates = new ArrayList<Candidate>();
        Iterator<Pose2d> goals = mapFromGoals.iterator();
        var next = new Object() {
            void plan() {
                if (!goals.hasNext()) {
                    reported.accept(candidates);
                    return;
                }
                planner.plan(mapFromStart, goals.next())
                        .handle((result, _) -> Optional.ofNullable(result))
                        .thenAccept(result -> self.scheduler().execute(() -> {
                            if (result.orElse(null) instanceof Planner.Result.Found found) {
                                candidates.add(Candidate.of(found));
                            }
                            plan();
                        }));
            }
        };
        next.plan();
    }

    /// Where a hunter gets to before a prey that takes a path, as early on it as can be.
    ///
    /// @param reported on the agent's thread; empty when there is no such place
    void intercept(Pose2d mapFromHunter, Path2d path, Consumer<Optional<Pose2d>> reported) {
        List<Pose2d> meetings = along(path, MEETING, MOST_MEETINGS);
        costs(mapFromHunter, meetings, costs -> {
            int first = 0;
            while (first < costs.size() && costs.get(first) > FASTER * MEETING * (first + 1)) {
                first++;
            }
            reported.accept(meetings.stream().skip(first).findFirst());
        });
    }

    /// Places along a path, one every few meters.
    private static List<Pose2d> along(Path2d path, double stride, int most) {
        var meetings = new ArrayList<Pose2d>();
        double before = 0; // m, length of the legs until here
        List<Point2d> points = path.points();
        for (int i = 1; i < points.size(); i++) {
            Point2d from = points.get(i - 1);
            Point2d to = points.get(i);
            double leg = from.distanceTo(to);
            while (meetings.size() < most && stride * (meetings.size() + 1) <= before + leg) {
                double share = (stride * (meetings.size() + 1) - before) / leg;
                meetings.add(
                        new Pose2d(from.x() + share * (to.x() - from.x()), from.y() + share * (to.y() - from.y()), 0));
            }
            before += leg;
        }
        return meetings;
    }

    /// @param reported on the agent's thread: what the paths cost [m]; +∞ where that is not known
    private void costs(Pose2d mapFromStart, List<Pose2d> mapFromGoals, Consumer<List<Double>> reported) {
        plannedPaths
                .costs(mapFromStart, mapFromGoals)
                .thenAccept(costs -> self.scheduler().execute(() -> reported.accept(costs)));
    }
}
