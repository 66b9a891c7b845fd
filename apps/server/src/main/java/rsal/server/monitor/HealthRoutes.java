package rsal.server.monitor;

import io.javalin.config.RoutesConfig;
import io.javalin.http.Context;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Future;
import java.util.function.Supplier;
import rsal.engine.LiveRun;
import rsal.server.http.Http;
import rsal.server.message.Refusal;

/// Says whether the process is alive (`/healthz`) and whether its run goes on as it should (`/readyz`), as Kubernetes
/// and monitors ask for it. Asking changes nothing in a run.
public final class HealthRoutes {
    /// @param status `ok`
    public record Alive(String status) {}

    /// @param status `ready`
    /// @param run as `scenario:configuration` with its seed
    /// @param ended whether the run has ended; another one may follow it
    public record Ready(String status, String run, long seed, boolean paused, boolean ended) {}

    private HealthRoutes() {}

    /// @param current the run that is shown
    public static void serve(RoutesConfig routes, Supplier<LiveRun> current) {
        alive(routes);
        routes.get("/readyz", request -> ready(request, current.get()));
    }

    /// Of a recording, which can always be looked at.
    public static void serve(RoutesConfig routes) {
        alive(routes);
        routes.get("/readyz", request -> Http.answer(request, new Alive("ready")));
    }

    private static void alive(RoutesConfig routes) {
        routes.get("/healthz", request -> Http.answer(request, new Alive("ok")));
    }

    /// Waits for the run's thread. A run that doesn't answer, as one with an agent in an endless loop, is refused with
    /// 503 after some seconds, as all requests are.
    private static void ready(Context request, LiveRun run) {
        whatBroke(run).ifPresent(why -> {
            throw new Refusal(503, "The run broke: %s".formatted(why));
        });
        request.future(() -> run.freshSnapshot()
                .toCompletableFuture()
                .thenAccept(snapshot -> Http.answer(
                        request,
                        new Ready(
                                "ready",
                                run.plan().scenario().name() + ":" + run.plan().configuration(),
                                run.plan().seed(),
                                snapshot.paused(),
                                run.result().toCompletableFuture().isDone()))));
    }

    private static Optional<String> whatBroke(LiveRun run) {
        CompletableFuture<?> result = run.result().toCompletableFuture();
        return result.state() == Future.State.FAILED
                ? Optional.of(String.valueOf(result.exceptionNow()))
                : Optional.empty();
    }
}
