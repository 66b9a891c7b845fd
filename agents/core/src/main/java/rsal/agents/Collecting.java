package rsal.agents;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.Capability;
import rsal.agent.message.CollectGoal;
import rsal.agent.message.Collected;
import rsal.agent.message.Depot;
import rsal.agent.protocol.ContractNet;
import rsal.agent.protocol.ContractNet.Call;
import rsal.agent.protocol.ContractNet.Contract;
import rsal.agent.protocol.Request;
import rsal.agent.protocol.Request.Asked;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Navigator;
import rsal.device.Planner;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// What a robot with a gripper does for others: it collects things, one after the other, and brings them to its depot.
/// Whoever calls for proposals hears what way it would have to make until the thing lies there, with all that it has
/// to do before; whoever asks gets it at once or not at all.
final class Collecting {
    /// Of those who can.
    static final Capability CAPABILITY = Capability.of("collect");

    static final Parameter DEPOT = Parameter.places(
            "depot",
            "Where it brings things: of several places to the one nearest to a thing. None: where it stood 2 s after"
                    + " its start.");
    static final Parameter QUEUE = Parameter.integer(
            "queue", 20, 0, 100, "", "How many things it takes on at most besides the one that it is after.");
    static final Parameter DEPOT_RADIUS =
            Parameter.number("depotRadius", 1.5, 0.3, 10, "m", "What lies that near to the depot is collected.");

    private static final Duration SETTLING = Duration.ofSeconds(2);
    private static final Duration REPEAT = Duration.ofSeconds(4);
    private static final String TOO_FAR = "No way leads there, or my battery would not last.";
    private static final double HANDLING = 6; // m that it could drive while it aims, grips and releases

    private final AgentContext self;
    private final Robot robot;
    private final Reporter reporter;
    private final Driver driver;
    private final Recharging recharging;
    private final double batteryRange;
    private final PlannedWays ways;
    private final int mostWaiting;
    private final double depotRadius;
    private List<Point2d> depots;
    private final Deque<Job> waiting = new ArrayDeque<>();
    private @Nullable Job current;
    private @Nullable Haul haul;

    private record Job(CollectGoal goal, Point2d mapFromDepot, Consumer<Collected> done, Consumer<String> failed) {}

    Collecting(AgentContext self, Robot robot, Reporter reporter, Arguments arguments) {
        this.self = self;
        this.robot = robot;
        this.reporter = reporter;
        this.driver = new Driver(self, robot.require(Navigator.class));
        this.recharging = new Recharging(
                self,
                robot,
                driver,
                reporter::mapFromBase,
                arguments,
                () -> current == null,
                this::giveBack,
                this::next);
        this.batteryRange = arguments.number(Recharging.RANGE.name());
        this.ways = new PlannedWays(robot.find(Planner.class));
        this.mostWaiting = arguments.integer(QUEUE.name());
        this.depotRadius = arguments.number(DEPOT_RADIUS.name());
        this.depots = arguments.places(DEPOT.name());
    }

    /// The service by which one asks somebody who is free: [CollectGoal] → [Collected].
    static Request<CollectGoal, Collected> requests(AgentContext self) {
        return new Request<>(self, "collect", CollectGoal.class, Collected.class);
    }

    /// The service by which one calls for proposals: [CollectGoal] → [Bid] → [Collected].
    static ContractNet<CollectGoal, Bid, Collected> calls(AgentContext self) {
        return new ContractNet<>(self, "collect-call", CollectGoal.class, Bid.class, Collected.class);
    }

    /// @param cost way until the thing lies in the depot [m, more where it is narrow], grips and releases included
    record Bid(double cost) {
        @Override
        public String toString() {
            return String.format(Locale.ROOT, "%.1f", cost);
        }
    }

    void begin() {
        requests(self).answer(this::asked);
        calls(self).answer(new ContractNet.Contractor<>() {
            @Override
            public void called(Call<CollectGoal, Bid> call) {
                Collecting.this.called(call);
            }

            @Override
            public void accepted(Contract<CollectGoal, Collected> contract) {
                Job job = job(contract.task(), contract::inform, contract::fail);
                contract.whenUnwanted(() -> drop(job));
                take(job);
            }
        });
        recharging.begin();
        self.state("waiting to know where it stands");
        if (depots.isEmpty()) {
            self.scheduler().after(SETTLING, this::standHere);
        } else {
            settle();
        }
        self.scheduler().every(REPEAT, this::tell);
    }

    private void standHere() {
        Optional<Pose2d> mapFromBase = reporter.mapFromBase();
        if (mapFromBase.isEmpty()) {
            self.scheduler().after(SETTLING, this::standHere);
            return;
        }
        depots = List.of(mapFromBase.get().position());
        settle();
    }

    private void settle() {
        self.offer(CAPABILITY);
        self.state("waiting for something to collect");
        tell();
    }

    /// Others may have missed it.
    private void tell() {
        for (int i = 0; i < depots.size(); i++) {
            String name = depots.size() == 1 ? robot.id() : robot.id() + "/" + (i + 1);
            self.publish(Depot.TOPIC, new Depot(name, depots.get(i), depotRadius));
        }
        jobs().forEach(job -> self.publish(CollectGoal.TOPIC, job.goal));
    }

    private void asked(Asked<CollectGoal, Collected> asked) {
        if (depots.isEmpty() || recharging.isNeeded() || current != null) {
            asked.refuse(depots.isEmpty() ? "I don't know my depot yet." : "I have something to do.");
            return;
        }
        cost(asked.what(), cost -> {
            if (current != null || !(cost < recharging.reach(batteryRange))) {
                asked.refuse(current == null ? TOO_FAR : "I have something to do.");
                return;
            }
            asked.agree();
            Job job = job(asked.what(), asked::inform, asked::fail);
            asked.whenUnwanted(() -> drop(job));
            take(job);
        });
    }

    private void called(Call<CollectGoal, Bid> call) {
        if (depots.isEmpty()) {
            call.refuse("I don't know my depot yet.");
        } else if (recharging.isNeeded()) {
            call.refuse("I must charge my battery.");
        } else if (jobs().stream().anyMatch(job -> job.goal.isSame(call.task()))) {
            call.refuse("I am about to collect it already.");
        } else if (current != null && waiting.size() >= mostWaiting) {
            call.refuse("I have enough to do.");
        } else {
            cost(call.task(), cost -> {
                if (cost < recharging.reach(batteryRange)) {
                    call.propose(new Bid(cost));
                } else {
                    call.refuse(TOO_FAR);
                }
            });
        }
    }

    /// What it costs until one thing more lies in its depot; told on the agent's lane.
    private void cost(CollectGoal more, DoubleConsumer told) {
        Optional<Pose2d> mapFromBase = reporter.mapFromBase();
        if (mapFromBase.isEmpty()) {
            told.accept(Double.POSITIVE_INFINITY);
            return;
        }
        double handling = HANDLING * (1 + jobs().size());
        ways.cost(route(mapFromBase.get(), more))
                .thenAccept(way -> self.scheduler().execute(() -> told.accept(way + handling)));
    }

    /// From here through all that it has to do, and at last to one thing more and with it to the depot.
    private List<Pose2d> route(Pose2d mapFromBase, CollectGoal more) {
        var route = new ArrayList<Pose2d>();
        route.add(mapFromBase);
        for (Job job : jobs()) {
            boolean held = job.equals(current) && haul != null && haul.isBringing();
            if (!held) {
                route.add(pose(job.goal.mapFromThing()));
            }
            route.add(pose(job.mapFromDepot));
        }
        route.add(pose(more.mapFromThing()));
        route.add(pose(depotFor(more)));
        return route;
    }

    /// What it has to do, in that order.
    private List<Job> jobs() {
        var jobs = new ArrayList<Job>();
        if (current != null) {
            jobs.add(current);
        }
        jobs.addAll(waiting);
        return jobs;
    }

    private Job job(CollectGoal goal, Consumer<Collected> done, Consumer<String> failed) {
        return new Job(goal, depotFor(goal), done, failed);
    }

    private Point2d depotFor(CollectGoal goal) {
        return depots.stream()
                .min(Comparator.comparingDouble(goal.mapFromThing()::distanceTo))
                .orElseThrow(); // nothing is taken on before there is one
    }

    private void take(Job job) {
        waiting.add(job);
        self.publish(CollectGoal.TOPIC, job.goal);
        next();
    }

    private void drop(Job job) {
        if (job.equals(current)) {
            if (haul != null) {
                haul.drop();
            }
        } else {
            waiting.remove(job);
        }
    }

    private void next() {
        self.show("things waiting", Integer.toString(waiting.size()));
        if (current != null || waiting.isEmpty() || recharging.isNeeded()) {
            return;
        }
        Job job = waiting.remove();
        var begun = new Haul(
                self,
                robot,
                reporter,
                driver,
                job.goal,
                job.mapFromDepot,
                why -> self.scheduler().execute(() -> ended(job, why)));
        current = job;
        haul = begun;
        begun.begin();
    }

    /// What it has taken on, others may do while it charges its battery.
    private void giveBack() {
        List<Job> given = List.copyOf(waiting);
        waiting.clear();
        given.forEach(job -> job.failed.accept("I must charge my battery."));
    }

    private void ended(Job job, Optional<String> why) {
        current = null;
        haul = null;
        if (why.isEmpty()) {
            var collected = new Collected(robot.id(), job.goal, job.mapFromDepot);
            self.publish(Collected.TOPIC, collected);
            job.done.accept(collected);
            self.state("has collected " + job.goal);
        } else {
            job.failed.accept(why.get());
            self.state("has not collected %s: %s".formatted(job.goal, why.get()));
        }
        next();
    }

    private static Pose2d pose(Point2d mapFromPlace) {
        return new Pose2d(mapFromPlace.x(), mapFromPlace.y(), 0);
    }
}
