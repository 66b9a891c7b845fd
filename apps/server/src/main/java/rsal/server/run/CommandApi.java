package rsal.server.run;

import io.javalin.http.Context;
import io.javalin.http.Handler;
import io.javalin.http.Header;
import java.io.IOException;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import rsal.engine.LiveRun;
import rsal.engine.Operator;
import rsal.engine.OperatorCommand;
import rsal.engine.OperatorCommands;
import rsal.engine.report.Answer;
import rsal.scenario.RunPlan;
import rsal.server.description.Answers;
import rsal.server.description.Descriptions;
import rsal.server.http.AccessControl;
import rsal.server.http.Http;
import rsal.server.http.HttpRoutes;
import rsal.server.live.CurrentRun.Numbered;
import rsal.server.message.Messages.Plan;
import rsal.server.message.Messages.Restart;
import rsal.server.message.Messages.SweepRunAgain;
import rsal.server.message.Refusal;
import rsal.server.scenario.RestartReader;
import rsal.server.scenario.ScenarioCatalog;
import rsal.server.sweep.SweepApi;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// What people tell runs: the [OperatorCommands], and to start another run. All need the token; what does not
/// stop robots needs that nobody else has control.
public final class CommandApi {
    private final RunSlots slots;
    private final ScenarioCatalog catalog;
    private final AccessControl gate;
    private final SweepApi sweeps;

    public CommandApi(RunSlots slots, ScenarioCatalog catalog, AccessControl gate, SweepApi sweeps) {
        this.slots = slots;
        this.catalog = catalog;
        this.gate = gate;
        this.sweeps = sweeps;
    }

    public void configure(HttpRoutes routes) {
        for (OperatorCommand command : OperatorCommands.ALL) {
            post(routes, "/api/run/" + command.name(), request -> execute(request, command));
        }
        post(routes, "/api/run/check", request -> {
            RunPlan plan = plan(request, Http.read(request, Restart.class, Http.MAX_TEXT));
            Http.answer(request, new Plan(Long.toString(plan.seed()), Descriptions.arguments(plan)));
        });
        post(routes, "/api/run/restart", request -> {
            checkControl(request);
            int stops = slots.stops();
            restart(request, plan(request, Http.read(request, Restart.class, Http.MAX_TEXT)), stops);
        });
        post(routes, "/api/run/watch", request -> {
            checkControl(request);
            int stops = slots.stops();
            restart(request, sweeps.plan(Http.read(request, SweepRunAgain.class)), stops);
        });
        routes.get("/api/beside", request -> Http.answer(request, slots.sideBySide()));
        post(routes, "/api/beside", request -> {
            int stops = slots.stops();
            checkControl(request);
            RunPlan plan = plan(request, Http.read(request, Restart.class, Http.MAX_TEXT));
            Http.answer(request, slots.open(plan, stops).info());
        });
        routes.delete("/api/beside/{number}", request -> {
            Http.authorize(request, gate);
            slots.close(request.pathParam("number"));
            Http.answer(request, Map.of());
        });
    }

    /// Only with the token. Answers `{}` unless told otherwise.
    private void post(HttpRoutes routes, String path, Handler handler) {
        routes.post(path, request -> {
            gate.authorize(request.header(Header.AUTHORIZATION));
            Http.answer(request, Map.of());
            Operator.tells(gate.lease().name(Http.operator(request)), () -> {
                handler.handle(request);
                return request;
            });
        });
    }

    private void checkControl(Context request) {
        gate.lease().check(Http.operator(request));
    }

    private void execute(Context request, OperatorCommand command) throws IOException {
        Arguments arguments;
        try {
            arguments = arguments(request, command);
        } catch (Refusal invalid) {
            checkControl(request); // which others must know first
            throw invalid;
        }
        if (!command.isSafe().test(arguments)) {
            checkControl(request);
        }
        Answers.whenDone(request, execute(request, command, arguments));
    }

    private CompletionStage<Answer> execute(Context request, OperatorCommand command, Arguments arguments) {
        if (command.isForAll()) {
            return slots.estop();
        }
        LiveRun run = slots.running(request);
        return Refusal.unless(() -> command.execute(run, arguments));
    }

    private static Arguments arguments(Context request, OperatorCommand command) throws IOException {
        var names = command.parameters().stream().map(Parameter::name).toList();
        Map<String, Object> given = names.isEmpty() ? Map.of() : Http.readObject(request, names);
        return Refusal.unless(() -> Arguments.of(command.parameters(), given));
    }

    /// @param stops how many emergency stops there had been when it was asked for
    private void restart(Context request, RunPlan plan, int stops) {
        sweeps.checkBeside(plan);
        slots.restart(slots.find(request), plan, stops);
        Numbered now = slots.find(request).now();
        Http.answer(request, RunApi.info(now));
    }

    /// What the wish asks for; otherwise as the run is now.
    private RunPlan plan(Context request, Restart wish) {
        LiveRun run = slots.find(request).now().run();
        if (wish.text().isPresent()) { // which may name programs
            gate.authorizeAdmin(request.header(Header.AUTHORIZATION));
        }
        return new RestartReader(catalog, run.plan(), run.snapshot().speed()).read(wish);
    }
}
