package rsal.cli.log;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import rsal.cli.show.RecordingFile;
import rsal.cli.terminal.Destination;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.FileName;
import rsal.cli.terminal.LifeSigns;
import rsal.cli.terminal.Subcommand;
import rsal.cli.terminal.Unreachable;
import rsal.recording.CsvExport;
import rsal.recording.Playback;
import rsal.recording.Recording;
import rsal.recording.animation.RunAnimation;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.time.AllowedToReadWallClock;

/// `rsal export`
@Command(
        name = "export",
        description = {
            "Write a recording as tables, one per topic ('/r1/scan' to 'r1.scan.csv'), or as an animated GIF that"
                    + " shows the run from above.",
            "Columns are fields of the messages. docs/reference/recordings.md explains them, with units."
        },
        footer = {
            "",
            "  rsal run hunt-and-prey --headless --speed max --record hunt.mcap",
            "  rsal export hunt.mcap --csv tables",
            "  rsal export hunt.mcap --csv tables --topic /state --topic /hunter-1/scan",
            "  rsal export hunt.mcap --gif hunt.gif --speed 4",
            ""
        })
@AllowedToReadWallClock("Prints now and then how much of an animation is drawn.")
public final class ExportCommand extends Subcommand {
    @Parameters(
            converter = FileName.class,
            paramLabel = "FILE.mcap",
            description = "A recording, from 'rsal run --record'.")
    private String name = "";

    @ArgGroup(multiplicity = "1")
    @SuppressWarnings("NullAway.Init") // picocli fills it in
    private Format format;

    @Option(names = "--force", description = "Overwrite existing files.")
    private boolean force;

    @Option(
            names = "--topic",
            paramLabel = "TOPIC",
            description = "Write only the table of this topic, such as '/r1/scan'. May be repeated.")
    private List<String> topics = List.of();

    @Option(names = "--size", paramLabel = "PX", description = "Longer side of the animation [pixels] (800).")
    private int size = 800;

    @Option(
            names = "--speed",
            paramLabel = "FACTOR",
            description = "Simulated seconds that the animation shows per second (4).")
    private double speed = 4;

    @Option(names = "--fps", paramLabel = "N", description = "Frames per second of the animation, 1 to 50 (10).")
    private double fps = 10;

    @Option(names = "--from", paramLabel = "S", description = "Time of the run at which the animation begins [s] (0).")
    private double from;

    @Option(
            names = "--until",
            paramLabel = "S",
            description = "Time of the run at which the animation ends [s]. Default: the end of the recording.")
    private double until = 1e9;

    static final class Format {
        @Option(names = "--csv", required = true, paramLabel = "DIR", description = "Folder for the tables.")
        @Nullable
        String folder;

        @Option(names = "--gif", required = true, paramLabel = "FILE.gif", description = "File for the animation.")
        @Nullable
        String animation;
    }

    @Override
    protected int run() {
        return format.folder == null ? animate(String.valueOf(format.animation)) : tables(format.folder);
    }

    private int tables(String folder) {
        try (Recording recording = RecordingFile.open(name, false)) {
            var export = new CsvExport(recording.file());
            keepTopics(export);
            Destination.of(folder, export.names(), force).prepare();
            try {
                List<Path> written = export.write(Destination.path(folder));
                recording.file().damage().forEach(damage -> err().println(name + ": " + damage));
                report(written.stream().map(Path::toString).toList());
            } catch (IOException e) {
                throw new Unreachable("The tables can't be written to '%s': %s.".formatted(folder, e.getMessage()));
            }
            return Exit.SUCCESS;
        } catch (IOException e) {
            throw new Unreachable("The recording '%s' can't be closed: %s.".formatted(name, e.getMessage()));
        }
    }

    private void keepTopics(CsvExport export) {
        if (topics.isEmpty()) {
            return;
        }
        for (String topic : topics) {
            if (!export.topics().contains(topic)) {
                throw new InvalidSettings(
                        Location.of(name),
                        "There is no table of the topic '%s'.".formatted(topic),
                        "Tables are of: %s.".formatted(String.join(", ", export.topics())));
            }
        }
        export.keep(topics);
    }

    private int animate(String gif) {
        check(topics.isEmpty(), "--topic is for --csv: an animation shows the whole run.");
        check(gif.endsWith(".gif"), "--gif '%s' must end with .gif.".formatted(gif));
        RunAnimation.Settings settings = settings();
        Path file = Destination.path(gif).toAbsolutePath();
        String fileName = String.valueOf(file.getFileName());
        Destination target = Destination.of(String.valueOf(file.getParent()), List.of(fileName), force)
                .prepareExisting();
        try (Playback playback = Playback.of(RecordingFile.open(name, false))) {
            playback.damage().forEach(damage -> err().println(name + ": " + damage));
            RunAnimation animation = animation(playback, settings);
            var signs = new LifeSigns();
            long begun = System.nanoTime();
            byte[] bytes = animation.gif(done -> {
                if (signs.isDue(System.nanoTime() - begun)) {
                    err().printf("%s: %.0f %% of %d pictures%n", gif, 100 * done, animation.frames());
                    err().flush();
                }
            });
            target.write(Map.of(fileName, bytes));
            report(List.of(gif));
            return Exit.SUCCESS;
        } catch (IOException e) {
            throw new Unreachable("The recording '%s' can't be drawn: %s.".formatted(name, e.getMessage()));
        }
    }

    private RunAnimation.Settings settings() {
        check(from >= 0 && from < 1e9, "--from must be from 0 to 1000000000 s, not '%s'.".formatted(from));
        check(until > 0 && until <= 1e9, "--until must be more than 0 s, not '%s'.".formatted(until));
        try {
            return new RunAnimation.Settings(
                    size,
                    speed,
                    fps,
                    Duration.ofMillis(Math.round(1e3 * from)),
                    Duration.ofMillis(Math.round(1e3 * until)));
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), String.valueOf(e.getMessage()));
        }
    }

    private RunAnimation animation(Playback playback, RunAnimation.Settings settings) {
        try {
            return new RunAnimation(playback, settings);
        } catch (IllegalArgumentException e) {
            throw new InvalidSettings(Location.of(name), String.valueOf(e.getMessage()), "");
        }
    }

    private void report(List<String> files) {
        if (json) {
            printJson(Map.of("files", files));
        } else {
            files.forEach(out()::println);
            out().flush();
        }
    }
}
