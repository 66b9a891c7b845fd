package rsal.server.run;

import io.javalin.http.Context;
import io.javalin.http.Header;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Semaphore;
import rsal.scenario.Scenario;
import rsal.scenario.ScenarioSchema;
import rsal.server.description.Descriptions;
import rsal.server.http.AccessControl;
import rsal.server.http.Http;
import rsal.server.http.HttpRoutes;
import rsal.server.message.Messages.ConfigurationInfo;
import rsal.server.message.Messages.TextCheck;
import rsal.server.message.Messages.TextError;
import rsal.server.message.Messages.TextToCheck;
import rsal.server.message.Messages.TextToSave;
import rsal.server.message.Refusal;
import rsal.server.scenario.ScenarioCatalog;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;

/// Reads, checks and saves the texts of scenarios. As all else: everybody who can reach the port may look, and
/// what makes the server work or changes a file takes the token.
public final class TextApi {
    private static final int MOST_MISTAKES = 100; // nobody mends more at once
    private static final int MOST_CHECKS = 2; // one under way, and one that waits

    private final RunSlots seats;
    private final ScenarioCatalog catalog;
    private final AccessControl gate;
    private final Semaphore checks = new Semaphore(MOST_CHECKS);

    public TextApi(RunSlots seats, ScenarioCatalog catalog, AccessControl gate) {
        this.seats = seats;
        this.catalog = catalog;
        this.gate = gate;
    }

    public void configure(HttpRoutes routes) {
        routes.get(
                "/api/scenarios/schema",
                request -> request.contentType("application/schema+json").result(ScenarioSchema.json()));
        routes.get("/api/scenarios/text", request -> {
            String id = request.queryParam("scenario");
            Http.answer(request, id == null ? catalog.text(present(request)) : catalog.text(id));
        });
        routes.post("/api/scenarios/check", request -> {
            gate.authorizeAdmin(request.header(Header.AUTHORIZATION));
            TextToCheck wish = Http.read(request, TextToCheck.class, Http.MAX_TEXT);
            if (!checks.tryAcquire()) { // or they would keep busy all threads that answer, also for an emergency stop
                throw new Refusal(409, "Other texts are being checked. Try again in a moment.");
            }
            try {
                Http.answer(request, check(wish, present(request)));
            } finally {
                checks.release();
            }
        });
        routes.put("/api/scenarios/text", request -> {
            Http.authorizeAdmin(request, gate);
            TextToSave wish = Http.read(request, TextToSave.class, 2 * Http.MAX_TEXT);
            catalog.save(wish.scenario(), wish.before(), wish.text());
            Http.answer(request, Map.of());
        });
    }

    private Scenario present(Context request) {
        return seats.find(request).now().run().plan().scenario();
    }

    /// One at a time: each plans whole runs.
    private synchronized TextCheck check(TextToCheck wish, Scenario present) {
        List<ConfigurationInfo> configurations = List.of();
        try {
            Scenario scenario = catalog.edited(wish.scenario(), wish.text(), present);
            configurations = Descriptions.configurations(scenario);
            scenario.check();
            return new TextCheck(configurations, List.of());
        } catch (InvalidSettings e) {
            List<TextError> errors = e.problems().stream()
                    .limit(MOST_MISTAKES)
                    .map(TextApi::error)
                    .toList();
            return new TextCheck(configurations, errors);
        }
    }

    private static TextError error(Problem problem) {
        var at = problem.location();
        return new TextError(at.file(), at.line(), at.column(), problem.message(), problem.remedy());
    }
}
