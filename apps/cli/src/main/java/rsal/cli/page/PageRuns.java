package rsal.cli.page;

import java.io.IOException;
import java.io.PrintWriter;
import java.net.BindException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import rsal.cli.terminal.Build;
import rsal.cli.terminal.ClosedAtExit;
import rsal.cli.terminal.Progress;
import rsal.cli.terminal.Unreachable;
import rsal.engine.LiveRun;
import rsal.engine.report.RunResult;
import rsal.recording.Recorder;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;
import rsal.server.PortInUse;
import rsal.server.RunServer;
import rsal.server.access.Listening;

/// Runs that a page shows: a first one, and those that somebody starts there in its place.
public final class PageRuns {
    public static final int DEFAULT_PORT = 8735;

    private static final String CHOOSE = "&choose"; // beside the token, in the part that browsers keep to themselves

    private PageRuns() {}

    /// Who has something to do with each of them; called on the thread that shows them, one run after the other.
    public interface Eye extends AutoCloseable {
        /// Whether the lines that agents print are left to the page.
        default boolean quiet() {
            return false;
        }

        /// Starts a run; on a thread of the page, too.
        default LiveRun start(RunPlan plan) {
            return LiveRun.start(plan);
        }

        /// The results of recordings so far; empty when nothing is recorded. Called on threads of the page; must not
        /// wait.
        default Optional<Recorder.Tally> recorded() {
            return Optional.empty();
        }

        /// Whether a run is only there to be looked at until somebody chooses one: then nothing is printed of it.
        default boolean isWaiting(LiveRun run) {
            return false;
        }

        /// The page is there, before all runs but the first.
        default void shown(RunServer page) {}

        /// A run has begun.
        void began(LiveRun run) throws Exception;

        void ended(LiveRun run, RunResult result) throws Exception;

        /// There are no more runs. Closing twice does nothing.
        @Override
        default void close() {}
    }

    /// What is shown first.
    ///
    /// @param scenarios what can be chosen in the page, as for [Scenario#load]
    /// @param sweeps where sweeps are kept that are begun there; empty where none can be
    public record First(RunPlan plan, List<String> scenarios, Stay stay, Optional<Path> sweeps) {
        /// A run that only others of its scenario may follow.
        public static First alone(RunPlan plan) {
            return new First(plan, List.of(), Stay.FOR_MORE, Optional.empty());
        }

        /// A run that others may follow: of what comes with RSAL, and of a person's own, which come first.
        public static First of(RunPlan plan, List<String> own, Stay stay, Path sweeps) {
            List<String> all = Stream.concat(own.stream(), Scenario.builtInNames().stream())
                    .distinct()
                    .toList();
            return new First(plan, all, stay, Optional.of(sweeps));
        }
    }

    /// How long the page is there.
    public enum Stay {
        /// It ends with the first run.
        FOR_THE_FIRST,
        /// Until a signal, for further runs.
        FOR_MORE,
        /// The same, and the page begins with the choice of a scenario.
        FOR_A_CHOICE
    }

    /// Where the page can be reached.
    ///
    /// @param port on this machine; null for the usual one, or any when that is in use
    /// @param listening for other machines; empty for none
    /// @param framed whether pages of other programs on this machine may show it in frames
    public record Endpoints(@Nullable Integer port, Optional<Listening> listening, boolean framed) {
        /// The usual ones.
        public static final Endpoints USUAL = new Endpoints(null, Optional.empty(), false);
    }

    /// Prints the page's address and shows runs until a signal ends it all, by an exception, or the first has ended.
    ///
    public static RunResult show(First first, Endpoints endpoints, PrintWriter err, Eye eye) throws Exception {
        var runs = new LinkedBlockingQueue<LiveRun>();
        var begun = new AtomicReference<AutoCloseable>(() -> {});
        // before it begins: a recording that was begun has to end, too
        var ending = new ClosedAtExit(() -> close(begun.get(), eye));
        try (eye;
                RunServer server = serve(first, endpoints, runs::add, eye)) {
            begun.set(server);
            keepKey(server, err);
            eye.shown(server);
            boolean isChoosing = first.stay() == Stay.FOR_A_CHOICE;
            err.println(isChoosing ? "Choose a scenario at " + server.url() + CHOOSE : "Watch it at " + server.url());
            if (endpoints.port() == null && server.url().getPort() != DEFAULT_PORT) {
                err.println(otherPort(server.url().getPort()));
            }
            endpoints.listening().ifPresent(listening -> printListening(listening, server.token(), err));
            while (true) {
                LiveRun run = runs.take();
                eye.began(run);
                boolean waits = eye.isWaiting(run);
                RunResult result = waits ? Progress.awaitSilently(run) : new Progress(err, eye.quiet()).await(run);
                ending.checkNoSignal();
                eye.ended(run, result);
                if (first.stay() == Stay.FOR_THE_FIRST) {
                    return result;
                }
                if (!waits) {
                    err.println("The page is still there, for another run, too; Ctrl-C ends it.");
                }
            }
        }
    }

    /// Else commands would reach the run that has the usual port.
    private static String otherPort(int port) {
        return "rsal: Port %d is in use, maybe by another run. For this run use --port %d, as in 'rsal status --port %d'."
                .formatted(DEFAULT_PORT, port, port);
    }

    private static void printListening(Listening listening, String token, PrintWriter err) {
        ReachableHosts.of(listening)
                .forEach(host -> err.println("From other machines: https://%s:%d/#token=%s"
                        .formatted(host, listening.address().getPort(), token)));
        err.println("rsal: All who have a token reach this run over the network, and may drive its robots.");
    }

    private static void close(AutoCloseable server, Eye eye) throws Exception {
        server.close(); // first, for the end of its run to be seen
        eye.close();
    }

    /// For 'rsal estop' and its like; the page does without.
    private static void keepKey(RunServer server, PrintWriter err) {
        try {
            new PageKey(server.url().getPort(), server.token()).keep();
        } catch (IOException e) {
            err.println(
                    "Commands like 'rsal estop' can't reach this run: neither '%s' nor a temporary folder can be written (%s). Maybe set XDG_RUNTIME_DIR to a private folder."
                            .formatted(PageKey.folder(), e.getMessage()));
        }
    }

    private static RunServer serve(First first, Endpoints endpoints, Consumer<LiveRun> onStart, Eye eye)
            throws IOException {
        String token = RunServer.newToken();
        try {
            return serve(
                    endpoints.port(),
                    (free, page) -> RunServer.start(
                            first.plan(),
                            new RunServer.Options(
                                    free,
                                    token,
                                    page,
                                    first.scenarios(),
                                    onStart,
                                    eye::start,
                                    eye::recorded,
                                    first.sweeps().map(folder -> new RunServer.Sweeping(folder, Build.name())),
                                    endpoints.listening(),
                                    endpoints.framed())));
        } catch (BindException e) {
            throw new Unreachable("RSAL can't listen at '%s': %s. Is the address in use, or of another machine?"
                    .formatted(
                            endpoints.listening().map(Listening::address).orElseThrow(),
                            String.valueOf(e.getMessage())));
        }
    }

    /// Starts a server at a port, with the built page.
    public interface Starter<S> {
        S at(int port, Path page) throws IOException, PortInUse;
    }

    /// @param port null for the usual one, or any when that is in use
    public static <S> S serve(@Nullable Integer port, Starter<S> server) throws IOException {
        Path page = page().orElseThrow(() ->
                new Unreachable("The page is not built. Start with ./rsal, which builds it; or run without a page: run "
                        + "--headless, replay --verify, bridge without --page."));
        try {
            if (port != null) {
                return server.at(port, page);
            }
            try {
                return server.at(DEFAULT_PORT, page);
            } catch (PortInUse _) {
                return server.at(0, page);
            }
        } catch (PortInUse taken) {
            throw new Unreachable(String.valueOf(taken.getMessage()));
        }
    }

    /// Where the launcher says the built page is.
    static Optional<Path> page() {
        return Optional.ofNullable(System.getProperty("rsal.page"))
                .map(Path::of)
                .filter(Files::isDirectory);
    }
}
