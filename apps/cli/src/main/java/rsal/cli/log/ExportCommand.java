package rsal.cli.log;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rsal.cli.show.RecordingFile;
import rsal.cli.terminal.Destination;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.Subcommand;
import rsal.cli.terminal.Unreachable;
import rsal.recording.CsvExport;
import rsal.recording.Recording;

/// `rsal export`
@Command(
        name = "export",
        description = {
            "Write a recording as tables, one for each topic: '/r1/scan' to 'r1.scan.csv'.",
            "Columns are fields of the messages; what they mean, and units, is in docs/reference/recordings.md."
        })
public final class ExportCommand extends Subcommand {
    @Parameters(paramLabel = "FILE.mcap", description = "A recording, from 'rsal run --record'.")
    private String name = "";

    @Option(names = "--csv", required = true, paramLabel = "DIR", description = "The folder to write to.")
    private String folder = "";

    @Option(names = "--force", description = "Overwrite files that are there.")
    private boolean force;

    @Override
    protected int run() {
        try (Recording recording = RecordingFile.open(name, false)) {
            var export = new CsvExport(recording.file());
            Destination.of(folder, export.names(), force).prepare();
            try {
                List<Path> written = export.write(Destination.path(folder));
                recording.file().damage().forEach(damage -> err().println(name + ": " + damage));
                if (json) {
                    printJson(
                            Map.of("files", written.stream().map(Path::toString).toList()));
                } else {
                    written.forEach(out()::println);
                    out().flush();
                }
            } catch (IOException e) {
                throw new Unreachable("The tables can't be written to '%s': %s.".formatted(folder, e.getMessage()));
            }
            return Exit.SUCCESS;
        } catch (IOException e) {
            throw new Unreachable("The recording '%s' can't be closed: %s.".formatted(name, e.getMessage()));
        }
    }
}
