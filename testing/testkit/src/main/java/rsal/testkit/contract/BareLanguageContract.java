package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import rsal.bare.BareLanguage;
import rsal.bare.BareLanguage.Platform;
import rsal.bare.BareLanguage.Program;
import rsal.time.AllowedToReadWallClock;

/// What a language owes to benchmarks, so that they count what they say.
@AllowedToReadWallClock("Agents of bare systems have threads of their own and the machine's time.")
public abstract class BareLanguageContract {
    private static final int AGENTS = 5;
    private static final int OTHERS = AGENTS - 1;
    private static final int LOOKS = 30_000;
    private static final long PAUSE = 1_000_000; // between two looks [ns]

    protected abstract BareLanguage language();

    private static List<String> names() {
        return IntStream.range(0, AGENTS).mapToObj(i -> "agent" + i).toList();
    }

    private static Map<String, Program> all(Program program) {
        var agents = new LinkedHashMap<String, Program>();
        names().forEach(name -> agents.put(name, program));
        return agents;
    }

    private static void untilAllHaveCounted(Platform platform, long least) {
        names().forEach(name -> untilItHasCounted(platform, name, least));
    }

    private static void untilItHasCounted(Platform platform, String agent, long least) {
        for (int look = 0; look < LOOKS && platform.count(agent) < least; look++) {
            LockSupport.parkNanos(PAUSE);
        }
        assertThat(platform.count(agent)).as(agent).isGreaterThanOrEqualTo(least);
    }

    @Test
    void beginnersCountOne() {
        try (var platform = language().start()) {
            platform.start(all(Program.BEGINNER));
            untilAllHaveCounted(platform, 1);
            assertThat(names()).allMatch(name -> platform.count(name) == 1);
        }
    }

    @Test
    void tellersHearAllOthersAgainAndAgain() {
        try (var platform = language().start()) {
            platform.start(all(Program.TELLER));
            untilAllHaveCounted(platform, OTHERS * 10);
        }
    }

    @Test
    void talkersGoOnTogether() {
        try (var platform = language().start()) {
            platform.start(all(Program.TALKER));
            untilAllHaveCounted(platform, OTHERS * 100);
        }
    }

    @Test
    void aManagerEndsContractNetsAgainAndAgain() {
        var agents = all(Program.BIDDER);
        agents.put("manager", Program.MANAGER);
        try (var platform = language().start()) {
            platform.start(agents);
            untilItHasCounted(platform, "manager", 20);
        }
    }

    @Test
    void opensNoPortWritesNoFileAndEnds() throws IOException {
        Set<String> portsBefore = Ports.listening();
        List<Path> filesBefore = files();
        try (var platform = language().start()) {
            platform.start(all(Program.TELLER));
            untilAllHaveCounted(platform, OTHERS);
            assertThat(Ports.listening()).isSubsetOf(portsBefore);
        }
        assertThat(files()).isEqualTo(filesBefore);
    }

    /// In the working directory.
    private static List<Path> files() throws IOException {
        try (Stream<Path> files = Files.list(Path.of(""))) {
            return files.sorted().toList();
        }
    }
}
