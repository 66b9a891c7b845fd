package rsal.scenario.installed;

import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.List;
import java.util.Optional;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Plugin;
import rsal.settings.PluginFiles;
import rsal.settings.PluginKind;
import rsal.settings.PluginLanguage;
import rsal.yaml.Yaml;

/// Reads plugins in files beside a scenario. In place of one that is a program from who knows where, as from a
/// recording, there is one that says so when it is used; the program is neither read nor run.
public final class PluginReader implements PluginFiles {
    private final Catalog catalog;
    private final FileSource files;

    public PluginReader(Catalog catalog, FileSource files) {
        this.catalog = catalog;
        this.files = files;
    }

    @Override
    public Optional<Plugin> read(PluginKind kind, String name, Location askedAt) {
        return catalog.pluginLanguage(name).map(language -> read(language, kind, name, askedAt));
    }

    private Plugin read(PluginLanguage language, PluginKind kind, String name, Location askedAt) {
        if (language.runsCode() && !files.isTrusted()) {
            files.read(name, Yaml.MAX_CHARACTERS, askedAt); // it must be there
            return standIn(kind, name);
        }
        try {
            return language.read(kind.type(), kind.word(), name, files, askedAt);
        } catch (InvalidSettings e) {
            throw e.beside(askedAt);
        }
    }

    private static Plugin standIn(PluginKind kind, String file) {
        return kind.type()
                .cast(Proxy.newProxyInstance(
                        kind.type().getClassLoader(),
                        new Class<?>[] {kind.type()},
                        (_, method, arguments) -> answer(kind, file, method, arguments)));
    }

    @Override
    public boolean isStandIn(Plugin plugin) {
        return isNotRun(plugin);
    }

    /// Whether this stands in place of a program that is not run.
    public static boolean isNotRun(Plugin plugin) {
        return Proxy.isProxyClass(plugin.getClass());
    }

    private static Object answer(PluginKind kind, String file, Method method, Object[] arguments) {
        return switch (method.getName()) {
            case "key", "toString" -> file;
            case "description" -> "A program that came with a recording, which is not run.";
            case "hashCode" -> file.hashCode();
            case "equals" ->
                arguments[0] instanceof Plugin other
                        && isNotRun(other)
                        && other.key().equals(file);
            default -> {
                if (method.getReturnType() == List.class) { // it declares nothing
                    yield List.of();
                }
                if (method.getReturnType() == Optional.class) {
                    yield Optional.empty();
                }
                throw new IllegalStateException(
                        "The %s '%s' is a program that came with a recording, and such are not run."
                                .formatted(kind.word(), file));
            }
        };
    }
}
