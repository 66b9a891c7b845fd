package rsal.engine.communication;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import rsal.agent.ChannelModel;
import rsal.device.Subscription;
import rsal.engine.event.EventLog;
import rsal.engine.metric.MetricsObserver;
import rsal.engine.report.LossReason;
import rsal.fault.Fault;
import rsal.scenario.RunPlan;
import rsal.scenario.fault.PlannedFault;
import rsal.scenario.fault.PlannedFault.OfMessages;
import rsal.scenario.fault.PlannedFault.OfRobot;
import rsal.scenario.fault.PlannedFault.Target;
import rsal.time.Phase;
import rsal.time.Scheduler;

/// Lets things go wrong when the plan says so. Each fault draws from streams of its own, so that none changes when
/// another comes. All calls on the run's thread.
public final class Faults {
    private final RunPlan plan;
    private final Scheduler scheduler;
    private final EventLog eventLog;
    private final MetricsObserver observer;
    private final Breaker breaker;
    private final ChannelFaults channelFaults;
    private final Counter gone = new Counter(); // robots
    private final Map<String, Runnable> ending = new HashMap<>(); // absences, by robots that have no room yet
    private final Set<String> left = new HashSet<>(); // robots that were taken out of the world
    private final Map<String, Set<String>> agentsOf = new HashMap<>(); // by robots
    private final Map<String, List<DelayedFault>> awaited = new HashMap<>(); // by robots that join late

    /// Breaks robots and their devices.
    interface Breaker {
        /// Why that can't be any more, as robots may have gone for good; empty when it can.
        Optional<String> refusal(OfRobot broken);

        /// @return ends it
        public Subscription begin(OfRobot broken, RandomGenerator random);
    }

    public Faults(
            RunPlan plan,
            Scheduler scheduler,
            EventLog eventLog,
            MetricsObserver observer,
            Traffic traffic,
            Breaker breaker) {
        this.plan = plan;
        this.scheduler = scheduler;
        this.eventLog = eventLog;
        this.observer = observer;
        this.breaker = breaker;
        this.channelFaults =
                new ChannelFaults((message, listener) -> traffic.lost(message, listener, LossReason.FAULT));
        plan.agents().forEach(agent -> agent.robot().ifPresent(robot -> mans(robot, agent.name())));
    }

    /// What becomes of messages.
    ChannelModel delivery() {
        return channelFaults;
    }

    /// Whether a robot is gone.
    public boolean isGone(String robot) {
        return gone.contains(robot);
    }

    /// A robot is there again, or for the first time.
    public void appeared(String robot) {
        Optional.ofNullable(ending.remove(robot)).ifPresent(Runnable::run);
    }

    /// A robot is not there yet: its faults begin when it joins, unless they are over by then.
    public void await(String robot) {
        awaited.put(robot, new ArrayList<>());
    }

    /// A robot that was not there yet has its devices now.
    public void joined(String robot) {
        Optional.ofNullable(awaited.remove(robot)).ifPresent(faults -> faults.forEach(DelayedFault::begin));
    }

    /// A robot was taken out of the world: it does not come back.
    public void left(String robot) {
        left.add(robot);
        appeared(robot);
    }

    /// An agent acts for a robot, and is silent while that is gone.
    public void mans(String robot, String agent) {
        agentsOf.computeIfAbsent(robot, _ -> new HashSet<>()).add(agent);
    }

    /// Whether an agent is not heard, as its robot is gone.
    public boolean isSilent(String agent) {
        return channelFaults.isSilent(agent);
    }

    /// Whether all that an agent says to another is lost now.
    public boolean blocks(String sender, String listener) {
        return channelFaults.blocks(sender, listener);
    }

    /// From now on things go wrong; some maybe at once.
    public void begin() {
        for (PlannedFault fault : plan.faults()) {
            var random = new SplittableRandom(fault.seed());
            if (fault.pick().isPresent()) {
                new FaultCourse(fault, fault.targets(), random).plan(fault.at());
            } else {
                for (Target target : fault.targets()) {
                    new FaultCourse(fault, List.of(target), random.split()).plan(fault.at());
                }
            }
        }
    }

    /// A fault from one time to the next.
    private final class FaultCourse {
        private final PlannedFault fault;
        private final List<Target> targets;
        private final SplittableRandom random;

        FaultCourse(PlannedFault fault, List<Target> targets, SplittableRandom random) {
            this.fault = fault;
            this.targets = targets;
            this.random = random;
        }

        /// @param earliest from now
        void plan(Duration earliest) {
            Duration delay =
                    fault.every().map(mean -> earliest.plus(chance(mean))).orElse(earliest);
            if (delay.isZero()) {
                strike();
            } else {
                scheduler.after(delay, Phase.WORLD, this::strike);
            }
        }

        /// Until something that comes at random comes: exponentially distributed.
        private Duration chance(Duration mean) {
            return Duration.ofNanos(Math.round(-StrictMath.log(1 - random.nextDouble()) * mean.toNanos()));
        }

        private void strike() {
            Optional<Duration> length = fault.lasts().map(span -> span.draw(random));
            List<Subscription> begun = struck().stream()
                    .map(target -> Faults.this.begin(target, length, random.split()))
                    .toList();
            length.ifPresent(time -> scheduler.after(time, Phase.WORLD, () -> {
                begun.forEach(Subscription::cancel);
                if (fault.every().isPresent()) {
                    plan(Duration.ZERO);
                }
            }));
        }

        /// Those that have it this time, in the order of all.
        private List<Target> struck() {
            int wanted = fault.pick().orElse(targets.size());
            Set<Integer> chosen = new HashSet<>();
            while (chosen.size() < Math.min(wanted, targets.size())) {
                chosen.add(random.nextInt(targets.size()));
            }
            var struck = new ArrayList<Target>();
            for (int i = 0; i < targets.size(); i++) {
                if (wanted >= targets.size() || chosen.contains(i)) {
                    struck.add(targets.get(i));
                }
            }
            return struck;
        }
    }

    /// A fault whose robot is not there yet.
    private final class DelayedFault implements Subscription {
        private final OfRobot target;
        private final RandomGenerator random;
        private Optional<Subscription> begun = Optional.empty();
        private boolean over;

        DelayedFault(OfRobot target, RandomGenerator random) {
            this.target = target;
            this.random = random;
        }

        /// Nobody reads for how long: it ends when it would have ended with the robot there.
        void begin() {
            if (!over) {
                begun = Optional.of(Faults.this.begin(target, Optional.empty(), random));
            }
        }

        @Override
        public void cancel() {
            over = true;
            awaited.getOrDefault(target.robot(), new ArrayList<>()).remove(this);
            begun.ifPresent(Subscription::cancel);
        }
    }

    private Subscription delayed(OfRobot target, RandomGenerator random) {
        var delayed = new DelayedFault(target, random);
        awaited.computeIfAbsent(target.robot(), _ -> new ArrayList<>()).add(delayed);
        return delayed;
    }

    private Subscription begin(Target target, Optional<Duration> length, RandomGenerator random) {
        if (target instanceof OfRobot late && awaited.containsKey(late.robot())) {
            return delayed(late, random);
        }
        Optional<String> refusal = target instanceof OfRobot broken ? breaker.refusal(broken) : Optional.empty();
        if (refusal.isPresent()) {
            eventLog.event("fault", target.name(), "not %s: %s".formatted(target.words(), refusal.get()));
            return () -> {};
        }
        observer.faultBegan();
        eventLog.event(
                "fault",
                target.name(),
                target.words()
                        + length.map(time -> String.format(Locale.ROOT, " for %.2f s", time.toNanos() / 1e9))
                                .orElse(""));
        Runnable over = () -> eventLog.event("fault", target.name(), "no longer " + target.words());
        if (target instanceof OfRobot lost && lost.fault() instanceof Fault.Gone) {
            return gone(lost, random, over);
        }
        Subscription begun = switch (target) {
            case OfMessages messages -> channelFaults.begin(messages, random);
            case OfRobot broken -> breaker.begin(broken, random);
        };
        return () -> {
            begun.cancel();
            over.run();
        };
    }

    /// It ends when the robot is there again, which may have to wait for room.
    private Subscription gone(OfRobot lost, RandomGenerator random, Runnable over) {
        String robot = lost.robot();
        appeared(robot); // what waited for room ends, as it is gone again
        gone.add(robot);
        Subscription silence = channelFaults.silence(Set.copyOf(agentsOf.getOrDefault(robot, Set.of())));
        Subscription absence = breaker.begin(lost, random);
        observer.gone(gone.names());
        Runnable end = () -> {
            gone.remove(robot);
            silence.cancel();
            observer.gone(gone.names());
            over.run();
        };
        return () -> {
            if (gone.times(robot) == 1 && !left.contains(robot)) {
                ending.put(robot, end);
                absence.cancel();
            } else {
                absence.cancel();
                end.run();
            }
        };
    }
}
