package rsal.server;

import io.javalin.config.RoutesConfig;
import io.javalin.http.Context;
import io.javalin.http.HandlerType;
import rsal.server.http.AccessControl;
import rsal.server.http.Http;
import rsal.server.http.HttpRoutes;
import rsal.server.http.Page;
import rsal.server.http.PageRoutes;
import rsal.server.monitor.Exposition;
import rsal.server.monitor.HealthRoutes;
import rsal.server.run.CommandApi;
import rsal.server.run.ControlApi;
import rsal.server.run.MapApi;
import rsal.server.run.RunApi;
import rsal.server.run.RunSlot;
import rsal.server.run.RunSlots;
import rsal.server.run.TextApi;
import rsal.server.scenario.ScenarioCatalog;
import rsal.server.sweep.SweepApi;

/// What can be asked and told over HTTP. `GET` shows, `POST` changes and needs the token. A refusal comes as
/// [rsal.server.message.Messages.Refused] with a status: 400 not understood, 401 no token, 409 not possible
/// now, 422 bad settings.
public final class Api {
    private final RunSlots slots;
    private final Page page;
    private final Exposition exposition;
    private final RunApi runs;
    private final MapApi maps;
    private final CommandApi commands;
    private final TextApi texts;
    private final SweepApi sweeps;
    private final ControlApi control;

    /// @param exposition what monitors are shown
    Api(
            RunSlots slots,
            ScenarioCatalog catalog,
            AccessControl gate,
            Page page,
            Exposition exposition,
            SweepApi sweeps) {
        this.slots = slots;
        this.page = page;
        this.exposition = exposition;
        this.runs = new RunApi(slots, catalog);
        this.maps = new MapApi(slots);
        this.commands = new CommandApi(slots, catalog, gate, sweeps);
        this.texts = new TextApi(slots, catalog, gate);
        this.sweeps = sweeps;
        this.control = new ControlApi(gate);
    }

    /// All is there for each of the runs side by side, below its address.
    void configure(RoutesConfig routes) {
        routes.before(RunSlots.BESIDE + "/*", slots::find); // also where the answer is the same for all
        configure(new HttpRoutes(routes, ""));
        configure(new HttpRoutes(routes, RunSlots.BESIDE));
        routes.get("/metrics", exposition::answer);
        HealthRoutes.serve(routes, () -> slots.first().now().run());
        routes.get(
                RunSlots.BESIDE + "/*",
                request -> PageRoutes.asset(request, page, pathIn(slots.find(request), request)));
        PageRoutes.serve(routes, page, this::isLate);
    }

    private void configure(HttpRoutes routes) {
        routes.before("/api/*", this::passOver);
        runs.configure(routes);
        maps.configure(routes);
        commands.configure(routes);
        texts.configure(routes);
        sweeps.configure(routes);
        control.configure(routes);
    }

    /// Those that ask about a run that another one has followed meanwhile are told nothing: that is no error of
    /// theirs.
    private void passOver(Context request) {
        String run = lookedAt(request);
        if (!run.isEmpty() && !slots.find(request).now().isNumber(run)) {
            request.status(204).skipRemainingHandlers();
        }
    }

    /// Whether somebody looks at a run that is over or not there any more, and could not know that yet: another one may
    /// be about to follow it.
    private boolean isLate(Context request) {
        String run = lookedAt(request);
        return !run.isEmpty()
                && slots.look(request)
                        .map(RunSlot::now)
                        .filter(now -> now.isOver() || !now.isNumber(run))
                        .isPresent();
    }

    /// The number of the run that somebody wants to see something of; empty where that is not said, and in commands.
    private static String lookedAt(Context request) {
        return request.method().equals(HandlerType.GET) ? Http.parameter(request, "run") : "";
    }

    /// What of a seat's page is asked for.
    private static String pathIn(RunSlot seat, Context request) {
        return request.path()
                .substring(RunSlots.BESIDE
                        .replace("{seat}", Integer.toString(seat.number()))
                        .length());
    }
}
