package rsal.cli.page;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.time.format.DateTimeParseException;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rsal.cli.terminal.Destination;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.LogLevels;
import rsal.cli.terminal.Subcommand;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Suggestion;
import rsal.time.AllowedToReadWallClock;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// `rsal logs`
@Command(
        name = "logs",
        description =
                "Show a log of 'rsal run --log FILE' or 'rsal serve --log FILE', as text or, with --json, as lines of"
                        + " JSON.")
@AllowedToReadWallClock("Waits for what is added.")
public final class LogsCommand extends Subcommand {
    private static final DateTimeFormatter TIME =
            DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm:ss.SSS").withZone(ZoneId.systemDefault());
    private static final long PERIOD_MILLIS = 200;
    private static final int MOST_NAMES = 10_000; // that are kept to suggest one

    @Parameters(paramLabel = "FILE", description = "The log.")
    private String file = "";

    @Option(
            names = {"-f", "--follow"},
            description = "Also show new entries, until Ctrl-C.")
    private boolean follow;

    @Option(
            names = "--level",
            paramLabel = "LEVEL",
            description = "Only entries of this level and more important ones: debug, info, warn, error.")
    private LogLevels.Level level = LogLevels.Level.debug;

    @Option(
            names = "--part",
            paramLabel = "PART",
            description = "Only entries of this part of the program, such as player.")
    private @Nullable String part;

    @Option(
            names = "--run",
            paramLabel = "NAME",
            description = "Only entries of runs with this text in their name, such as patrol.")
    private @Nullable String run;

    @Option(names = "--robot", paramLabel = "NAME", description = "Only entries about this robot.")
    private @Nullable String robot;

    @Option(names = "--agent", paramLabel = "NAME", description = "Only entries about this agent.")
    private @Nullable String agent;

    private final Map<String, SortedSet<String>> known = new LinkedHashMap<>(); // names in the log, by filter
    private boolean hasFound;

    @Override
    protected int run() throws IOException, InterruptedException {
        Path path = Destination.path(file);
        if (!Files.isRegularFile(path)) {
            throw new InvalidSettings(
                    Location.of(file), "There is no such file.", "'rsal run --log FILE' keeps a log.");
        }
        long read = 0;
        do {
            if (Files.exists(path)) { // it has become FILE.1, and the new one is not there yet
                read = print(path, Files.size(path) < read ? 0 : read);
                out().flush();
            }
            if (follow) {
                Thread.sleep(PERIOD_MILLIS);
            }
        } while (follow);
        if (!hasFound) {
            printNothing();
        }
        return Exit.SUCCESS;
    }

    /// An empty answer looks like a run without events: a name may be mistyped.
    ///
    /// @throws InvalidSettings when the log has nothing of a name that was asked for
    private void printNothing() {
        filters().forEach((key, wanted) -> {
            SortedSet<String> names = known.getOrDefault(key, new TreeSet<>());
            boolean isThere =
                    key.equals("run") ? names.stream().anyMatch(name -> name.contains(wanted)) : names.contains(wanted);
            if (!isThere) {
                throw new InvalidSettings(
                        Location.of(file),
                        "No entry has the %s '%s'.".formatted(key, wanted),
                        names.isEmpty() ? "No entry names a %s.".formatted(key) : Suggestion.among(wanted, names));
            }
        });
        err().println((level == LogLevels.Level.debug
                        ? "'%s' has no entry%s."
                        : "'%s' has no entry%s of level '%s' or a more important one.")
                .formatted(file, filters().isEmpty() ? "" : " that passes these filters", level));
    }

    /// What was asked for, by key of entries.
    private Map<String, String> filters() {
        var filters = new LinkedHashMap<String, String>();
        put(filters, "part", part);
        put(filters, "run", run);
        put(filters, "robot", robot);
        put(filters, "agent", agent);
        return filters;
    }

    private static void put(Map<String, String> filters, String key, @Nullable String wanted) {
        if (wanted != null) {
            filters.put(key, wanted);
        }
    }

    /// Tells what is behind a place, up to the last whole line.
    ///
    /// @return where that ends
    private long print(Path path, long from) throws IOException {
        try (var input = new RandomAccessFile(path.toFile(), "r")) {
            input.seek(from);
            long end = from;
            byte[] rest = new byte[0];
            byte[] buffer = new byte[1 << 16];
            for (int count = input.read(buffer); count > 0; count = input.read(buffer)) {
                byte[] all = Arrays.copyOf(rest, rest.length + count);
                System.arraycopy(buffer, 0, all, rest.length, count);
                int begin = 0;
                for (int i = rest.length; i < all.length; i++) {
                    if (all[i] == '\n') {
                        print(new String(all, begin, i - begin, StandardCharsets.UTF_8));
                        end += i + 1 - begin;
                        begin = i + 1;
                    }
                }
                rest = Arrays.copyOfRange(all, begin, all.length);
            }
            return end;
        }
    }

    private void print(String line) {
        JsonNode entry;
        try {
            entry = JsonMapper.shared().readTree(line);
        } catch (JacksonException e) {
            return; // not of ours, or cut where the machine lost power
        }
        if (!hasFound) {
            filters().keySet().forEach(key -> learn(key, word(entry, key)));
        }
        if (isWanted(entry)) {
            hasFound = true;
            out().println(json ? line : text(entry));
        }
    }

    private void learn(String key, String name) {
        SortedSet<String> names = known.computeIfAbsent(key, _ -> new TreeSet<>());
        if (!name.isEmpty() && names.size() < MOST_NAMES) {
            names.add(name);
        }
    }

    private boolean isWanted(JsonNode entry) {
        boolean important = Stream.of(LogLevels.Level.values())
                .filter(each -> each.name().equalsIgnoreCase(word(entry, "level")))
                .findFirst()
                .map(each -> each.compareTo(level) >= 0)
                .orElse(false);
        return important
                && (part == null || word(entry, "part").equals(part))
                && (run == null || word(entry, "run").contains(run))
                && (robot == null || word(entry, "robot").equals(robot))
                && (agent == null || word(entry, "agent").equals(agent));
    }

    /// `2026-11-29 15:10:00.123  WARN   patrol:virtual#42    12.3 s  guard-1: ran into wall`.
    private static String text(JsonNode entry) {
        String device = word(entry, "device");
        String about = Stream.of(word(entry, "agent"), word(entry, "robot") + (device.isEmpty() ? "" : "/" + device))
                .filter(name -> !name.isEmpty())
                .findFirst()
                .map(name -> name + ": ")
                .orElse("");
        String time = entry.path("simulatedSeconds").isNumber()
                ? String.format(
                        Locale.ROOT, "%8.1f s  ", entry.path("simulatedSeconds").asDouble())
                : "";
        String source =
                Optional.of(word(entry, "run")).filter(name -> !name.isEmpty()).orElseGet(() -> word(entry, "part"));
        String error = word(entry, "error");
        return Stream.of(
                                when(word(entry, "time")),
                                "%-5s".formatted(word(entry, "level")),
                                source,
                                time + about + word(entry, "message"))
                        .collect(Collectors.joining("  "))
                + (error.isEmpty() ? "" : "\n" + error.stripTrailing());
    }

    private static String when(String time) {
        try {
            return TIME.format(Instant.parse(time));
        } catch (DateTimeParseException e) {
            return time;
        }
    }

    private static String word(JsonNode entry, String key) {
        return entry.path(key).asString("");
    }
}
