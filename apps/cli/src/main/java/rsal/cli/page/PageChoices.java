package rsal.cli.page;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;
import rsal.cli.terminal.CommandWords;
import rsal.cli.terminal.Destination;
import rsal.cli.terminal.FileName;
import rsal.cli.terminal.LogLevels;
import rsal.cli.terminal.Logging;
import rsal.foxglove.FoxgloveServer;

/// Who looks on: the page's port, a recording, Foxglove. Options of commands that run scenarios.
public final class PageChoices {
    private static final String STDERR = "-";

    @Option(
            names = "--port",
            paramLabel = "P",
            converter = Port.class,
            description = "Port of the page, on this machine only; 0: any free port. Default: " + PageRuns.DEFAULT_PORT
                    + ", or any free port if it is in use.")
    private @Nullable Integer port;

    @Option(
            names = "--frames",
            description = "Let pages of other programs on this machine, such as Jupyter, show the page in frames.")
    private boolean frames;

    @Option(
            names = "--record",
            paramLabel = "FILE.mcap",
            description = "Record the run, for Foxglove, 'rsal replay' and 'rsal export'. Further runs from the page"
                    + " are written to FILE-2.mcap and so on.")
    private @Nullable String record;

    @Option(
            names = "--record-ros2",
            paramLabel = "FOLDER",
            converter = FileName.class,
            description = "Record the readings of sensors as a bag of ROS 2, for 'ros2 bag', RViz and Foxglove."
                    + " Further runs from the page go to FOLDER-2 and so on.")
    private @Nullable String recordRos2;

    @Option(
            names = "--foxglove",
            description = "Let Foxglove on this machine watch the run, and publish goals and poses. The address of"
                    + " the connection is printed first.")
    private boolean foxglove;

    @Option(
            names = "--foxglove-port",
            paramLabel = "P",
            converter = Port.class,
            description = "Port for Foxglove; 0: any free port. Default: " + FoxgloveServer.PORT + ".")
    private @Nullable Integer foxglovePort;

    @Option(
            names = "--sweeps",
            paramLabel = "DIR",
            defaultValue = "sweeps",
            description = "Folder for sweeps that are started in the page, each in its own folder. Default:"
                    + " ${DEFAULT-VALUE}.")
    private String sweeps = "";

    @Option(
            names = "--log",
            paramLabel = "FILE",
            description =
                    "Write a log as lines of JSON, for 'rsal logs'. At 10 MB the file becomes FILE.1, up to FILE.5."
                            + " '-' writes the lines to stderr, for containers. Default: the file that RSAL_LOG"
                            + " names, if any.")
    private @Nullable String log;

    @Option(
            names = "--log-level",
            paramLabel = "LEVEL",
            converter = LogLevels.Converter.class,
            defaultValue = "info",
            description = "Lowest level of the log: debug (also messages of agents), info, warn or error. Parts of the"
                    + " program can have their own levels: 'info,player=debug'. Default: ${DEFAULT-VALUE}.")
    private @Nullable LogLevels logLevels;

    @Mixin
    private NetworkChoices network = new NetworkChoices();

    public Path sweeps() {
        return Destination.path(sweeps);
    }

    /// @param line for errors in options
    public PageRuns.Endpoints endpoints(CommandLine line) {
        return new PageRuns.Endpoints(port, network.listening(line), frames);
    }

    /// @param command as it was typed
    public Onlookers onlookers(boolean force, boolean headless, String command, PrintWriter err) throws IOException {
        Optional<String> logged = Optional.ofNullable(log)
                .or(() -> Optional.ofNullable(System.getenv("RSAL_LOG")))
                .filter(name -> !name.isEmpty());
        logged.ifPresent(this::keepLog);
        return new Onlookers(
                RunRecorder.to(Optional.ofNullable(record), force, headless, err),
                new RobotRecordings("ros2", Optional.ofNullable(recordRos2), force, err),
                foxglove || foxglovePort != null
                        ? Optional.of(
                                Onlookers.foxglove(foxglovePort == null ? FoxgloveServer.PORT : foxglovePort, err))
                        : Optional.empty(),
                logged.isPresent(),
                command);
    }

    private void keepLog(String file) {
        LogLevels levels = Objects.requireNonNull(logLevels);
        if (file.equals(STDERR)) {
            Logging.printAsJson(levels);
        } else {
            Logging.keep(Destination.path(file), levels);
        }
    }

    public static final class Port implements ITypeConverter<Integer> {
        private static final int MOST = 65535;

        @Override
        public Integer convert(String typed) {
            double port = CommandWords.orNaN(typed);
            if (!(port >= 0 && port <= MOST && port == Math.rint(port))) {
                throw new TypeConversionException(
                        "'%s' is not a port from 0 to %d, like %d.".formatted(typed, MOST, PageRuns.DEFAULT_PORT));
            }
            return (int) port;
        }
    }
}
