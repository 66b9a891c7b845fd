package rsal.java;

import java.util.List;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.settings.PluginLanguage;

/// Plugins in Java, in files of people's own: each has a public class of its name. Files of one folder see the
/// same classes, agents and plugins, so that a metric knows the messages of its scenario's agents.
public final class JavaPlugins implements PluginLanguage {
    @Override
    public String suffix() {
        return Sources.SUFFIX;
    }

    @Override
    public boolean runsCode() {
        return true;
    }

    @Override
    public <T> T read(Class<T> kind, String what, String path, FileSource files, Location askedAt) {
        var sources = Sources.read(path, files, askedAt);
        var use = new JavaClass.Use(what, List.of(kind), "Let it implement %s.".formatted(kind.getName()));
        return JavaClass.of(sources, FolderClasses.of(askedAt.file(), sources), use)
                .create(kind);
    }

    @Override
    public boolean isOf(Class<?> kind, String path, FileSource files, Location askedAt) {
        var sources = Sources.read(path, files, askedAt);
        return JavaClass.isOf(kind, sources, FolderClasses.of(askedAt.file(), sources));
    }
}
