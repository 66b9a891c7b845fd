package rsal.cli.run;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rsal.cli.page.PageChoices;
import rsal.cli.page.PageRuns;
import rsal.cli.show.RecordingFile;
import rsal.cli.terminal.ClosedAtExit;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.FileName;
import rsal.cli.terminal.Subcommand;
import rsal.engine.report.RunEvent;
import rsal.recording.Playback;
import rsal.recording.Recording;
import rsal.recording.Verification;
import rsal.recording.Verification.Compared;
import rsal.recording.Verification.Finding;
import rsal.scenario.RunPlan;
import rsal.scenario.text.Counted;
import rsal.server.ReplayServer;
import rsal.server.RunServer;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// `rsal replay`
@Command(
        name = "replay",
        description = {
            "Show a recorded run in a browser: play, pause, step, and go to any time.",
            "With --verify, run the scenario again and compare both runs, event by event. The scenario is taken from"
                    + " the recording. The exit code is then 0 if they are the same, 4 if they differ. They are"
                    + " compared up to the first command of a person, or the end of a recording that was cut off."
        })
public final class ReplayCommand extends Subcommand {
    @Parameters(
            converter = FileName.class,
            paramLabel = "FILE.mcap",
            description = "A recording, from 'rsal run --record'.")
    private String name = "";

    @Option(names = "--verify", description = "Run it again and compare, without a page.")
    private boolean verify;

    @Option(
            names = "--trust",
            description =
                    "With --verify: run the programs of agents in Java that are in the recording. Use it only if you"
                            + " trust the author of the recording.")
    private boolean trust;

    @Option(
            names = "--port",
            paramLabel = "P",
            converter = PageChoices.Port.class,
            description = "Port of the page, on this machine only; 0: any free port. Default: " + PageRuns.DEFAULT_PORT
                    + ", or any free port if it is in use.")
    private @Nullable Integer port;

    @Override
    protected int run() throws Exception {
        check(!verify || port == null, "With --verify there is no page, and so no --port.");
        check(verify || !trust, "--trust is for --verify: without it nothing is run.");
        check(verify || !json, "--json prints what --verify has found; add --verify.");
        return verify ? verify() : show();
    }

    /// Until a signal ends it, by an exception.
    private int show() throws Exception {
        Recording recording = RecordingFile.open(name, false);
        err().println("Reading %s (%.0f MB)".formatted(name, recording.file().size() / 1e6));
        err().flush();
        Playback playback;
        try {
            playback = Playback.of(recording);
        } catch (IOException e) {
            recording.close();
            throw new InvalidSettings(
                    Location.of(name), "This recording can't be read: %s".formatted(e.getMessage()), "");
        }
        playback.damage().forEach(damage -> err().println(name + ": " + damage));
        String file = String.valueOf(Path.of(name).getFileName());
        String token = RunServer.newToken();
        try (ReplayServer server =
                PageRuns.serve(port, (free, page) -> ReplayServer.start(playback, file, free, token, page))) {
            var _ = new ClosedAtExit(server);
            err().println("Watch it at " + server.url());
            err().println("Ctrl-C ends it.");
            err().flush();
            new CountDownLatch(1).await(); // nothing but a signal ends it
            return Exit.SUCCESS;
        }
    }

    private int verify() throws Exception {
        try (Recording recording = RecordingFile.open(name, false)) {
            if (!recording.isRepeatable()) {
                throw new InvalidSettings(
                        Location.of(name), "This run was in real time, which can't be run again.", "");
            }
            Finding finding = verified(recording);
            recording.file().damage().forEach(damage -> err().println(name + ": " + damage));
            if (json) {
                printJson(json(finding));
            } else {
                out().println(text(finding));
                out().flush();
            }
            return finding instanceof Finding.Different || isNothing(finding) ? Exit.NO_SUCCESS : Exit.SUCCESS;
        }
    }

    private Finding verified(Recording recording) throws Exception {
        RunPlan plan = recording.plan(trust);
        if (!plan.untrusted().isEmpty()) {
            throw new InvalidSettings(
                    Location.of(name),
                    "To run this again is to run programs that are in the recording: %s."
                            .formatted(String.join(", ", plan.untrusted())),
                    "Add --trust if you trust who made it.");
        }
        try {
            return Verification.begin(recording, plan).toCompletableFuture().get();
        } catch (ExecutionException e) {
            throw e.getCause() instanceof Exception cause ? cause : e;
        }
    }

    /// Whether there was nothing in the recording to compare: it may have been cut off soon after it began.
    private static boolean isNothing(Finding finding) {
        return finding instanceof Finding.Same same
                && !same.isWhole()
                && same.compared().equals(Compared.NOTHING);
    }

    private static String text(Finding finding) {
        return switch (finding) {
            case Finding.Same same
            when isNothing(same) -> "Nothing was compared: the recording ends before anything happened.";
            case Finding.Same same
            when same.isWhole() -> "The same: %s in %s s.".formatted(words(same.compared()), seconds(same.until()));
            case Finding.Same same ->
                "The same up to %s s, where the recording ends before the run did: %s."
                        .formatted(seconds(same.until()), words(same.compared()));
            case Finding.Steered steered ->
                "The same up to %s s, where a person took part: %s.%n  %s"
                        .formatted(seconds(steered.event().time()), words(steered.compared()), line(steered.event()));
            case Finding.Different different ->
                "Different from %s s on; up to %s s all is the same (%s).%n  recorded: %s%n  now:      %s"
                                .formatted(
                                        seconds(different.time()),
                                        seconds(different.equalUntil()),
                                        words(different.compared()),
                                        line(different.recorded(), different.now()),
                                        line(different.now(), different.recorded()))
                        + different.differences().stream()
                                .map("%n  %s"::formatted)
                                .collect(Collectors.joining());
        };
    }

    /// All of it: the same events may come of what is not the same.
    private static String words(Compared compared) {
        return "%s, %s and %s of all robots and agents"
                .formatted(
                        Counted.of(compared.events(), "event"),
                        Counted.of(compared.messages(), "message"),
                        Counted.of(compared.states(), "state"));
    }

    private static void put(Map<String, Object> found, Compared compared) {
        found.put("events", compared.events());
        found.put("messages", compared.messages());
        found.put("states", compared.states());
    }

    private static String line(Optional<RunEvent> event, Optional<RunEvent> other) {
        return event.map(ReplayCommand::line)
                .orElse(other.isPresent() ? "no event" : "no event; robots, beliefs or messages are not the same");
    }

    private static String line(RunEvent event) {
        String subject = event.subject().isEmpty() ? "" : event.subject() + ": ";
        return "%s s  %s, %s%s".formatted(seconds(event.time()), event.kind(), subject, event.text());
    }

    private static Map<String, Object> json(Finding finding) {
        var found = new LinkedHashMap<String, Object>();
        switch (finding) {
            case Finding.Same same -> {
                found.put("same", true);
                found.put("whole", same.isWhole());
                found.put("until", same.until().toNanos() / 1e9);
                put(found, same.compared());
            }
            case Finding.Steered steered -> {
                found.put("same", true);
                found.put("whole", false);
                found.put("until", steered.event().time().toNanos() / 1e9);
                put(found, steered.compared());
                found.put("steered", line(steered.event()));
            }
            case Finding.Different different -> {
                found.put("same", false);
                found.put("until", different.equalUntil().toNanos() / 1e9);
                put(found, different.compared());
                found.put("recorded", different.recorded().map(ReplayCommand::line));
                found.put("now", different.now().map(ReplayCommand::line));
                found.put("differences", different.differences());
            }
        }
        return found;
    }

    private static String seconds(Duration time) {
        return String.format(Locale.ROOT, "%.2f", time.toNanos() / 1e9);
    }
}
