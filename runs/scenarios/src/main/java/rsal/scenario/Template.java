package rsal.scenario;

import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Suggestion;
import rsal.yaml.Yaml;

/// What somebody's own scenario begins with: one that comes with the program, and the files that it names.
/// There is an agent among them: a scenario that comes with the program has one configuration more, with one in
/// Java. Immutable.
public final class Template {
    /// The agent that is laid beside a scenario that comes with the program.
    public static final String WATCHER = "Watcher.java";
    /// The configuration that it is in.
    public static final String WATCHED = "own";

    private static final String FILE = "scenario.yaml";
    private static final Pattern NAME = Pattern.compile("(?m)^scenario: .*$");
    private static final Pattern TITLE = Pattern.compile("(?m)^title: .*$");
    private static final String TEMPLATES = "/rsal/templates/";
    private static final String WITH_WATCHER = """
              %s:
                title: With an agent of yours, which listens to the others
                agents: {watcher: {type: %s}}
            """.formatted(WATCHED, WATCHER);

    private final Scenario scenario;
    private final Map<String, String> texts;

    private Template(Scenario scenario, Map<String, String> texts) {
        this.scenario = scenario;
        this.texts = Collections.unmodifiableMap(new LinkedHashMap<>(texts));
    }

    /// @param scenario the name of one that comes with the program
    /// @throws InvalidSettings when none has that name
    public static Template of(String scenario) {
        if (!Scenario.isBuiltIn(scenario)) {
            throw new InvalidSettings(
                    Location.of(scenario),
                    "There is no scenario '%s' to begin with.".formatted(scenario),
                    Suggestion.among(scenario, Scenario.builtInNames()));
        }
        return read("/rsal/scenarios/" + scenario + "/").watched();
    }

    /// The text ends with the scenario's configurations.
    private Template watched() {
        var all = new LinkedHashMap<>(texts);
        all.put(FILE, texts.get(FILE) + WITH_WATCHER);
        all.put(
                WATCHER,
                FileSource.resources(Template.class, TEMPLATES)
                        .text(WATCHER, Yaml.MAX_CHARACTERS, Location.of(WATCHER)));
        var files = new LinkedHashMap<String, byte[]>();
        all.forEach((path, text) -> files.put(path, text.getBytes(StandardCharsets.UTF_8)));
        Scenario watched = Scenario.again(FILE, files, true);
        var _ = watched.plan(RunOptions.NONE.withConfiguration(WATCHED)); // all others are as they were
        return new Template(watched, all);
    }

    /// One with a plugin in Java.
    ///
    /// @param kind `metric` or `controller`
    public static Template withPlugin(String kind) {
        return read(TEMPLATES + kind + "/");
    }

    /// One with agents in a language; empty where there is none.
    ///
    /// @param language `java`, or the key of the multi-agent system that has it (`jason`)
    public static Optional<Template> inLanguage(String language) {
        String folder = TEMPLATES + language + "/";
        return language.matches("\\w+") && Template.class.getResource(folder + FILE) != null
                ? Optional.of(read(folder))
                : Optional.empty();
    }

    private static Template read(String folder) {
        var texts = new LinkedHashMap<String, String>();
        FileSource resources = FileSource.resources(Template.class, folder);
        FileSource noted = (path, most, askedAt) -> {
            byte[] read = resources.read(path, most, askedAt);
            texts.put(path, new String(read, StandardCharsets.UTF_8));
            return read;
        };
        Location at = Location.of(FILE);
        Scenario scenario = Scenario.read(FILE, noted.text(FILE, Yaml.MAX_CHARACTERS, at), noted);
        scenario.check(); // reads what its configurations name
        return new Template(scenario, texts);
    }

    /// The scenario as it comes with the program.
    public Scenario scenario() {
        return scenario;
    }

    /// The same by another name, which is its title, too.
    ///
    /// @return texts by path; the scenario's own, the first, is that of [Scenario#fileIn]
    /// @throws InvalidSettings when no scenario can be called so
    public Map<String, String> named(String name) {
        if (!Format.NAME.matcher(name).matches()) {
            throw new InvalidSettings(
                    Location.of(name),
                    "A scenario can't be called '%s'.".formatted(name),
                    "A name begins with a letter and has up to 40 letters, digits, - and _.");
        }
        if (Scenario.isBuiltIn(name)) { // whose name would not lead to its folder
            throw new InvalidSettings(
                    Location.of(name),
                    "A scenario that comes with RSAL is called '%s'.".formatted(name),
                    "Choose another name.");
        }
        var own = new LinkedHashMap<String, String>();
        texts.forEach((path, text) -> {
            if (path.equals(FILE)) {
                String called = NAME.matcher(text).replaceFirst(Matcher.quoteReplacement("scenario: " + name));
                own.put(
                        Scenario.fileIn(name),
                        TITLE.matcher(called).replaceFirst("title: '%s'".formatted(title(name))));
            } else {
                own.put(path, text);
            }
        });
        return own;
    }

    /// `chase-two` as people write it, `Chase two`.
    private static String title(String name) {
        String words = name.replaceAll("[-_]+", " ").strip();
        return Character.toUpperCase(words.charAt(0)) + words.substring(1);
    }
}
