package rsal.experiment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import com.google.common.jimfs.Configuration;
import com.google.common.jimfs.Jimfs;
import java.io.IOException;
import java.nio.file.FileSystem;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CompletableFuture;
import java.util.stream.LongStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.Timeout.ThreadMode;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.engine.LiveRun;
import rsal.experiment.example.Endless;
import rsal.scenario.Scenario;
import rsal.settings.InvalidSettings;
import rsal.testkit.LongTest;

class SweepRunTest {
    @TempDir
    Path folder;

    private Path out;
    private Scenario scenario;
    private Sweep sweep;

    @BeforeEach
    void plan() {
        out = folder.resolve("out");
        scenario = Guards.in(folder);
        sweep = Sweep.of(scenario, Guards.design(2));
    }

    @Test
    void eachRunIsWhatItWouldBeAlone() throws Exception {
        List<Row> rows = run(sweep, create(sweep), 4);
        assertThat(rows).hasSize(8);
        for (Row row : rows) {
            try (LiveRun alone = LiveRun.start(sweep.plan(sweep.trials().get(row.run() - 1)))) {
                assertThat(row.eventHash())
                        .isEqualTo(alone.result().toCompletableFuture().get().eventHash());
            }
        }
        assertThat(rows)
                .extracting(Row::outcome)
                .containsExactly(
                        "success", "success", "timeout", "timeout", "success", "success", "timeout", "timeout");
    }

    @Test
    void theTableHasARowPerRunAndColumnsForAllThatIsMeasured() throws Exception {
        run(sweep, create(sweep), 2);
        List<String> lines = Files.readAllLines(out.resolve(SweepFolder.TABLE));
        assertThat(lines.getFirst())
                .isEqualTo("run,combination,configuration,argument.guards,argument.places,seed,outcome,reason,"
                        + "simulatedSeconds,wallSeconds,eventHash,metric.guards,metric.way.guard-1,"
                        + "metric.firstCollision,metric.way.guard-2,outOfBounds,failedAgents");
        assertThat(lines).hasSize(9);
        assertThat(lines.get(2)).startsWith("2,2,long,2,anywhere,1,success,,3.1,");
        Row row = SweepFolder.rows(out).get(1);
        assertThat(row.metrics().get("guards").orElseThrow()).isPositive();
        assertThat(row.metrics()).containsEntry("firstCollision", OptionalDouble.empty());
        assertThat(row.arguments()).containsEntry("guards", 2);
    }

    /// Wherever the file ends: after a row, or anywhere in one.
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 17, 100_000})
    void goesOnAfterAKillWithoutLosingOrDoublingARow(int left) throws Exception {
        run(sweep, create(sweep), 2);
        List<Row> whole = SweepFolder.rows(out);
        Path rows = out.resolve(SweepFolder.ROWS);
        byte[] all = Files.readAllBytes(rows);
        int third = lineEnd(all, lineEnd(all, lineEnd(all, 0)));
        int fourth = lineEnd(all, third);
        Files.write(rows, Arrays.copyOf(all, Math.min(third + left, fourth - 1)));
        Files.writeString(out.resolve(SweepFolder.TABLE), "half a ta");

        var opened = SweepFolder.resume(out, sweep, Guards.session());
        assertThat(opened.rows()).hasSize(3);
        run(sweep, opened, 2);

        assertThat(withoutWallTime(SweepFolder.rows(out))).isEqualTo(withoutWallTime(whole));
        assertThat(Files.readAllLines(rows)).hasSize(8);
        assertThat(Files.readAllLines(out.resolve(SweepFolder.TABLE))).hasSize(9);
        assertThat(SweepFolder.manifest(out).sessions()).hasSize(2);
    }

    @LongTest
    @Test
    void goesOnInAFolderOfWindows() throws Exception {
        try (FileSystem windows = Jimfs.newFileSystem(Configuration.windows())) {
            out = windows.getPath("C:\\Users\\Bob\\my sweep");
            create(sweep).close();
            run(sweep, SweepFolder.resume(out, sweep, Guards.session()), 2);
            assertThat(SweepFolder.rows(out)).hasSize(8);
            assertThat(Files.readAllLines(out.resolve(SweepFolder.TABLE))).hasSize(9);
        }
    }

    @Test
    void reportsNoFoldersOfTheMachineThatMadeIt() throws Exception {
        var session = new Manifest.Session(
                "2026-01-02T03:04:05Z",
                "/home/bob/lab/guards.yaml",
                List.of("rsal", "sweep", "/home/bob/lab/guards.yaml", "--out=/home/bob/lab/swept"),
                1,
                Manifest.Machine.here("0"));
        run(sweep, SweepFolder.create(out, sweep, session), 1);
        assertThat(out.resolve(SweepFolder.MANIFEST))
                .content()
                .doesNotContain("bob", out.getParent().toString());
        assertThat(SweepFolder.manifest(out).sessions().getFirst().command())
                .containsExactly("rsal", "sweep", "guards.yaml", "--out=swept");
    }

    @Test
    void aLastLineThatIsNoRowIsCutOff() throws Exception {
        run(sweep, create(sweep), 2);
        Path rows = out.resolve(SweepFolder.ROWS);
        Files.write(rows, new byte[] {0, 0, 0, '\n'}, StandardOpenOption.APPEND); // after a loss of power
        try (var opened = SweepFolder.resume(out, sweep, Guards.session())) {
            assertThat(opened.rows()).hasSize(8);
        }
    }

    @Test
    void aFolderOfAnotherSweepIsRefused() throws Exception {
        create(sweep).close();
        Sweep other = Sweep.of(scenario, Guards.design(3));
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> SweepFolder.resume(out, other, Guards.session()))
                .withMessageContainingAll("another one", "seeds (there [1, 2], here [1, 2, 3])");
        Sweep changed = Sweep.of(Guards.in(folder, Guards.TEXT + "# a word more\n"), Guards.design(2));
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> SweepFolder.resume(out, changed, Guards.session()))
                .withMessageContaining("scenario's text");
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> create(sweep))
                .withMessageContainingAll("a sweep in it already", "--resume");
    }

    @Test
    void aFolderWithOtherThingsIsRefused() throws IOException {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> SweepFolder.resume(out, sweep, Guards.session()))
                .withMessageContaining("no sweep to resume");
        Files.createDirectories(out);
        Files.writeString(out.resolve("thesis.tex"), "");
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> create(sweep))
                .withMessageContaining("not empty");
    }

    @LongTest
    @Test
    void onlyOneWritesToAFolder() {
        try (var _ = create(sweep)) {
            assertThatExceptionOfType(InvalidSettings.class)
                    .isThrownBy(() -> SweepFolder.resume(out, sweep, Guards.session()))
                    .withMessageContaining("Another process");
        }
    }

    @LongTest
    @Test
    void seesThatARunComesOutOtherwiseNow() throws Exception {
        run(sweep, create(sweep), 2);
        try (var same = SweepFolder.resume(out, sweep, Guards.session());
                var runs = new SweepRun(sweep, same, 1, _ -> {})) {
            runs.checkRepeatable();
        }
        Path rows = out.resolve(SweepFolder.ROWS);
        Files.writeString(rows, Files.readString(rows).replaceAll("\"eventHash\":\"....", "\"eventHash\":\"beef"));
        try (var other = SweepFolder.resume(out, sweep, Guards.session());
                var runs = new SweepRun(sweep, other, 1, _ -> {})) {
            assertThatExceptionOfType(InvalidSettings.class)
                    .isThrownBy(runs::checkRepeatable)
                    .withMessageContainingAll("was beef", "has changed since");
        }
    }

    /// With the second seed nothing is free for so many large robots; with the first there is.
    @LongTest
    @Test
    void whatCantBeginBecomesARowWithItsReason() throws Exception {
        String crowded = Guards.TEXT.replace(
                "pose: {free: true}", "pose: {free: true, clearance: 0.4, within: [-1.2, -1.6, 0.6, -0.4]}");
        Scenario tight = Guards.in(folder, crowded);
        var design = new Design(
                List.of("short"),
                List.of(),
                Map.of("guards", "2"),
                LongStream.rangeClosed(1, 30).boxed().toList(),
                Optional.empty());
        Sweep planned = planned(tight, design);
        List<Row> rows = run(planned, create(planned), 2);
        assertThat(rows).hasSize(30);
        assertThat(rows).filteredOn(Row::isBroken).isNotEmpty().allSatisfy(row -> {
            assertThat(row.reason()).contains("guard");
            assertThat(row.simulatedSeconds()).isEmpty();
        });
        assertThat(rows).filteredOn(row -> !row.isBroken()).isNotEmpty();
    }

    private static Sweep planned(Scenario scenario, Design design) {
        for (int first = 0; ; first++) {
            try {
                List<Long> seeds = new ArrayList<>(design.seeds());
                Collections.rotate(seeds, -first);
                return Sweep.of(
                        scenario,
                        new Design(
                                design.configurations(), design.factors(), design.settings(), seeds, design.limit()));
            } catch (InvalidSettings e) {
                if (first == design.seeds().size()) {
                    throw e;
                }
            }
        }
    }

    @Test
    void whatIsClosedEndsWithoutRowsForRunsUnderWay() throws Exception {
        try (var opened = create(sweep)) {
            var runs = new SweepRun(sweep, opened, 2, _ -> {});
            runs.close();
            runs.run();
            assertThat(opened.rows()).isEmpty();
        }
    }

    @Test
    void isClosedByWhoeverIsInformedOfARow() throws Exception {
        var reported = new ArrayList<Row>();
        try (var opened = create(sweep)) {
            var self = new SweepRun[1];
            self[0] = new SweepRun(sweep, opened, 1, row -> {
                reported.add(row);
                self[0].close();
            });
            self[0].run();
        }
        assertThat(reported).hasSize(1);
        assertThat(SweepFolder.rows(out))
                .extracting(Row::run)
                .containsExactly(reported.getFirst().run());
    }

    private Scenario withAgent(String type) {
        return Guards.in(folder, Guards.TEXT + "  other: {agents: {other: {type: %s}}}\n".formatted(type));
    }

    private static Design thatAndShort(Long... seeds) {
        return new Design(List.of("other", "short"), List.of(), Map.of(), List.of(seeds), Optional.empty());
    }

    @Test
    void aRunWithoutMemoryBecomesARowAndTheOthersGoOn() throws Exception {
        Sweep hungry = Sweep.of(withAgent("glutton"), thatAndShort(1L, 2L));
        List<Row> rows = run(hungry, create(hungry), 2);
        assertThat(rows).hasSize(4);
        assertThat(rows)
                .filteredOn(row -> row.configuration().equals("other"))
                .hasSize(2)
                .allSatisfy(row -> assertThat(row.isBroken()).isTrue())
                .allSatisfy(row -> assertThat(row.reason()).contains("not enough memory", "--jobs"));
        assertThat(rows)
                .filteredOn(row -> row.configuration().equals("short"))
                .extracting(Row::outcome)
                .containsExactly("timeout", "timeout");
    }

    @Test
    @Timeout(value = 60, threadMode = ThreadMode.SEPARATE_THREAD)
    @LongTest
    void anAgentThatNeverReturnsIsLeftBehindWhenTheSweepIsGivenUp() throws Exception {
        Sweep stuck = Sweep.of(withAgent("endless"), thatAndShort(1L));
        try (var opened = create(stuck)) {
            var runs = new SweepRun(stuck, opened, 2, _ -> {});
            var ended = new CompletableFuture<Boolean>();
            Thread.ofPlatform().daemon().start(() -> {
                try {
                    runs.run();
                    ended.complete(true);
                } catch (InterruptedException | RuntimeException e) {
                    ended.completeExceptionally(e);
                }
            });
            Endless.BEGAN.acquire();
            assertThat(ended).as("it waits for those that may end").isNotDone();
            runs.close();
            assertThat(ended.get()).isTrue();
            assertThat(opened.rows()).noneMatch(row -> row.configuration().equals("other"));
        } finally {
            Endless.RELEASE.release(4);
        }
    }

    private SweepFolder create(Sweep planned) {
        return SweepFolder.create(out, planned, Guards.session("rsal", "sweep"));
    }

    /// @return all rows, in order
    private List<Row> run(Sweep planned, SweepFolder opened, int jobs) throws InterruptedException {
        try (opened;
                var runs = new SweepRun(planned, opened, jobs, _ -> {})) {
            runs.run();
            return opened.rows();
        }
    }

    private static int lineEnd(byte[] all, int from) {
        int end = from;
        while (all[end] != '\n') {
            end++;
        }
        return end + 1;
    }

    private static List<Row> withoutWallTime(List<Row> rows) {
        return rows.stream()
                .map(row -> new Row(
                        row.run(),
                        row.combination(),
                        row.configuration(),
                        row.arguments(),
                        row.seed(),
                        row.outcome(),
                        row.reason(),
                        row.simulatedSeconds(),
                        OptionalDouble.empty(),
                        row.eventHash(),
                        row.metrics(),
                        row.outOfBounds(),
                        row.failedAgents()))
                .toList();
    }
}
