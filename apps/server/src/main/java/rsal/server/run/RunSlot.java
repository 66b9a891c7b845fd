package rsal.server.run;

import java.time.Duration;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;
import rsal.engine.LiveRun;
import rsal.engine.SpeedFactor;
import rsal.engine.report.Answer;
import rsal.engine.report.Snapshot;
import rsal.scenario.RunPlan;
import rsal.server.description.Descriptions;
import rsal.server.description.FloorPlan;
import rsal.server.history.NumberHistory;
import rsal.server.history.Recollection;
import rsal.server.http.AccessControl;
import rsal.server.http.Http;
import rsal.server.live.CurrentRun;
import rsal.server.live.CurrentRun.Numbered;
import rsal.server.live.Live;
import rsal.server.live.LiveViewSource;
import rsal.server.message.Messages.SeatInfo;
import rsal.server.message.Messages.Trails;

/// A place where a run is shown, then its successors: what there is once for each of the runs side by side. All
/// methods may be called from any thread.
public final class RunSlot implements AutoCloseable {
    private static final int FIRST = 1;

    private final int number;
    private final CurrentRun current;
    private final LiveViewSource showing;
    private final Live live;
    private final AtomicReference<@Nullable PackedFloor> floor = new AtomicReference<>();

    /// The map of a run, which takes a while to draw.
    private record PackedFloor(int run, byte[] bytes) {}

    /// @param number of no other seat of the server
    /// @param current whose this is from now on
    RunSlot(int number, CurrentRun current, AccessControl gate) {
        this.number = number;
        this.current = current;
        showing = new LiveViewSource(current);
        live = new Live(showing, gate);
    }

    /// The one that is always there.
    static RunSlot first(CurrentRun current, AccessControl gate) {
        return new RunSlot(FIRST, current, gate);
    }

    public int number() {
        return number;
    }

    boolean isFirst() {
        return number == FIRST;
    }

    CurrentRun current() {
        return current;
    }

    public Numbered now() {
        return current.now();
    }

    public Live live() {
        return live;
    }

    /// What devices of its run's robots have told so far, as numbers.
    NumberHistory numbers() {
        return showing.numbers();
    }

    /// What devices of its run's robots had told and its agents had in mind before.
    Recollection recollection() {
        return showing.recollection();
    }

    /// Where its run's robots went before some time.
    Trails trails(Duration until) {
        return showing.trails(until);
    }

    /// What looking back takes.
    public long bytesKept() {
        return showing.bytesKept();
    }

    /// The cells of a run's map, as [Http#packed] packs them.
    byte[] floor(Numbered run) {
        PackedFloor known = floor.get();
        if (known == null || known.run() != run.number()) {
            known = new PackedFloor(
                    run.number(), Http.packed(FloorPlan.cells(run.run().plan().scene())));
            floor.set(known);
        }
        return known.bytes();
    }

    /// Switches off all motors. What has ended has none.
    CompletionStage<Answer> estop() {
        Numbered now = now();
        return now.run().operator().estop().thenApply(answer -> now.isOver() ? new Answer.Stopped(0) : answer);
    }

    /// How its run gets on, for those who see all side by side.
    SeatInfo info() {
        LiveRun run = now().run();
        RunPlan plan = run.plan();
        Snapshot snapshot = run.snapshot();
        return new SeatInfo(
                number,
                plan.scenario().title(),
                plan.scenario().name(),
                plan.configuration(),
                Long.toString(plan.seed()),
                plan.options().arguments(),
                plan.options().mas().orElse(""),
                snapshot.time().toNanos() / 1e9,
                SpeedFactor.format(snapshot.speed()),
                snapshot.paused(),
                snapshot.stopped(),
                Descriptions.outcome(run, snapshot));
    }

    /// Lets its viewers go, with a word, then ends its run.
    @Override
    public void close() {
        live.end();
        current.close();
    }
}
