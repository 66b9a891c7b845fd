package rsal.cli.show;

import java.util.Optional;
import rsal.metric.MetricType;
import rsal.scenario.installed.Providers;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.PluginLanguage;

/// A metric in a file of somebody's own.
final class OwnMetric {
    private OwnMetric() {}

    /// @param path of a file
    /// @return empty when it is none, or has mistakes: those are told when it is shown as an agent
    static Optional<InstalledKind> of(String path) {
        return Providers.byKey(PluginLanguage.class, PluginLanguage::suffix).values().stream()
                .filter(language -> path.endsWith(language.suffix()))
                .findFirst()
                .flatMap(language -> read(language, path));
    }

    private static Optional<InstalledKind> read(PluginLanguage language, String path) {
        try {
            String name = ShownAgent.name(path);
            FileSource folder = FileSource.folder(ShownAgent.folder(path));
            return Optional.of(
                    InstalledKind.of(language.read(MetricType.class, "metric", name, folder, Location.of(path)))
                            .named(name));
        } catch (InvalidSettings _) {
            return Optional.empty();
        }
    }
}
