package rsal.agents;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import rsal.agent.AgentContext;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.PlaceFinder;
import rsal.device.Planner;
import rsal.robot.Robot;

/// Finds where to run to: of places spread over the map the one that a robot reaches with the greatest lead over those
/// that are after it, by a way that leads past none of them.
final class Evasion {
    private static final int PLACES = 24;
    private static final double CLEARANCE = 0.4; // m
    private static final double FASTER = 1.5; // hunters than prey
    private static final double FAR = 1000; // m, where no way leads
    private static final double BERTH = 2.0; // m from hunters on its way

    private final AgentContext self;
    private final Planner planner;
    private final Optional<PlaceFinder> finder;
    private List<Pose2d> mapFromRefuges = List.of();
    private boolean looking;

    Evasion(AgentContext self, Robot robot) {
        this.self = self;
        this.planner = robot.require(Planner.class);
        this.finder = robot.find(PlaceFinder.class);
    }

    /// Has places found that it may run to, once.
    void learn(Pose2d mapFromBase) {
        if (looking || finder.isEmpty()) {
            return;
        }
        looking = true;
        finder.get()
                .find(mapFromBase, PLACES, CLEARANCE)
                .thenAccept(result -> self.scheduler().execute(() -> {
                    if (result instanceof PlaceFinder.Result.Found(List<Point2d> places)) {
                        mapFromRefuges = Words.poses(places);
                    }
                }));
    }

    /// @param mapFromHunters where they are
    /// @param told on the agent's lane; empty when there is nowhere to run to
    void flee(Pose2d mapFromBase, Collection<Pose2d> mapFromHunters, Consumer<Optional<Pose2d>> told) {
        List<Refuge> refuges = mapFromRefuges.stream().map(Refuge::new).toList();
        var flight = new Flight(refuges, refuges.size() * (1 + mapFromHunters.size()), told);
        if (refuges.isEmpty()) {
            told.accept(Optional.empty());
        }
        for (Refuge refuge : refuges) {
            plan(mapFromBase, refuge.mapFromPlace, flight, found -> {
                if (keepsClear(found, mapFromHunters)) {
                    refuge.own = found.cost();
                }
            });
            for (Pose2d hunter : mapFromHunters) {
                plan(hunter, refuge.mapFromPlace, flight, found -> {
                    refuge.theirs = Math.min(refuge.theirs, found.cost());
                });
            }
        }
    }

    private void plan(Pose2d mapFromStart, Pose2d mapFromGoal, Flight flight, Consumer<Planner.Result.Found> found) {
        planner.plan(mapFromStart, mapFromGoal)
                .handle((result, _) -> Optional.ofNullable(result))
                .thenAccept(result -> self.scheduler().execute(() -> {
                    if (result.orElse(null) instanceof Planner.Result.Found way) {
                        found.accept(way);
                    }
                    flight.answered();
                }));
    }

    private static boolean keepsClear(Planner.Result.Found way, Collection<Pose2d> mapFromHunters) {
        List<Point2d> points = way.path().points();
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

    /// A place to run to, and what ways there cost [m].
    private static final class Refuge {
        private final Pose2d mapFromPlace;
        private double own = Double.POSITIVE_INFINITY;
        private double theirs = FAR; // the nearest hunter's

        Refuge(Pose2d mapFromPlace) {
            this.mapFromPlace = mapFromPlace;
        }

        double lead() {
            return theirs - FASTER * own;
        }
    }

    /// One choice of a refuge, while it waits for ways.
    private static final class Flight {
        private final List<Refuge> refuges;
        private final Consumer<Optional<Pose2d>> told;
        private int waitsFor;

        Flight(List<Refuge> refuges, int waitsFor, Consumer<Optional<Pose2d>> told) {
            this.refuges = refuges;
            this.waitsFor = waitsFor;
            this.told = told;
        }

        void answered() {
            waitsFor--;
            if (waitsFor == 0) {
                told.accept(refuges.stream()
                        .filter(refuge -> Double.isFinite(refuge.own))
                        .max(Comparator.comparingDouble(Refuge::lead))
                        .map(refuge -> refuge.mapFromPlace));
            }
        }
    }
}
