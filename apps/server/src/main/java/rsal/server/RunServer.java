package rsal.server;

import java.io.IOException;
import java.net.URI;
import java.nio.channels.ServerSocketChannel;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import rsal.engine.LiveRun;
import rsal.recording.Recorder;
import rsal.scenario.RunPlan;
import rsal.server.access.Listening;
import rsal.server.http.AccessControl;
import rsal.server.http.Page;
import rsal.server.http.PageServer;
import rsal.server.http.PageServer.TlsListener;
import rsal.server.live.CurrentRun;
import rsal.server.monitor.Exposition;
import rsal.server.run.RunSlots;
import rsal.server.scenario.ScenarioCatalog;
import rsal.server.sweep.SweepApi;
import rsal.server.sweep.SweepHome;
import rsal.server.sweep.Sweeps;

/// Runs a scenario, and others beside it, and shows them on this machine's loopback address, and elsewhere only if
/// asked to.
/// Everybody who can reach the port may look; changing anything takes the token.
///
/// All methods may be called from any thread.
public final class RunServer implements AutoCloseable {
    private final RunSlots seats;
    private final Sweeps sweeps;
    private final PageServer server;
    private final String token;
    private final AccessControl gate;

    /// @param port 0 for any that is free
    /// @param token what a browser must know to change anything, as from [#newToken]
    /// @param page directory of the built page
    /// @param scenarios what can be chosen in the page, as for [rsal.scenario.Scenario#load], and nothing else
    /// @param onStart told of each run, the first and those that replace it, when it begins; not of those that are
    /// begun beside it
    /// @param starter starts those runs
    /// @param recorded the results of recordings so far, empty when there are none; on any thread, must not wait
    /// @param sweeping empty where no sweeps can be begun
    /// @param listening where other machines reach it; empty for nowhere
    /// @param framed whether pages of other programs on this machine may show it in frames, as notebooks do
    public record Options(
            int port,
            String token,
            Path page,
            List<String> scenarios,
            Consumer<LiveRun> onStart,
            Function<RunPlan, LiveRun> starter,
            Supplier<Optional<Recorder.Tally>> recorded,
            Optional<Sweeping> sweeping,
            Optional<Listening> listening,
            boolean framed) {
        public Options {
            scenarios = List.copyOf(scenarios);
        }

        /// In no frames of others.
        public Options(
                int port,
                String token,
                Path page,
                List<String> scenarios,
                Consumer<LiveRun> onStart,
                Function<RunPlan, LiveRun> starter,
                Supplier<Optional<Recorder.Tally>> recorded,
                Optional<Sweeping> sweeping,
                Optional<Listening> listening) {
            this(port, token, page, scenarios, onStart, starter, recorded, sweeping, listening, false);
        }

        /// For this machine alone.
        public Options(
                int port,
                String token,
                Path page,
                List<String> scenarios,
                Consumer<LiveRun> onStart,
                Function<RunPlan, LiveRun> starter,
                Supplier<Optional<Recorder.Tally>> recorded,
                Optional<Sweeping> sweeping) {
            this(port, token, page, scenarios, onStart, starter, recorded, sweeping, Optional.empty());
        }

        /// With runs of one scenario that nobody else sees all of.
        public Options(int port, String token, Path page, Consumer<LiveRun> onStart) {
            this(port, token, page, List.of(), onStart, LiveRun::start, Optional::empty, Optional.empty());
        }
    }

    /// Folder for sweeps that are started in the page, each in its own folder.
    ///
    /// @param folder made when the first begins
    /// @param program its name and version, to be noted with them
    public record Sweeping(Path folder, String program) {}

    /// Opens the port, then starts the run.
    ///
    /// @throws PortInUse when the port is taken; nothing was started then
    /// @throws java.net.BindException when the address for other machines can't be listened at; nothing
    ///         was started then
    /// @throws IOException when the page was not built, or the port can't be opened for another reason
    public static RunServer start(RunPlan plan, Options options) throws IOException, PortInUse {
        var page = new Page(options.page());
        ServerSocketChannel door = PortInUse.open(options.port());
        Optional<TlsListener> remote = Optional.empty();
        try {
            if (options.listening().isPresent()) {
                Listening listening = options.listening().get();
                remote = Optional.of(new TlsListener(PageServer.open(listening.address()), listening.identity()));
            }
            return new RunServer(plan, options, page, door, remote);
        } catch (IOException | RuntimeException e) {
            door.close();
            if (remote.isPresent()) {
                remote.get().channel().close();
            }
            throw e;
        }
    }

    private RunServer(RunPlan plan, Options options, Page page, ServerSocketChannel door, Optional<TlsListener> remote)
            throws IOException {
        token = options.token();
        var catalog = new ScenarioCatalog(options.scenarios());
        sweeps = new Sweeps(
                options.sweeping().map(each -> new SweepHome(each.folder(), each.program())),
                catalog,
                Sweeps.coresBesideARun());
        gate = new AccessControl(PageServer.port(door), token, options.listening(), options.framed());
        var first = new CurrentRun(plan, options.onStart(), options.starter());
        seats = new RunSlots(first, gate);
        try {
            var exposition = new Exposition(first, seats.first().live(), seats.first()::bytesKept, options.recorded());
            var sweepApi = new SweepApi(first, sweeps, gate);
            server = new PageServer(
                    door,
                    token,
                    gate,
                    seats,
                    new Api(seats, catalog, gate, page, exposition, sweepApi)::configure,
                    remote);
        } catch (IOException | RuntimeException e) {
            seats.close();
            throw e;
        }
    }

    /// 128 random bits, as they may stand in a URL.
    public static String newToken() {
        byte[] bits = new byte[16];
        new SecureRandom().nextBytes(bits);
        return Base64.getUrlEncoder().withoutPadding().encodeToString(bits);
    }

    /// What people must know to change something.
    public String token() {
        return token;
    }

    /// The page's address, with the token in the part that browsers keep to themselves.
    public URI url() {
        return server.url();
    }

    /// Why programs, which say of no operator that they are his, may not change anything now; empty when they may.
    /// For any thread.
    public Optional<String> heldBack() {
        return gate.lease().heldBack("");
    }

    /// The run that is shown now; of several side by side the first.
    public LiveRun run() {
        return seats.first().now().run();
    }

    /// All that are side by side.
    RunSlots seats() {
        return seats;
    }

    /// Ends the runs, a sweep and the server, with a second's patience for each run whose agents never return. Closing
    /// twice does nothing.
    @Override
    public void close() {
        server.close();
        sweeps.close();
    }
}
