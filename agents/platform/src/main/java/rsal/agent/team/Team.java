package rsal.agent.team;

import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.DoubleSupplier;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.presence.FailureDetector;
import rsal.agent.protocol.ContractNet;
import rsal.agent.protocol.ContractNet.Proposal;
import rsal.agent.protocol.ContractNet.Round;
import rsal.agent.protocol.ContractNet.Verdict;
import rsal.agent.protocol.ContractNetInitiator;
import rsal.agent.protocol.ConversationResult;
import rsal.agent.protocol.RetryPolicy;

/// The books of a team: jobs that are open and jobs that members do. Calls for bids whenever something has changed,
/// divides what is open, and gives each member that is free its next job; a job whose member fails, falls silent or
/// ends is open again at once. On the agent's lane.
///
/// A job belongs to one member at a time, as far as can be heard: one that has only fallen silent may go on with what
/// another has got meanwhile.
public final class Team {
    private static final int MOST_AT_ONCE = 16; // jobs in one call
    private static final Duration PAUSE = Duration.ofSeconds(5); // until what nobody could do is called again
    private static final double LOYALTY = 0.8; // what a job costs the one that has it, when all is allotted again
    private static final Duration BARRED = Duration.ofSeconds(60); // for one that failed at a job

    private final AgentContext self;
    private final Rules rules;
    private final Consumer<? super Event> onEvent;
    private final ContractNet<Offer, Estimate, String> net;
    private final FailureDetector roll;
    private final Map<String, Entry> entries = new LinkedHashMap<>(); // by job's name
    private @Nullable ContractNetInitiator<Offer, Estimate, String> undecided;
    private boolean due;
    private boolean missed; // a call, while another was undecided
    private boolean anewWanted;
    private int auctions;

    /// @param onEvent told on the agent's lane
    public Team(AgentContext self, Rules rules, Consumer<? super Event> onEvent) {
        this.self = self;
        this.rules = rules;
        this.onEvent = onEvent;
        this.net = Worker.net(self);
        this.roll = new FailureDetector(self, rules.ping(), rules.silence(), _ -> callSoon());
    }

    /// Looks who is there and begins to allot.
    public void begin() {
        roll.begin();
        self.directory().onChange(_ -> callSoon());
        self.scheduler().every(PAUSE, this::callSoon);
        if (rules.reconsider().isPositive()) {
            self.scheduler().every(rules.reconsider(), () -> call(true));
        }
        callSoon();
    }

    /// Gives the team something to do.
    ///
    /// @throws IllegalArgumentException when it has a job of that name already
    public void add(Job job) {
        add(job, () -> 0);
    }

    /// @param urgency so much longer a way is worth it to do this job rather than another [m]; asked at each call.
    /// Counts only where each member gets its next job ([Rules#oneAtATime]).
    public void add(Job job, DoubleSupplier urgency) {
        if (entries.putIfAbsent(job.name(), new Entry(job, urgency)) != null) {
            throw new IllegalArgumentException(
                    "Team of '%s' has a job '%s' already.".formatted(self.name(), job.name()));
        }
        callSoon();
    }

    /// Does not want a job any more; the member that does it stops. Nobody is informed. Does nothing when it has no
    /// job of that name.
    public void withdraw(String name) {
        Entry entry = entries.remove(name);
        if (entry != null && entry.contract != null) {
            entry.release();
            callSoon();
        }
    }

    /// Allots everything again, once, also what is under way: when something has come that can't wait until somebody is
    /// free.
    public void reallot() {
        anewWanted = true;
        callSoon();
    }

    public boolean has(String name) {
        return entries.containsKey(name);
    }

    /// All that is to be done, in the order in which it came.
    public List<View> jobs() {
        return entries.values().stream()
                .map(entry ->
                        new View(entry.job, Optional.ofNullable(entry.contract).map(Contract::member), entry.failures))
                .toList();
    }

    /// Calls after what is running now, once.
    private void callSoon() {
        if (!due) {
            due = true;
            self.scheduler().execute(() -> {
                due = false;
                call(anewWanted);
            });
        }
    }

    /// @param anew whether those under way are allotted again, too
    private void call(boolean anew) {
        if (undecided != null) {
            missed = true;
            return;
        }
        anewWanted &= !anew;
        List<Entry> called = entries.values().stream()
                .filter(entry -> anew || entry.contract == null)
                .sorted(Comparator.comparingDouble((Entry entry) -> -entry.urgency.getAsDouble()))
                .limit(MOST_AT_ONCE)
                .toList();
        List<String> members = roll.present().stream()
                .map(FailureDetector.Member::name)
                .filter(name -> Worker.isOne(self, name))
                .toList();
        boolean nobodyCan = members.isEmpty() || (!anew && busy().containsAll(members));
        if (called.isEmpty() || nobodyCan) {
            return;
        }
        List<Job> jobs = called.stream().map(entry -> entry.job).toList();
        Optional<AuctionTerms> auction = anew || !rules.inRoutes()
                ? Optional.empty()
                : rules.auction()
                        .map(allocation -> new AuctionTerms(
                                self.name(), ++auctions, allocation, members, barred(called, members)));
        var offer = new Offer(jobs, rules.inRoutes() && !anew, anew, auction);
        undecided = net.call(members, offer, rules.replyWithin(), RetryPolicy.DEFAULT, new Manager(called, anew));
    }

    private Map<String, Set<Integer>> barred(List<Entry> called, List<String> members) {
        Instant now = self.scheduler().instant();
        var barred = new HashMap<String, Set<Integer>>();
        for (String member : members) {
            for (int job = 0; job < called.size(); job++) {
                if (called.get(job).isBarred(member, now)) {
                    barred.computeIfAbsent(member, _ -> new HashSet<>()).add(job);
                }
            }
        }
        return barred;
    }

    private Set<String> busy() {
        var busy = new HashSet<String>();
        for (Entry entry : entries.values()) {
            if (entry.contract != null) {
                busy.add(entry.contract.member);
            }
        }
        return busy;
    }

    private void ended(String member, Entry entry, ConversationResult<String> how) {
        if (!entry.isWith(member)) {
            return; // withdrawn, or given to another
        }
        entry.contract = null;
        switch (how) {
            case ConversationResult.Informed<String>(String report) -> {
                entries.remove(entry.job.name(), entry);
                onEvent.accept(new Event.Done(entry.job, member, report));
            }
            case ConversationResult.Failed<String>(String why)
            when why.startsWith(Worker.UNFIT) -> onEvent.accept(new Event.Returned(entry.job, member, why));
            case ConversationResult.Failed<String>(String why) -> failed(member, entry, why);
            case ConversationResult.Refused<String>(String why) -> failed(member, entry, why);
            case ConversationResult.NotUnderstood<String>(String why) -> failed(member, entry, why);
            case ConversationResult.Silent<String>(String why) ->
                onEvent.accept(new Event.Returned(entry.job, member, why));
            case ConversationResult.Cancelled<String> _ ->
                onEvent.accept(new Event.Returned(entry.job, member, "cancelled"));
        }
        callSoon();
    }

    private void failed(String member, Entry entry, String why) {
        entry.failures++;
        entry.barred.put(member, self.scheduler().instant().plus(BARRED));
        if (entry.failures == rules.tries()) {
            entries.remove(entry.job.name(), entry);
            onEvent.accept(new Event.GivenUp(entry.job, member, why));
        } else {
            onEvent.accept(new Event.Returned(entry.job, member, why));
        }
    }

    /// Jobs for those who are free, by the jobs' numbers in the call.
    private SortedMap<String, Integer> allot(List<Entry> open, NavigableMap<String, Estimate> estimates, boolean anew) {
        boolean central = rules.auction().isEmpty();
        return central && rules.inRoutes() && !anew ? firstOfRoutes(estimates) : oneEach(open, estimates);
    }

    private SortedMap<String, Integer> firstOfRoutes(NavigableMap<String, Estimate> estimates) {
        var firstOf = new TreeMap<String, Integer>();
        JobRoutes.divide(estimates, rules.objective()).forEach((member, route) -> {
            Estimate estimate = estimates.get(member);
            if (estimate != null && estimate.free()) {
                firstOf.put(member, JobRoutes.next(estimate, route));
            }
        });
        return firstOf;
    }

    /// By squares where the longest is to be short: long ways then count much more than short ones.
    private SortedMap<String, Integer> oneEach(List<Entry> open, NavigableMap<String, Estimate> estimates) {
        var costs = new TreeMap<String, double[]>();
        double[] urgency =
                open.stream().mapToDouble(entry -> entry.urgency.getAsDouble()).toArray();
        double most = Arrays.stream(urgency).max().orElse(0);
        estimates.forEach((member, estimate) -> {
            if (estimate.free()) {
                var cost = new double[urgency.length];
                for (int job = 0; job < cost.length; job++) {
                    double loyal = open.get(job).isWith(member) ? LOYALTY : 1;
                    double distance = loyal * estimate.first().get(job);
                    double later = most - urgency[job];
                    cost[job] = switch (rules.objective()) {
                        case SUM -> distance + later;
                        case LONGEST -> distance * distance + later * later;
                        case NONE -> Double.isInfinite(distance) ? distance : job;
                    };
                }
                costs.put(member, cost);
            }
        });
        return new TreeMap<>(Assignment.cheapest(costs));
    }

    private final class Manager implements ContractNet.Manager<Offer, Estimate, String> {
        private final List<Entry> called;
        private final boolean anew;
        private final Map<String, Entry> given = new HashMap<>();

        Manager(List<Entry> called, boolean anew) {
            this.called = called;
            this.anew = anew;
        }

        @Override
        public Verdict<Offer> decide(Round<Estimate> round) {
            ContractNetInitiator<Offer, Estimate, String> tender = undecided;
            undecided = null;
            var estimates = new TreeMap<String, Estimate>();
            for (Proposal<Estimate> proposal : round.proposals()) {
                if (proposal.bid().first().size() == called.size()) {
                    estimates.put(proposal.from(), possible(proposal.from(), proposal.bid()));
                }
            }
            var shares = new HashMap<String, Offer>();
            allot(called, estimates, anew).forEach((member, number) -> {
                Entry entry = called.get(number);
                boolean known = entries.get(entry.job.name()) == entry; // not withdrawn meanwhile
                if (!known || tender == null || entry.isWith(member)) {
                    return;
                }
                if (anew) {
                    entry.release();
                    entries.values().stream()
                            .filter(other -> other.isWith(member))
                            .forEach(Entry::release);
                }
                if (entry.contract == null && !busy().contains(member)) {
                    entry.contract = new Contract(member, tender);
                    given.put(member, entry);
                    shares.put(member, new Offer(List.of(entry.job), false, false));
                }
            });
            if (anew || missed) {
                missed = false;
                callSoon(); // for those that lost their member to another job, or came meanwhile
            }
            self.scheduler()
                    .execute(() ->
                            given.forEach((member, entry) -> onEvent.accept(new Event.Allotted(entry.job, member))));
            return new Verdict.Share<>(shares);
        }

        /// Without jobs that this member has failed at lately, and that are not wanted any more.
        private Estimate possible(String member, Estimate estimate) {
            var out = new HashSet<Integer>();
            for (int job = 0; job < called.size(); job++) {
                Entry entry = called.get(job);
                boolean gone = entries.get(entry.job.name()) != entry;
                if (gone || entry.isBarred(member, self.scheduler().instant())) {
                    out.add(job);
                }
            }
            return out.isEmpty() ? estimate : estimate.without(out);
        }

        @Override
        public void ended(Proposal<Estimate> accepted, ConversationResult<String> how) {
            Entry entry = given.get(accepted.from());
            if (entry != null) {
                Team.this.ended(accepted.from(), entry, how);
            }
        }
    }

    /// @param member who does it; empty while it is open
    /// @param failures how often somebody has tried in vain
    public record View(Job job, Optional<String> member, int failures) {}

    /// What becomes of jobs.
    public sealed interface Event {
        Job job();

        String member();

        /// A member begins with it.
        record Allotted(Job job, String member) implements Event {}

        /// @param report the result
        record Done(Job job, String member, String report) implements Event {}

        /// It is open again.
        record Returned(Job job, String member, String why) implements Event {}

        /// It was tried too often and is open no more.
        ///
        /// @param member who tried last
        record GivenUp(Job job, String member, String why) implements Event {}
    }

    private record Contract(String member, ContractNetInitiator<Offer, Estimate, String> tender) {}

    private static final class Entry {
        private final Job job;
        private final DoubleSupplier urgency;
        private final Map<String, Instant> barred = new HashMap<>(); // until when
        private @Nullable Contract contract;
        private int failures;

        Entry(Job job, DoubleSupplier urgency) {
            this.job = job;
            this.urgency = urgency;
        }

        boolean isWith(String member) {
            return contract != null && contract.member.equals(member);
        }

        /// The member that does it stops.
        void release() {
            Contract old = contract;
            contract = null;
            if (old != null) {
                old.tender.cancel(old.member);
            }
        }

        boolean isBarred(String member, Instant now) {
            Instant until = barred.get(member);
            return until != null && now.isBefore(until);
        }
    }
}
