package rsal.cli;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rsal.recording.Recording;
import rsal.recording.Verification;
import rsal.recording.Verification.Finding;
import rsal.scenario.run.RunEvent;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// `rsal replay`
@Command(
        name = "replay",
        description = {
            "Run a recorded run again and compare, event by event, whether it is the same.",
            "The scenario is taken from the recording. Exit codes: 0 the same, 4 different; up to where a person took"
                    + " part or the recording was cut off, where that was so."
        })
final class ReplayCommand extends Subcommand {
    @Parameters(paramLabel = "FILE.mcap", description = "A recording, from 'rsal run --record'.")
    private String name = "";

    @Option(names = "--verify", description = "Compare; without, there is nothing to do.")
    private boolean verify;

    @Override
    int run() throws Exception {
        check(verify, "Say --verify: a recording is run again and compared. To see it, open it in Foxglove.");
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
            return finding instanceof Finding.Different ? Exit.NO_SUCCESS : Exit.SUCCESS;
        }
    }

    private static Finding verified(Recording recording) throws Exception {
        try {
            return Verification.begin(recording).toCompletableFuture().get();
        } catch (ExecutionException e) {
            throw e.getCause() instanceof Exception cause ? cause : e;
        }
    }

    private static String text(Finding finding) {
        return switch (finding) {
            case Finding.Same same
            when same.isWhole() -> "The same: %d events in %s s.".formatted(same.events(), seconds(same.until()));
            case Finding.Same same ->
                "The same up to %s s, where the recording ends before the run did: %d events."
                        .formatted(seconds(same.until()), same.events());
            case Finding.Steered steered ->
                "The same up to %s s, where a person took part: %d events.%n  %s"
                        .formatted(seconds(steered.event().time()), steered.events(), line(steered.event()));
            case Finding.Different different ->
                "Different from %s s on; up to %s s all is the same (%d events).%n  recorded: %s%n  now:      %s"
                        .formatted(
                                seconds(different.time()),
                                seconds(different.equalUntil()),
                                different.events(),
                                line(different.recorded(), different.now()),
                                line(different.now(), different.recorded()));
        };
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
                found.put("events", same.events());
            }
            case Finding.Steered steered -> {
                found.put("same", true);
                found.put("whole", false);
                found.put("until", steered.event().time().toNanos() / 1e9);
                found.put("events", steered.events());
                found.put("steered", line(steered.event()));
            }
            case Finding.Different different -> {
                found.put("same", false);
                found.put("until", different.equalUntil().toNanos() / 1e9);
                found.put("events", different.events());
                found.put("recorded", different.recorded().map(ReplayCommand::line));
                found.put("now", different.now().map(ReplayCommand::line));
            }
        }
        return found;
    }

    private static String seconds(Duration time) {
        return String.format(Locale.ROOT, "%.2f", time.toNanos() / 1e9);
    }
}
