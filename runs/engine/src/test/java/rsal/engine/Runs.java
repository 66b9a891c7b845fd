package rsal.engine;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import rsal.engine.report.AgentInspection;
import rsal.engine.report.Answer;
import rsal.engine.report.ReceivedMessage;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;

/// Runs for tests: two wanderers in the office.
public final class Runs {
    static final String TWO_WANDERERS = """
            rsal: 1
            scenario: two-wanderers
            arguments:
              caughtAfter: {type: number, default: 100}
            world: {map: office}
            robots:
              prey:
                model: pioneer2dx
                pose: [-12.0, -1.0, 180]
                devices: {laser: urg04lx, localizer: {type: truthful, error: 0.2}}
              hunter:
                count: 1
                model: pioneer3at
                pose: {free: true}
            agents:
              run: {type: quitter, robot: prey, parameters: {caughtAfter: $caughtAfter, by: hunter-1, distance: 30}}
              chase: {type: wanderer, robot: hunter}
            run:
              seed: 7
              clock: {speed: max}
              stop:
                - {when: allCaught(prey), outcome: success}
                - {when: time >= 20, outcome: timeout}
            metrics:
              - {name: captureTime, from: firstTime(allCaught(prey)), unit: s}
              - {name: captureDistance, from: max(captureDistance)}
              - {name: error, from: p95(poseError), per: robot, bound: {max: 0.1}}
              - {name: way, from: distance(prey)}
            """;

    private Runs() {}

    public static RunPlan plan(Path folder, String text, RunOptions options) {
        try {
            Path file = Files.writeString(folder.resolve("scenario.yaml"), text);
            return Scenario.load(file.toString()).plan(options);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    public static void write(Path file, String text) {
        try {
            Files.writeString(file, text);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /// Runs to the end.
    public static RunResult result(RunPlan plan) {
        try (var run = LiveRun.start(plan)) {
            return result(run);
        }
    }

    public static RunResult result(LiveRun run) {
        try {
            return run.result().toCompletableFuture().get(60, TimeUnit.SECONDS);
        } catch (InterruptedException | TimeoutException e) {
            throw new AssertionError(e);
        } catch (ExecutionException e) {
            throw (RuntimeException) e.getCause();
        }
    }

    /// Completes with what is in an agent's mailbox when something of that topic is.
    static CompletableFuture<List<ReceivedMessage>> mail(LiveRun run, String agent, String topic) {
        var heard = new CompletableFuture<List<ReceivedMessage>>();
        run.onEvents(() -> run.inspector().inside(agent).thenAccept(answer -> {
            if (answer instanceof Answer.Seen(AgentInspection inside)) {
                inside.mail()
                        .filter(mail ->
                                mail.stream().anyMatch(letter -> letter.topic().equals(topic)))
                        .ifPresent(heard::complete);
            }
        }));
        run.result().thenAccept(early -> heard.completeExceptionally(new AssertionError(early.outcome())));
        return heard;
    }
}
