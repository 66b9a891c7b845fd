package rsal.server;

import static org.assertj.core.api.Assertions.assertThat;
import static rsal.server.Errand.TOKEN;
import static rsal.server.TalkServer.each;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rsal.agent.AgentType;
import rsal.engine.RunOperator;
import rsal.server.RawHttp.Response;
import tools.jackson.databind.JsonNode;

/// What the page is told of what agents say, hear, believe and want. These tests look at one moment of one run.
@Timeout(120)
class CommunicationApiTest {
    private static TalkServer talk;

    @BeforeAll
    static void start(@TempDir Path directory) throws Exception {
        talk = new TalkServer(directory);
        talk.advanceTo(10);
    }

    @AfterAll
    static void stop() {
        talk.close();
    }

    @Test
    void whatIsSaidAllTheTimeIsThereForThoseWhoAsk() throws Exception {
        assertThat(talk.run().events(0))
                .noneMatch(event ->
                        event.said().filter(said -> said.topic().equals("pose")).isPresent());
        JsonNode topics = talk.get("/api/routine");
        assertThat(topics.get("topics").toString()).contains("\"pose\"");
        assertThat(topics.get("said")).isEmpty();
        JsonNode poses = talk.get("/api/routine?topic=pose").get("said");
        assertThat(poses)
                .isNotEmpty()
                .allMatch(one -> one.get("text").asString().contains(" is at ("));
        assertThat(poses.get(0).get("time").asDouble())
                .isLessThan(poses.get(poses.size() - 1).get("time").asDouble());
        assertThat(talk.get("/api/routine?topic=none").get("said")).isEmpty();
    }

    @Test
    void reportsWhoHeardWhatAndWhyNotWithoutAToken() throws Exception {
        JsonNode topics = talk.get("/api/topics").get("topics");
        assertThat(each(topics))
                .extracting(topic -> topic.get("topic").asString())
                .contains("go", "hello", "pose")
                .isSorted();
        JsonNode pose = StreamSupport.stream(topics.spliterator(), false)
                .filter(topic -> topic.get("topic").asString().equals("pose"))
                .findFirst()
                .orElseThrow();
        JsonNode all = talk.get("/api/communication").get("communication");
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
    void reportsAllTypesOfAgentsWithWhatCanBeTyped() throws Exception {
        List<JsonNode> types = each(talk.get("/api/agents/types").get("types"));
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
    void reportsWhichRobotsHearEachOther() throws Exception {
        JsonNode reported = talk.get("/api/links?robot=nobody");
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
    void reportsWhatAnAgentTalksAboutInOrder() throws Exception {
        JsonNode spread = talk.get("/api/agent?name=spread");
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
    void reportsWhatReachedAnAgentInOrder() throws Exception {
        JsonNode nav = talk.get("/api/agent?name=nav-1");
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
        assertThat(each(talk.get("/api/agent?name=evade").get("mail")))
                .anyMatch(one -> one.get("forAll").asBoolean());
    }

    @Test
    void reportsWhatAnAgentWithoutAMindShows() throws Exception {
        JsonNode spread = talk.get("/api/agent?name=spread");
        assertThat(spread.get("mind").isNull()).isTrue();
        assertThat(spread.get("status").asString()).isEqualTo("RUNNING");
        assertThat(spread.get("state").asString()).isNotEmpty();
    }

    @Test
    void reportsWhichArgumentsAnAgentHas() throws Exception {
        List<JsonNode> arguments = each(talk.get("/api/agent?name=evade").get("arguments"));
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
        assertThat(each(talk.get("/api/agent?name=nav-1").get("arguments")))
                .extracting(argument -> argument.get("name").asString())
                .doesNotContain("hunter");
    }

    @Test
    void reportsWhatAnAgentBelievesAndWants() throws Exception {
        JsonNode mind = talk.get("/api/agent?name=evade").get("mind");
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
        for (String path :
                new String[] {"/api/agent?name=nobody", "/api/agent", "/api/agent?name=" + "x".repeat(500)}) {
            Response response = RawHttp.get(talk.port(), path, talk.host());
            assertThat(response.status()).isEqualTo(409);
            assertThat(response.body()).contains("There is no agent '");
        }
    }

    @Test
    void openToNobodyElsesPages() throws Exception {
        for (String path : new String[] {"/api/communication", "/api/topics", "/api/links", "/api/agent?name=evade"}) {
            assertThat(RawHttp.get(talk.port(), path, "Host: example.org").status())
                    .isEqualTo(421);
            assertThat(RawHttp.get(talk.port(), path, talk.host(), "Origin: http://example.org")
                            .status())
                    .isEqualTo(403);
            assertThat(RawHttp.post(talk.port(), path, "{}", talk.host(), "Authorization: Bearer " + TOKEN)
                            .status())
                    .isEqualTo(404);
        }
    }
}
