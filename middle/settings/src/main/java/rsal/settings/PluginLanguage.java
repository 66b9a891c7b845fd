package rsal.settings;

/// A language in which people write plugins in files of their own, as metrics. Found by
/// [java.util.ServiceLoader].
public interface PluginLanguage {
    /// How its files' names end: `.java`.
    String suffix();

    /// Whether its files are programs that may do whatever this process may, also when they are only read. Such
    /// files are read from where a person keeps them ([FileSource#isTrusted]), never from a recording, which
    /// anybody may have made.
    boolean runsCode();

    /// Makes a plugin of the class in a file.
    ///
    /// @param kind the interface that it implements
    /// @param what to call it in messages: `metric`
    /// @param path of the file among the files
    /// @param askedAt where it is named
    /// @throws InvalidSettings with the errors in it, or when it can't be read
    <T> T read(Class<T> kind, String what, String path, FileSource files, Location askedAt);

    /// Whether the class in a file is of a kind. Makes nothing of it.
    ///
    /// @throws InvalidSettings with the errors in it, or when it can't be read
    boolean isOf(Class<?> kind, String path, FileSource files, Location askedAt);
}
