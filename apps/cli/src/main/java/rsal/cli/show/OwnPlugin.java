package rsal.cli.show;

import java.util.Optional;
import java.util.stream.Stream;
import rsal.metric.MetricType;
import rsal.robot.DeviceDriver;
import rsal.scenario.installed.Providers;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.PluginKind;
import rsal.settings.PluginLanguage;

/// A metric in a file of somebody's own, or a plugin of a device driver, such as a controller.
final class OwnPlugin {
    private OwnPlugin() {}

    /// @param path of a file
    /// @return empty when its class is none of those
    /// @throws InvalidSettings with the errors in it
    static Optional<InstalledKind> of(String path) {
        return language(path).flatMap(language -> new File(language, path).read());
    }

    /// Whether a file has such a class. Makes nothing of it, and reports no errors.
    static boolean is(String path) {
        try {
            return language(path)
                    .filter(language -> new File(language, path).isPlugin())
                    .isPresent();
        } catch (InvalidSettings _) {
            return false;
        }
    }

    private static Optional<PluginLanguage> language(String path) {
        return Providers.byKey(PluginLanguage.class, PluginLanguage::suffix).values().stream()
                .filter(language -> path.endsWith(language.suffix()))
                .findFirst();
    }

    /// @param driver key of the one that uses such plugins
    private record Use(PluginKind kind, String driver) {
        static Stream<Use> all() {
            return Providers.byKey(DeviceDriver.class, DeviceDriver::key).values().stream()
                    .flatMap(driver -> driver.parameters().stream()
                            .flatMap(parameter -> parameter.plugins().stream())
                            .map(kind -> new Use(kind, driver.key())));
        }
    }

    private record File(PluginLanguage language, String path) {
        boolean isPlugin() {
            return is(MetricType.class)
                    || Use.all().anyMatch(use -> is(use.kind().type()));
        }

        Optional<InstalledKind> read() {
            return is(MetricType.class)
                    ? Optional.of(
                            InstalledKind.of(read(MetricType.class, "metric")).named(name()))
                    : Use.all().filter(use -> is(use.kind().type())).findFirst().map(this::read);
        }

        private InstalledKind read(Use use) {
            PluginKind kind = use.kind();
            return InstalledKind.of(read(kind.type(), kind.word()), kind.word(), use.driver())
                    .named(name());
        }

        private boolean is(Class<?> kind) {
            return language.isOf(kind, name(), folder(), Location.of(path));
        }

        private <T> T read(Class<T> kind, String word) {
            return language.read(kind, word, name(), folder(), Location.of(path));
        }

        private String name() {
            return ShownAgent.name(path);
        }

        private FileSource folder() {
            return FileSource.folder(ShownAgent.folder(path));
        }
    }
}
