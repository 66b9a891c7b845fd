package rsal.scenario;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import rsal.scenario.installed.Catalog;
import rsal.scenario.installed.Installation;
import rsal.scene.Scene;
import rsal.settings.FileSource;
import rsal.settings.FormatVersion;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Parameter;
import rsal.settings.Problem;
import rsal.settings.Problems;
import rsal.settings.Section;
import rsal.settings.Suggestion;
import rsal.settings.Value;
import rsal.yaml.Yaml;

/// A scenario as its author wrote it, checked in itself, arguments still open. Immutable.
public final class Scenario {
    /// Of all scenarios of this process, as many have the same map.
    private static final Installation INSTALLATION = new Installation();

    private static final List<String> BUILT_IN = List.of(
            "distribution", "find-and-collect", "foraging", "hunt-and-prey", "patrol", "rescue", "swarm", "teleop");
    static final String FILE = "scenario.yaml";

    private final Value.Mapping settings;
    private final FileSource files;
    private final Optional<String> text; // of a world it is read when somebody asks
    private final String name;
    private final String title;
    private final String description;
    private final List<Parameter<?>> arguments;
    private final List<Configuration> configurations;

    private Scenario(Value.Mapping settings, FileSource files, Optional<String> text, Problems problems) {
        this.settings = settings;
        this.files = files;
        this.text = text;
        var section = new Section("", settings, problems);
        section.number("rsal"); // it must be there
        FormatVersion.check(section, "scenario", Format.VERSION);
        this.name = section.text("scenario");
        this.title = section.text("title", name);
        this.description = section.text("description", "");
        this.arguments = List.copyOf(ArgumentReader.declared(section.section("arguments")));
        this.configurations = configurations(section.section("configurations"));
    }

    /// Where the text of a scenario is.
    ///
    /// @param file what to call it in messages
    /// @param name under which it is among the files
    /// @param asked what a person named
    private record Origin(String file, String name, Location asked, ReadFiles files) {
        String text() {
            return files.text(name, Yaml.MAX_CHARACTERS, asked);
        }

        Scenario read() {
            return Scenario.read(file, text(), files);
        }

        Origin edited(String text) {
            return new Origin(file, name, asked, files.with(name, text));
        }
    }

    /// Reads a scenario that comes with the program, or a person's own.
    ///
    /// @param nameOrFile `hunt-and-prey`, or the path of a YAML file, of its folder, or of a world. The file of a
    /// folder is `scenario.yaml`, else what [#fileIn] says
    /// @throws InvalidSettings when there is none, or with all of its errors
    public static Scenario load(String nameOrFile) {
        return isAWorld(nameOrFile)
                ? ofWorld(nameOrFile, new ReadFiles(FileSource.disk()))
                : origin(nameOrFile).read();
    }

    /// The text of a scenario as it is written now, with all its errors.
    ///
    /// @param nameOrFile as for [#load]
    /// @throws InvalidSettings when there is none, and of a world
    public static String written(String nameOrFile) {
        return origin(nameOrFile).text();
    }

    /// Where a scenario is read from, which [#location] says once it was.
    ///
    /// @param nameOrFile as for [#load]
    /// @throws InvalidSettings when there can be none, and of a world
    public static String fileOf(String nameOrFile) {
        return origin(nameOrFile).file();
    }

    /// Reads a scenario with another text than its own, among the files that are around that.
    ///
    /// @param nameOrFile as for [#load]
    /// @throws InvalidSettings when there is none, with all errors of the text, and of a world
    public static Scenario edited(String nameOrFile, String text) {
        Origin own = origin(nameOrFile);
        return (text.equals(own.text()) ? own : own.edited(text)).read();
    }

    private static boolean isAWorld(String nameOrFile) {
        return !BUILT_IN.contains(nameOrFile) && isWorld(nameOrFile);
    }

    private static Origin origin(String nameOrFile) {
        if (BUILT_IN.contains(nameOrFile)) {
            var files = new ReadFiles(FileSource.resources(Scenario.class, "/rsal/scenarios/" + nameOrFile + "/"));
            String file = nameOrFile + "/" + FILE;
            return new Origin(file, FILE, Location.of(file), files);
        }
        if (isAWorld(nameOrFile)) {
            throw noText(Location.of(nameOrFile));
        }
        if (!looksLikeFile(nameOrFile)) {
            throw new InvalidSettings(
                    Location.of(nameOrFile),
                    "There is no scenario '%s'.".formatted(nameOrFile),
                    Suggestion.among(nameOrFile, BUILT_IN)
                            + " Name your own scenario by its file, or by the folder of the file.");
        }
        return onDisk(nameOrFile);
    }

    private static InvalidSettings noText(Location world) {
        return new InvalidSettings(
                world,
                "'%s' is a world, not a scenario, so its text can't be edited.".formatted(world.file()),
                "Maybe write a scenario that takes place there (world: {file: …}).");
    }

    /// Reads a scenario again from the files that it was read from before, wherever those are now.
    ///
    /// @param file its [#location]
    /// @param files as [#readFiles] had them once it was planned
    /// @param trusted whether agents' programs among them may be run; those of others are not even read, and an
    ///         agent of such a program fails at its start
    /// @throws InvalidSettings with all of its errors, and when one of its files is not among them
    public static Scenario again(String file, Map<String, byte[]> files, boolean trusted) {
        boolean isWorld = isWorld(file);
        var again = ReadFiles.again(files, isWorld, trusted);
        return isWorld ? ofWorld(file, again) : new Origin(file, nameOf(file), Location.of(file), again).read();
    }

    /// The same with another text, among the same files.
    ///
    /// @throws InvalidSettings with all errors of the text, and of a world
    public Scenario edited(String text) {
        if (isWorld()) {
            throw noText(location());
        }
        if (text.equals(text()) || !(files instanceof ReadFiles read)) {
            return this;
        }
        String file = location().file();
        return new Origin(file, nameOf(file), location(), read.with(nameOf(file), text)).read();
    }

    /// The same, for runs that are to be alike: each of its files is read once, whatever is written to it from then on.
    ///
    /// @throws InvalidSettings with all of its errors
    public Scenario kept() {
        if (!(files instanceof ReadFiles read)) {
            return this;
        }
        String file = location().file();
        return isWorld() ? ofWorld(file, read.kept()) : new Origin(file, nameOf(file), location(), read.kept()).read();
    }

    /// Whether it has another text than its file has now.
    public boolean isEdited() {
        return files instanceof ReadFiles read && read.isEdited();
    }

    private static String nameOf(String file) {
        return file.substring(Math.max(file.lastIndexOf('/'), file.lastIndexOf(File.separatorChar)) + 1);
    }

    /// What was read of it so far, by the path in its folder: itself, and what its plans took from other files that do
    /// not come with the program. Handed over, not shared.
    public Map<String, byte[]> readFiles() {
        return files instanceof ReadFiles read ? read.all() : Map.of();
    }

    /// Whether it comes with the program.
    static boolean isBuiltIn(String name) {
        return BUILT_IN.contains(name);
    }

    /// Names of those that come with the program, which reads none of them.
    public static List<String> builtInNames() {
        return BUILT_IN;
    }

    /// Reads one that lies in the folder of another, for what that takes from it.
    ///
    /// @param path relative to that folder
    /// @param at where it is named
    /// @throws InvalidSettings when there is none, or with the errors of its head
    static Scenario beside(Scenario host, String path, Location at) {
        var problems = new Problems();
        String text = host.files.text(path, Yaml.MAX_CHARACTERS, at);
        var scenario = new Scenario(Yaml.read(path, text), host.files, Optional.of(text), problems);
        problems.throwIfAny();
        return scenario;
    }

    /// Whether files of this name are worlds, which can be run as they are: [#load] makes a scenario of them.
    public static boolean isWorld(String name) {
        return Catalog.installed().formatOf(name).isPresent();
    }

    /// What is in a world, as a run with the seed 1 finds it; when that is nothing, with a warning.
    ///
    /// @param path of a file that [#isWorld]
    /// @throws InvalidSettings with its errors
    public static Scene scene(String path) {
        var seeds = new Seeds((Long) Format.SEED.fallback().orElseThrow());
        Scene scene = Catalog.installed()
                .formatOf(path, FileSource.disk())
                .orElseThrow(() -> new IllegalArgumentException("'%s' is not a world.".formatted(path)))
                .read(path, FileSource.disk(), seeds.of("world"));
        return scene.isEmpty()
                ? scene.serving(
                        List.of(),
                        Stream.concat(scene.warnings().stream(), Stream.of(Notes.nothingIn(Location.of(path))))
                                .toList())
                : scene;
    }

    /// A world with nothing but what is in it.
    private static Scenario ofWorld(String path, ReadFiles files) {
        Location at = Location.of(path);
        String file = path.substring(path.lastIndexOf('/') + 1);
        var world = Map.<String, Value>of("file", new Value.Scalar(at, path));
        var settings = new LinkedHashMap<String, Value>();
        settings.put("rsal", new Value.Scalar(at, (long) Format.VERSION));
        settings.put("scenario", new Value.Scalar(at, file));
        settings.put("world", new Value.Mapping(at, world, Map.of()));
        return new Scenario(new Value.Mapping(at, settings, Map.of()), files, Optional.empty(), new Problems());
    }

    private static boolean looksLikeFile(String name) {
        return name.endsWith(".yaml") || name.endsWith(".yml") || name.contains("/") || new File(name).isDirectory();
    }

    /// What a scenario's file is called in a folder of its own.
    ///
    /// @param folder the name of that, which is the scenario's
    public static String fileIn(String folder) {
        return folder + ".yaml";
    }

    private static Origin onDisk(String path) {
        try {
            Path given = Path.of(path);
            Path file = Files.isDirectory(given) ? ScenarioFolder.fileIn(given) : given;
            Path fileName = file.getFileName();
            Path folder = file.toAbsolutePath().getParent();
            if (fileName == null || folder == null) {
                throw new InvalidSettings(Location.of(path), "This is not a file.", "");
            }
            var files = new ReadFiles(FileSource.folder(folder));
            return new Origin(file.toString(), fileName.toString(), Location.of(path), files);
        } catch (InvalidPathException e) {
            throw new InvalidSettings(Location.of(path), "This can't be a file: %s.".formatted(e.getReason()), "");
        }
    }

    /// Reads a scenario's text.
    ///
    /// @param file what to call it in messages
    /// @param files where the maps and models are that it names
    /// @throws InvalidSettings with all of its errors
    static Scenario read(String file, String text, FileSource files) {
        Value.Mapping settings = Yaml.read(file, text);
        var problems = new Problems();
        var scenario = new Scenario(settings, files, Optional.of(text), problems);
        if (!problems.isEmpty()) {
            throw new InvalidSettings(distinct(problems.all(), scenario.errors(RunOptions.NONE)));
        }
        return scenario;
    }

    /// The scenarios that come with the program.
    public static List<Scenario> builtIn() {
        return BUILT_IN.stream().map(Scenario::load).toList();
    }

    public String name() {
        return name;
    }

    public String title() {
        return title;
    }

    /// Some sentences for people; empty when there are none.
    public String description() {
        return description;
    }

    /// As its author wrote it; of a world, the text of that.
    ///
    /// @throws InvalidSettings when a world can't be read
    public String text() {
        return text.orElseGet(() -> files.text(location().file(), Yaml.MAX_CHARACTERS, location()));
    }

    /// Where it was read from.
    public Location location() {
        return Location.of(settings.location().file());
    }

    public List<Parameter<?>> arguments() {
        return arguments;
    }

    /// The first is the default. One that declares none has one, `default`.
    public List<Configuration> configurations() {
        return configurations;
    }

    /// Whether runs of a configuration are to go in real time, as far as that is written: an argument may say so, too.
    public boolean isInRealTime(String configuration) {
        return clockMode(overlay(configuration))
                .or(() -> clockMode(settings))
                .filter("wall"::equals)
                .isPresent();
    }

    private static Optional<Object> clockMode(Value.Mapping settings) {
        Optional<Value> value = Optional.of(settings);
        for (String key : List.of("run", "clock", "mode")) {
            value = value.filter(Value.Mapping.class::isInstance).flatMap(all -> ((Value.Mapping) all).find(key));
        }
        return value.filter(Value.Scalar.class::isInstance).map(mode -> ((Value.Scalar) mode).value());
    }

    /// Decides everything that is still open.
    ///
    /// @throws InvalidSettings with every error of the scenario and the options
    public RunPlan plan(RunOptions options) {
        try {
            return planned(options);
        } catch (InvalidSettings e) {
            throw new InvalidSettings(new Blame(options, this::errors).of(e.problems()), e.warnings());
        }
    }

    private RunPlan planned(RunOptions options) {
        return new PlanReader(this, options, INSTALLATION).read();
    }

    /// Plans every configuration.
    ///
    /// @throws InvalidSettings with every error of the scenario
    public void check() {
        check(_ -> {});
    }

    /// Plans every configuration.
    ///
    /// @param planned told the plans of those without an error, in their order
    /// @throws InvalidSettings with every error of the scenario
    public void check(Consumer<RunPlan> planned) {
        var errors = new LinkedHashSet<Problem>();
        var warnings = new LinkedHashSet<Problem>();
        for (Configuration configuration : configurations) {
            try {
                planned.accept(planned(RunOptions.NONE.withConfiguration(configuration.name())));
            } catch (InvalidSettings e) {
                errors.addAll(e.problems());
                warnings.addAll(e.warnings());
            }
        }
        if (!errors.isEmpty()) {
            throw new InvalidSettings(List.copyOf(errors), List.copyOf(warnings));
        }
    }

    /// Whether it is but a world with all that is in it.
    public boolean isWorld() {
        return files.everywhere();
    }

    /// What a configuration lays over it; empty for one that is not written.
    Value.Mapping overlay(String configuration) {
        return settings.find("configurations")
                .filter(Value.Mapping.class::isInstance)
                .flatMap(all -> ((Value.Mapping) all).find(configuration))
                .filter(Value.Mapping.class::isInstance)
                .map(Value.Mapping.class::cast)
                .orElseGet(() -> Value.Mapping.empty(location()));
    }

    /// All that it says with a configuration on top, but for what that says of arguments.
    Value.Mapping settings(String configuration) {
        Value.Mapping over = overlay(configuration);
        return RobotReader.under(settings, over)
                .without("configurations")
                .merge(over.without(Format.ARGUMENTS).without("title"));
    }

    Value.Mapping settings() {
        return settings;
    }

    FileSource files() {
        return files;
    }

    private List<Problem> errors(RunOptions options) {
        try {
            planned(options);
            return List.of();
        } catch (InvalidSettings e) {
            return e.problems();
        }
    }

    private static List<Problem> distinct(List<Problem> first, List<Problem> more) {
        var all = new LinkedHashSet<>(first);
        all.addAll(more);
        return List.copyOf(all);
    }

    private static List<Configuration> configurations(Section section) {
        var configurations = new ArrayList<Configuration>();
        for (String name : section.names()) {
            Section one = section.section(name);
            if (!Format.NAME.matcher(name).matches()) {
                one.problem(one.location(), "'%s' can't be the name of a configuration.".formatted(name), "");
            }
            configurations.add(new Configuration(name, one.text("title", "")));
        }
        return configurations.isEmpty()
                ? List.of(new Configuration(Format.DEFAULT_CONFIGURATION, ""))
                : List.copyOf(configurations);
    }

    @Override
    public String toString() {
        return name + " (" + location() + ")";
    }
}
