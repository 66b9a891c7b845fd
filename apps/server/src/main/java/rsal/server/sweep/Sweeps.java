package rsal.server.sweep;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import rsal.experiment.Design;
import rsal.experiment.ExperimentOutline;
import rsal.experiment.Manifest;
import rsal.experiment.Sweep;
import rsal.experiment.SweepFolder;
import rsal.scenario.RunPlan;
import rsal.server.http.FewAtOnce;
import rsal.server.message.Messages.FieldError;
import rsal.server.message.Messages.SweepRunAgain;
import rsal.server.message.Messages.SweepRuns;
import rsal.server.message.Messages.SweepSize;
import rsal.server.message.Messages.SweepState;
import rsal.server.message.Messages.SweepWish;
import rsal.server.message.Messages.SweepsBefore;
import rsal.server.message.Refusal;
import rsal.server.scenario.ScenarioCatalog;
import rsal.settings.InvalidSettings;
import rsal.time.AllowedToReadWallClock;

/// Sweeps that are begun in the page: one at a time, each in a folder of its own below the one that the operator
/// gave. All methods may be called from any thread.
@AllowedToReadWallClock("Notes when a sweep was made.")
public final class Sweeps implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(Sweeps.class);

    private final Optional<SweepHome> sweeping;
    private final Optional<EarlierSweeps> earlier;
    private final ScenarioCatalog catalog;
    private final FewAtOnce fewReports = new FewAtOnce("the sweep's report");
    private final int cores;
    private @Nullable BackgroundSweep newest;
    private boolean closed;

    /// @param sweeping empty where none can be begun
    /// @param catalog where scenarios are
    /// @param cores how many of them sweeps may keep busy
    public Sweeps(Optional<SweepHome> sweeping, ScenarioCatalog catalog, int cores) {
        this.sweeping = sweeping;
        this.earlier = sweeping.map(here -> new EarlierSweeps(here.folder()));
        this.catalog = catalog;
        this.cores = cores;
    }

    /// One core less than the machine has, which is left to the run that is shown, and to the page.
    public static int coresBesideARun() {
        return Math.max(1, Runtime.getRuntime().availableProcessors() - 1);
    }

    SweepState state() {
        return new SweepState(sweeping.isPresent(), cores, newest().map(BackgroundSweep::info));
    }

    /// @throws Refusal with what is wrong with the wish
    SweepSize size(SweepWish wish) {
        return new SweepReader(catalog, wish).size();
    }

    /// @param check throws when none may begin now; called last of all
    /// @throws Refusal when one goes on, or with what is wrong with the wish
    void begin(SweepWish wish, Runnable check) {
        SweepHome here = here();
        checkFree();
        int jobs = jobs(wish);
        Sweep sweep = new SweepReader(catalog, wish).sweep(); // may take a while
        synchronized (this) {
            checkFree();
            check.run();
            Path out = unused(here.folder(), sweep.scenario().name());
            var order = new BackgroundSweep.Order(nextNumber(), sweep, wish.scenario(), jobs, out);
            newest = begin(order, create(order, here), false);
        }
    }

    /// Goes on with one that was stopped, or failed, or whose server is gone.
    ///
    /// @param name of its folder, as [rsal.server.message.Messages.EarlierSweep] has it; empty for the newest
    ///         of this server
    /// @throws Refusal when there is none, it has ended, or it can't go on here
    synchronized void resume(String name) {
        SweepHome here = here();
        checkFree();
        BackgroundSweep.Order order = name.isEmpty()
                ? stopped(newest().orElseThrow(Sweeps::none))
                : earlierOrder(earlier().find(name));
        newest = begin(
                order, open(order, () -> SweepFolder.resume(order.out(), order.sweep(), session(order, here))), true);
    }

    private static BackgroundSweep.Order stopped(BackgroundSweep last) {
        if (last.hasEnded()) {
            throw ended();
        }
        return last.order();
    }

    /// What is left to do of a sweep from before, by this server or by `rsal sweep`.
    private BackgroundSweep.Order earlierOrder(Path out) {
        try {
            ExperimentOutline outline = ExperimentOutline.read(out);
            Manifest manifest = outline.manifest();
            if (manifest.sessions().isEmpty()) {
                throw new Refusal(409, "No file says how the sweep in '%s' was started.".formatted(out));
            }
            if (outline.ended() >= outline.runs()) {
                throw ended();
            }
            Manifest.Session last = manifest.sessions().getLast();
            if (last.command().contains("--record")) {
                throw new Refusal(409, "Its runs are recorded, which the page can't do. Continue in a terminal.");
            }
            Design design = manifest.subject().design();
            SweepReader.tooLarge(design).ifPresent(error -> {
                throw new Refusal(409, error.message());
            });
            String scenario = catalog.idOf(last.scenario());
            Sweep sweep = Sweep.of(catalog.load(scenario), design);
            return new BackgroundSweep.Order(nextNumber(), sweep, scenario, Math.clamp(last.jobs(), 1, cores), out);
        } catch (InvalidSettings e) {
            throw new Refusal(409, e);
        } catch (UncheckedIOException e) {
            throw new Refusal(409, "The sweep in '%s' can't be read: %s.".formatted(out, e.getMessage()));
        }
    }

    private static Refusal ended() {
        return new Refusal(409, "The sweep has ended: all of its runs are there.");
    }

    private int nextNumber() {
        return newest().map(last -> last.order().number() + 1).orElse(1);
    }

    private static SweepFolder create(BackgroundSweep.Order order, SweepHome here) {
        try {
            return open(order, () -> SweepFolder.create(order.out(), order.sweep(), session(order, here)));
        } catch (Refusal refusal) {
            discard(order.out());
            throw refusal;
        }
    }

    /// Takes a folder away again that nothing could be written to.
    private static void discard(Path folder) {
        try {
            Files.deleteIfExists(folder);
        } catch (IOException e) {
            LOG.warn("Nothing could be written to the folder {}, which is kept: {}", folder, e.getMessage());
        }
    }

    private static SweepFolder open(BackgroundSweep.Order order, Supplier<SweepFolder> opening) {
        try {
            return opening.get();
        } catch (InvalidSettings e) {
            throw new Refusal(409, e);
        } catch (UncheckedIOException e) {
            throw unwritable(order.out(), e);
        }
    }

    private static Refusal unwritable(Path folder, Exception e) {
        return new Refusal(409, "The sweep can't be written to '%s': %s.".formatted(folder, e.getMessage()));
    }

    private BackgroundSweep begin(BackgroundSweep.Order order, SweepFolder folder, boolean again) {
        return new BackgroundSweep(order, folder, cores, again);
    }

    /// Gives up the runs under way; nothing happens when there are none.
    void stop() {
        newest().ifPresent(BackgroundSweep::stop);
    }

    /// The page that `rsal report` writes.
    ///
    /// @throws Refusal while there is nothing to report, or others are asking
    String report() {
        return fewReports.ask(newest().orElseThrow(Sweeps::none)::report);
    }

    /// Runs of a combination that have ended.
    ///
    /// @param label of the combination
    /// @throws Refusal when there is none
    SweepRuns runs(String label) {
        return newest().orElseThrow(Sweeps::none).runs(label);
    }

    /// A run of the newest once more; see [BackgroundSweep#plan].
    ///
    /// @throws Refusal when the newest is another one, or has no such run
    RunPlan plan(SweepRunAgain wish) {
        return newest().filter(sweep -> sweep.order().number() == wish.sweep())
                .orElseThrow(() -> new Refusal(404, "Sweep '%d' is not the newest here.".formatted(wish.sweep())))
                .plan(wish.run());
    }

    /// Those before the newest.
    SweepsBefore before() {
        return new SweepsBefore(earlier().list(newest().map(last -> last.order().out())));
    }

    /// The page that `rsal report` writes of one of them.
    ///
    /// @param name of its folder
    String reportOf(String name) {
        return earlier().report(name);
    }

    private EarlierSweeps earlier() {
        return earlier.orElseThrow(Sweeps::notHere);
    }

    boolean isInProgress() {
        return newest().filter(BackgroundSweep::isInProgress).isPresent();
    }

    private synchronized Optional<BackgroundSweep> newest() {
        return Optional.ofNullable(newest);
    }

    private SweepHome here() {
        return sweeping.orElseThrow(Sweeps::notHere);
    }

    private static Refusal notHere() {
        return new Refusal(404, "No sweeps can be started here.");
    }

    private static Refusal none() {
        return new Refusal(404, "No sweep was started here.");
    }

    private synchronized void checkFree() {
        if (closed) {
            throw new Refusal(503, "The server is ending.");
        }
        if (isInProgress()) {
            throw new Refusal(409, "A sweep is running already. Stop it first, or wait until it has ended.");
        }
    }

    private int jobs(SweepWish wish) {
        int jobs = wish.jobs().orElse(cores);
        if (jobs < 1 || jobs > cores) {
            throw new Refusal(
                    422,
                    "This can't be swept as it is.",
                    List.of(new FieldError(
                            "jobs",
                            "'jobs' must be from 1 to %d, not '%d'.".formatted(cores, jobs),
                            "One core is left to the run that is shown.")));
        }
        return jobs;
    }

    /// Makes a folder that nobody has used, `hunt-and-prey-3`: nothing that the page says is part of its path.
    ///
    /// @param name of the scenario, by its file
    private static Path unused(Path folder, String name) {
        String plain = name.replaceAll("[^A-Za-z0-9_-]", "_");
        try {
            Files.createDirectories(folder);
            for (int i = 1; ; i++) {
                try {
                    return Files.createDirectory(folder.resolve(plain + "-" + i));
                } catch (FileAlreadyExistsException _) {
                    // the next one then
                }
            }
        } catch (IOException e) {
            throw unwritable(folder, e);
        }
    }

    private static Manifest.Session session(BackgroundSweep.Order order, SweepHome here) {
        return new Manifest.Session(
                Instant.now().truncatedTo(ChronoUnit.SECONDS).toString(),
                order.named(),
                order.sweep().command(order.named(), order.jobs(), order.out()),
                order.jobs(),
                Manifest.Machine.here(here.program()));
    }

    @Override
    public void close() {
        synchronized (this) {
            closed = true;
        }
        newest().ifPresent(BackgroundSweep::close);
    }
}
