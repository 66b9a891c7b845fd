package rsal.agent.team;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.ServiceDescription;
import rsal.agent.protocol.ContractNet;
import rsal.agent.protocol.ContractNet.Call;
import rsal.agent.protocol.ContractNet.Contract;
import rsal.data.Pose2d;

/// A member's side of a team: tells what jobs would cost it, and does one at a time. On the agent's lane. Its agent
/// must be [there][rsal.agent.presence.Presence], or nobody calls it.
public final class Worker {
    /// Begins why a job is given back that another, or the same one later, can do as well as before.
    static final String UNFIT = "Not fit for it now: ";

    private static final String NAME = "work";

    private final AgentContext self;
    private final PathCostEstimator pathCosts;
    private final Supplier<Optional<Pose2d>> mapFromBase;
    private final Consumer<Worker> onChange;
    private final Map<Class<? extends Job>, Skill<?>> skills = new LinkedHashMap<>();
    private final AuctionRoom room;
    private DoubleSupplier reach = () -> Double.POSITIVE_INFINITY;
    private Optional<String> unfit = Optional.empty();
    private @Nullable Assigned current;

    /// @param mapFromBase where the robot believes to be; empty while it does not know
    /// @param onChange told whenever it takes on a job or has ended one
    public Worker(
            AgentContext self,
            PathCostEstimator pathCosts,
            Supplier<Optional<Pose2d>> mapFromBase,
            Consumer<Worker> onChange) {
        this.self = self;
        this.pathCosts = pathCosts;
        this.mapFromBase = mapFromBase;
        this.onChange = onChange;
        this.room = new AuctionRoom(self);
        self.atEnd(this::letGo);
    }

    static ContractNet<Offer, Estimate, String> net(AgentContext self) {
        return new ContractNet<>(self, NAME, Offer.class, Estimate.class, String.class);
    }

    /// Whether an agent has one.
    static boolean isOne(AgentContext self, String agent) {
        return self.directory().capabilities(agent).stream()
                .anyMatch(capability -> capability.name().equals(NAME));
    }

    /// Can do jobs of a kind from now on.
    public <J extends Job> void learn(Class<J> kind, Skill<J> skill) {
        skills.put(kind, skill);
    }

    /// Takes on only what costs no more.
    ///
    /// @param farthest [m]; asked at each call
    public void within(DoubleSupplier farthest) {
        reach = farthest;
    }

    /// From now on bids.
    public void begin() {
        room.begin();
        net(self).answer(new Bidder());
        var details = new LinkedHashMap<String, String>();
        skills.keySet().forEach(kind -> details.put(kind.getSimpleName(), "yes"));
        self.offer(new ServiceDescription(NAME, details));
    }

    /// What it does now; empty when it has no job.
    public Optional<Job> job() {
        return Optional.ofNullable(current).map(assigned -> assigned.job);
    }

    /// Takes no jobs until it is fit again, and gives back the one it has.
    ///
    /// @param why for people (`charging`)
    public void unfit(String why) {
        unfit = Optional.of(why);
        if (current != null) {
            current.fail(UNFIT + why);
        }
    }

    public void fit() {
        unfit = Optional.empty();
    }

    private void letGo() {
        if (current != null) {
            current.end();
        }
    }

    private Optional<TaskRoute> course(Job job) {
        return skill(job).flatMap(skill -> skill.course(job));
    }

    private Optional<Skill<Job>> skill(Job job) {
        @SuppressWarnings("unchecked") // learned for that very class
        var skill = (Skill<Job>) skills.get(job.getClass());
        return Optional.ofNullable(skill);
    }

    private void take(Contract<Offer, String> contract) {
        Job job = contract.task().jobs().getFirst();
        Optional<Skill<Job>> skill = skill(job);
        if (unfit.isPresent() || current != null || skill.isEmpty()) {
            contract.fail(skill.isEmpty() ? "I can't do that." : UNFIT + unfit.orElse("I am doing something else."));
            return;
        }
        var assigned = new Assigned(job, contract);
        current = assigned;
        contract.whenUnwanted(assigned::end);
        self.show("job", job.name());
        onChange.accept(this);
        skill.get().begin(job, assigned);
    }

    /// Answers calls, as soon as it knows all the ways.
    private final class Bidder implements ContractNet.Contractor<Offer, Estimate, String> {
        @Override
        public void called(Call<Offer, Estimate> call) {
            Optional<Pose2d> here = mapFromBase.get();
            if (unfit.isPresent() || here.isEmpty()) {
                refuse(call, unfit.orElse("I don't know where I am."));
                return;
            }
            List<Job> jobs = call.task().jobs();
            List<Optional<TaskRoute>> courses =
                    jobs.stream().map(Worker.this::course).toList();
            if (courses.stream().allMatch(Optional::isEmpty)) {
                refuse(call, "I can't do that.");
                return;
            }
            new Costing(courses, call).begin(here.get());
        }

        private void refuse(Call<Offer, Estimate> call, String why) {
            call.task().auction().ifPresent(room::decline);
            call.refuse(why);
        }

        @Override
        public void accepted(Contract<Offer, String> contract) {
            take(contract);
        }
    }

    /// Finds out what the jobs of a call cost, and bids.
    private final class Costing {
        private final List<Optional<TaskRoute>> courses;
        private final Call<Offer, Estimate> call;
        private final boolean free;
        private final Map<Query, CompletableFuture<Double>> known = new HashMap<>(); // many jobs end at one depot

        Costing(List<Optional<TaskRoute>> courses, Call<Offer, Estimate> call) {
            this.courses = courses;
            this.call = call;
            this.free = current == null || call.task().anew();
        }

        void begin(Pose2d here) {
            Optional<TaskRoute> left = free ? Optional.empty() : job().flatMap(Worker.this::course);
            Pose2d mapFromStart = left.map(TaskRoute::mapFromEnd).orElse(here);
            var before = left.map(course -> cost(here, course)).orElseGet(() -> CompletableFuture.completedFuture(0.0));
            var own = new ArrayList<CompletableFuture<Double>>();
            var pathCosts = new ArrayList<CompletableFuture<Double>>();
            for (Optional<TaskRoute> to : courses) {
                own.add(to.map(course -> pathCost(course.mapFromBegin(), course.mapFromEnd())
                                .thenApply(way -> way + course.work()))
                        .orElseGet(Costing::never));
                pathCosts.add(to.map(course -> pathCost(mapFromStart, course.mapFromBegin()))
                        .orElseGet(Costing::never));
            }
            if (call.task().inRoutes()) {
                for (Optional<TaskRoute> from : courses) {
                    for (Optional<TaskRoute> to : courses) {
                        pathCosts.add(
                                from.isEmpty() || to.isEmpty()
                                        ? never()
                                        : pathCost(
                                                from.get().mapFromEnd(),
                                                to.get().mapFromBegin()));
                    }
                }
            }
            var all = new ArrayList<>(pathCosts);
            all.addAll(own);
            all.add(before);
            CompletionStage<?> reported = CompletableFuture.allOf(all.toArray(CompletableFuture[]::new));
            reported.thenRun(() -> self.scheduler().execute(() -> bid(before.join(), values(own), values(pathCosts))));
        }

        private CompletableFuture<Double> cost(Pose2d here, TaskRoute left) {
            return pathCost(here, left.mapFromBegin())
                    .thenCombine(pathCost(left.mapFromBegin(), left.mapFromEnd()), (to, on) -> to + on + left.work());
        }

        private CompletableFuture<Double> pathCost(Pose2d from, Pose2d to) {
            return from.equals(to)
                    ? CompletableFuture.completedFuture(0.0)
                    : known.computeIfAbsent(
                            new Query(from, to),
                            way -> pathCosts
                                    .cost(way.mapFromStart, way.mapFromGoal)
                                    .exceptionally(_ -> Double.POSITIVE_INFINITY)
                                    .toCompletableFuture());
        }

        private static CompletableFuture<Double> never() {
            return CompletableFuture.completedFuture(Double.POSITIVE_INFINITY);
        }

        private static List<Double> values(List<CompletableFuture<Double>> futures) {
            return futures.stream().map(CompletableFuture::join).toList();
        }

        /// @param pathCosts to each job, then from each job to each
        private void bid(double before, List<Double> own, List<Double> pathCosts) {
            int jobs = own.size();
            double farthest = reach.getAsDouble();
            var rows = new ArrayList<List<Double>>();
            for (int row = 0; row < pathCosts.size() / jobs; row++) {
                var costs = new ArrayList<Double>();
                for (int job = 0; job < jobs; job++) {
                    double cost = (row == 0 ? before : 0) + pathCosts.get(row * jobs + job) + own.get(job);
                    costs.add(cost <= farthest ? cost : Double.POSITIVE_INFINITY);
                }
                rows.add(costs);
            }
            var estimate =
                    new Estimate(free, rows.getFirst(), Collections.unmodifiableList(rows.subList(1, rows.size())));
            call.task().auction().ifPresentOrElse(terms -> auction(terms, estimate), () -> call.propose(estimate));
        }

        private void auction(AuctionTerms terms, Estimate estimate) {
            room.enter(
                    terms,
                    estimate,
                    call.replyBy(),
                    result -> result.ifPresentOrElse(call::propose, () -> call.refuse("Others do it.")));
        }
    }

    private record Query(Pose2d mapFromStart, Pose2d mapFromGoal) {}

    /// The job it does.
    private final class Assigned implements Work {
        private final Job job;
        private final Contract<Offer, String> contract;
        private Runnable lettingGo = () -> {};
        private boolean over;

        Assigned(Job job, Contract<Offer, String> contract) {
            this.job = job;
            this.contract = contract;
        }

        @Override
        public void done(String report) {
            if (!over) {
                contract.inform(report);
                end();
            }
        }

        @Override
        public void fail(String why) {
            if (!over) {
                contract.fail(why);
                end();
            }
        }

        @Override
        public void onEnd(Runnable afterwards) {
            lettingGo = afterwards;
            if (over) {
                afterwards.run();
            }
        }

        @Override
        public boolean isOver() {
            return over;
        }

        private void end() {
            if (!over) {
                over = true;
                current = null;
                self.show("job", "none");
                lettingGo.run();
                onChange.accept(Worker.this);
            }
        }
    }
}
