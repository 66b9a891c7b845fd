package rsal.server.frame;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.server.message.Messages.AgentDetails;
import rsal.server.message.Messages.Details;
import rsal.server.message.Messages.RobotDetails;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class DetailChangesTest {
    private static final int LOOKS = 200;

    private static RobotDetails robot(String id, String behavior) {
        return new RobotDetails(
                id,
                false,
                Optional.empty(),
                "",
                behavior,
                "",
                false,
                "",
                List.of(),
                Optional.empty(),
                List.of(),
                List.of());
    }

    private static AgentDetails agent(String name, String state) {
        return new AgentDetails(
                name, "role", "type", "", AgentDetails.Status.RUNNING, state, Map.of(), 0, Optional.empty(), List.of());
    }

    private static Details details(List<RobotDetails> robots, List<AgentDetails> agents) {
        return new Details(1, true, Optional.empty(), robots, agents);
    }

    private static JsonNode read(String text) {
        return JsonMapper.shared().readTree(text).get("details");
    }

    @Test
    void reportsOnlyWhatIsAnother() {
        var changes = new DetailChanges();
        assertThat(changes.version()).isZero();
        changes.take(details(List.of(robot("a", ""), robot("b", "")), List.of(agent("x", ""))));
        long known = changes.version();
        assertThat(changes.take(details(List.of(robot("a", ""), robot("b", "")), List.of(agent("x", "")))))
                .isFalse();
        assertThat(changes.version()).isEqualTo(known);
        assertThat(changes.take(details(List.of(robot("a", ""), robot("b", "wander")), List.of(agent("x", "")))))
                .isTrue();
        JsonNode news = read(changes.since(known));
        assertThat(news.get("whole").asBoolean()).isFalse();
        assertThat(news.get("robots")).hasSize(1);
        assertThat(news.get("robots").get(0).get("id").asString()).isEqualTo("b");
        assertThat(news.get("agents")).isEmpty();
        assertThat(read(changes.since(0)).get("robots")).hasSize(2);
    }

    /// A viewer that is told at some looks and not at others knows all, as one that is told all at each.
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5})
    void whoIsSentChangesKnowsAll(int seed) {
        var random = new Random(seed);
        var changes = new DetailChanges();
        var robots = new ArrayList<>(List.of(robot("r0", "")));
        var agents = new ArrayList<AgentDetails>();
        long known = 0;
        List<JsonNode> here = List.of();
        List<JsonNode> there = List.of();
        int parts = 0;
        for (int look = 0; look < LOOKS; look++) {
            switch (random.nextInt(12)) {
                case 0 -> robots.add(robot("r" + (look + 1), ""));
                case 1 -> agents.add(agent("a" + look, ""));
                case 2 -> {
                    if (robots.size() > 1) {
                        robots.remove(random.nextInt(robots.size()));
                    }
                }
                case 3, 4, 5, 6 ->
                    robots.replaceAll(each -> random.nextInt(4) > 0 ? each : robot(each.id(), "b" + random.nextInt(3)));
                case 7, 8 ->
                    agents.replaceAll(
                            each -> random.nextInt(4) > 0 ? each : agent(each.name(), "s" + random.nextInt(3)));
                default -> {}
            }
            changes.take(details(List.copyOf(robots), List.copyOf(agents)));
            if (random.nextInt(3) > 0 && changes.version() != known) {
                JsonNode news = read(changes.since(known));
                known = changes.version();
                here = merged(here, news, "robots", "id");
                there = merged(there, news, "agents", "name");
                parts += news.get("whole").asBoolean() ? 0 : 1;
                JsonNode all = read(changes.since(0));
                assertThat(here).as("look %d", look).containsExactlyElementsOf(all.get("robots"));
                assertThat(there).as("look %d", look).containsExactlyElementsOf(all.get("agents"));
            }
        }
        assertThat(parts).isGreaterThan(10);
    }

    /// As the page does it, in details.ts.
    private static List<JsonNode> merged(List<JsonNode> before, JsonNode news, String list, String name) {
        var all = new ArrayList<JsonNode>(news.get("whole").asBoolean() ? List.of() : before);
        for (JsonNode each : news.get(list)) {
            int place = 0;
            while (place < all.size() && !all.get(place).get(name).equals(each.get(name))) {
                place++;
            }
            if (place < all.size()) {
                all.set(place, each);
            } else {
                all.add(each);
            }
        }
        return all;
    }
}
