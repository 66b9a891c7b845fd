package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentSpec;
import rsal.agent.Message;
import rsal.agent.plain.PlainHostProvider;
import rsal.agent.platform.AgentPlatform;
import rsal.agent.presence.Presence;
import rsal.agent.protocol.ConversationResult;
import rsal.agent.protocol.Request;
import rsal.agent.team.Job;
import rsal.agent.team.Rules;
import rsal.agent.team.Skill;
import rsal.agent.team.TaskRoute;
import rsal.agent.team.Team;
import rsal.agent.team.Work;
import rsal.agent.team.Worker;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.engine.communication.Radio;
import rsal.engine.report.LossReason;
import rsal.scenario.Communication;
import rsal.scenario.fault.Span;
import rsal.settings.Arguments;
import rsal.testkit.DrawnMap;
import rsal.testkit.fake.TestedType;
import rsal.time.LockstepScheduler;

/// Conversations over a limited radio: its range is short behind walls, messages get lost, come late, and wait for
/// their turn or are dropped when one says too much at once.
class RadioTalkTest {
    private static final int SEEDS = 10;

    /// 30 m by 13 m. A wall hides who goes along the north side, for some meters, from the one in the south-west.
    private static final DrawnMap YARD = DrawnMap.grid(1, """
            ##############################
            #............................#
            #.........###................#
            #............................#
            #............................#
            #............................#
            #............................#
            #............................#
            #............................#
            #............................#
            #............................#
            #z...........................#
            ##############################""");
    private static final double NORTH = 11.5; // m
    private static final double HIDDEN = 12; // m, somewhere behind the wall

    private final LockstepScheduler scheduler = new LockstepScheduler();
    private final AgentPlatform platform = new AgentPlatform(
            scheduler, new PlainHostProvider().create(Arguments.defaults(List.of()), scheduler), Optional.empty());
    private final Map<String, Point2d> places = new HashMap<>(); // of robots, which are called like their agents
    private final Map<LossReason, Integer> lost = new EnumMap<>(LossReason.class);

    private void radio(int seed) {
        var limits =
                new Communication(27, 5, 0.15, new Span(Duration.ZERO, Duration.ofMillis(300)), Optional.of(8.0), seed);
        var radio = new Radio(limits, YARD.grid(), agent -> agent, robot -> Optional.ofNullable(places.get(robot)));
        platform.deliverBy((message, listener) -> copies(radio, message, listener));
    }

    private List<Duration> copies(Radio radio, Message<?> message, String listener) {
        List<Duration> copies = radio.copies(message, listener);
        if (copies.isEmpty()) {
            lost.merge(radio.why(), 1, Integer::sum);
        }
        return copies;
    }

    private void start(String name, Point2d mapFromRobot, Agent agent) {
        places.put(name, mapFromRobot);
        var arguments = Arguments.defaults(List.of());
        platform.start(
                new AgentSpec(name, "tested", new TestedType(agent), arguments, Optional.empty(), name.hashCode()));
    }

    private void advance(double seconds) {
        scheduler.advance(Duration.ofMillis(Math.round(1000 * seconds)));
    }

    private record Visit(String name, Point2d place) implements Job {}

    /// Walks 1 m/s along the north side, out of sight of the one in the south-west for some of it.
    private final class Walker implements Skill<Visit> {
        private static final Duration BEAT = Duration.ofMillis(500);
        private static final double STRIDE = 0.5; // m in a beat

        private final AgentContext self;
        private final Consumer<Visit> seen;
        private final Worker worker;

        Walker(AgentContext self, Consumer<Visit> seen) {
            this.self = self;
            this.seen = seen;
            this.worker = new Worker(
                    self,
                    (from, to) -> CompletableFuture.completedFuture(from.distanceTo(to)),
                    () -> Optional.of(pose(here())),
                    _ -> {});
            worker.learn(Visit.class, this);
            worker.begin();
            Presence.begin(self);
            self.scheduler().every(BEAT, this::idle);
        }

        /// Who has nothing to do comes back to where it is heard.
        private void idle() {
            if (worker.job().isEmpty()) {
                walk(3);
            }
        }

        /// @return whether it is there
        private boolean walk(double x) {
            double left = x - here().x();
            places.put(self.name(), new Point2d(here().x() + Math.clamp(left, -STRIDE, STRIDE), here().y()));
            return Math.abs(left) <= STRIDE;
        }

        private Point2d here() {
            return places.get(self.name());
        }

        private static Pose2d pose(Point2d place) {
            return new Pose2d(place.x(), place.y(), 0);
        }

        @Override
        public Optional<TaskRoute> course(Visit job) {
            return Optional.of(TaskRoute.at(pose(job.place)));
        }

        @Override
        public void begin(Visit job, Work work) {
            self.scheduler().after(BEAT, () -> goOn(job, work));
        }

        private void goOn(Visit job, Work work) {
            if (work.isOver()) {
                return;
            }
            if (walk(job.place.x())) {
                seen.accept(job);
                work.done("seen");
            } else {
                begin(job, work);
            }
        }
    }

    /// Of ten jobs beyond the wall, each is done, and known to be done once, although whoever walks there is
    /// not heard on the way.
    @Test
    void aTeamDoesAllOfItsJobs() {
        var all = new EnumMap<LossReason, Integer>(LossReason.class);
        int taken = 0;
        for (int seed = 1; seed <= SEEDS; seed++) {
            var test = new RadioTalkTest();
            taken += test.work(seed);
            test.lost.forEach((why, count) -> all.merge(why, count, Integer::sum));
        }
        assertThat(all)
                .as("what kept messages from being heard")
                .containsOnlyKeys(LossReason.RANGE, LossReason.CHANCE, LossReason.BANDWIDTH);
        assertThat(taken).as("jobs that were given to another").isPositive();
    }

    /// @return how many jobs were allotted more than once
    private int work(int seed) {
        radio(seed);
        var random = new SplittableRandom(seed);
        var seen = new ArrayList<Visit>();
        var reported = new ArrayList<String>();
        var allotted = new ArrayList<String>();
        var teams = new ArrayList<Team>();
        for (String name : List.of("amy", "bob", "eve", "ian")) {
            start(name, new Point2d(1.5 + random.nextDouble(4), NORTH), self -> new Walker(self, seen::add));
        }
        start("zoe", YARD.place('z'), self -> {
            var team = new Team(self, Rules.DEFAULT.withTries(0), event -> {
                switch (event) {
                    case Team.Event.Done _ -> reported.add(event.job().name());
                    case Team.Event.Allotted _ -> allotted.add(event.job().name());
                    default -> {}
                }
            });
            team.begin();
            teams.add(team);
        });
        var jobs = new ArrayList<Visit>();
        for (int i = 0; i < 10; i++) {
            double x = random.nextBoolean() ? 1.5 + random.nextDouble(4) : 18 + random.nextDouble(6);
            var job = new Visit("j" + i, new Point2d(x, NORTH));
            jobs.add(job);
            advance(random.nextDouble(4));
            scheduler.execute(() -> teams.getFirst().add(job));
        }
        advance(600);
        assertThat(teams.getFirst().jobs()).as("seed %d", seed).isEmpty();
        assertThat(reported)
                .as("seed %d", seed)
                .containsExactlyInAnyOrderElementsOf(
                        jobs.stream().map(Visit::name).toList());
        assertThat(seen).as("seed %d", seed).containsAll(jobs);
        return allotted.size() - new HashSet<>(allotted).size();
    }

    @Test
    void eachQuestionIsHeardOnceAndEndsOnce() {
        int informed = 0;
        for (int seed = 1; seed <= SEEDS; seed++) {
            informed += new RadioTalkTest().ask(seed);
        }
        assertThat(informed).isGreaterThan(SEEDS * 30 * 2 / 3);
    }

    /// Thirty questions, some while the one who is asked is hidden.
    ///
    /// @return how many were answered
    private int ask(int seed) {
        radio(seed);
        var random = new SplittableRandom(seed);
        var heard = new ArrayList<Integer>();
        var endings = new HashMap<Integer, List<ConversationResult<Integer>>>();
        start(
                "amy",
                new Point2d(3.5, NORTH),
                self -> doubling(self).answer(asked -> {
                    heard.add(asked.what());
                    asked.inform(2 * asked.what());
                }));
        var asks = new ArrayList<Consumer<Integer>>();
        start("zoe", YARD.place('z'), self -> {
            var request = doubling(self);
            asks.add(question -> {
                endings.put(question, new ArrayList<>());
                request.ask("amy", question, endings.get(question)::add);
            });
        });
        advance(1);
        for (int i = 0; i < 30; i++) {
            int question = i;
            scheduler.execute(() -> asks.getFirst().accept(question));
            places.put("amy", new Point2d(random.nextInt(4) == 0 ? HIDDEN : 3.5, NORTH));
            advance(random.nextDouble(3));
        }
        places.put("amy", new Point2d(3.5, NORTH));
        advance(60);
        assertThat(heard).as("seed %d", seed).doesNotHaveDuplicates();
        endings.forEach((question, ends) -> assertThat(ends)
                .as("seed %d, question %d", seed, question)
                .singleElement()
                .satisfies(end -> {
                    if (end instanceof ConversationResult.Informed<Integer>(Integer answer)) {
                        assertThat(answer).isEqualTo(2 * question);
                        assertThat(heard).contains(question);
                    } else {
                        assertThat(end).isInstanceOf(ConversationResult.Silent.class);
                    }
                }));
        return (int) endings.values().stream()
                .filter(ends -> ends.getFirst() instanceof ConversationResult.Informed)
                .count();
    }

    private static Request<Integer, Integer> doubling(AgentContext self) {
        return new Request<>(self, "double", Integer.class, Integer.class);
    }
}
