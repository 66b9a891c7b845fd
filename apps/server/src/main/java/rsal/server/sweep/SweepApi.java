package rsal.server.sweep;

import io.javalin.http.Context;
import io.javalin.http.Header;
import java.util.Map;
import rsal.scenario.RunPlan;
import rsal.server.http.AccessControl;
import rsal.server.http.Http;
import rsal.server.http.HttpRoutes;
import rsal.server.live.CurrentRun;
import rsal.server.live.CurrentRun.Numbered;
import rsal.server.message.Messages.SweepRunAgain;
import rsal.server.message.Messages.SweepWish;
import rsal.server.message.Refusal;

/// Sweeps over HTTP. As everywhere, `GET` shows; all else needs the token.
public final class SweepApi {
    private static final String STYLED = "default-src 'none'; style-src 'unsafe-inline'; base-uri 'none';"
            + " form-action 'none'; frame-ancestors 'none'"; // a report carries its style

    private final CurrentRun current;
    private final Sweeps sweeps;
    private final AccessControl gate;

    /// @param current the run that sweeps may not disturb
    public SweepApi(CurrentRun current, Sweeps sweeps, AccessControl gate) {
        this.current = current;
        this.sweeps = sweeps;
        this.gate = gate;
    }

    public void configure(HttpRoutes routes) {
        routes.get("/api/sweeps", this::state);
        routes.get("/api/sweeps/runs", request -> {
            Http.answer(request, sweeps.runs(Http.parameter(request, "combination")));
        });
        routes.get("/api/sweeps/before", request -> Http.answer(request, sweeps.before()));
        routes.get("/api/sweeps/report", request -> {
            String earlier = Http.parameter(request, "sweep");
            request.header("Content-Security-Policy", STYLED);
            request.contentType("text/html; charset=utf-8")
                    .result(earlier.isEmpty() ? sweeps.report() : sweeps.reportOf(earlier));
        });
        routes.post("/api/sweeps/check", request -> {
            gate.authorize(request.header(Header.AUTHORIZATION));
            Http.answer(request, sweeps.size(Http.read(request, SweepWish.class)));
        });
        routes.post("/api/sweeps", request -> {
            Http.authorizeAdmin(request, gate);
            sweeps.begin(Http.read(request, SweepWish.class), this::checkBeside);
            state(request);
        });
        routes.post("/api/sweeps/resume", request -> {
            Http.authorizeAdmin(request, gate);
            checkBeside();
            sweeps.resume(Http.parameter(request, "sweep"));
            state(request);
        });
        routes.delete("/api/sweeps", request -> {
            Http.authorizeAdmin(request, gate);
            sweeps.stop();
            Http.answer(request, Map.of());
        });
    }

    /// A run of a sweep that is to be seen again; see [Sweeps#plan].
    public RunPlan plan(SweepRunAgain wish) {
        return sweeps.plan(wish);
    }

    /// Before another run begins.
    ///
    /// @throws Refusal when it would be disturbed
    public void checkBeside(RunPlan plan) {
        if (plan.clock() == RunPlan.Clock.WALL && sweeps.isInProgress()) {
            throw new Refusal(409, "This run is in real time, and a sweep would delay it. Stop the sweep first.");
        }
    }

    /// Before a sweep begins.
    private void checkBeside() {
        Numbered now = current.now();
        if (now.run().plan().clock() == RunPlan.Clock.WALL && !now.isOver()) {
            throw new Refusal(409, "The run is in real time, and a sweep would delay it. Stop the run first.");
        }
    }

    private void state(Context request) {
        Http.answer(request, sweeps.state());
    }
}
