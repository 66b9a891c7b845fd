package rsal.server.history;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import rsal.device.SimulationControl.Standing;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunResult;
import rsal.engine.report.Snapshot;
import rsal.engine.report.Teammate;
import rsal.recording.Playback;
import rsal.server.description.AppearanceEncoder;
import rsal.server.description.Descriptions;
import rsal.server.frame.FrameEncoder;
import rsal.server.frame.Moment;
import rsal.server.frame.ObjectRegistry;
import rsal.server.frame.ObjectTracker;
import rsal.server.message.Json;
import rsal.server.message.Messages.Newcomers;
import rsal.server.message.Messages.RecordingInfo;
import rsal.server.message.Messages.RunInfo;
import rsal.server.message.Messages.ServerMessage;
import rsal.server.message.Messages.ThingInfo;

/// A recorded run, to look back on. For one thread.
public final class RecordedPast implements Past {
    public static final int RUN = 1;

    private static final CompletableFuture<RunResult> NO_RESULT = new CompletableFuture<>();

    private final Playback playback;
    private final RunInfo run;
    private final List<Teammate> team; // all that ever came
    private final List<String> robots;
    private final CompletableFuture<RunResult> result;
    private final FrameEncoder encoder = new FrameEncoder();
    private final Map<Integer, Standing> reported = new HashMap<>(); // things as viewers know them
    private Map<Integer, ThingInfo> infos = Map.of(); // of those that are there
    private ObjectRegistry roster = new ObjectRegistry(RUN, Map.of(), 0);

    /// @param name of the file, for people
    public RecordedPast(Playback playback, String name) {
        this.playback = playback;
        team = snapshot(playback.until()).team();
        robots = team.stream().map(mate -> mate.spec().id()).toList();
        result = playback.result().map(CompletableFuture::completedFuture).orElse(NO_RESULT);
        var about = new RecordingInfo(
                name,
                playback.run().getOrDefault("started", ""),
                playback.result().isPresent(),
                playback.damage());
        run = Descriptions.run(RUN, playback.plan(), team, Optional.of(about));
    }

    private Snapshot snapshot(Duration time) {
        try {
            return playback.at(time);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    public RunInfo run() {
        return run;
    }

    @Override
    public int number() {
        return RUN;
    }

    @Override
    public String info() {
        return Json.write(ServerMessage.of(run));
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
        return Json.write(ServerMessage.of(new Newcomers(RUN, some)));
    }

    @Override
    public Duration from() {
        return playback.from();
    }

    @Override
    public Duration until() {
        return playback.until();
    }

    @Override
    public boolean isRecording() {
        return true;
    }

    @Override
    public Moment at(Duration time) {
        Snapshot snapshot = snapshot(time);
        List<Standing> moved = look(snapshot.things());
        String details = Json.write(ServerMessage.of(
                Descriptions.details(RUN, snapshot, snapshot.outcome().isPresent() ? result : NO_RESULT)));
        return new Moment(snapshot.time(), roster, details, encoder.encode(RUN, 0, snapshot, robots, moved));
    }

    /// Viewers are at different times, and each thing is told to all as it was when it was seen first.
    ///
    /// @return those that are elsewhere
    private List<Standing> look(List<Standing> things) {
        var all = new LinkedHashMap<Integer, ThingInfo>();
        var moved = new ArrayList<Standing>();
        int corners = 0;
        for (Standing thing : things) {
            if (all.size() == ObjectTracker.MOST_THINGS || corners >= ObjectTracker.MOST_CORNERS) {
                break;
            }
            Standing first = reported.computeIfAbsent(thing.number(), _ -> thing);
            ThingInfo info = infos.get(thing.number());
            ThingInfo own = info == null ? AppearanceEncoder.thing(first) : info;
            all.put(thing.number(), own);
            corners += ObjectRegistry.corners(own);
            if (!thing.mapFromThing().equals(first.mapFromThing()) || thing.height() != first.height()) {
                moved.add(thing);
            }
        }
        int left = things.size() - all.size();
        if (!all.keySet().equals(infos.keySet()) || left != roster.left()) {
            infos = all;
            roster = new ObjectRegistry(RUN, all, left);
        }
        return moved;
    }

    @Override
    public Duration near(Duration time, int after) {
        return playback.states(time, after);
    }

    @Override
    public List<RunEvent> events(long sequence) {
        List<RunEvent> all = playback.events();
        return all.subList(Math.clamp(sequence, 0, all.size()), all.size());
    }
}
