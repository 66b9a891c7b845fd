package rsal.cli.page;

import java.net.URLEncoder;
import java.net.http.HttpRequest;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import rsal.cli.terminal.Subcommand;
import rsal.cli.terminal.Unreachable;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// What asks or tells a run that has a page on this machine.
public abstract class PageCommand extends Subcommand {
    private static final Duration PATIENCE = Duration.ofSeconds(20); // where many runs go on, answers are late
    private static final Duration EMERGENCY = Duration.ofSeconds(3); // then somebody must see to the robots
    private static final String OPERATOR = "rsal-commands"; // one, as only one person can read the page's token

    @Option(
            names = "--port",
            paramLabel = "P",
            converter = PageChoices.Port.class,
            description = "Port of the run's page on this machine. Default: " + PageRuns.DEFAULT_PORT
                    + ", or the port of your only page.")
    private @Nullable Integer port;

    final int port() {
        Integer known = port;
        if (known == null) {
            known = chosen();
            port = known;
        }
        return known;
    }

    private int chosen() {
        try {
            ChosenPage chosen = ChosenPage.now();
            chosen.note().ifPresent(note -> err().println("rsal: " + note));
            return chosen.port();
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), String.valueOf(e.getMessage()), e);
        }
    }

    /// A word as part of a query.
    static String quoted(String word) {
        return URLEncoder.encode(word, StandardCharsets.UTF_8);
    }

    /// Asks for something to look at.
    ///
    /// @throws Unreachable when nobody is there, or answers in time
    /// @throws ParameterException when it is refused, with the reason
    final JsonNode ask(String path) throws InterruptedException {
        return send(page(), page().at(path));
    }

    /// Has something done, and waits until the server says that it is.
    ///
    /// @return what it says of it
    /// @throws Unreachable when nobody is there or answers in time, or it is not the same person's run
    /// @throws ParameterException when it is refused, with the reason
    final JsonNode send(String command, Object message) throws InterruptedException {
        return post("/api/run/" + command, message);
    }

    /// Whether somebody has control of the run, no matter who.
    final boolean isControlled() throws InterruptedException {
        return !ask("/api/control").path("holder").asString("").isEmpty();
    }

    /// Has control of the run from now on, for as long as the server gives it at once, also from somebody else.
    ///
    /// @throws Unreachable as [#send] does
    final void takeControl() throws InterruptedException {
        String name = "'%s' at a terminal".formatted(spec.qualifiedName());
        post("/api/control", Map.of("name", name, "over", true));
    }

    /// All may act again.
    final void giveControlBack() throws InterruptedException {
        send(page(), asOperator("/api/control").DELETE());
    }

    /// As [#send] does, of what can't wait.
    ///
    /// @return what the server says of it
    /// @throws Unreachable when nobody confirms it within 3 s
    final JsonNode printAtOnce(String command, Object message) throws InterruptedException {
        return send(new PageClient(port(), EMERGENCY), posted("/api/run/" + command, message));
    }

    private JsonNode post(String path, Object message) throws InterruptedException {
        return send(page(), posted(path, message));
    }

    private HttpRequest.Builder posted(String path, Object message) {
        return asOperator(path)
                .POST(HttpRequest.BodyPublishers.ofString(JsonMapper.shared().writeValueAsString(message)));
    }

    private HttpRequest.Builder asOperator(String path) {
        PageClient page = page();
        PageKey key = PageKey.of(page.port())
                .orElseThrow(() -> new Unreachable(
                        "There is no page of yours at '%s'. 'rsal run' prints its address; use --port P."
                                .formatted(page.address())));
        return page.at(path)
                .header("Authorization", "Bearer " + key.token())
                .header("RSAL-Operator", OPERATOR)
                .header("Content-Type", "application/json");
    }

    private PageClient page() {
        return new PageClient(port(), PATIENCE);
    }

    private JsonNode send(PageClient page, HttpRequest.Builder asked) throws InterruptedException {
        PageClient.Answer answer = page.send(asked);
        if (answer.isRefusal()) {
            throw new ParameterException(
                    spec.commandLine(),
                    answer.said()
                            .path("message")
                            .asString("'%s' refuses.".formatted(asked.build().uri())));
        }
        return answer.said();
    }
}
