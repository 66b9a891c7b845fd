package rsal.server.run;

import io.javalin.http.Context;
import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import rsal.data.OccupancyGrid;
import rsal.server.history.Past;
import rsal.server.http.Grids;
import rsal.server.http.Http;
import rsal.server.http.HttpRoutes;
import rsal.server.live.CurrentRun.Numbered;
import rsal.server.message.Refusal;

/// The map of a run, and the maps that its robots draw.
public final class MapApi {
    private final RunSlots slots;

    public MapApi(RunSlots slots) {
        this.slots = slots;
    }

    public void configure(HttpRoutes routes) {
        routes.get("/api/map/{run}", this::map);
        routes.get("/api/drawn/{run}", this::drawn);
        routes.get("/api/drawn/{run}/files", this::drawnFiles);
    }

    private void map(Context request) {
        RunSlot seat = slots.find(request);
        Numbered now = seat.now();
        String run = request.pathParam("run");
        if (wasBefore(run, now)) {
            request.status(204);
        } else if (now.isNumber(run)) {
            Http.answerPacked(request, seat.floor(now));
        } else {
            throw new Refusal(404, "Only the map of run %d is there.".formatted(now.number()));
        }
    }

    /// A map that a robot has drawn; see [rsal.server.message.Messages.DrawnMap].
    private void drawn(Context request) {
        if (wasBefore(request.pathParam("run"), slots.find(request).now())) {
            request.status(204);
        } else {
            Grids.answer(request, drawn(request, String.valueOf(request.queryParam("robot"))));
        }
    }

    /// The same as files that ROS and scenarios read, to be saved.
    private void drawnFiles(Context request) throws IOException {
        String robot = String.valueOf(request.queryParam("robot"));
        Grids.answerFiles(request, robot, drawn(request, robot));
    }

    private OccupancyGrid drawn(Context request, String robot) {
        RunSlot seat = slots.find(request);
        Numbered now = seat.now();
        Optional<Duration> time = Past.askedBack(request);
        Optional<OccupancyGrid> drawn = time.isPresent()
                ? seat.recollection().map(robot, Http.parameter(request, "device"), time.get())
                : Grids.drawn(now.run().snapshot(), request);
        return drawn.filter(_ -> now.isNumber(request.pathParam("run")))
                .orElseThrow(() -> new Refusal(
                        404, "Robot '%s' has drawn no map in this run.".formatted(Refusal.shortened(robot))));
    }

    /// Whether a number is that of a run that another one has followed, which who asks about it could not know.
    private static boolean wasBefore(String run, Numbered now) {
        return run.matches("[1-9]\\d{0,8}") && Integer.parseInt(run) < now.number();
    }
}
