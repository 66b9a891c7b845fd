package rsal.server;

import static org.assertj.core.api.Assertions.assertThat;
import static rsal.server.Errand.TOKEN;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.function.Predicate;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.Timeout.ThreadMode;
import org.junit.jupiter.api.io.TempDir;
import rsal.agent.AgentType;
import rsal.engine.LiveRun;
import rsal.engine.RunOperator;
import rsal.engine.report.Answer;
import rsal.engine.report.Snapshot;
import rsal.scenario.RunOptions;
import rsal.server.RawHttp.Response;
import rsal.testkit.LongTest;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.ObjectMapper;

/// What the page is told of what agents say, hear, believe and want.
@Timeout(value = 120, threadMode = ThreadMode.SEPARATE_THREAD) // who spins is not interrupted
class CommunicationApiTest {
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    private Path directory;

    private static final double STEP = 0.1; // [s]

    private RunServer server;
    private int port;
    private String host;

    @BeforeEach
    void start() throws Exception {
        server = Errand.serve("talk.yaml", directory, 0);
        server.run().pause();
        port = server.url().getPort();
        host = "Host: 127.0.0.1:" + port;
    }

    @AfterEach
    void stop() {
        server.close();
    }

    private JsonNode get(String path) throws Exception {
        Response response = RawHttp.get(port, path, host);
        assertThat(response.status()).as(response.body()).isEqualTo(200);
        return JSON.readTree(response.body());
    }

    /// Lets the run come so far, step by step, and stand still there.
    private void advanceTo(double seconds) {
        Snapshot before = reached(Snapshot::paused);
        double left = seconds - before.time().toMillis() / 1000.0;
        for (int i = 0; i < left / STEP - 1e-6; i++) { // not one more, by rounding
            server.run().step();
        }
        reached(now -> now.time().toMillis() >= 1000 * seconds);
    }

    private Snapshot reached(Predicate<Snapshot> wanted) {
        return server.run().when(wanted).toCompletableFuture().join();
    }

    private static List<JsonNode> each(JsonNode list) {
        return StreamSupport.stream(list.spliterator(), false).toList();
    }

    @Test
    void whatIsSaidAllTheTimeIsThereForThoseWhoAsk() throws Exception {
        advanceTo(3);
        assertThat(server.run().events(0))
                .noneMatch(event ->
                        event.said().filter(said -> said.topic().equals("pose")).isPresent());
        JsonNode topics = get("/api/routine");
        assertThat(topics.get("topics").toString()).contains("\"pose\"");
        assertThat(topics.get("said")).isEmpty();
        JsonNode poses = get("/api/routine?topic=pose").get("said");
        assertThat(poses)
                .isNotEmpty()
                .allMatch(one -> one.get("text").asString().contains(" is at ("));
        assertThat(poses.get(0).get("time").asDouble())
                .isLessThan(poses.get(poses.size() - 1).get("time").asDouble());
        assertThat(get("/api/routine?topic=none").get("said")).isEmpty();
    }

    @Test
    void tellsWhoHeardWhatAndWhyNotWithoutAToken() throws Exception {
        advanceTo(5);
        JsonNode topics = get("/api/topics").get("topics");
        assertThat(each(topics))
                .extracting(topic -> topic.get("topic").asString())
                .contains("go", "hello", "pose")
                .isSorted();
        JsonNode pose = StreamSupport.stream(topics.spliterator(), false)
                .filter(topic -> topic.get("topic").asString().equals("pose"))
                .findFirst()
                .orElseThrow();
        JsonNode all = get("/api/communication").get("communication");
        assertThat(pose.get("said").asLong()).isPositive();
        assertThat(pose.get("outOfRange").asLong()).isZero();
        assertThat(pose.get("heard").asLong()).isPositive().isEqualTo(sum(all, "heard"));
        assertThat(pose.get("byChance").asLong()).isPositive().isEqualTo(sum(all, "lost"));
    }

    private static long sum(JsonNode all, String what) {
        return StreamSupport.stream(all.spliterator(), false)
                .filter(one -> one.get("topic").asString().equals("pose"))
                .mapToLong(one -> one.get(what).asLong())
                .sum();
    }

    @Test
    void tellsAllTypesOfAgentsWithWhatCanBeTyped() throws Exception {
        List<JsonNode> types = each(get("/api/agents/types").get("types"));
        assertThat(types)
                .extracting(type -> type.get("type").asString())
                .containsAll(
                        RunOperator.agentTypes().stream().map(AgentType::key).toList());
        JsonNode nav = types.stream()
                .filter(type -> type.get("type").asString().equals("nav"))
                .findFirst()
                .orElseThrow();
        assertThat(nav.get("needsRobot").asBoolean()).isTrue();
        assertThat(each(nav.get("arguments")))
                .allMatch(argument -> !argument.get("description").asString().isEmpty());
    }

    @Test
    void tellsWhichRobotsHearEachOther() throws Exception {
        advanceTo(5);
        JsonNode reported = get("/api/links?robot=nobody");
        assertThat(reported.get("ofChosen").asBoolean()).isFalse();
        assertThat(each(reported.get("links")))
                .extracting(link ->
                        link.get("one").asString() + " " + link.get("other").asString())
                .containsExactlyInAnyOrder("courier-1 courier-2", "courier-1 prey", "courier-2 prey");
        assertThat(each(reported.get("links")))
                .allMatch(link ->
                        link.get("there").asBoolean() && link.get("back").asBoolean());
    }

    @Test
    void tellsWhatAnAgentTalksAboutInOrder() throws Exception {
        advanceTo(10);
        JsonNode spread = get("/api/agent?name=spread");
        assertThat(spread.get("agent").asString()).isEqualTo("spread");
        assertThat(spread.get("mind").isNull()).isTrue();
        assertThat(each(spread.get("talks")))
                .isNotEmpty()
                .hasSizeLessThanOrEqualTo(100)
                .isSortedAccordingTo((one, next) -> Double.compare(
                        one.get("time").asDouble(), next.get("time").asDouble()))
                .allSatisfy(said -> assertThat(
                                said.get("from").asString() + said.get("to").asString())
                        .contains("spread"))
                .anySatisfy(said -> {
                    assertThat(said.get("protocol").asString()).isEqualTo("fipa-request");
                    assertThat(said.get("act").asString()).isEqualTo("request");
                    assertThat(said.get("to").asString()).startsWith("nav-");
                    assertThat(said.get("words").asString()).contains("go to");
                });
        assertThat(each(spread.get("hearings"))).isNotEmpty().hasSizeLessThanOrEqualTo(60);
    }

    @Test
    void tellsWhatReachedAnAgentInOrder() throws Exception {
        advanceTo(10);
        JsonNode nav = get("/api/agent?name=nav-1");
        List<JsonNode> mail = each(nav.get("mail"));
        assertThat(mail)
                .isNotEmpty()
                .hasSizeLessThanOrEqualTo(8 * 32)
                .noneMatch(one -> one.get("from").asString().equals("nav-1"))
                .anySatisfy(one -> {
                    assertThat(one.get("from").asString()).isEqualTo("spread");
                    assertThat(one.get("forAll").asBoolean()).isFalse();
                    assertThat(one.get("words").asString())
                            .startsWith("request")
                            .contains("go to");
                });
        assertThat(each(get("/api/agent?name=evade").get("mail")))
                .anyMatch(one -> one.get("forAll").asBoolean());
    }

    @Test
    void tellsWhatAnAgentWithoutAMindShows() throws Exception {
        advanceTo(10);
        JsonNode spread = get("/api/agent?name=spread");
        assertThat(spread.get("mind").isNull()).isTrue();
        assertThat(spread.get("status").asString()).isEqualTo("RUNNING");
        assertThat(spread.get("state").asString()).isNotEmpty();
    }

    @Test
    void tellsWhichArgumentsAnAgentHas() throws Exception {
        advanceTo(1);
        List<JsonNode> arguments = each(get("/api/agent?name=evade").get("arguments"));
        assertThat(arguments)
                .extracting(argument -> argument.get("name").asString())
                .startsWith("hunter", "catchDistance")
                .contains("fleeDistance");
        JsonNode hunter = arguments.getFirst();
        assertThat(hunter.get("value").asString()).isEqualTo("courier");
        assertThat(hunter.get("fallback").asString()).isEmpty();
        assertThat(arguments)
                .filteredOn(argument -> argument.get("name").asString().equals("fleeDistance"))
                .singleElement()
                .satisfies(distance -> {
                    assertThat(distance.get("value").asString()).isEqualTo("6");
                    assertThat(distance.get("fallback").asString()).isEqualTo("6");
                    assertThat(distance.get("unit").asString()).isEqualTo("m");
                    assertThat(distance.get("description").asString())
                            .isEqualTo("It flees from hunters nearer than this.");
                });
        assertThat(each(get("/api/agent?name=nav-1").get("arguments")))
                .extracting(argument -> argument.get("name").asString())
                .doesNotContain("hunter");
    }

    @Test
    void tellsWhatAnAgentBelievesAndWants() throws Exception {
        advanceTo(10);
        JsonNode mind = get("/api/agent?name=evade").get("mind");
        assertThat(each(mind.get("beliefs"))).isNotEmpty();
        assertThat(each(mind.get("goals")))
                .extracting(goal -> goal.get("name").asString())
                .contains("explore", "not be caught");
        assertThat(each(mind.get("goals")))
                .filteredOn(goal -> goal.get("state").asString().equals("PURSUED"))
                .hasSizeLessThanOrEqualTo(1);
        assertThat(each(mind.get("goals")))
                .allSatisfy(goal -> assertThat(each(goal.get("plans"))).isNotEmpty())
                .allSatisfy(goal -> assertThat(goal.get("urgency").asString()).matches("-?[0-9.e+]+"));
    }

    @Test
    void saysWhoIsNotThere() throws Exception {
        advanceTo(1);
        for (String path :
                new String[] {"/api/agent?name=nobody", "/api/agent", "/api/agent?name=" + "x".repeat(500)}) {
            Response response = RawHttp.get(port, path, host);
            assertThat(response.status()).isEqualTo(409);
            assertThat(response.body()).contains("There is no agent '");
        }
    }

    @Test
    void tellsStepByStepWhatChangesInAnAgentWhileSomebodyLooks() throws Exception {
        advanceTo(2);
        assertThat(each(get("/api/agent?name=evade").get("history")))
                .as("what it does is noted before, too")
                .isNotEmpty()
                .allMatch(change -> change.get("kind").asString().equals("DOES"));
        List<JsonNode> history = List.of();
        for (int time = 3; time < 60 && thoughts(history).isEmpty(); time++) { // until it sees somebody
            advanceTo(time);
            history = each(get("/api/agent?name=evade").get("history"));
        }
        assertThat(history).extracting(change -> change.get("time").asDouble()).isSorted();
        assertThat(thoughts(history))
                .extracting(change -> change.get("name").asString())
                .contains("nearest hunter");
        assertThat(thoughts(history)).allMatch(change -> change.get("time").asDouble() > 2);
    }

    private static List<JsonNode> thoughts(List<JsonNode> history) {
        return history.stream()
                .filter(change -> !change.get("kind").asString().equals("DOES"))
                .toList();
    }

    @Test
    void openToNobodyElsesPages() throws Exception {
        for (String path : new String[] {"/api/communication", "/api/topics", "/api/links", "/api/agent?name=evade"}) {
            assertThat(RawHttp.get(port, path, "Host: example.org").status()).isEqualTo(421);
            assertThat(RawHttp.get(port, path, host, "Origin: http://example.org")
                            .status())
                    .isEqualTo(403);
            assertThat(RawHttp.post(port, path, "{}", host, "Authorization: Bearer " + TOKEN)
                            .status())
                    .isEqualTo(404);
        }
    }

    @Test
    @LongTest
    void whoAsksABusyRunIsToldSoInTheEnd() throws Exception {
        var free = new CountDownLatch(1);
        try (var _ = server.run().onSnapshot(() -> await(free))) { // on the run's thread
            server.run().step();
            server.run().snapshot();
            Response response = RawHttp.get(port, "/api/readings?robot=prey", host);
            assertThat(response.status()).as(response.body()).isEqualTo(503);
            assertThat(response.body()).contains("did not answer in time");
            Response reported = RawHttp.post(
                    port, "/api/run/remove", "{\"name\": \"prey\"}", host, "Authorization: Bearer " + TOKEN);
            assertThat(reported.status()).as(reported.body()).isEqualTo(503);
            assertThat(reported.body()).contains("did not answer in time");
        } finally {
            free.countDown();
        }
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void refusedWhenTheRunIsOver() throws Exception {
        server.run().stop();
        server.run().result().toCompletableFuture().join();
        Response response = RawHttp.get(port, "/api/links", host);
        assertThat(response.status()).isEqualTo(409);
        assertThat(response.body()).contains("The run is over.");
    }

    @Test
    void whatWasKnownAtTheEndIsToldAfterwards() throws Exception {
        advanceTo(2);
        String numbers = "/api/numbers/past?robot=prey&device=laser&number=ranges.least";
        ServerClock.await().until(() -> !get(numbers).get("times").isEmpty());
        advanceTo(5);
        server.run().stop();
        server.run().result().toCompletableFuture().join();
        JsonNode evade = get("/api/agent?name=evade");
        assertThat(evade.get("mind").get("goals").size()).isPositive();
        assertThat(evade.get("mail").size()).isPositive();
        assertThat(get("/api/agent?name=spread").get("talks").size()).isPositive();
        assertThat(get("/api/readings?robot=prey").get("readings").size()).isPositive();
        assertThat(get("/api/numbers?robot=prey").get("devices").size()).isPositive();
        JsonNode past = get(numbers);
        assertThat(past.get("times").get(0).asDouble())
                .as("before anybody asked")
                .isLessThan(5);
        assertThat(past.get("values").size()).isEqualTo(past.get("times").size());
        assertThat(get("/api/numbers/past?robot=nobody").get("times").size()).isZero();
        assertThat(get("/api/topics").get("topics").size()).isPositive();
        assertThat(RawHttp.get(port, "/api/agent?name=nobody", host).status()).isEqualTo(409);
    }

    @Test
    void whatWasKnownOfAMomentIsToldOfItAfterwards() throws Exception {
        advanceTo(3);
        Known then = known("");
        String asked = "&time=3";
        ServerClock.await()
                .until(() -> get("/api/numbers?robot=prey" + asked).get("time").asDouble() == 3
                        && !get("/api/agent?name=evade" + asked).get("mind").isNull());
        advanceTo(12);
        assertThat(known("")).isNotEqualTo(then);
        assertThat(known(asked)).isEqualTo(then);
        for (String path : List.of("/api/agent?name=evade", "/api/agent?name=spread")) {
            JsonNode agent = get(path + asked);
            for (String list : List.of("history", "mail", "talks")) {
                assertThat(each(agent.get(list)))
                        .allSatisfy(
                                one -> assertThat(one.get("time").asDouble()).isLessThanOrEqualTo(3));
            }
        }
        assertThat(thoughts(each(get("/api/agent?name=evade&time=12").get("history"))))
                .isNotEmpty();
        assertThat(get("/api/agent?name=spread&time=12").get("talks").size()).isPositive();
        assertThat(get("/api/links?robot=prey&time=12").get("links").size()).isPositive();
        server.run().stop();
        server.run().result().toCompletableFuture().join();
        assertThat(known(asked)).as("when it is over").isEqualTo(then);
        assertThat(get("/api/readings?robot=nobody" + asked).get("readings").size())
                .isZero();
        for (String time : List.of("soon", "NaN", "Infinity", "-Infinity", "")) {
            assertThat(RawHttp.get(port, "/api/readings?robot=prey&time=" + time, host)
                            .status())
                    .as(time)
                    .isEqualTo(400);
        }
    }

    /// Whoever goes on by steps looks closely, also at what is hardly newer than what is kept.
    @Test
    void whatIsKnownWhereARunIsPausedIsKept() throws Exception {
        for (double seconds : new double[] {3, 3.1, 3.2}) {
            advanceTo(seconds);
            ServerClock.await()
                    .until(() -> get("/api/numbers?robot=prey&time=" + seconds)
                                    .get("time")
                                    .asDouble()
                            == seconds);
        }
    }

    /// What devices of a robot told, what its agent has in mind, and who hears whom.
    private record Known(JsonNode numbers, JsonNode readings, JsonNode state, JsonNode beliefs, JsonNode links) {}

    /// @param asked about when; empty for now
    private Known known(String asked) throws Exception {
        JsonNode agent = get("/api/agent?name=evade" + asked);
        return new Known(
                get("/api/numbers?robot=prey" + asked),
                get("/api/readings?robot=prey" + asked),
                agent.get("state"),
                agent.get("shown"),
                get("/api/links?robot=prey" + asked));
    }

    /// What is told now was told then, so that it is older.
    @Test
    void whatIsKnownOfAMomentIsAsOldAsItWasThen() throws Exception {
        advanceTo(3);
        ServerClock.await()
                .until(() -> get("/api/numbers?robot=prey&time=3").get("time").asDouble() == 3);
        advanceTo(3.3);
        JsonNode then = get("/api/readings?robot=prey&time=3.2").get("readings");
        assertThat(each(then))
                .filteredOn(reading -> reading.get("device").asString().equals("base"))
                .singleElement()
                .satisfies(reading -> assertThat(reading.get("age").asDouble()).isBetween(0.0, 0.31));
    }

    @Test
    void whatIsSaidAllTheTimeIsToldOfAMomentToo() throws Exception {
        advanceTo(20);
        assertThat(each(get("/api/routine?topic=pose&time=15").get("said")))
                .isNotEmpty()
                .allSatisfy(said -> assertThat(said.get("time").asDouble()).isBetween(5.0, 15.0));
    }

    @Test
    void lookingChangesNothing() throws Exception {
        RunOptions limited = RunOptions.NONE.withLimit(Duration.ofSeconds(10));
        String unseen;
        try (var run = LiveRun.start(Errand.plan("talk.yaml", limited.withSpeed(Double.POSITIVE_INFINITY)))) {
            unseen = run.result().toCompletableFuture().join().eventHash();
        }
        try (var run = LiveRun.start(Errand.plan("talk.yaml", limited.withSpeed(1)))) { // not over before the looks
            run.pause();
            for (int step = 0; step < 50; step++) {
                run.step();
                look(run);
            }
            run.speed(Double.POSITIVE_INFINITY);
            run.resume();
            assertThat(run.result().toCompletableFuture().join().eventHash()).isEqualTo(unseen);
        }
    }

    /// At two agents and at what all say.
    private static void look(LiveRun run) {
        assertThat(run.inspector().inside("evade").toCompletableFuture().join()).isInstanceOf(Answer.Seen.class);
        assertThat(run.inspector().inside("spread").toCompletableFuture().join())
                .isInstanceOf(Answer.Seen.class);
        assertThat(run.inspector().communication().toCompletableFuture().join()).isInstanceOf(Answer.Heard.class);
        assertThat(run.inspector().links("").toCompletableFuture().join()).isInstanceOf(Answer.Linked.class);
    }
}
