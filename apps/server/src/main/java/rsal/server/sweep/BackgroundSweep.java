package rsal.server.sweep;

import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import rsal.experiment.Findings;
import rsal.experiment.Pace;
import rsal.experiment.Recordings;
import rsal.experiment.Row;
import rsal.experiment.Sweep;
import rsal.experiment.SweepFolder;
import rsal.experiment.SweepRun;
import rsal.experiment.Trial;
import rsal.experiment.report.Report;
import rsal.experiment.report.ShellWords;
import rsal.scenario.RunPlan;
import rsal.server.http.Page;
import rsal.server.message.Messages.SweepInfo;
import rsal.server.message.Messages.SweepInfo.SweepStatus;
import rsal.server.message.Messages.SweepRuns;
import rsal.server.message.Refusal;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;
import rsal.time.AllowedToReadWallClock;

/// A sweep whose runs go on in threads of their own, beside what the page shows. Closing it gives up the runs
/// under way; rows that are there stay. All methods may be called from any thread.
@AllowedToReadWallClock("Tells how long it still takes.")
final class BackgroundSweep implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(BackgroundSweep.class);
    private static final Duration PATIENCE = Duration.ofMillis(500); // with its last row, when all ends

    private static final int MOST_RUNS = 500; // of a combination; the table has all of them

    private final Order order;
    private final SweepFolder folder;
    private final SweepRun runs;
    private final int before;
    private final long began = System.nanoTime();
    private final Thread thread;
    private volatile State state = new State(SweepStatus.RUNS, "");
    private @Nullable Reported reported;
    private @Nullable Page report;

    /// What is to be done.
    ///
    /// @param number counts this server's sweeps, from 1
    /// @param named the scenario, as for [rsal.scenario.Scenario#load]
    /// @param jobs how many runs at once
    /// @param out where the rows are
    record Order(int number, Sweep sweep, String named, int jobs, Path out) {}

    private record State(SweepStatus status, String problem) {}

    /// What is told of the rows that were there, which takes a while to work out.
    private record Reported(Findings findings, SweepDescription description) {
        int rows() {
            return findings.rows().size();
        }
    }

    private record Page(int rows, String html) {}

    /// @param folder this closes it
    /// @param cores how many of them runs may keep busy
    /// @param again whether rows of an earlier session may be there
    BackgroundSweep(Order order, SweepFolder folder, int cores, boolean again) {
        this.order = order;
        this.folder = folder;
        this.before = folder.rows().size();
        this.runs = new SweepRun(order.sweep(), folder, order.jobs(), cores, Recordings.NONE, _ -> {});
        this.thread = Thread.ofPlatform().daemon().name("sweep").start(() -> state = work(again));
    }

    private State work(boolean again) {
        try (folder;
                runs) {
            if (again && runs.left() > 0) {
                runs.checkRepeatable();
            }
            runs.run();
            return new State(isComplete() ? SweepStatus.ENDED : SweepStatus.STOPPED, "");
        } catch (InterruptedException _) {
            return new State(SweepStatus.STOPPED, "");
        } catch (InvalidSettings e) {
            return failed(e.problems().stream().map(Problem::message).collect(Collectors.joining(" ")));
        } catch (UncheckedIOException e) {
            return failed("Rows can't be written to '%s': %s. Those that are there stay."
                    .formatted(order.out(), e.getMessage()));
        } catch (RuntimeException | Error e) {
            LOG.error("The sweep in {} failed.", order.out(), e);
            return failed("The sweep failed; the server's log says why. Rows that are there stay.");
        }
    }

    private static State failed(String problem) {
        return new State(SweepStatus.FAILED, problem);
    }

    private boolean isComplete() {
        return folder.rows().size() == order.sweep().trials().size();
    }

    Order order() {
        return order;
    }

    /// Whether all of its runs have rows.
    boolean hasEnded() {
        return state.status() == SweepStatus.ENDED;
    }

    boolean isInProgress() {
        return state.status() == SweepStatus.RUNS;
    }

    SweepInfo info() {
        State now = state; // before rows are counted: those that hear of its end get all rows
        Reported reported = reported();
        int runs = order.sweep().trials().size();
        Optional<Duration> left = now.status() == SweepStatus.RUNS
                ? new Pace(runs, before, reported.rows(), Duration.ofNanos(System.nanoTime() - began)).left()
                : Optional.empty();
        return new SweepInfo(
                order.number(),
                order.named(),
                order.sweep().scenario().title(),
                now.status(),
                now.problem(),
                ShellWords.of(order.sweep().command(order.named(), order.jobs(), order.out())),
                order.out().toString(),
                order.jobs(),
                runs,
                reported.rows(),
                reported.description().broken(),
                left.map(duration -> duration.toMillis() / 1e3),
                reported.description().metrics(),
                reported.description().combinations());
    }

    /// The page that `rsal report` writes.
    ///
    /// @throws Refusal while there is nothing to report
    synchronized String report() {
        Reported now = reported();
        if (now.rows() == 0) {
            throw new Refusal(409, "No run has ended yet.");
        }
        Page known = report;
        if (known == null || known.rows() != now.rows()) {
            known = new Page(now.rows(), Report.html(now.findings()));
            report = known;
        }
        return known.html();
    }

    /// Runs of a combination that have ended, by number: the last [#MOST_RUNS].
    ///
    /// @throws Refusal when there is no such combination
    SweepRuns runs(String label) {
        Findings findings = reported().findings();
        List<Row> rows = findings.design().combinations().stream()
                .filter(combination -> findings.label(combination).equals(label))
                .findFirst()
                .map(findings::of)
                .orElseThrow(() ->
                        new Refusal(404, "The sweep has no combination '%s'.".formatted(Refusal.shortened(label))));
        return new SweepRuns(rows.subList(Math.max(0, rows.size() - MOST_RUNS), rows.size()).stream()
                .map(SweepDescription::run)
                .toList());
    }

    /// A run of it once more, in real time, to be looked at. Comes out as it did: nothing is read again.
    ///
    /// @param run its number, from 1
    /// @throws Refusal when it has none of that number, or none that can begin
    RunPlan plan(int run) {
        List<Trial> trials = order.sweep().trials();
        if (run < 1 || run > trials.size()) {
            throw new Refusal(404, "The sweep has runs 1 to %d, no '%d'.".formatted(trials.size(), run));
        }
        try {
            return order.sweep().plan(trials.get(run - 1), 1);
        } catch (InvalidSettings e) {
            throw new Refusal(409, e);
        }
    }

    private synchronized Reported reported() {
        Reported known = reported;
        if (known == null || known.rows() != folder.rows().size()) {
            Findings findings = folder.findings();
            known = new Reported(findings, SweepDescription.of(findings));
            reported = known;
        }
        return known;
    }

    /// Gives up the runs under way, soon; their rows are not there.
    void stop() {
        runs.close();
    }

    /// The same, and waits a little for that.
    @Override
    public void close() {
        stop();
        try {
            thread.join(PATIENCE);
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt();
        }
    }
}
