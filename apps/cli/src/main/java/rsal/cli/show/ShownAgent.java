package rsal.cli.show;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import rsal.agent.AgentLanguage;
import rsal.agent.AgentOutline;
import rsal.agent.AgentType;
import rsal.cli.terminal.TextTable;
import rsal.scenario.installed.Providers;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// An agent that its author wrote in a file, in Java, Python or AgentSpeak, for `rsal show`.
///
/// @param needs types of devices that its robot must have
/// @param hears names of topics
public record ShownAgent(
        String file,
        String description,
        List<String> needs,
        List<InstalledKind.Setting> settings,
        List<Line> goals,
        List<Line> plans,
        List<String> hears,
        List<Line> says) {

    /// Of a program, which nobody can see into.
    private static final AgentOutline UNKNOWN = new AgentOutline(List.of(), List.of(), List.of(), List.of());

    record Line(String file, int line, String text) {
        static List<Line> of(List<AgentOutline.Line> lines) {
            return lines.stream()
                    .map(line -> new Line(line.at().file(), line.at().line(), line.text()))
                    .toList();
        }
    }

    /// @param path of a file
    /// @return empty when its name is that of none
    /// @throws InvalidSettings with the errors in it, or when it can't be read
    static Optional<ShownAgent> of(String path) {
        return language(path).map(language -> of(path, language));
    }

    /// Whether a file is called like the program of an agent.
    public static boolean is(String path) {
        return language(path).isPresent();
    }

    private static Optional<AgentLanguage> language(String path) {
        return Providers.byKey(AgentLanguage.class, AgentLanguage::suffix).values().stream()
                .filter(language -> language.reads(path))
                .findFirst();
    }

    private static ShownAgent of(String path, AgentLanguage language) {
        AgentType type = language.read(name(path), FileSource.folder(folder(path)), Location.of(path));
        InstalledKind kind = InstalledKind.of(type);
        AgentOutline outline = type.outline().orElse(UNKNOWN);
        return new ShownAgent(
                path,
                kind.description(),
                kind.needs(),
                kind.settings(),
                Line.of(outline.goals()),
                Line.of(outline.plans()),
                outline.hears(),
                Line.of(outline.says()));
    }

    /// Of a file.
    static String name(String path) {
        return path.substring(path.lastIndexOf('/') + 1);
    }

    /// In which a file is.
    static Path folder(String path) {
        try {
            return Path.of(path).toAbsolutePath().resolveSibling(".").normalize();
        } catch (InvalidPathException e) {
            throw new InvalidSettings(Location.of(path), "This can't be a file: %s.".formatted(e.getReason()), "");
        }
    }

    /// For people.
    String text() {
        var text = new StringBuilder("%s: an agent%n".formatted(file));
        if (!description.isEmpty()) {
            text.append(description).append('\n');
        }
        if (!needs.isEmpty()) {
            text.append("Needs a robot with ").append(String.join(", ", needs)).append(".\n");
        }
        var settable = new TextTable("  ");
        settings.forEach(setting -> settable.row(
                setting.name(),
                setting.value().map(Object::toString).orElse(""),
                setting.expected(),
                setting.description()));
        section(text, "Parameters (agents: {NAME: {type: %s, parameters: {…}}})".formatted(name(file)), settable);
        section(text, "Goals that it begins with", lines(goals));
        section(text, "Plans", lines(plans));
        section(
                text,
                "Hears",
                hears.isEmpty() ? new TextTable("  ") : new TextTable("  ").row(String.join(", ", hears)));
        section(text, "Says", lines(says));
        return text.toString();
    }

    private static TextTable lines(List<Line> lines) {
        var table = new TextTable("  ");
        lines.forEach(line -> table.row(line.file + ":" + line.line, line.text));
        return table;
    }

    private static void section(StringBuilder text, String heading, TextTable table) {
        if (!table.isEmpty()) {
            text.append('\n').append(heading).append('\n').append(table);
        }
    }
}
