package rsal.agent.platform;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.InstanceOfAssertFactories.MAP;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import rsal.agent.Blackboard;
import rsal.agent.Topic;
import rsal.time.LockstepScheduler;

class BlackboardTest {
    private static final Topic<Integer> NUMBERS = new Topic<>("numbers", Integer.class);
    private static final Topic<Integer> OTHERS = new Topic<>("others", Integer.class);

    private final LockstepScheduler clock = new LockstepScheduler();
    private final Blackboard board = new Blackboard(clock);

    @Test
    void noteFadesWhenItsTimeIsUp() {
        board.write(NUMBERS, "one", 1, Duration.ofSeconds(10));
        clock.advance(Duration.ofMillis(9_999));
        assertThat(board.read(NUMBERS, "one")).map(Blackboard.Note::content).contains(1);
        clock.advance(Duration.ofMillis(1));
        assertThat(board.read(NUMBERS, "one")).isEmpty();
    }

    @Test
    void noteWithoutALifetimeStaysUntilItIsErased() {
        board.write(NUMBERS, "one", 1);
        clock.advance(Duration.ofDays(365));
        assertThat(board.read(NUMBERS, "one")).isPresent();
        board.erase(NUMBERS, "one");
        assertThat(board.all()).isEmpty();
    }

    @Test
    void lifetimesMayBeLongerThanTimeItself() {
        board.write(NUMBERS, "one", 1, Duration.ofSeconds(Long.MAX_VALUE));
        clock.advance(Duration.ofDays(365));
        assertThat(board.read(NUMBERS, "one")).isPresent();
    }

    @Test
    void fadedNotesTakeNoPlaceThoughNobodyReads() {
        board.write(NUMBERS, "one", 1, Duration.ofSeconds(1));
        clock.advance(Duration.ofSeconds(1));
        board.write(OTHERS, "two", 2);
        assertThat(board).extracting("size").isEqualTo(1);
        assertThat(board).extracting("topics").asInstanceOf(MAP).hasSize(1);
    }

    @Test
    void rewritingBeginsANewLife() {
        board.write(NUMBERS, "one", 1, Duration.ofSeconds(1));
        clock.advance(Duration.ofMillis(500));
        board.write(NUMBERS, "one", 11, Duration.ofSeconds(1));
        clock.advance(Duration.ofMillis(900));
        assertThat(board.read(NUMBERS)).extracting(Blackboard.Note::content).containsExactly(11);
    }

    /// Against a board that keeps all that was ever done and looks for what still counts.
    @Test
    void showsWhatAFullHistoryShows() {
        for (long seed = 0; seed < 200; seed++) {
            var random = new Random(seed);
            var tried = new Blackboard(clock);
            var history = new ArrayList<Deed>();
            for (int step = 0; step < 100; step++) {
                Topic<Integer> topic = random.nextBoolean() ? NUMBERS : OTHERS;
                String name = "n" + random.nextInt(4);
                switch (random.nextInt(5)) {
                    case 0 -> {
                        tried.erase(topic, name);
                        history.add(new Deed(topic, name, false, step, Instant.MIN));
                    }
                    case 1 -> {
                        tried.write(topic, name, step);
                        history.add(new Deed(topic, name, true, step, Instant.MAX));
                    }
                    case 2 -> clock.advance(Duration.ofMillis(random.nextInt(300)));
                    default -> {
                        var lifetime = Duration.ofMillis(random.nextInt(1000));
                        tried.write(topic, name, step, lifetime);
                        history.add(new Deed(
                                topic, name, true, step, clock.instant().plus(lifetime)));
                    }
                }
                assertThat(tried.read(NUMBERS))
                        .as("seed %d, step %d", seed, step)
                        .extracting(Blackboard.Note::content)
                        .containsExactlyElementsOf(stillThere(history, NUMBERS));
            }
        }
    }

    private List<Integer> stillThere(List<Deed> history, Topic<Integer> topic) {
        var there = new ArrayList<Integer>();
        for (int i = 0; i < history.size(); i++) {
            Deed deed = history.get(i);
            boolean undone = history.subList(i + 1, history.size()).stream()
                    .anyMatch(later -> later.topic.equals(deed.topic) && later.name.equals(deed.name));
            if (deed.topic.equals(topic) && deed.wrote && !undone && deed.fades.isAfter(clock.instant())) {
                there.add(deed.content);
            }
        }
        return there;
    }

    private record Deed(Topic<Integer> topic, String name, boolean wrote, int content, Instant fades) {}
}
