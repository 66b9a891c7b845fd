package rsal.server;

import io.javalin.config.RoutesConfig;
import io.javalin.http.Context;
import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rsal.agent.platform.AgentPlatform;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.engine.report.AgentInspection;
import rsal.engine.report.AgentView;
import rsal.engine.report.Answer;
import rsal.engine.report.RobotView;
import rsal.engine.report.RunEvent;
import rsal.engine.report.SentMessage;
import rsal.engine.report.Snapshot;
import rsal.recording.Playback;
import rsal.recording.Playback.RobotPoses;
import rsal.scenario.RunPlan.PlannedAgent;
import rsal.server.description.CameraViews;
import rsal.server.description.Descriptions;
import rsal.server.description.DeviceMountings;
import rsal.server.description.FloorPlan;
import rsal.server.description.PlottableNumbers;
import rsal.server.description.ReadingWords;
import rsal.server.frame.TrailMaker;
import rsal.server.history.AgentPast;
import rsal.server.history.Past;
import rsal.server.history.RecordedNumbers;
import rsal.server.history.RecordedPast;
import rsal.server.http.AccessControl;
import rsal.server.http.Grids;
import rsal.server.http.Http;
import rsal.server.http.Page;
import rsal.server.http.PageRoutes;
import rsal.server.message.Messages.RobotInfo;
import rsal.server.message.Messages.RunInfo;
import rsal.server.message.Messages.Trails;
import rsal.server.message.Refusal;
import rsal.server.monitor.HealthRoutes;

/// What can be asked about a recording over HTTP, as [Api] has it of a run. What asks for a time takes `time` in s of
/// the run; left out, it is the end.
final class ReplayApi {
    private static final String OVER = "This is a recording, which can't be changed.";

    private final Playback playback;
    private final RunInfo run;
    private final RecordedNumbers numbers;
    private final AccessControl gate;
    private final Page page;

    ReplayApi(Playback playback, RunInfo run, AccessControl gate, Page page) {
        this.playback = playback;
        this.run = run;
        this.numbers = new RecordedNumbers(
                playback, run.robots().stream().map(RobotInfo::id).collect(Collectors.toSet()));
        this.gate = gate;
        this.page = page;
    }

    void configure(RoutesConfig routes) {
        HealthRoutes.serve(routes);
        routes.get("/api/run", request -> Http.answer(request, run));
        routes.get("/api/map/{run}", this::map);
        routes.get("/api/drawn/{run}", request -> Grids.answer(request, drawn(request)));
        routes.get(
                "/api/drawn/{run}/files",
                request -> Grids.answerFiles(request, String.valueOf(request.queryParam("robot")), drawn(request)));
        routes.get("/api/agent", this::agent);
        routes.get(
                "/api/readings",
                request ->
                        Http.answer(request, ReadingWords.of(readings(request).readings())));
        routes.get("/api/routine", this::routine);
        routes.get("/api/numbers", request -> Http.answer(request, PlottableNumbers.of(readings(request))));
        routes.get(
                "/api/numbers/past",
                request -> Http.answer(
                        request,
                        numbers.past(
                                Http.parameter(request, "robot"),
                                Http.parameter(request, "device"),
                                Http.parameter(request, "number"))));
        routes.get("/api/trails", request -> Http.answer(request, trails(request)));
        routes.get(
                "/api/links",
                request -> Http.answer(
                        request,
                        Descriptions.links(playback.at(Past.asked(request)).links())));
        routes.get(
                "/api/blobs",
                request -> Http.answer(request, CameraViews.of(readings(request).readings())));
        routes.get(
                "/api/mounts",
                request -> Http.answer(
                        request, DeviceMountings.of(readings(request).readings())));
        routes.get("/api/*", _ -> {
            throw new Refusal(409, "This was not recorded.");
        });
        routes.post("/api/run/*", request -> {
            gate.authorize(request.header("Authorization"));
            throw new Refusal(409, OVER);
        });
        PageRoutes.serve(routes, page, _ -> false);
    }

    private void map(Context request) {
        check(request);
        Http.answerPacked(request, Http.packed(FloorPlan.cells(playback.plan().scene())));
    }

    private OccupancyGrid drawn(Context request) throws IOException {
        check(request);
        String robot = String.valueOf(request.queryParam("robot"));
        return Grids.drawn(playback.at(Past.asked(request)), request)
                .orElseThrow(() ->
                        new Refusal(404, "Robot '%s' had drawn no map by then.".formatted(Refusal.shortened(robot))));
    }

    private Answer.Read readings(Context request) throws IOException {
        String robot = String.valueOf(request.queryParam("robot"));
        Snapshot then = playback.at(Past.asked(request));
        RobotView view = then.robots().stream()
                .filter(one -> one.id().equals(robot))
                .findFirst()
                .orElseThrow(
                        () -> new Refusal(404, "No robot '%s' was there then.".formatted(Refusal.shortened(robot))));
        return new Answer.Read(then.time(), view.readings());
    }

    private Trails trails(Context request) throws IOException {
        List<String> robots = run.robots().stream().map(RobotInfo::id).toList();
        var trails = new TrailMaker(robots.size());
        Duration until = Past.asked(request);
        Duration known = until.compareTo(playback.until()) < 0 ? until : playback.until();
        Duration from = known.minus(TrailMaker.SECONDS);
        for (RobotPoses then : playback.poses(from, known, TrailMaker.spacing(robots.size()))) {
            for (int i = 0; i < robots.size(); i++) {
                Pose2d pose = then.mapFromBases().get(robots.get(i));
                if (pose != null) {
                    trails.add(i, then.time().toNanos() / 1e9, pose.x(), pose.y());
                }
            }
        }
        return trails.trails();
    }

    /// What was said shortly before, but for what is among the events.
    private void routine(Context request) throws IOException {
        Duration until = Past.asked(request);
        Set<SentMessage> known = said(until)
                .filter(said -> said.time().compareTo(until.minus(Past.SHORTLY)) > 0)
                .collect(Collectors.toSet());
        var byTopic = new TreeMap<String, List<SentMessage>>();
        for (SentMessage said : playback.said(until.minus(Past.SHORTLY), until)) {
            if (said.conversation().isEmpty() && !known.contains(said)) { // an act that is said again is one event
                byTopic.computeIfAbsent(said.topic(), _ -> new ArrayList<>()).add(said);
            }
        }
        Http.answer(request, Descriptions.routine(byTopic, Http.parameter(request, "topic")));
    }

    private static void check(Context request) {
        if (!request.pathParam("run").equals(Integer.toString(RecordedPast.RUN))) {
            throw new Refusal(404, "Only what run %d had is there.".formatted(RecordedPast.RUN));
        }
    }

    /// What it was started with, showed, had in mind and talked about, and what was said to it by name: whom it reached
    /// what is said to all is not recorded.
    private void agent(Context request) throws IOException {
        String name = String.valueOf(request.queryParam("name"));
        Optional<PlannedAgent> planned = playback.plan().agents().stream()
                .filter(agent -> agent.name().equals(name))
                .findFirst();
        Duration time = Past.asked(request);
        Optional<AgentPlatform.View> shown = playback.at(time).agents().stream()
                .map(AgentView::view)
                .filter(view -> view.agent().name().equals(name))
                .findFirst();
        if (planned.isEmpty() && shown.isEmpty()) { // else somebody started it
            throw new Refusal(404, "There was no agent '%s' then.".formatted(Refusal.shortened(name)));
        }
        var past = new AgentPast(name, time, playback.events());
        Http.answer(
                request,
                Descriptions.inside(new AgentInspection(
                        name,
                        planned,
                        shown,
                        playback.mind(time, name),
                        Optional.empty(),
                        past.history(playback.changes(time, name)),
                        Optional.of(past.mail()),
                        past.talks(),
                        List.of())));
    }

    private Stream<SentMessage> said(Duration until) {
        return happened(until).flatMap(event -> event.said().stream());
    }

    private Stream<RunEvent> happened(Duration until) {
        return playback.events().stream().takeWhile(event -> event.time().compareTo(until) <= 0);
    }
}
