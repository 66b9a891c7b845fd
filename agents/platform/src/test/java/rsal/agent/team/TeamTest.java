package rsal.agent.team;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeSet;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.agent.AgentContext;
import rsal.agent.platform.AgentPlatform.Status;
import rsal.agent.platform.Run;
import rsal.agent.presence.Presence;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.settings.Arguments;
import rsal.settings.PluginChoice;

class TeamTest {
    private record Visit(String name, Point2d place) implements Job {
        Pose2d pose() {
            return new Pose2d(place.x(), place.y(), 0);
        }
    }

    private static Visit visit(String name, double x) {
        return new Visit(name, new Point2d(x, 0));
    }

    /// Walks 1 m/s on a line.
    private final class Walker implements Skill<Visit> {
        private final AgentContext self;
        private Pose2d here;
        private final Worker worker;
        private Optional<Pose2d> mapFromEnd = Optional.empty(); // of all jobs; empty where each is done at its place
        private Consumer<Work> atPlace = work -> work.done("seen");

        Walker(AgentContext self, double x) {
            this.self = self;
            this.here = new Pose2d(x, 0, 0);
            this.worker = new Worker(
                    self,
                    (from, to) -> CompletableFuture.completedFuture(from.distanceTo(to)),
                    () -> Optional.of(here),
                    _ -> {});
        }

        @Override
        public Optional<TaskRoute> course(Visit job) {
            return Optional.of(new TaskRoute(job.pose(), mapFromEnd.orElse(job.pose()), 0));
        }

        @Override
        public void begin(Visit job, Work work) {
            log.add(self.name() + " begins " + job.name());
            work.onEnd(() -> log.add(self.name() + " ends " + job.name()));
            long millis = Math.round(1000 * here.distanceTo(job.pose()));
            self.scheduler().after(Duration.ofMillis(millis), () -> {
                if (!work.isOver()) {
                    here = job.pose();
                    atPlace.accept(work);
                }
            });
        }
    }

    private final Run run = new Run();
    private final List<String> log = new ArrayList<>();
    private final List<String> events = new ArrayList<>();
    private final List<String> done = new ArrayList<>();
    private final Map<String, Walker> walkers = new HashMap<>();
    private final Set<String> silenced = new HashSet<>();
    private Team team;

    private void walker(String name, double x) {
        run.start(name, self -> {
            var walker = new Walker(self, x);
            walkers.put(name, walker);
            walker.worker.learn(Visit.class, walker);
            walker.worker.begin();
            Presence.begin(self);
        });
    }

    private void team(Rules rules, Visit... jobs) {
        run.start("zoe", self -> {
            team = new Team(self, rules, event -> {
                events.add(words(self, event));
                if (event instanceof Team.Event.Done) {
                    done.add(event.job().name());
                }
            });
            team.begin();
            List.of(jobs).forEach(team::add);
        });
        run.advance(0);
    }

    private static String words(AgentContext self, Team.Event event) {
        String kind = event.getClass().getSimpleName();
        double time = self.scheduler().instant().toEpochMilli() / 1000.0;
        return "%.1f %s %s %s".formatted(time, kind, event.job().name(), event.member());
    }

    private void silence(String name) {
        silenced.add(name);
        run.deliverBy((message, listener) -> silenced.contains(message.sender()) || silenced.contains(listener)
                ? List.of()
                : List.of(Duration.ZERO));
    }

    @Test
    void eachGetsWhatMakesTheLongestRouteLeast() {
        walker("amy", 0);
        walker("bob", 100);
        team(Rules.DEFAULT, visit("a", 10), visit("b", 20), visit("c", 90), visit("d", 95));
        run.advance(30);
        assertThat(events)
                .containsExactlyInAnyOrder(
                        "0.0 Allotted a amy",
                        "0.0 Allotted d bob",
                        "5.0 Done d bob",
                        "5.0 Allotted c bob",
                        "10.0 Done a amy",
                        "10.0 Done c bob",
                        "10.0 Allotted b amy",
                        "20.0 Done b amy");
        assertThat(team.jobs()).isEmpty();
    }

    @Test
    void whatOneHasToDoYetCounts() {
        walker("amy", 0);
        walker("bob", 100);
        team(Rules.DEFAULT, visit("a", 40));
        run.advance(1);
        team.add(visit("b", 45)); // 44 m for amy, after what she does, and 55 m for bob
        run.advance(60);
        assertThat(events).contains("40.0 Allotted b amy");
    }

    @Test
    void jobThatComesWhileAnotherIsNotAllottedYetIsAllottedRightAfterIt() {
        run.deliverBy((_, _) -> List.of(Duration.ofMillis(400)));
        walker("amy", 0);
        walker("bob", 10);
        team(Rules.DEFAULT);
        run.advance(4);
        team.add(visit("a", 3));
        run.advance(0.5);
        team.add(visit("b", 7));
        run.advance(2);
        assertThat(events).containsExactly("4.8 Allotted a amy", "5.6 Allotted b bob");
    }

    @Test
    void whoIsFreeDoesWhatHasWaitedLongestWhenNothingElseCounts() {
        walker("amy", 0);
        walker("bob", 100);
        team(Rules.DEFAULT.firstCome(), visit("a", 90), visit("b", 95), visit("c", 10));
        run.advance(100);
        assertThat(events)
                .filteredOn(event -> event.contains("Allotted"))
                .containsExactlyInAnyOrder("0.0 Allotted a amy", "0.0 Allotted b bob", "5.0 Allotted c bob");
    }

    @Test
    void ofAllThatEndsAtOnePlaceTheNearestIsDoneFirst() {
        walker("amy", 0);
        run.advance(0);
        walkers.get("amy").mapFromEnd = Optional.of(Pose2d.ORIGIN);
        team(Rules.DEFAULT, visit("a", 30), visit("b", 10), visit("c", 20));
        run.advance(0);
        assertThat(events).containsExactly("0.0 Allotted b amy");
    }

    @Test
    void whatIsTooFarIsLeftToOthers() {
        walker("amy", 0);
        run.advance(0);
        walkers.get("amy").worker.within(() -> 20);
        team(Rules.DEFAULT, visit("a", 30));
        run.advance(10);
        assertThat(events).isEmpty();
        walker("bob", 100);
        run.advance(1);
        assertThat(events).containsExactly("10.0 Allotted a bob");
    }

    @Test
    void oneAtATimeTheMostUrgentThatIsNotMuchFarther() {
        walker("amy", 0);
        team(Rules.DEFAULT.oneAtATime().withObjective(Objective.SUM));
        team.add(visit("near", 10), () -> 0);
        team.add(visit("far", 25), () -> 20);
        team.add(visit("very far", 70), () -> 20);
        run.advance(100);
        assertThat(log)
                .filteredOn(line -> line.contains("begins"))
                .containsExactly("amy begins far", "amy begins near", "amy begins very far");
    }

    @Test
    void jobOfOneThatFallsSilentIsSoonWithAnother() {
        walker("amy", 0);
        walker("bob", 1000);
        team(Rules.DEFAULT, visit("a", 30));
        run.advance(10);
        silence("amy");
        run.advance(5 + 1 + 3); // it may have been heard of up to a second later
        assertThat(walkers.get("bob").worker.job()).contains(visit("a", 30));
        assertThat(events).hasSize(3).element(1).asString().endsWith("Returned a amy");
    }

    @Test
    void jobOfOneThatEndsIsWithAnotherAtOnce() {
        walker("amy", 0);
        walker("bob", 1000);
        team(Rules.DEFAULT, visit("a", 30));
        run.advance(10);
        run.stop("amy");
        run.advance(0.1);
        assertThat(walkers.get("bob").worker.job()).contains(visit("a", 30));
    }

    @Test
    void whoComesLateOrIsBackJoins() {
        team(Rules.DEFAULT, visit("a", 30), visit("b", 40));
        run.advance(20);
        assertThat(events).isEmpty();
        walker("amy", 0);
        run.advance(1);
        assertThat(walkers.get("amy").worker.job()).contains(visit("a", 30));
        silence("amy");
        run.advance(60);
        silenced.clear();
        run.advance(60);
        assertThat(team.jobs()).isEmpty();
    }

    @Test
    void jobThatOneFailsAtIsGivenToAnotherAndGivenUpAtLast() {
        walker("amy", 0);
        walker("bob", 1000);
        run.advance(0);
        walkers.get("amy").atPlace = work -> work.fail("It is dark.");
        walkers.get("bob").atPlace = work -> work.fail("It is dark.");
        team(Rules.DEFAULT.withTries(2), visit("a", 10));
        run.advance(2000);
        assertThat(events)
                .containsExactly(
                        "0.0 Allotted a amy", "10.0 Returned a amy", "10.0 Allotted a bob", "1000.0 GivenUp a bob");
        assertThat(team.has("a")).isFalse();
    }

    @Test
    void oneThatIsNotFitGivesItsJobBackAndTakesNoneUntilItIs() {
        walker("amy", 0);
        team(Rules.DEFAULT, visit("a", 10));
        run.advance(5);
        walkers.get("amy").worker.unfit("charging");
        run.advance(100);
        assertThat(log).containsExactly("amy begins a", "amy ends a");
        assertThat(team.jobs().getFirst().failures()).isZero();
        walkers.get("amy").worker.fit();
        run.advance(16);
        assertThat(team.jobs()).isEmpty();
    }

    @Test
    void whatIsWithdrawnIsStopped() {
        walker("amy", 0);
        team(Rules.DEFAULT, visit("a", 10), visit("b", 20));
        run.advance(5);
        team.withdraw("a");
        team.withdraw("b");
        team.withdraw("c");
        run.advance(100);
        assertThat(log).containsExactly("amy begins a", "amy ends a");
        assertThat(events).containsExactly("0.0 Allotted a amy");
        team.add(visit("a", 20));
        run.advance(100);
        assertThat(events).last().asString().contains("Done a amy");
    }

    @Test
    void twoTeamsShareMembersWithoutDisturbingEachOther() {
        walker("amy", 0);
        team(Rules.DEFAULT, visit("a", 10));
        run.start("yan", self -> {
            var other = new Team(self, Rules.DEFAULT, event -> events.add(words(self, event)));
            other.begin();
            other.add(visit("b", 20));
        });
        run.advance(100);
        assertThat(events).filteredOn(line -> line.contains("Done")).hasSize(2);
        assertThat(log).filteredOn(line -> line.contains("begins")).hasSize(2);
    }

    @Test
    void teamThatIsGivenAJobTwiceIsEndedByName() {
        team(Rules.DEFAULT, visit("a", 10));
        run.scheduler.execute(() -> {});
        run.start("yan", self -> {
            var other = new Team(self, Rules.DEFAULT, _ -> {});
            other.add(visit("a", 1));
            other.add(visit("a", 2));
        });
        run.advance(0);
        assertThat(run.view("yan").status()).isEqualTo(Status.FAILED);
    }

    private static Rules auctioned(AllocationType type) {
        return Rules.DEFAULT.allocated(new PluginChoice(type, Arguments.of(type.parameters(), Map.of())));
    }

    private static Rules rules(String word) {
        return switch (word) {
            case "routes" -> Rules.DEFAULT;
            case "ssi" -> auctioned(new SequentialAuctions());
            case "cbba" -> auctioned(new ConsensusBundles());
            default -> Rules.DEFAULT.oneAtATime();
        };
    }

    @ParameterizedTest
    @ValueSource(strings = {"ssi", "cbba"})
    void membersDivideJobsAmongThemselves(String allocation) {
        walker("amy", 0);
        walker("bob", 100);
        team(rules(allocation), visit("a", 10), visit("b", 20), visit("c", 90), visit("d", 95));
        run.advance(30);
        assertThat(events)
                .filteredOn(event -> event.contains("Done"))
                .containsExactlyInAnyOrder("5.0 Done d bob", "10.0 Done a amy", "10.0 Done c bob", "20.0 Done b amy");
        assertThat(team.jobs()).isEmpty();
    }

    /// One falls silent within an auction: nobody waits for it, and its job goes to another.
    @ParameterizedTest
    @ValueSource(strings = {"ssi", "cbba"})
    void oneThatFallsSilentGivesItsJobToAnother(String allocation) {
        walker("amy", 0);
        walker("bob", 1000);
        team(rules(allocation), visit("a", 30));
        run.advance(10);
        silence("amy");
        team.add(visit("b", 990));
        run.advance(5 + 1 + 3 + 5);
        assertThat(walkers.get("bob").worker.job()).isPresent();
        run.advance(1000);
        assertThat(team.jobs()).isEmpty();
        assertThat(events).anyMatch(event -> event.endsWith("Returned a amy"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"routes", "next", "ssi", "cbba"})
    void whateverHappensEachJobIsDoneOnceWhileSomebodyIsThere(String word) {
        for (int seed = 1; seed <= (Boolean.getBoolean("rsal.test.all") ? 100 : 12); seed++) {
            var test = new TeamTest();
            test.storm(seed, rules(word).withTries(0));
        }
    }

    /// A fifth of all messages is lost, members fail now and then, and all but one end.
    private void storm(int seed, Rules rules) {
        var random = new SplittableRandom(seed);
        run.deliverBy((_, _) -> random.nextInt(5) == 0
                ? List.of()
                : List.of(Duration.ofMillis(random.nextInt(50)), Duration.ofMillis(random.nextInt(300))));
        List<String> names = List.of("amy", "bob", "eve", "ian");
        names.forEach(name -> walker(name, random.nextDouble(100)));
        walkers.values()
                .forEach(walker -> walker.atPlace = work -> {
                    if (random.nextInt(4) == 0) {
                        work.fail("It was dark.");
                    } else {
                        work.done("seen");
                    }
                });
        var jobs = new TreeSet<String>();
        team(rules);
        for (int i = 0; i < 12; i++) {
            jobs.add("j" + i);
            team.add(visit("j" + i, random.nextDouble(100)));
            run.advance(random.nextDouble(10));
            if (i % 4 == 3) {
                run.stop(names.get(i / 4));
            }
        }
        run.advance(2000);
        assertThat(team.jobs()).as("seed %d", seed).isEmpty();
        assertThat(done).as("seed %d", seed).containsExactlyInAnyOrderElementsOf(jobs);
    }
}
