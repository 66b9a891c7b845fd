package rsal.server;

import static org.assertj.core.api.Assertions.assertThat;
import static rsal.server.Errand.TOKEN;
import static rsal.server.TalkServer.each;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.Timeout.ThreadMode;
import org.junit.jupiter.api.io.TempDir;
import rsal.engine.LiveRun;
import rsal.engine.report.Answer;
import rsal.scenario.RunOptions;
import rsal.server.RawHttp.Response;
import rsal.testkit.LongTest;
import tools.jackson.databind.JsonNode;

/// What the page is told of how agents came to what they believe and want, and of moments that are over.
@Timeout(value = 120, threadMode = ThreadMode.SEPARATE_THREAD) // who spins is not interrupted
class CommunicationPastApiTest {
    private TalkServer talk;

    @BeforeEach
    void start(@TempDir Path directory) throws Exception {
        talk = new TalkServer(directory);
    }

    @AfterEach
    void stop() {
        talk.close();
    }

    @Test
    void reportsStepByStepWhatChangesInAnAgentWhileSomebodyLooks() throws Exception {
        talk.advanceTo(2);
        assertThat(each(talk.get("/api/agent?name=evade").get("history")))
                .as("what it does is noted before, too")
                .isNotEmpty()
                .allMatch(change -> change.get("kind").asString().equals("DOES"));
        List<JsonNode> history = List.of();
        for (int time = 3; time < 60 && thoughts(history).isEmpty(); time++) { // until it sees somebody
            talk.advanceTo(time);
            history = each(talk.get("/api/agent?name=evade").get("history"));
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
    @LongTest
    void whoAsksABusyRunIsInformedInTheEnd() throws Exception {
        var free = new CountDownLatch(1);
        try (var _ = talk.run().onSnapshot(() -> await(free))) { // on the run's thread
            talk.run().step();
            talk.run().snapshot();
            Response response = RawHttp.get(talk.port(), "/api/readings?robot=prey", talk.host());
            assertThat(response.status()).as(response.body()).isEqualTo(503);
            assertThat(response.body()).contains("did not answer in time");
            Response reported = RawHttp.post(
                    talk.port(),
                    "/api/run/remove",
                    "{\"name\": \"prey\"}",
                    talk.host(),
                    "Authorization: Bearer " + TOKEN);
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
        talk.run().stop();
        talk.run().result().toCompletableFuture().join();
        Response response = RawHttp.get(talk.port(), "/api/links", talk.host());
        assertThat(response.status()).isEqualTo(409);
        assertThat(response.body()).contains("The run is over.");
    }

    @Test
    void whatWasKnownAtTheEndIsReportedAfterwards() throws Exception {
        talk.advanceTo(2);
        String numbers = "/api/numbers/past?robot=prey&device=laser&number=ranges.least";
        ServerClock.await().until(() -> !talk.get(numbers).get("times").isEmpty());
        talk.advanceTo(5);
        talk.run().stop();
        talk.run().result().toCompletableFuture().join();
        JsonNode evade = talk.get("/api/agent?name=evade");
        assertThat(evade.get("mind").get("goals").size()).isPositive();
        assertThat(evade.get("mail").size()).isPositive();
        assertThat(talk.get("/api/agent?name=spread").get("talks").size()).isPositive();
        assertThat(talk.get("/api/readings?robot=prey").get("readings").size()).isPositive();
        assertThat(talk.get("/api/numbers?robot=prey").get("devices").size()).isPositive();
        JsonNode past = talk.get(numbers);
        assertThat(past.get("times").get(0).asDouble())
                .as("before anybody asked")
                .isLessThan(5);
        assertThat(past.get("values").size()).isEqualTo(past.get("times").size());
        assertThat(talk.get("/api/numbers/past?robot=nobody").get("times").size())
                .isZero();
        assertThat(talk.get("/api/topics").get("topics").size()).isPositive();
        assertThat(RawHttp.get(talk.port(), "/api/agent?name=nobody", talk.host())
                        .status())
                .isEqualTo(409);
    }

    @Test
    void whatWasKnownOfAMomentIsReportedAfterwards() throws Exception {
        talk.advanceTo(3);
        Known then = known("");
        String asked = "&time=3";
        ServerClock.await()
                .until(() ->
                        talk.get("/api/numbers?robot=prey" + asked).get("time").asDouble() == 3
                                && !talk.get("/api/agent?name=evade" + asked)
                                        .get("mind")
                                        .isNull());
        talk.advanceTo(12);
        assertThat(known("")).isNotEqualTo(then);
        assertThat(known(asked)).isEqualTo(then);
        for (String path : List.of("/api/agent?name=evade", "/api/agent?name=spread")) {
            JsonNode agent = talk.get(path + asked);
            for (String list : List.of("history", "mail", "talks")) {
                assertThat(each(agent.get(list)))
                        .allSatisfy(
                                one -> assertThat(one.get("time").asDouble()).isLessThanOrEqualTo(3));
            }
        }
        assertThat(thoughts(each(talk.get("/api/agent?name=evade&time=12").get("history"))))
                .isNotEmpty();
        assertThat(talk.get("/api/agent?name=spread&time=12").get("talks").size())
                .isPositive();
        assertThat(talk.get("/api/links?robot=prey&time=12").get("links").size())
                .isPositive();
        talk.run().stop();
        talk.run().result().toCompletableFuture().join();
        assertThat(known(asked)).as("when it is over").isEqualTo(then);
        assertThat(talk.get("/api/readings?robot=nobody" + asked)
                        .get("readings")
                        .size())
                .isZero();
        for (String time : List.of("soon", "NaN", "Infinity", "-Infinity", "")) {
            assertThat(RawHttp.get(talk.port(), "/api/readings?robot=prey&time=" + time, talk.host())
                            .status())
                    .as(time)
                    .isEqualTo(400);
        }
    }

    /// Whoever goes on by steps looks closely, also at what is hardly newer than what is kept.
    @Test
    void whatIsKnownWhereARunIsPausedIsKept() throws Exception {
        for (double seconds : new double[] {3, 3.1, 3.2}) {
            talk.advanceTo(seconds);
            ServerClock.await()
                    .until(() -> talk.get("/api/numbers?robot=prey&time=" + seconds)
                                    .get("time")
                                    .asDouble()
                            == seconds);
        }
    }

    /// What devices of a robot told, what its agent has in mind, and who hears whom.
    private record Known(JsonNode numbers, JsonNode readings, JsonNode state, JsonNode beliefs, JsonNode links) {}

    /// @param asked about when; empty for now
    private Known known(String asked) throws Exception {
        JsonNode agent = talk.get("/api/agent?name=evade" + asked);
        return new Known(
                talk.get("/api/numbers?robot=prey" + asked),
                talk.get("/api/readings?robot=prey" + asked),
                agent.get("state"),
                agent.get("shown"),
                talk.get("/api/links?robot=prey" + asked));
    }

    /// What is told now was told then, so that it is older.
    @Test
    void whatIsKnownOfAMomentIsAsOldAsItWasThen() throws Exception {
        talk.advanceTo(3);
        ServerClock.await()
                .until(() ->
                        talk.get("/api/numbers?robot=prey&time=3").get("time").asDouble() == 3);
        talk.advanceTo(3.3);
        JsonNode then = talk.get("/api/readings?robot=prey&time=3.2").get("readings");
        assertThat(each(then))
                .filteredOn(reading -> reading.get("device").asString().equals("base"))
                .singleElement()
                .satisfies(reading -> assertThat(reading.get("age").asDouble()).isBetween(0.0, 0.31));
    }

    @Test
    void whatIsSaidAllTheTimeIsReportedOfAMomentToo() throws Exception {
        talk.advanceTo(20);
        assertThat(each(talk.get("/api/routine?topic=pose&time=15").get("said")))
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
