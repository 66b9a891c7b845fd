package rsal.server;

import io.javalin.config.RoutesConfig;
import io.javalin.http.Context;
import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import rsal.agent.Society;
import rsal.data.OccupancyGrid;
import rsal.data.Stamped;
import rsal.recording.Playback;
import rsal.scenario.RunPlan.PlannedAgent;
import rsal.scenario.run.AgentView;
import rsal.scenario.run.Inside;
import rsal.scenario.run.MindChange;
import rsal.server.Messages.RunInfo;

/// What can be asked about a recording over HTTP, as [Api] has it of a run. What asks for a time takes `time` in s of
/// the run; left out, it is the end.
final class ReplayApi {
    private static final String OVER = "This is a recording: what it shows is over, and can't be changed.";

    private static final Set<String> DOINGS = Set.of("agent", "fault"); // kinds of events
    private static final int MOST_OF_A_HISTORY = 100;

    private final Playback playback;
    private final RunInfo run;
    private final Gate gate;
    private final Page page;

    ReplayApi(Playback playback, RunInfo run, Gate gate, Page page) {
        this.playback = playback;
        this.run = run;
        this.gate = gate;
        this.page = page;
    }

    void configure(RoutesConfig routes) {
        Api.admit(routes, gate);
        routes.get("/api/run", request -> Api.answer(request, run));
        routes.get("/api/map/{run}", this::map);
        routes.get("/api/drawn/{run}", request -> Api.answer(request, drawn(request)));
        routes.get(
                "/api/drawn/{run}/files",
                request -> Api.answerFiles(request, String.valueOf(request.queryParam("robot")), drawn(request)));
        routes.get("/api/agent", this::agent);
        routes.get("/api/*", _ -> {
            throw new Refusal(409, "This was not recorded.");
        });
        routes.post("/api/run/*", request -> {
            gate.authorize(request.header("Authorization"));
            throw new Refusal(409, OVER);
        });
        Api.serve(routes, page);
    }

    private void map(Context request) {
        check(request);
        Api.answerPacked(request, Api.packed(FloorPlan.cells(playback.plan().scene())));
    }

    private OccupancyGrid drawn(Context request) throws IOException {
        check(request);
        String robot = String.valueOf(request.queryParam("robot"));
        return playback.at(time(request)).robots().stream()
                .filter(view -> view.id().equals(robot))
                .flatMap(view -> view.map().stream())
                .map(Stamped::value)
                .findFirst()
                .orElseThrow(() ->
                        new Refusal(404, "Robot (%s) had drawn no map by then.".formatted(Refusal.shortened(robot))));
    }

    private static void check(Context request) {
        if (!request.pathParam("run").equals(Integer.toString(RecordedPast.RUN))) {
            throw new Refusal(404, "Only what run %d had is there.".formatted(RecordedPast.RUN));
        }
    }

    /// What it was started with, showed and had in mind; conversations are among the events. Who heard what is not
    /// recorded.
    private void agent(Context request) throws IOException {
        String name = String.valueOf(request.queryParam("name"));
        PlannedAgent planned = playback.plan().agents().stream()
                .filter(agent -> agent.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new Refusal(404, "No agent (%s) was planned.".formatted(Refusal.shortened(name))));
        Duration time = time(request);
        Optional<Society.View> shown = playback.at(time).agents().stream()
                .map(AgentView::view)
                .filter(view -> view.agent().name().equals(name))
                .findFirst();
        Api.answer(
                request,
                Descriptions.inside(new Inside(
                        planned,
                        shown,
                        playback.mind(time, name),
                        Optional.empty(),
                        history(name, time),
                        Optional.empty(),
                        List.of(),
                        List.of())));
    }

    /// What it did last until then.
    private List<MindChange> history(String agent, Duration until) {
        List<MindChange> done = playback.events().stream()
                .filter(event -> event.subject().equals(agent)
                        && DOINGS.contains(event.kind())
                        && event.time().compareTo(until) <= 0)
                .map(event -> new MindChange(event.time(), MindChange.Kind.DOES, "", event.text()))
                .toList();
        return done.subList(Math.max(0, done.size() - MOST_OF_A_HISTORY), done.size());
    }

    private static Duration time(Context request) {
        String typed = Optional.ofNullable(request.queryParam("time")).orElse("1e9");
        try {
            return Past.time(Double.parseDouble(typed));
        } catch (NumberFormatException _) {
            throw new Refusal(400, "A time is a number of seconds, not (%s).".formatted(Refusal.shortened(typed)));
        }
    }
}
