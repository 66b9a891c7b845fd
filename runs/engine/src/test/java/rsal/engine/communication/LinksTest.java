package rsal.engine.communication;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rsal.agent.Message;
import rsal.agent.message.Text;
import rsal.engine.report.Answer;
import rsal.engine.report.Link;
import rsal.engine.report.Link.Way;

class LinksTest {
    private static final Way SILENT = new Way(true, false);
    private static final Way SPOKEN = new Way(true, true);
    private static final Links.Air ALL = new Links.Air((_, _) -> true, (_, _) -> true);
    private static final Links.Air NOBODY = new Links.Air((_, _) -> false, (_, _) -> true);
    private static final Set<String> BOTH = new LinkedHashSet<>(List.of("a", "b"));

    private Instant now = Instant.EPOCH;

    /// Robots are called by the first letter of their agents; agents in upper case have none.
    private final Links links =
            new Links(() -> now, agent -> Character.isUpperCase(agent.charAt(0)) ? "" : agent.substring(0, 1));

    private void says(String sender, String listener) {
        links.heard(new Message<>(Text.TOPIC, sender, "", now, new Text("hi")), listener);
    }

    private Answer.Linked look(Set<String> robots, String chosen) {
        return links.look(robots, chosen, ALL, 0);
    }

    @Test
    void whatIsSaidIsReportedForASecond() {
        assertThat(look(BOTH, "").links()).containsExactly(new Link("a", "b", SILENT, SILENT));
        says("amy", "bob");
        says("amy", "ann"); // of the same robot
        says("Base", "bob");
        assertThat(look(BOTH, "").links()).containsExactly(new Link("a", "b", SPOKEN, SILENT));
        now = now.plusMillis(600);
        says("bob", "amy");
        assertThat(look(BOTH, "").links()).containsExactly(new Link("a", "b", SPOKEN, SPOKEN));
        now = now.plusMillis(600);
        assertThat(look(BOTH, "").links()).containsExactly(new Link("a", "b", SILENT, SPOKEN));
        now = now.plus(Duration.ofSeconds(1));
        assertThat(look(BOTH, "").links()).containsExactly(new Link("a", "b", SILENT, SILENT));
    }

    @Test
    void whatNobodyLooksAtIsNotNoted() {
        says("amy", "bob");
        assertThat(look(BOTH, "").links()).containsExactly(new Link("a", "b", SILENT, SILENT));
        says("amy", "bob");
        long impatient = Links.PATIENCE.toNanos() + 1;
        links.beat(impatient);
        assertThat(look(BOTH, "").links())
                .as("in the time of the run it was looked for just now")
                .containsExactly(new Link("a", "b", SPOKEN, SILENT));
        now = now.plus(Links.PATIENCE).plusNanos(1);
        links.beat(impatient);
        says("amy", "bob");
        assertThat(look(BOTH, "").links()).containsExactly(new Link("a", "b", SILENT, SILENT));
        says("amy", "bob");
        links.beat(impatient - 1);
        assertThat(look(BOTH, "").links()).containsExactly(new Link("a", "b", SPOKEN, SILENT));
    }

    @Test
    void whoNeitherHearsNorHeardIsLeftOut() {
        look(BOTH, "");
        says("bob", "amy");
        var out = links.look(BOTH, "", NOBODY, 0);
        assertThat(out.links()).containsExactly(new Link("a", "b", new Way(false, false), new Way(false, true)));
        now = now.plusSeconds(2);
        assertThat(links.look(BOTH, "", NOBODY, 0).links()).isEmpty();
        assertThat(links.look(BOTH, "", new Links.Air((from, _) -> from.equals("b"), (_, _) -> true), 0)
                        .links())
                .containsExactly(new Link("a", "b", new Way(false, false), SILENT));
    }

    @Test
    void ofManyRobotsThoseOfTheChosenOneAreReported() {
        assertThat(look(robots(Links.MOST_ROBOTS), "").ofChosen()).isFalse();
        assertThat(look(robots(Links.MOST_ROBOTS), "").links())
                .hasSize(Links.MOST_ROBOTS * (Links.MOST_ROBOTS - 1) / 2);
        Set<String> many = robots(Links.MOST_ROBOTS + 1);
        Answer.Linked chosen = look(many, "robot-7");
        assertThat(chosen.ofChosen()).isTrue();
        assertThat(chosen.links())
                .hasSize(Links.MOST_ROBOTS)
                .allMatch(link -> link.one().equals("robot-7"));
        assertThat(look(many, "").links()).isEmpty();
        assertThat(look(many, "nobody").links()).isEmpty();
    }

    @Test
    void whatIsReportedToNobodyIsNotNoted() {
        Set<String> many = robots(Links.MOST_ROBOTS);
        many.addAll(BOTH);
        assertThat(look(many, "").ofChosen()).isTrue();
        says("amy", "bob");
        assertThat(look(many, "a").links()).contains(new Link("a", "b", SILENT, SILENT));
        says("amy", "bob");
        assertThat(look(many, "a").links()).contains(new Link("a", "b", SPOKEN, SILENT));
    }

    @Test
    void whoIsFarAwayIsAskedOnceAndOnlyWhereSomebodySpeaks() {
        var asked = new ArrayList<String>();
        var far = new Links.Air((from, _) -> from.equals("b"), (one, other) -> {
            asked.add(one + other);
            return false;
        });
        assertThat(links.look(BOTH, "", far, 0).links()).isEmpty();
        assertThat(asked).containsExactly("ab");
        links.look(BOTH, "", new Links.Air(NOBODY.sends(), far.reaches()), 0);
        assertThat(asked).hasSize(1);
    }

    @Test
    void areLookedForOnceInASecondAndWhatIsAsBeforeIsTheSame() {
        var each = new LinkSampler();
        Answer.Linked first = each.at(Duration.ofSeconds(1), () -> look(BOTH, ""));
        assertThat(each.at(Duration.ofMillis(1999), () -> Answer.Linked.NONE)).isSameAs(first);
        assertThat(each.at(Duration.ofSeconds(2), () -> look(BOTH, ""))).isSameAs(first);
        Set<String> three = new LinkedHashSet<>(List.of("a", "b", "c"));
        Answer.Linked more = each.at(Duration.ofSeconds(3), () -> look(three, ""));
        assertThat(more.links()).hasSize(3);
        assertThat(more.links().getFirst()).isSameAs(first.links().getFirst());
    }

    private static Set<String> robots(int count) {
        var ids = new LinkedHashSet<String>();
        IntStream.rangeClosed(1, count).forEach(i -> ids.add("robot-" + i));
        return ids;
    }
}
