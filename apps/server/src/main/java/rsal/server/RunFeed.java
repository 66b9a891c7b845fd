package rsal.server;

import java.util.List;
import rsal.scenario.run.RunEvent;
import rsal.scenario.run.Snapshot;
import rsal.server.CurrentRun.Numbered;
import rsal.server.Messages.ServerMessage;

/// Shows a run, encoded once for all viewers. For one thread.
final class RunFeed implements Feed {
    private static final int LOOKS_PER_DETAILS = 4;

    private final Numbered run;
    private final String info;
    private final List<String> robots;
    private final FrameEncoder encoder = new FrameEncoder();
    private long looks;
    private long shown = -1; // sequence of the snapshot
    private String details = "";
    private byte[] frame = {};
    private long sequence;

    RunFeed(Numbered run) {
        this.run = run;
        info = Json.write(
                ServerMessage.of(Descriptions.run(run.number(), run.run().plan())));
        robots = run.run().plan().robots().stream()
                .map(robot -> robot.spec().id())
                .toList();
    }

    Numbered run() {
        return run;
    }

    /// Takes the newest snapshot and asks for a newer one. Details are looked at less often than frames.
    void look() {
        Snapshot snapshot = run.run().snapshot();
        boolean changed = snapshot.sequence() != shown;
        if (looks++ % LOOKS_PER_DETAILS == 0) {
            String before = details;
            details = Json.write(ServerMessage.of(Descriptions.details(
                    run.number(), snapshot, run.run().result().toCompletableFuture())));
            changed |= !details.equals(before);
        }
        if (changed) {
            shown = snapshot.sequence();
            frame = encoder.encode(run.number(), ++sequence, snapshot, robots);
        }
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
    public String details() {
        return details;
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
    public List<RunEvent> events(long after) {
        return run.run().events(after);
    }
}
