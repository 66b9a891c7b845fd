package rsal.scenario.installed;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import rsal.agent.AgentHostProvider;
import rsal.agent.AgentLanguage;
import rsal.agent.AgentType;
import rsal.map.Maps;
import rsal.metric.MetricType;
import rsal.model.RobotModels;
import rsal.robot.DeviceDriver;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.PluginLanguage;
import rsal.settings.Problems;
import rsal.settings.Suggestion;
import rsal.system.RobotSystemProvider;
import rsal.world.SceneFormat;

/// What scenarios can name in this installation, by key, in the order of the keys.
///
/// @param languages in which people write agents, by suffix
/// @param plugins languages in which people write plugins, by suffix
/// @param formats of world files, by suffix
public record Catalog(
        Map<String, RobotSystemProvider> systems,
        Map<String, AgentHostProvider> hosts,
        Map<String, DeviceDriver> drivers,
        Map<String, AgentType> agents,
        Map<String, AgentLanguage> languages,
        Map<String, MetricType> metrics,
        Map<String, PluginLanguage> plugins,
        Map<String, SceneFormat> formats,
        List<String> models,
        List<String> parts,
        List<String> maps) {

    private static final int MAX_BYTES = 1 << 28; // of a world's file

    public static Catalog installed() {
        return new Catalog(
                Providers.byKey(RobotSystemProvider.class, RobotSystemProvider::key),
                Providers.byKey(AgentHostProvider.class, AgentHostProvider::key),
                Providers.byKey(DeviceDriver.class, DeviceDriver::key),
                Providers.byKey(AgentType.class, AgentType::key),
                Providers.byKey(AgentLanguage.class, AgentLanguage::suffix),
                Providers.byKey(MetricType.class, MetricType::key),
                Providers.byKey(PluginLanguage.class, PluginLanguage::suffix),
                Providers.byKey(SceneFormat.class, SceneFormat::suffix),
                RobotModels.builtIn(),
                RobotModels.builtInParts(),
                Maps.builtIn());
    }

    /// The language of a plugin's file; empty for a name that is no such file's.
    Optional<PluginLanguage> pluginLanguage(String name) {
        return plugins.values().stream()
                .filter(language -> name.endsWith(language.suffix()))
                .findFirst();
    }

    /// The format of a world's file, by its name.
    public Optional<SceneFormat> formatOf(String path) {
        return formats.entrySet().stream()
                .filter(format -> path.endsWith(format.getKey()))
                .map(Map.Entry::getValue)
                .findFirst()
                .or(() -> sharing(path).findFirst());
    }

    /// The format of a world's file, by its name, and by what is in it where several formats have such names.
    public Optional<SceneFormat> formatOf(String path, FileSource files) {
        List<SceneFormat> sharing = sharing(path).toList();
        if (sharing.isEmpty()) {
            return formatOf(path);
        }
        byte[] content;
        try {
            content = files.read(path, MAX_BYTES, Location.of(path));
        } catch (InvalidSettings _) { // who reads it says why
            return formatOf(path);
        }
        return sharing.stream()
                .filter(format -> format.recognizes(content))
                .findFirst()
                .or(() -> formatOf(path));
    }

    private Stream<SceneFormat> sharing(String path) {
        return formats.values().stream()
                .filter(format -> format.sharedSuffixes().stream().anyMatch(path::endsWith));
    }

    /// One of those by key, or a problem that says which there are.
    ///
    /// @param what to call it in the message
    public static <P> Optional<P> find(String what, Map<String, P> known, String key, Location at, Problems problems) {
        return find(what, known, key, at, "", problems);
    }

    private static <P> Optional<P> find(
            String what, Map<String, P> known, String key, Location at, String advice, Problems problems) {
        Optional<P> found = Optional.ofNullable(known.get(key));
        if (found.isEmpty()) {
            problems.add(
                    at, "There is no %s '%s'.".formatted(what, key), Suggestion.among(key, known.keySet()) + advice);
        }
        return found;
    }

    /// The language of an agent's file; empty for a name that is no such file's.
    public Optional<AgentLanguage> language(String name) {
        return languages.values().stream()
                .filter(language -> language.reads(name))
                .findFirst();
    }

    /// A type of agent, of which people write their own.
    public Optional<AgentType> agent(String key, Location at, Problems problems) {
        return find(
                "type of agent",
                agents,
                key,
                at,
                " An agent of your own is named by its file, such as Watcher.java, watcher.py or watcher.asl.",
                problems);
    }
}
