package rsal.server.run;

import io.javalin.http.Context;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.eclipse.jetty.ee10.websocket.server.JettyServerUpgradeRequest;
import org.eclipse.jetty.ee10.websocket.server.JettyServerUpgradeResponse;
import org.eclipse.jetty.ee10.websocket.server.JettyWebSocketServerContainer;
import org.jspecify.annotations.Nullable;
import rsal.engine.LiveRun;
import rsal.engine.report.Answer;
import rsal.scenario.RunPlan;
import rsal.server.http.AccessControl;
import rsal.server.http.ViewerEndpoint;
import rsal.server.live.CurrentRun;
import rsal.server.live.CurrentRun.Numbered;
import rsal.server.message.Messages.SideBySide;
import rsal.server.message.Refusal;
import rsal.time.AllowedToReadWallClock;

/// Runs side by side: the first, at `/`, which is always there, and others, at `/beside/<number>/`. What runs in real
/// time has no other beside it, which could make it late. All methods may be called from any thread.
@AllowedToReadWallClock("An operator waits for a stop to be confirmed.")
public final class RunSlots implements ViewerEndpoint {
    /// Where the others are, as routes have it.
    public static final String BESIDE = "/beside/{seat}";

    /// As many as can be watched at once, in two rows of two. Each keeps a core busy when it goes as fast as it
    /// can, and up to [rsal.server.history.History#MOST_BYTES] to look back on.
    static final int MOST = 4;

    /// For which the operator waits to hear that all have stopped.
    private static final Duration PATIENCE = Duration.ofSeconds(1);

    /// The fewest: runs side by side, each with as many as there are cores, would take them from each other.
    private static final int HELPERS_BESIDE = 1;

    private static final Pattern LIVE = Pattern.compile("/beside/([^/]+)/api/live");

    private final AccessControl gate;
    private final RunSlot first;
    private volatile List<RunSlot> all; // in the order in which they came
    private final AtomicInteger stops = new AtomicInteger();
    private int newest;
    private boolean closed;

    /// @param current of the first seat; whose this is from now on
    public RunSlots(CurrentRun current, AccessControl gate) {
        this.gate = gate;
        first = RunSlot.first(current, gate);
        all = List.of(first);
        newest = first.number();
    }

    public RunSlot first() {
        return first;
    }

    /// The first one first.
    public List<RunSlot> all() {
        return all;
    }

    /// Whose address was asked for.
    ///
    /// @throws Refusal when there is none of that number (any more)
    public RunSlot find(Context request) {
        String number = numberIn(request);
        return number.isEmpty() ? first : present(number);
    }

    /// Whose address was asked for, if there is one of that number (still).
    public Optional<RunSlot> look(Context request) {
        String number = numberIn(request);
        return number.isEmpty() ? Optional.of(first) : beside(number);
    }

    /// The run that is asked about, also when it is over: it remembers what it was asked then.
    LiveRun run(Context request) {
        return find(request).now().run();
    }

    /// The run that is asked about.
    ///
    /// @throws Refusal when it is over
    LiveRun running(Context request) {
        Numbered now = find(request).now();
        if (now.isOver()) {
            throw new Refusal(409, "The run is over. Restart it first.");
        }
        return now.run();
    }

    /// All, for those who see them side by side.
    SideBySide sideBySide() {
        return new SideBySide(MOST, all.stream().map(RunSlot::info).toList());
    }

    /// Empty for the first.
    private static String numberIn(Context request) {
        return request.pathParamMap().getOrDefault("seat", "");
    }

    private Optional<RunSlot> beside(String number) {
        return all.stream()
                .filter(seat ->
                        !seat.isFirst() && Integer.toString(seat.number()).equals(number))
                .findFirst();
    }

    private RunSlot present(String number) {
        return beside(number).orElseThrow(() -> gone(number));
    }

    private static Refusal gone(String number) {
        return new Refusal(
                404,
                "There is no run '%s' next to the first one. Maybe it was closed."
                        .formatted(Refusal.shortened(number)));
    }

    /// Begins a run beside those that are there. Nobody but its viewers sees it: who is told of runs, records them or
    /// reads metrics knows the first seat alone.
    ///
    /// @param asked how many emergency stops there had been when this was asked for
    /// @throws Refusal when there are [#MOST] already, it or another one is in real time, or all were stopped since
    synchronized RunSlot open(RunPlan plan, int asked) {
        if (closed) {
            throw new Refusal(503, "The server is ending.");
        }
        if (all.size() >= MOST) {
            throw new Refusal(409, "%d runs are side by side already. Close one of them first.".formatted(MOST));
        }
        if (isInRealTime(plan)) {
            throw new Refusal(409, "This run is in real time, and runs side by side would delay it. Restart instead.");
        }
        if (all.stream()
                .anyMatch(seat ->
                        isInRealTime(seat.now().run().plan()) && !seat.now().isOver())) {
            throw new Refusal(409, "The run is in real time, and another one would delay it. Stop it first.");
        }
        checkNoStopSince(asked);
        var seat = new RunSlot(
                newest + 1,
                new CurrentRun(
                        plan,
                        _ -> {},
                        next -> LiveRun.of(next).helpers(HELPERS_BESIDE).start()),
                gate);
        newest = seat.number();
        all = Stream.concat(all.stream(), Stream.of(seat)).toList();
        stopIfToldSince(asked, seat);
        return seat;
    }

    /// Ends a seat's run and begins another one there.
    ///
    /// @param asked how many emergency stops there had been when this was asked for
    /// @throws Refusal when that is in real time, and not alone, or the seat was closed, or all were stopped since;
    ///     then the run has ended, and none has begun
    synchronized void restart(RunSlot seat, RunPlan plan, int asked) {
        if (!all.contains(seat)) {
            throw gone(Integer.toString(seat.number()));
        }
        if (isInRealTime(plan) && all.size() > 1) {
            throw new Refusal(409, "This run is in real time, and the other runs would delay it. Close those first.");
        }
        seat.current().restart(plan, () -> checkNoStopSince(asked));
        stopIfToldSince(asked, seat);
    }

    private void checkNoStopSince(int asked) {
        if (stops.get() != asked) {
            throw new Refusal(409, "An emergency stop came after this was asked for, so no run was begun. Ask again.");
        }
    }

    /// The stop may have come while the run began, and have been told to those before it only.
    private void stopIfToldSince(int asked, RunSlot seat) {
        if (stops.get() != asked) {
            var _ = seat.estop();
        }
    }

    private static boolean isInRealTime(RunPlan plan) {
        return plan.clock() == RunPlan.Clock.WALL;
    }

    /// Ends a run beside the first, and with it its address. Its number is not used again.
    ///
    /// @throws Refusal when there is none
    synchronized void close(String number) {
        if (number.equals(Integer.toString(first.number()))) {
            throw new Refusal(409, "The first run can't be closed. Stop it instead.");
        }
        RunSlot seat = present(number);
        all = all.stream().filter(other -> other != seat).toList();
        seat.close();
    }

    /// How many emergency stops there have been. What was asked for before one begins no run after it.
    public int stops() {
        return stops.get();
    }

    /// Switches off all motors of all runs. Those that are over move nothing any more.
    ///
    /// @return when all are off, or after [#PATIENCE]; a refusal names each run that has not confirmed it by then
    CompletionStage<Answer> estop() {
        stops.incrementAndGet(); // before all are told: who comes to them later sees it
        List<CompletionStage<Answer>> answers = all.stream()
                .filter(seat -> !seat.now().isOver())
                .map(RunSlots::confirmedStop)
                .toList(); // all are told at once
        return answers.stream()
                .reduce(
                        CompletableFuture.completedFuture(new Answer.Stopped(0)),
                        (all, next) -> all.thenCombine(next, RunSlots::both));
    }

    private static CompletionStage<Answer> confirmedStop(RunSlot seat) {
        CompletableFuture<Answer> stopped = seat.estop().toCompletableFuture();
        return CompletableFuture.supplyAsync(() -> confirmation(stopped, seat.number()), Thread::startVirtualThread);
    }

    private static Answer confirmation(CompletableFuture<Answer> stopped, int number) {
        try {
            return stopped.get(PATIENCE.toMillis(), TimeUnit.MILLISECONDS);
        } catch (TimeoutException _) {
            return new Answer.Refused("Run %d was asked to stop and has not confirmed it within %d s. Maybe one of its"
                            .formatted(number, PATIENCE.toSeconds())
                    + " agents never returns: check its robots yourself.");
        } catch (ExecutionException e) {
            return new Answer.Refused(
                    "Run %d could not be stopped: %s. Check its robots yourself.".formatted(number, e.getCause()));
        } catch (InterruptedException e) { // nobody does
            throw new IllegalStateException(e);
        }
    }

    private static Answer both(Answer one, Answer other) {
        if (one instanceof Answer.Refused(String first) && other instanceof Answer.Refused(String second)) {
            return new Answer.Refused(first + " " + second);
        }
        if (one instanceof Answer.Stopped(int some) && other instanceof Answer.Stopped(int more)) {
            return new Answer.Stopped(some + more);
        }
        return one instanceof Answer.Refused ? one : other;
    }

    @Override
    public void configure(JettyWebSocketServerContainer sockets) {
        first.live().configure(sockets);
        sockets.addMapping("/beside/*", this::enter);
    }

    private @Nullable Object enter(JettyServerUpgradeRequest request, JettyServerUpgradeResponse response)
            throws Exception {
        try {
            Matcher path = LIVE.matcher(request.getRequestURI().getPath());
            return present(path.matches() ? path.group(1) : "").live().open(request, response);
        } catch (Refusal refusal) {
            response.sendError(refusal.status(), refusal.sentence());
            return null;
        }
    }

    /// Ends all runs, too.
    @Override
    public synchronized void close() {
        closed = true;
        all.forEach(seat -> seat.live().close());
        all.forEach(seat -> seat.now().run().stop()); // then each ends while others are waited for
        all.forEach(seat -> seat.current().close());
    }
}
