package rsal.agents.patrol.strategy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Supplier;

/// A patrol of robots that are points on the paths between places: nobody disturbs another, and every message
/// arrives at once. Runs thousands of simulated hours in a second, to compare strategies.
public final class IdealPatrol {
    private static final double SILENCE = 5; // s until the others count a lost robot out
    private static final double WAIT = 1; // s that a robot waits where it is

    private final PatrolGraph graph;
    private final Supplier<PatrolStrategy> strategies;
    private final List<Robot> robots = new ArrayList<>();
    private final double[] visited;
    private final VisitGaps gaps;

    private static final class Robot {
        private final PatrolStrategy strategy;
        private final PatrolView view;
        private final String name;
        private int at;
        private int next;
        private int step; // the next place on the path
        private double arrival; // there
        private boolean waits; // where it is
        private double silent = Double.POSITIVE_INFINITY; // from then on it is not there

        Robot(String name, PatrolStrategy strategy, PatrolView view, int at) {
            this.name = name;
            this.strategy = strategy;
            this.view = view;
            this.at = at;
            this.next = at;
            this.step = at;
        }
    }

    /// A robot that is lost.
    ///
    /// @param robot its number
    /// @param time when [s]
    public record Loss(int robot, double time) {}

    /// @param starts places where the robots begin
    /// @param warmUp time that does not count [s]
    private IdealPatrol(
            PatrolGraph graph, Supplier<PatrolStrategy> strategies, int[] starts, long seed, double warmUp) {
        this.graph = graph;
        this.strategies = strategies;
        this.visited = new double[graph.size()];
        this.gaps = new VisitGaps(graph.size(), warmUp);
        var random = new SplittableRandom(seed);
        for (int start : starts) {
            robots.add(new Robot(
                    "%05d".formatted(robots.size()),
                    this.strategies.get(),
                    new PatrolView(graph, random.split()),
                    start));
        }
    }

    /// One patrol.
    ///
    /// @param strategies makes one for each robot
    /// @param starts places where the robots begin
    /// @param losses robots that are lost meanwhile
    /// @param warmUp time that does not count [s]
    /// @param time when it ends [s]
    /// @return asked for the values at that time
    /// @throws IllegalArgumentException when a place can't be reached from the others
    public static VisitGaps run(
            PatrolGraph graph,
            Supplier<PatrolStrategy> strategies,
            int[] starts,
            List<Loss> losses,
            long seed,
            double warmUp,
            double time) {
        checkConnected(graph);
        var patrol = new IdealPatrol(graph, strategies, starts, seed, warmUp);
        losses.forEach(loss -> patrol.robots.get(loss.robot).silent = loss.time);
        patrol.run(time);
        return patrol.gaps;
    }

    private static void checkConnected(PatrolGraph graph) {
        for (int place = 1; place < graph.size(); place++) {
            if (Double.isInfinite(graph.length(0, place))) {
                throw new IllegalArgumentException(
                        "Place '%d' can't be reached from place '0'. Add an edge that leads there, or leave it out."
                                .formatted(place));
            }
        }
    }

    private void run(double end) {
        while (true) {
            Robot first = null;
            for (Robot robot : robots) {
                boolean goes = robot.arrival < robot.silent;
                first = goes && (first == null || robot.arrival < first.arrival) ? robot : first;
            }
            if (first == null || first.arrival > end) {
                return;
            }
            arrive(first);
        }
    }

    private void arrive(Robot robot) {
        double now = robot.arrival;
        robot.at = robot.step;
        visited[robot.at] = now;
        if (robot.waits) {
            gaps.stay(robot.at, now);
        } else {
            gaps.visit(robot.at, now);
        }
        if (robot.at == robot.next) {
            look(robot, now);
            robot.next = robot.strategy.next(robot.view);
        }
        robot.step = graph.firstStep(robot.at, robot.next);
        robot.waits = robot.next == robot.at;
        double time = robot.waits
                ? WAIT
                : graph.length(robot.at, robot.step) / graph.speed() + (robot.step == robot.next ? graph.stop() : 0);
        robot.arrival = now + Math.max(time, 1e-3);
    }

    /// What the robot knows now: everything.
    private void look(Robot robot, double now) {
        List<Robot> present =
                robots.stream().filter(other -> now < other.silent + SILENCE).toList();
        PatrolView view = robot.view;
        if (view.members() != present.size() || present.get(view.self()) != robot) {
            view.setTeam(
                    present.indexOf(robot),
                    present.stream().map(other -> other.name).toList());
        }
        var lengths = new double[graph.size()];
        Arrays.setAll(lengths, place -> graph.length(robot.at, place));
        view.set(now, lengths);
        for (int place = 0; place < visited.length; place++) {
            view.visit(place, visited[place]);
        }
        for (int member = 0; member < present.size(); member++) {
            Robot other = present.get(member);
            boolean goes = other != robot && other.arrival > now;
            view.report(
                    member,
                    other.at,
                    goes ? other.next : PatrolView.NONE,
                    goes ? arrival(other) : Double.POSITIVE_INFINITY,
                    other.strategy.note());
        }
    }

    private double arrival(Robot robot) {
        double rest = robot.step == robot.next ? 0 : graph.time(robot.step, robot.next);
        return robot.arrival + rest;
    }
}
