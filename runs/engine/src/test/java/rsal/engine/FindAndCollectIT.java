package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rsal.data.Point2d;
import rsal.device.SimulationControl.Standing;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunResult;
import rsal.scenario.PlannedThings;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;
import rsal.testkit.LongTest;
import rsal.testkit.Trials;

@Timeout(600)
class FindAndCollectIT {
    private static final Scenario SCENARIO = Scenario.load("find-and-collect");
    private static final Scenario ALONE = Scenario.load("foraging");
    private static final Path WRITTEN = Path.of("../scenarios/src/main/resources/rsal/scenarios/find-and-collect");

    /// Somebody tells after 5 s where two cans lie: collectors are awarded one each after 6 s.
    private static final String TWO_CANS = """
            rsal: 1
            scenario: two-cans
            title: Two collectors in AgentSpeak fetch two cans
            world: {map: four-rooms}
            robots:
              collector:
                count: 2
                model: pioneer2dx
                pose: [[-3, 2, 0], [3.5, -2, 90]]
                devices:
                  laser: urg04lx
                  sonar: front8rear8dx
                  camera: blob-camera
                  gripper: pioneer-gripper
                  localizer: {type: amcl}
                  planner: {type: wavefront}
                  navigator: {}
                  pilot: {}
            things:
              can:
                count: 2
                pose: [[1.5, 3.6, 0], [4.6, -3.2, 0]]
                body: {radius: 0.08, height: 0.1}
                color: "#2ca02c"
                obstacle: false
                grippable: true
                depot: {around: collector, radius: 1.2}
            agents:
              collect: {type: collector.asl, robot: collector}
              fetch: {type: fetch.asl}
              told: {type: told.asl}
            mas: {use: jason}
            run:
              stop:
                - {when: allCollected(can), outcome: success, after: 5}
                - {when: time > 400, outcome: timeout}
            metrics:
              - {name: wallCollisions, from: count(wallCollisions)}
              - {name: collisions, from: count(collisions)}
              - {name: gone, from: count(gone(collector))}
            """;
    private static final String TOLD = """
            !tell.
            +!tell
               <- .wait(5000);
                  .send(fetch, achieve, found('#2ca02c', 1.5, 3.6));
                  .send(fetch, achieve, found('#2ca02c', 4.6, -3.2)).
            """;

    @TempDir
    private Path folder;

    /// @param cans where they lie at the end
    private record Collection(RunPlan plan, RunResult result, List<RunEvent> events, List<Standing> cans) {
        double metric(String name) {
            return result.metrics().get(name).getAsDouble();
        }

        /// What agents said that they had collected.
        long said() {
            return events.stream()
                    .filter(event ->
                            event.kind().equals("message") && event.text().matches("collector-\\d+ has brought .*"))
                    .count();
        }
    }

    private static Collection collect(String configuration, long seed) {
        return collect(configuration, seed, Map.of());
    }

    private static Collection collect(String configuration, long seed, Map<String, String> arguments) {
        return collect(SCENARIO, configuration, seed, arguments);
    }

    private static Collection collect(
            Scenario scenario, String configuration, long seed, Map<String, String> arguments) {
        var options = RunOptions.NONE
                .withConfiguration(configuration)
                .withArguments(arguments)
                .withSeed(seed)
                .withSpeed(Double.POSITIVE_INFINITY);
        RunPlan plan = scenario.plan(options);
        try (var run = LiveRun.start(plan)) {
            var result = run.result()
                    .toCompletableFuture()
                    .orTimeout(300, TimeUnit.SECONDS)
                    .join();
            List<Standing> cans = run.snapshot().things().stream()
                    .filter(thing -> thing.name().startsWith("can"))
                    .toList();
            return new Collection(plan, result, run.events(0), cans);
        }
    }

    /// All cans lie in a depot, and there was nothing of them before.
    private static void assertTidy(Collection collection) {
        long seed = collection.result.seed();
        PlannedThings cans = collection.plan.things().getFirst();
        assertThat(collection.result.outcome()).as("seed %d", seed).isEqualTo("success");
        assertThat(collection.cans).as("seed %d", seed).hasSameSizeAs(cans.each());
        for (Standing can : collection.cans) {
            Point2d place = can.mapFromThing().position();
            assertThat(can.height()).as("%s, seed %d", can.name(), seed).isZero();
            assertThat(cans.depot().orElseThrow().holds(place, 0))
                    .as("%s at %s, seed %d", can.name(), place, seed)
                    .isTrue();
        }
        assertThat(collection.metric("wallCollisions")).as("seed %d", seed).isZero();
    }

    @Trials(
            value = {
                "four-rooms, 1",
                "told, 1",
                "near, 1",
                "office, 1",
                "four-rooms, 2",
                "four-rooms, 3",
                "office, 2",
                "office, 3",
                "told, 2"
            },
            landing = 3)
    void everyCanLiesInADepotAtTheEnd(String configuration, long seed) {
        Collection all = collect(configuration, seed);
        assertTidy(all);
        assertThat(all.metric("collisions")).isZero();
        assertThat(all.said()).isEqualTo(all.cans.size());
    }

    @LongTest
    @Trials({"1", "2", "3"})
    void agentsInAgentSpeakCollectAllEachSeedTheSameWay(long seed) {
        Collection all = collect("jason", seed);
        assertTidy(all);
        assertThat(all.metric("collisions")).isZero();
        assertThat(all.result.failed()).isEmpty();
        assertThat(all.said()).isEqualTo(all.cans.size());
        assertThat(all.events)
                .filteredOn(event -> event.subject().equals("fetch"))
                .extracting(RunEvent::text)
                .anyMatch(text -> text.matches("thing \\d+ goes to collect-\\d"));
        assertThat(collect("jason", seed).result.eventHash()).isEqualTo(all.result.eventHash());
    }

    private Collection collectTwo(long seed, String... faults) throws IOException {
        for (String agent : List.of("collector.asl", "fetch.asl")) {
            Files.copy(WRITTEN.resolve(agent), folder.resolve(agent));
        }
        Files.writeString(folder.resolve("told.asl"), TOLD);
        Path file = Files.writeString(
                folder.resolve("scenario.yaml"), TWO_CANS + "faults: [%s]\n".formatted(String.join(", ", faults)));
        Collection all = collect(Scenario.load(file.toString()), "default", seed, Map.of());
        assertTidy(all);
        assertThat(all.metric("collisions")).isZero();
        assertThat(all.result.failed()).isEmpty();
        return all;
    }

    /// What the agent `fetch` has said that it does, of this.
    private static List<String> fetching(Collection all, String pattern) {
        return all.events.stream()
                .filter(event -> Handover.isOfAgent(event) && event.subject().equals("fetch"))
                .map(RunEvent::text)
                .filter(text -> text.matches(pattern))
                .toList();
    }

    @LongTest
    @Trials({"1", "2", "3"})
    void theOtherFetchesWhatOneInAgentSpeakWasAwardedThatStops(long seed) throws IOException {
        Collection all = collectTwo(seed, "{kind: gone, robots: collector-1, at: 9}");
        assertThat(all.metric("gone")).isOne();
        RunEvent gone = all.events.stream()
                .filter(event -> event.text().startsWith("gone"))
                .findFirst()
                .orElseThrow();
        assertThat(Handover.of(all.events, gone, "collect-1").job()).isEqualTo("driving to a thing");
        assertThat(fetching(all, "thing 1 goes to .*|collect-1 .*"))
                .containsExactly("thing 1 goes to collect-1", "collect-1 does not answer", "thing 1 goes to collect-2");
    }

    @LongTest
    @Test
    void anAwardInAgentSpeakThatIsLostIsMadeAgain() throws IOException {
        Collection all = collectTwo(1, "{kind: lost, topics: speech, from: fetch, at: 5.5, for: 1}");
        assertThat(fetching(all, "thing 1 goes to .*")).hasSize(2);
    }

    @Trials({"1", "2", "3", "4", "5"})
    void agentsInAgentSpeakCollectAllWhileTwoOfFiveMessagesAreLost(long seed) throws IOException {
        collectTwo(seed, "{kind: lost, topics: speech, from: [collect, fetch], share: 0.4}");
    }

    @Trials({"1", "2", "3"})
    @LongTest
    void cansThatComeLaterAreCollectedByRobotsThatMindTheirBatteries(long seed) {
        Collection all = collect("advanced", seed);
        assertTidy(all);
        for (int collector = 1; collector <= 4; collector++) {
            double least = all.metric("leastCharge.collector-" + collector);
            assertThat(least).as("collector-%d, seed %d", collector, seed).isGreaterThan(0.05);
        }
        assertThat(all.events)
                .filteredOn(
                        event -> event.kind().equals("agent") && event.text().startsWith("charging"))
                .isNotEmpty();
    }

    @LongTest
    @Trials({"1", "2", "3"})
    void theOthersCollectAllAlsoWhatOneWasOnItsWayToThatStops(long seed) {
        Collection all = collect("faulty", seed);
        assertTidy(all);
        assertThat(all.metric("gone")).isOne();
        RunEvent gone = all.events.stream()
                .filter(event -> event.text().startsWith("gone"))
                .findFirst()
                .orElseThrow();
        String silent = gone.subject().replace("collector", "collect");
        Handover can = Handover.of(all.events, gone, silent);
        assertThat(can.job()).as("seed %d", seed).startsWith("driving to ");
        assertThat(can.taken()).as("%s, seed %d", can.job(), seed).isPresent();
        assertThat(all.events)
                .filteredOn(event -> event.time().minus(gone.time()).compareTo(Handover.MOST) > 0)
                .extracting(RunEvent::text)
                .anyMatch(text -> text.matches("collect-\\d, accept-proposal: .*"))
                .noneMatch(text -> text.startsWith(silent + ", accept-proposal: "));
        assertThat(all.metric("collisions")).isZero();
    }

    @LongTest
    @Trials({"office, 1", "four-rooms, 1", "four-rooms, 2", "four-rooms, 3", "office, 2"})
    void foragersBringAllByThemselvesAndKeepTheirBatteriesCharged(String configuration, long seed) {
        Collection all = collect(ALONE, configuration, seed, Map.of());
        assertTidy(all);
        assertThat(all.metric("collisions")).isZero();
        all.result.metrics().forEach((name, value) -> {
            if (name.startsWith("leastCharge.")) {
                assertThat(value.getAsDouble()).as("%s, seed %d", name, seed).isGreaterThan(0.2);
            }
        });
        if (configuration.equals("office")) { // where it takes long enough
            assertThat(all.events).extracting(RunEvent::text).contains("recharge: stand at a charger");
        }
    }

    @Trials({"1", "2", "3"})
    @LongTest
    void foragersBringAllWhenOneStopsAndOneSeesNothingForAWhile(long seed) {
        Collection all = collect(ALONE, "faulty", seed, Map.of());
        assertTidy(all);
        assertThat(all.metric("collisions")).isZero();
        assertThat(all.metric("gone")).isOne();
    }

    @Trials({"1", "2", "3"})
    @LongTest
    void thoseWhoBidAreDoneAQuarterSoonerThanThoseWhoAreAsked(long seed) {
        Collection bidding = collect("watched", seed);
        Collection asked = collect("watched", seed, Map.of("allocation", "first"));
        assertTidy(bidding);
        assertTidy(asked);
        assertThat(bidding.metric("collectTime")).isLessThan(0.75 * asked.metric("collectTime"));
    }
}
