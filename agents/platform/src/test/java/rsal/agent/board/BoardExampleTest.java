package rsal.agent.board;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.Topic;
import rsal.agent.platform.Run;
import rsal.data.Point2d;

/// What docs/how-to/boards.md shows, word for word.
class BoardExampleTest {
    private static final Path PAGE = Path.of("../../docs/how-to/boards.md");
    private static final Path HERE = Path.of("src/test/java/rsal/agent/board/BoardExampleTest.java");

    private final Run run = new Run();

    // shown: a topic
    record Spill(double liters) {
        static final Topic<Spill> TOPIC = new Topic<>("spills", Spill.class);
    }

    // end

    // shown: one who writes
    static final class Lookout implements Agent {
        @Override
        public void start(AgentContext self) {
            var board = new TeamBoard(self, "team", event -> self.show("board", event.toString()));
            board.write(Spill.TOPIC, "kitchen", new Spill(0.5), new Point2d(3, 1), Duration.ofMinutes(10));
        }
    }

    // end

    // shown: one who reads
    static final class Cleaner implements Agent {
        @Override
        public void start(AgentContext self) {
            var board = new TeamBoard(self, "team", event -> self.show("board", event.toString()));
            var near = Query.of(Spill.TOPIC).within(10, new Point2d(0, 0)).newest(5);
            BoardWatch<Spill> spills = board.watch(near, () -> {});
            self.scheduler().every(Duration.ofSeconds(1), () -> {
                String words = spills.notes().stream()
                        .map(note -> "%s (%s liters)"
                                .formatted(note.name(), note.content().liters()))
                        .collect(Collectors.joining(", "));
                self.state(words.isEmpty() ? "all is clean" : "to clean: " + words);
            });
        }
    }

    // end

    @Test
    void cleanerKnowsWhatTheLookoutSawUntilItHasFaded() {
        run.start("board", self -> new BoardKeeper(self, "team", BoardKeeper.Limits.DEFAULT).begin());
        run.start("lookout", new Lookout());
        run.start("cleaner", new Cleaner());
        run.advance(60);
        assertThat(run.view("cleaner").state()).isEqualTo("to clean: kitchen (0.5 liters)");
        assertThat(run.view("lookout").beliefs()).containsEntry("board", "Kept[keeper=board]");
        run.advance(600);
        assertThat(run.view("cleaner").state()).isEqualTo("all is clean");
    }

    @Test
    void pageShowsJustThis() throws IOException {
        String page = packed(Files.readString(PAGE));
        List<String> parts = Arrays.stream(Files.readString(HERE).split("// " + "shown: "))
                .skip(1)
                .filter(part -> part.contains("// end"))
                .map(part -> part.substring(part.indexOf('\n'), part.indexOf("// end")))
                .toList();
        assertThat(parts).hasSize(3).allSatisfy(part -> assertThat(page).contains(packed(part)));
    }

    private static String packed(String text) {
        return text.replaceAll("\\s+", "");
    }
}
