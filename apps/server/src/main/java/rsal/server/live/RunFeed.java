package rsal.server.live;

import java.time.Duration;
import java.util.List;
import rsal.engine.report.RobotView;
import rsal.engine.report.RunEvent;
import rsal.engine.report.Snapshot;
import rsal.engine.report.Teammate;
import rsal.server.description.AppearanceEncoder;
import rsal.server.description.Descriptions;
import rsal.server.frame.DetailChanges;
import rsal.server.frame.Feed;
import rsal.server.frame.FrameEncoder;
import rsal.server.frame.ObjectRegistry;
import rsal.server.frame.ObjectTracker;
import rsal.server.live.CurrentRun.Numbered;
import rsal.server.message.Json;
import rsal.server.message.Messages.MotorsOff;
import rsal.server.message.Messages.Newcomers;
import rsal.server.message.Messages.ServerMessage;

/// Shows a run, encoded once for all viewers. For one thread.
final class RunFeed implements Feed {
    private static final int FRAMES_PER_DETAILS = 4;

    private final Numbered run;
    private final ObjectTracker surveyor;
    private String info = "";
    private List<Teammate> team = List.of();
    private List<String> robots = List.of();
    private final FrameEncoder encoder = new FrameEncoder();
    private int pauses = FRAMES_PER_DETAILS; // since the details were looked at
    private long shown = -1; // sequence of the snapshot
    private final DetailChanges details = new DetailChanges();
    private byte[] frame = {};
    private Snapshot seen;
    private long sequence;

    RunFeed(Numbered run) {
        this.run = run;
        surveyor = new ObjectTracker(run.number());
        seen = run.run().snapshot();
        send(run.team(seen));
    }

    private void send(List<Teammate> all) {
        team = all;
        robots = all.stream().map(mate -> mate.spec().id()).toList();
        info = Json.write(
                ServerMessage.of(Descriptions.run(run.number(), run.run().plan(), all)));
    }

    Numbered run() {
        return run;
    }

    /// Takes the newest snapshot and asks for a newer one. Details are looked at less often than frames, where
    /// these come often: else what is looked back on would have words of seconds before.
    ///
    /// @param pause until the next look, as [ViewSource#look] has it
    void look(int pause) {
        Snapshot snapshot = run.run().snapshot();
        boolean changed = snapshot.sequence() != shown;
        if (snapshot.team().size() > robots.size()) {
            send(snapshot.team());
        }
        surveyor.look(snapshot.things());
        boolean all = pauses >= FRAMES_PER_DETAILS;
        pauses = (all ? 0 : pauses) + pause;
        if (all) {
            changed |= details.take(Descriptions.details(
                    run.number(), snapshot, run.run().result().toCompletableFuture()));
        }
        if (changed) {
            shown = snapshot.sequence();
            seen = snapshot;
            frame = encoder.encode(run.number(), ++sequence, snapshot, robots, surveyor.moved());
        }
    }

    /// What the frame shows.
    Snapshot seen() {
        return seen;
    }

    /// Of the frame, since the run's start.
    Duration time() {
        return seen.time();
    }

    /// Simulated over real time, as asked for; +∞ for as fast as it can.
    double speed() {
        return seen.speed();
    }

    /// Simulated over real time, as measured.
    double rate() {
        return seen.rate();
    }

    /// Ids of the robots that are there now.
    List<String> present() {
        return seen.robots().stream().map(RobotView::id).toList();
    }

    /// Whether the run is over, and the frame its last.
    boolean isLast() {
        return seen.outcome().isPresent();
    }

    @Override
    public int number() {
        return run.number();
    }

    @Override
    public String info() {
        return info;
    }

    @Override
    public int robots() {
        return robots.size();
    }

    @Override
    public String newcomers(int known) {
        var some = team.subList(known, team.size()).stream()
                .map(AppearanceEncoder::robot)
                .toList();
        return Json.write(ServerMessage.of(new Newcomers(run.number(), some)));
    }

    @Override
    public ObjectRegistry things() {
        return surveyor.roster();
    }

    @Override
    public long detailsVersion() {
        return details.version();
    }

    @Override
    public String details(long known) {
        return details.since(known);
    }

    @Override
    public byte[] frame() {
        return frame;
    }

    @Override
    public long sequence() {
        return sequence;
    }

    @Override
    public MotorsOff motorsOff() {
        return isLast() ? MotorsOff.NONE : Descriptions.motorsOff(seen);
    }

    @Override
    public List<RunEvent> events(long after) {
        return run.run().events(after);
    }
}
