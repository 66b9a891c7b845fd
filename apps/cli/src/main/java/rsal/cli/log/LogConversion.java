package rsal.cli.log;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import rsal.cli.terminal.Destination;
import rsal.cli.terminal.Unreachable;
import rsal.navigation.log.LaserHints;
import rsal.navigation.log.LogFormats;
import rsal.navigation.log.LogWriter;
import rsal.navigation.log.RobotLog;
import rsal.scenario.text.Counted;

/// A robot's log in another format. Which formats can be written, [LogFormats] knows.
public final class LogConversion implements Conversion {
    /// @param scans that were written
    /// @param motions messages of odometry that were written
    /// @param leftOut scans that could not be
    record Converted(String file, String written, int scans, int motions, int leftOut) {}

    @Override
    public String description() {
        return "logs of robots, to "
                + LogFormats.writers().stream()
                        .map(LogWriter::description)
                        .reduce((one, other) -> one + " or " + other)
                        .orElse("nothing");
    }

    @Override
    public boolean accepts(String file, Optional<String> out) {
        boolean isOther = new WorldConversion().accepts(file, out) || new ModelConversion().accepts(file, out);
        return !isOther && out.flatMap(LogConversion::writer).isPresent();
    }

    private static Optional<LogWriter> writer(String out) {
        return LogFormats.writers().stream()
                .filter(writer -> writer.accepts(out))
                .findFirst();
    }

    @Override
    public Result convert(Request request) {
        String out = request.out().orElseThrow();
        Path target = Destination.path(out);
        ConvertedFiles.requireFolder(target);
        RobotLog log = LogOptions.read(request.file(), LaserHints.DEFAULT);
        LogWriter.Written written = write(writer(out).orElseThrow(), log, target, request.force());
        var lines = new ArrayList<String>();
        lines.add("%s: %s, %s"
                .formatted(
                        target,
                        Counted.of(written.scans(), "scan"),
                        Counted.of(written.motions(), "message") + " of odometry"));
        var notes = new StringWriter();
        LogOptions.printSkipped(new PrintWriter(notes, true), request.file(), log);
        LogOptions.printOddities(new PrintWriter(notes, true), request.file(), log);
        if (written.leftOut() > 0) {
            lines.add(
                    "Left out: %s without odometry before and after.".formatted(Counted.of(written.leftOut(), "scan")));
        }
        return new Result(
                new Converted(request.file(), target.toString(), written.scans(), written.motions(), written.leftOut()),
                lines,
                notes.toString().lines().toList());
    }

    /// What was half written is deleted, unless it has taken the place of something else.
    private static LogWriter.Written write(LogWriter writer, RobotLog log, Path target, boolean force) {
        boolean isNew = !Files.exists(target);
        try {
            return writer.write(log, target, force);
        } catch (FileAlreadyExistsException _) {
            throw ConvertedFiles.isThere(target);
        } catch (IOException | RuntimeException e) {
            if (isNew) {
                delete(target);
            }
            if (e instanceof RuntimeException error) {
                throw error;
            }
            throw new Unreachable("It can't be written: %s.".formatted(e));
        }
    }

    private static void delete(Path target) {
        try {
            if (Files.isDirectory(target)) {
                List<Path> inside;
                try (Stream<Path> files = Files.list(target)) {
                    inside = files.toList();
                }
                for (Path file : inside) {
                    Files.delete(file);
                }
            }
            Files.deleteIfExists(target);
        } catch (IOException _) {
            // there is nothing better to do
        }
    }
}
