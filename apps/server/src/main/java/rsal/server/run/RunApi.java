package rsal.server.run;

import io.javalin.http.Context;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.UnaryOperator;
import rsal.engine.LiveRun;
import rsal.engine.RunOperator;
import rsal.engine.report.Answer;
import rsal.model.RobotModels;
import rsal.server.description.Answers;
import rsal.server.description.CameraViews;
import rsal.server.description.Descriptions;
import rsal.server.description.DeviceMountings;
import rsal.server.description.PlottableNumbers;
import rsal.server.history.Past;
import rsal.server.history.Recollection;
import rsal.server.http.Http;
import rsal.server.http.HttpRoutes;
import rsal.server.live.CurrentRun.Numbered;
import rsal.server.message.Messages.RunInfo;
import rsal.server.scenario.ScenarioCatalog;

/// What can be asked about a run, its robots and its agents.
public final class RunApi {
    private final RunSlots slots;
    private final ScenarioCatalog catalog;

    public RunApi(RunSlots slots, ScenarioCatalog catalog) {
        this.slots = slots;
        this.catalog = catalog;
    }

    public void configure(HttpRoutes routes) {
        routes.get(
                "/api/run",
                request -> Http.answer(request, info(slots.find(request).now())));
        routes.get("/api/scenarios", request -> Http.answer(request, catalog.all()));
        routes.get("/api/scenarios/picture", request -> {
            request.contentType("image/png").result(catalog.picture(Http.parameter(request, "scenario")));
        });
        routes.get("/api/status", this::status);
        routes.get("/api/abilities", request -> {
            Answers.whenDone(request, slots.running(request).inspector().abilities(Http.parameter(request, "robot")));
        });
        routes.get("/api/readings", request -> {
            Answers.whenDone(request, readings(request));
        });
        routes.get("/api/numbers", request -> {
            slots.find(request).numbers().want(Http.parameter(request, "robot"));
            Answers.whenDone(request, readings(request), PlottableNumbers::of);
        });
        routes.get("/api/numbers/past", request -> {
            Http.answer(
                    request,
                    slots.find(request)
                            .numbers()
                            .past(
                                    Http.parameter(request, "robot"),
                                    Http.parameter(request, "device"),
                                    Http.parameter(request, "number")));
        });
        routes.get(
                "/api/trails",
                request -> Http.answer(request, slots.find(request).trails(Past.asked(request))));
        routes.get(
                "/api/communication",
                request ->
                        Answers.whenDone(request, slots.run(request).inspector().communication()));
        routes.get("/api/links", request -> {
            Answers.whenDone(request, links(request));
        });
        routes.get("/api/blobs", request -> {
            Answers.whenDone(request, readings(request), reported -> CameraViews.of(reported.readings()));
        });
        routes.get("/api/mounts", request -> {
            Answers.whenDone(request, readings(request), reported -> DeviceMountings.of(reported.readings()));
        });
        routes.get("/api/costs", request -> {
            Answers.whenDone(request, slots.running(request).inspector().costs(Http.parameter(request, "robot")));
        });
        routes.get("/api/sayable", request -> Http.answer(request, Descriptions.sayable(RunOperator.sayable())));
        routes.get(
                "/api/topics",
                request ->
                        Answers.whenDone(request, slots.run(request).inspector().topics()));
        routes.get("/api/routine", request -> Answers.whenDone(request, routine(request)));
        routes.get("/api/agent", request -> Answers.whenDone(request, inside(request)));
        routes.get(
                "/api/robots/models",
                request -> Http.answer(request, Descriptions.robotModels(RobotModels.readBuiltIn())));
        routes.get(
                "/api/agents/types",
                request -> Http.answer(request, Descriptions.agentTypes(RunOperator.agentTypes())));
    }

    private void status(Context request) {
        Numbered now = slots.find(request).now();
        request.future(() -> now.run()
                .freshSnapshot()
                .toCompletableFuture()
                .thenAccept(snapshot -> Http.answer(request, Descriptions.status(now.number(), now.run(), snapshot))));
    }

    /// What devices of a robot have told last; at another time than now when that is asked for.
    private CompletionStage<Answer> readings(Context request) {
        String robot = Http.parameter(request, "robot");
        return Past.askedBack(request)
                .<CompletionStage<Answer>>map(time -> CompletableFuture.completedStage(
                        slots.find(request).recollection().readings(robot, time)))
                .orElseGet(() -> slots.run(request).inspector().readings(robot));
    }

    /// Who hears whom; at another time than now when that is asked for.
    private CompletionStage<Answer> links(Context request) {
        return Past.askedBack(request)
                .<CompletionStage<Answer>>map(time -> CompletableFuture.completedStage(
                        slots.find(request).recollection().links(time)))
                .orElseGet(() -> slots.running(request).inspector().links(Http.parameter(request, "robot")));
    }

    /// What an agent has in mind; at another time than now when that is asked for.
    private CompletionStage<Answer> inside(Context request) {
        String name = Http.parameter(request, "name");
        LiveRun run = slots.run(request);
        Recollection recollection = slots.find(request).recollection();
        recollection.want(name);
        CompletionStage<Answer> now = run.inspector().inside(name);
        return Past.askedBack(request)
                .map(time -> later(
                        now,
                        answer -> answer instanceof Answer.Seen(var agent)
                                ? new Answer.Seen(recollection.inside(agent, time, run.events(0)))
                                : answer))
                .orElse(now);
    }

    /// What agents say all the time; what they said shortly before another time than now when that is asked
    /// for.
    private CompletionStage<Answer> routine(Context request) {
        String topic = Http.parameter(request, "topic");
        return Past.askedBack(request)
                .map(time -> slots.run(request).inspector().routine(topic, time, Past.SHORTLY))
                .orElseGet(() -> slots.run(request).inspector().routine(topic));
    }

    /// Not on the run's thread, which has better to do.
    private static CompletionStage<Answer> later(CompletionStage<Answer> stage, UnaryOperator<Answer> reported) {
        return stage.thenApplyAsync(reported, Thread::startVirtualThread);
    }

    static RunInfo info(Numbered now) {
        return Descriptions.run(
                now.number(), now.run().plan(), now.team(now.run().snapshot()));
    }
}
