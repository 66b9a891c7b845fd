package rsal.agents.patrol;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Collectors;
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
import rsal.time.Task;

/// Has a robot patrol while it has nothing else to do, once it has heard a [PatrolOrder]. It decides itself, by
/// what the other robots report: there is no master whose loss would end the patrol. Does not stop at places
/// where it shall not stay, and counts those that it passes. Leaves places out that can't be reached from the
/// others. Of different orders it follows the one heard first, for as long as its sender repeats it.
public final class PatrolMember {
    private static final Duration BEAT = Duration.ofSeconds(1);
    private static final Duration LOOK = Duration.ofMillis(200);
    private static final Duration LISTEN = Duration.ofSeconds(2); // before the first decision
    private static final Tolerance NEAR = Tolerance.position(0.5);
    private static final double PASSED = 0.8; // m, from a place
    private static final double AGAIN = 10; // s until a visit of the same place counts again
    private static final double SPEED = 0.5; // m/s, with turns
    private static final double STOP = 2; // s, for a turn to the next place
    private static final double MOVED = 1; // m, less is no progress, as of a robot that turns to and fro
    private static final double STUCK = 30; // s without progress until it gives up
    private static final double DETOUR = 2; // times the path's length, at most
    private static final double DETOUR_MORE = 10; // m
    private static final Duration FORGET = Duration.ofSeconds(16); // after the last order of a sender: three are lost

    private final AgentContext self;
    private final String robot;
    private final NavigationClient driver;
    private final Supplier<Optional<Pose2d>> mapFromBase;
    private final PlannedPaths paths;
    private final PatrolTeam team = new PatrolTeam();
    private boolean fit = true;
    private boolean idle = true;
    private @Nullable PatrolOrder order;
    private String sender = ""; // of the order
    private Instant ordered = Instant.MIN; // when it was last heard
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
        self.subscribe(PatrolOrder.TOPIC, message -> hear(message.sender(), message.content()));
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

    private void hear(String from, PatrolOrder heard) {
        Instant now = self.scheduler().instant();
        if (heard.equals(order)) {
            sender = from;
            ordered = now;
            return;
        }
        boolean isAnother = order != null && !from.equals(sender);
        if (heard.mapFromPlaces().isEmpty()
                || (isAnother && ordered.plus(FORGET).isAfter(now))) {
            return;
        }
        order = heard;
        sender = from;
        ordered = now;
        if (patrolling != null) {
            patrolling.end();
            patrolling = null;
        }
        PathMatrix.of(paths, AgentWords.poses(heard.mapFromPlaces()), self.scheduler())
                .thenAccept(lengths -> self.scheduler().execute(() -> begin(heard, lengths)));
    }

    private void begin(PatrolOrder heard, double[] lengths) {
        if (!heard.equals(order) || patrolling != null) {
            return; // another one was heard meanwhile
        }
        double stop = STOP + heard.stayTime().toMillis() / 1000.0;
        var places = new ReachablePlaces(heard.mapFromPlaces(), PatrolGraph.ofLengths(lengths, SPEED, stop));
        List<Point2d> others = places.mapFromOthers();
        if (!others.isEmpty()) {
            self.print("does not patrol %s: no path leads there from the other places"
                    .formatted(others.stream()
                            .map(AgentWords::pose)
                            .map(AgentWords::place)
                            .collect(Collectors.joining(", "))));
        }
        patrolling = new Patrolling(heard, places);
        patrolling.begin();
    }

    /// What it does about one order.
    private final class Patrolling {
        private final PatrolOrder order;
        private final ReachablePlaces places;
        private final List<Pose2d> mapFromPlaces;
        private final PatrolStrategy strategy;
        private final PatrolView view;
        private final double[] own; // when the robot itself was last at each place [s]
        private final double[] known; // when a member was last at each place [s]; -∞ where nothing is known
        private final List<Task> tasks = new ArrayList<>();
        private final Instant began = self.scheduler().instant();
        private int last = PatrolView.NONE;
        private int next = PatrolView.NONE;
        private double arrival; // s, about
        private @Nullable Drive drive; // to the next place, until it is there
        private int decision; // counts: late answers to an older decision are ignored
        private double ready = LISTEN.toSeconds(); // s, before which it does not decide
        private boolean deciding;
        private boolean over;

        Patrolling(PatrolOrder order, ReachablePlaces places) {
            this.order = order;
            this.places = places;
            this.mapFromPlaces = AgentWords.poses(places.mapFromReachable());
            this.strategy = order.strategy()
                    .as(PatrolStrategyType.class)
                    .create(order.strategy().arguments());
            this.view = new PatrolView(places.graph(), self.random());
            this.own = new double[places.size()];
            Arrays.fill(own, -AGAIN);
            this.known = new double[places.size()];
            Arrays.fill(known, Double.NEGATIVE_INFINITY);
        }

        void begin() {
            tasks.add(self.scheduler().every(BEAT, this::beat));
            tasks.add(self.scheduler().every(LOOK, this::look));
            report();
        }

        void end() {
            pause();
            over = true;
            tasks.forEach(Task::cancel);
        }

        private double now() {
            return Duration.between(began, self.scheduler().instant()).toMillis() / 1000.0;
        }

        private void beat() {
            if (over) {
                return;
            }
            report();
            if (isFree() && next != PatrolView.NONE && drive != null && drive.isHopeless(mapFromBase.get(), now())) {
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
                    places.ordered(last),
                    places.ordered(next),
                    Math.max(0, next == PatrolView.NONE ? 0 : arrival - now()),
                    Arrays.stream(strategy.note())
                            .limit(PatrolReport.LONGEST_NOTE)
                            .boxed()
                            .toList());
        }

        private void report() {
            if (last == PatrolView.NONE && isFree()) {
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
            for (int place = 0; idleness.size() == places.orderSize() && place < places.size(); place++) {
                double idle = idleness.get(places.ordered(place));
                if (idle != Visited.UNKNOWN) {
                    note(place, now - idle);
                }
            }
            int place = places.placeAt(visited.mapFromPlace());
            if (place != PatrolView.NONE) {
                note(place, now);
            }
        }

        /// A member was at a place.
        private void note(int place, double time) {
            known[place] = Math.max(known[place], time);
            view.visit(place, time);
        }

        /// What it does instead may lead it anywhere.
        void pause() {
            decision++;
            deciding = false;
            last = PatrolView.NONE;
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
                            choose(
                                    here,
                                    costs.stream()
                                            .mapToDouble(Double::doubleValue)
                                            .toArray());
                        }
                    }));
        }

        private void choose(Pose2d here, double[] lengths) {
            double now = now();
            view.set(now, lengths);
            next = PatrolView.NONE;
            team.show(view, places, self.name(), own(), self.scheduler().instant(), now);
            int chosen = strategy.next(view);
            if (chosen < 0 || chosen >= mapFromPlaces.size()) {
                throw new IllegalStateException("Strategy '%s' chose place %d of %d places from 0."
                        .formatted(order.strategy(), chosen, mapFromPlaces.size()));
            }
            if (chosen == last && here.distanceTo(mapFromPlaces.get(chosen)) <= PASSED) {
                driver.stop(); // it waits here
                return;
            }
            next = chosen;
            double length = Double.isFinite(lengths[chosen]) ? lengths[chosen] : 0;
            arrival = now + length / SPEED;
            drive = new Drive(here, now, DETOUR * length + DETOUR_MORE);
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
                drive = null;
                visit(place);
                int asked = decision;
                self.scheduler().after(order.stayTime(), () -> {
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
            boolean stays = order.stayTime().isPositive() && place == next;
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
            self.publish(Visited.TOPIC, new Visited(robot, places.mapFromPlace(place), idleness(now)));
        }

        private List<Double> idleness(double now) {
            return IntStream.range(0, places.orderSize())
                    .map(places::place)
                    .mapToObj(each -> each == PatrolView.NONE || Double.isInfinite(known[each])
                            ? Visited.UNKNOWN
                            : Math.max(0, now - known[each]))
                    .toList();
        }
    }

    /// One drive to a place, however slow the robot is.
    private static final class Drive {
        private final double longest; // m
        private Pose2d mapFromLast;
        private double moved; // s, when it was last seen to move
        private double driven; // m

        Drive(Pose2d mapFromStart, double now, double longest) {
            this.mapFromLast = mapFromStart;
            this.moved = now;
            this.longest = longest;
        }

        /// Whether it has stood for long, or has driven around for so long that it can't find the place.
        boolean isHopeless(Optional<Pose2d> mapFromBase, double now) {
            double step = mapFromBase.map(mapFromLast::distanceTo).orElse(0.0);
            if (step >= MOVED) {
                driven += step;
                moved = now;
                mapFromLast = mapFromBase.orElse(mapFromLast);
            }
            return now - moved > STUCK || driven > longest;
        }
    }
}
