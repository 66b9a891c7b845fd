package rsal.agents.patrol;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agents.driving.NavigationClient;
import rsal.agents.driving.PlannedPaths;
import rsal.agents.parts.AgentWords;
import rsal.agents.patrol.strategy.PatrolGraph;
import rsal.agents.patrol.strategy.PatrolStrategy;
import rsal.agents.patrol.strategy.PatrolStrategyType;
import rsal.agents.patrol.strategy.PatrolView;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;

/// Has a robot patrol while it has nothing else to do, once it has heard a [PatrolOrder]. It decides itself, by
/// what the other robots report: there is no master whose loss would end the patrol. Does not stop at places
/// where it shall not stay, and counts those that it passes.
public final class PatrolMember {
    private static final Duration BEAT = Duration.ofSeconds(1);
    private static final Duration LOOK = Duration.ofMillis(200);
    private static final Duration LISTEN = Duration.ofSeconds(2); // before the first decision
    private static final Tolerance NEAR = Tolerance.position(0.5);
    private static final double PASSED = 0.8; // m, from a place
    private static final double AGAIN = 10; // s until a visit of the same place counts again
    private static final double SPEED = 0.5; // m/s, with turns
    private static final double STOP = 2; // s, for a turn to the next place
    private static final double PATIENCE = 2; // times the expected time of a drive
    private static final double DELAY = 20; // s more
    private static final double FAR = 10; // times the longest path: where none leads

    private final AgentContext self;
    private final String robot;
    private final NavigationClient driver;
    private final Supplier<Optional<Pose2d>> mapFromBase;
    private final PlannedPaths paths;
    private final PatrolTeam team = new PatrolTeam();
    private boolean fit = true;
    private boolean idle = true;
    private @Nullable PatrolOrder order;
    private @Nullable Patrolling patrolling;

    public PatrolMember(
            AgentContext self,
            String robot,
            NavigationClient driver,
            Supplier<Optional<Pose2d>> mapFromBase,
            PlannedPaths paths) {
        this.self = self;
        this.robot = robot;
        this.driver = driver;
        this.mapFromBase = mapFromBase;
        this.paths = paths;
    }

    public void begin() {
        self.subscribe(PatrolOrder.TOPIC, message -> hear(message.content()));
        self.subscribe(
                PatrolReport.TOPIC,
                message -> team.note(
                        message.sender(), message.content(), self.scheduler().instant()));
        self.subscribe(Visited.TOPIC, message -> {
            if (patrolling != null) {
                patrolling.hear(message.content());
            }
        });
    }

    /// Whether the robot can patrol at all; not while it charges, for instance.
    public void fit(boolean isFit) {
        fit = isFit;
        change();
    }

    /// Whether the robot has nothing else to do.
    public void idle(boolean isIdle) {
        idle = isIdle;
        change();
    }

    private boolean isFree() {
        return fit && idle;
    }

    private void change() {
        if (patrolling != null) {
            if (isFree()) {
                patrolling.comeBack();
            } else {
                patrolling.pause();
            }
        }
    }

    private void hear(PatrolOrder heard) {
        if (heard.equals(order) || heard.mapFromPlaces().isEmpty()) {
            return;
        }
        order = heard;
        if (patrolling != null) {
            patrolling.end();
            patrolling = null;
        }
        lengths(heard.mapFromPlaces())
                .thenAccept(lengths -> self.scheduler().execute(() -> {
                    if (heard.equals(order) && patrolling == null) {
                        patrolling = new Patrolling(heard, lengths);
                        patrolling.begin();
                    }
                }));
    }

    /// Of the paths between all places, the same in both directions [m].
    private CompletionStage<double[]> lengths(List<Point2d> mapFromPlaces) {
        List<Pose2d> goals = AgentWords.poses(mapFromPlaces);
        CompletionStage<List<List<Double>>> rows = CompletableFuture.completedStage(List.of());
        for (Pose2d start : goals) {
            rows = rows.thenCompose(before -> paths.costs(start, goals).thenApply(row -> {
                var all = new ArrayList<>(before);
                all.add(row);
                return all;
            }));
        }
        return rows.thenApply(all -> symmetric(all, goals.size()));
    }

    private static double[] symmetric(List<List<Double>> rows, int size) {
        var lengths = new double[size * size];
        double longest = 1;
        for (int from = 0; from < size; from++) {
            for (int to = 0; to < size; to++) {
                double length = (rows.get(from).get(to) + rows.get(to).get(from)) / 2;
                lengths[from * size + to] = from == to ? 0 : length;
                longest = Double.isFinite(length) ? Math.max(longest, length) : longest;
            }
        }
        for (int i = 0; i < lengths.length; i++) {
            lengths[i] = Double.isFinite(lengths[i]) ? lengths[i] : FAR * longest;
        }
        return lengths;
    }

    /// What it does about one order.
    private final class Patrolling {
        private final PatrolOrder places;
        private final List<Pose2d> mapFromPlaces;
        private final PatrolStrategy strategy;
        private final PatrolView view;
        private final double[] own; // when the robot itself was last at each place [s]
        private final double[] known; // when a member was last at each place, as far as is known [s]
        private final Instant began = self.scheduler().instant();
        private int last = PatrolView.NONE;
        private int next = PatrolView.NONE;
        private double arrival; // s, about
        private double giveUpAt; // s, when something must be in the way
        private int decision; // counts, so that what comes late of an older one changes nothing
        private double ready = LISTEN.toSeconds(); // s, before which it does not decide
        private boolean deciding;
        private boolean over;

        Patrolling(PatrolOrder order, double[] lengths) {
            this.places = order;
            this.mapFromPlaces = AgentWords.poses(order.mapFromPlaces());
            this.strategy = order.strategy()
                    .as(PatrolStrategyType.class)
                    .create(order.strategy().arguments());
            double stop = STOP + order.stayTime().toMillis() / 1000.0;
            this.view = new PatrolView(PatrolGraph.ofLengths(lengths, SPEED, stop), self.random());
            this.own = new double[mapFromPlaces.size()];
            Arrays.fill(own, -AGAIN);
            this.known = new double[mapFromPlaces.size()];
        }

        void begin() {
            var beat = self.scheduler().every(BEAT, this::beat);
            var look = self.scheduler().every(LOOK, this::look);
            self.atEnd(() -> {
                beat.cancel();
                look.cancel();
            });
            report();
        }

        void end() {
            pause();
            over = true;
        }

        private double now() {
            return Duration.between(began, self.scheduler().instant()).toMillis() / 1000.0;
        }

        private void beat() {
            if (over) {
                return;
            }
            report();
            if (isFree() && next != PatrolView.NONE && now() > giveUpAt) {
                decision++;
                giveUp(next);
                driver.stop();
            }
            resume();
        }

        private PatrolReport own() {
            return new PatrolReport(
                    robot,
                    isFree(),
                    last,
                    next,
                    Math.max(0, next == PatrolView.NONE ? 0 : arrival - now()),
                    Arrays.stream(strategy.note())
                            .limit(PatrolReport.LONGEST_NOTE)
                            .boxed()
                            .toList());
        }

        private void report() {
            if (last == PatrolView.NONE) {
                mapFromBase.get().ifPresent(here -> last = nearest(here));
            }
            self.publish(PatrolReport.TOPIC, own());
        }

        private int nearest(Pose2d here) {
            int best = 0;
            for (int place = 1; place < mapFromPlaces.size(); place++) {
                boolean nearer = here.distanceTo(mapFromPlaces.get(place)) < here.distanceTo(mapFromPlaces.get(best));
                best = nearer ? place : best;
            }
            return best;
        }

        /// Another one was somewhere.
        void hear(Visited visited) {
            List<Double> idleness = visited.idleness();
            double now = now();
            for (int place = 0; idleness.size() == mapFromPlaces.size() && place < idleness.size(); place++) {
                note(place, now - idleness.get(place));
            }
            int place = places.mapFromPlaces().indexOf(visited.mapFromPlace());
            if (place >= 0) {
                note(place, now);
            }
        }

        /// A member was at a place.
        private void note(int place, double time) {
            known[place] = Math.max(known[place], time);
            view.visit(place, time);
        }

        void pause() {
            decision++;
            deciding = false;
            if (next != PatrolView.NONE) {
                next = PatrolView.NONE;
                driver.stop();
            }
            report();
        }

        /// Decides at the next beat, when those that come back at the same time have reported that, too.
        void comeBack() {
            ready = Math.max(ready, now() + BEAT.toMillis() / 2000.0);
            report();
        }

        private void resume() {
            if (isFree() && !over && next == PatrolView.NONE && !deciding && now() >= ready) {
                mapFromBase.get().ifPresent(this::decide);
            }
        }

        private void decide(Pose2d here) {
            int asked = ++decision;
            deciding = true;
            paths.costs(here, mapFromPlaces)
                    .thenAccept(costs -> self.scheduler().execute(() -> {
                        if (asked == decision && isFree() && !over) {
                            deciding = false;
                            choose(costs.stream()
                                    .mapToDouble(Double::doubleValue)
                                    .toArray());
                        }
                    }));
        }

        private void choose(double[] lengths) {
            double now = now();
            view.set(now, lengths);
            next = PatrolView.NONE;
            team.show(view, self.name(), own(), self.scheduler().instant(), now);
            int chosen = strategy.next(view);
            if (chosen < 0 || chosen >= mapFromPlaces.size()) {
                throw new IllegalStateException("Strategy '%s' chose place %d of %d places from 0."
                        .formatted(places.strategy(), chosen, mapFromPlaces.size()));
            }
            if (chosen == last && lengths[chosen] <= PASSED) {
                driver.stop(); // it waits here
                return;
            }
            next = chosen;
            double length = Double.isFinite(lengths[chosen]) ? lengths[chosen] : 0;
            arrival = now + length / SPEED;
            giveUpAt =
                    now + PATIENCE * length / SPEED + DELAY + places.stayTime().toMillis() / 1000.0;
            int asked = decision;
            self.state("patrolling, to " + AgentWords.place(mapFromPlaces.get(chosen)));
            driver.goTo(mapFromPlaces.get(chosen), NEAR, result -> {
                if (asked == decision && next == chosen) {
                    ended(chosen, result);
                }
            });
            report();
        }

        private void ended(int place, Result result) {
            if (result instanceof Result.Reached) {
                visit(place);
                int asked = decision;
                self.scheduler().after(places.stayTime(), () -> {
                    if (asked == decision) {
                        next = PatrolView.NONE;
                        resume();
                    }
                });
            } else {
                giveUp(place);
            }
        }

        /// It can't get there now: other places first. The others are not told that it was visited.
        private void giveUp(int place) {
            view.visit(place, now());
            next = PatrolView.NONE;
        }

        /// Counts places near the robot.
        private void look() {
            if (over || !isFree()) {
                return;
            }
            Optional<Pose2d> here = mapFromBase.get();
            double now = now();
            for (int place = 0; here.isPresent() && place < own.length; place++) {
                boolean near = here.get().distanceTo(mapFromPlaces.get(place)) <= PASSED;
                if (near && (now - own[place] >= AGAIN || place == next)) {
                    arrive(place);
                }
            }
        }

        private void arrive(int place) {
            boolean stays = places.stayTime().isPositive() && place == next;
            if (stays) {
                return; // when it has stopped there
            }
            visit(place);
            if (place == next) {
                next = PatrolView.NONE; // on to the next one without a stop
                resume();
            }
        }

        private void visit(int place) {
            double now = now();
            last = place;
            own[place] = now;
            note(place, now);
            List<Double> idleness = IntStream.range(0, own.length)
                    .mapToObj(each -> Math.max(0, now - known[each]))
                    .toList();
            self.publish(
                    Visited.TOPIC, new Visited(robot, places.mapFromPlaces().get(place), idleness));
        }
    }
}
