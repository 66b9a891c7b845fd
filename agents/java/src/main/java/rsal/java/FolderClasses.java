package rsal.java;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.SequencedMap;
import java.util.concurrent.ConcurrentHashMap;
import rsal.settings.OwnCode;

/// The classes of one folder's Java files. A file that has changed since begins them again; what runs goes on
/// with those that it has.
///
/// The newest ones of each folder are known to the whole process: a sweep reads its scenario hundreds of times,
/// and agents of two files have the same class for their messages only when one loader has defined it. So runs
/// of a process share what is static in them, as they share it of classes that come with RSAL. Safe for any
/// thread.
final class FolderClasses extends ClassLoader {
    private static final int MOST_FOLDERS = 64;
    private static final SequencedMap<String, FolderClasses> NEWEST =
            new LinkedHashMap<>(); // by the file that names them

    private final Map<String, String> texts = new ConcurrentHashMap<>(); // by path
    private final Map<String, byte[]> compiled = new ConcurrentHashMap<>(); // by name of the class

    static {
        registerAsParallelCapable();
    }

    private FolderClasses() {
        super(OwnCode.LOADER, FolderClasses.class.getClassLoader());
    }

    /// Those of a folder in which all these files are compiled.
    ///
    /// @param namedIn the scenario, or another file that names the class
    /// @throws rsal.settings.InvalidSettings with what can't be compiled
    static FolderClasses of(String namedIn, Sources sources) {
        synchronized (NEWEST) {
            FolderClasses known = NEWEST.get(namedIn);
            if (known != null && known.has(sources)) {
                return known;
            }
            Map<String, byte[]> fresh = Compiler.compile(sources);
            FolderClasses classes = known == null || known.contradicts(sources) ? new FolderClasses() : known;
            classes.add(sources, fresh);
            NEWEST.remove(namedIn);
            NEWEST.put(namedIn, classes);
            if (NEWEST.size() > MOST_FOLDERS) {
                NEWEST.pollFirstEntry();
            }
            return classes;
        }
    }

    private boolean has(Sources sources) {
        return sources.texts().entrySet().stream()
                .allMatch(file -> file.getValue().equals(texts.get(file.getKey())));
    }

    /// Whether one of the files has another text than it had.
    private boolean contradicts(Sources sources) {
        return sources.texts().entrySet().stream()
                .anyMatch(file ->
                        !texts.getOrDefault(file.getKey(), file.getValue()).equals(file.getValue()));
    }

    private void add(Sources sources, Map<String, byte[]> fresh) {
        texts.putAll(sources.texts());
        fresh.forEach(compiled::putIfAbsent); // of the same texts they are the same
    }

    /// Those that were compiled from files, by name.
    Map<String, byte[]> compiled() {
        return Collections.unmodifiableMap(compiled);
    }

    @Override
    protected Class<?> findClass(String name) throws ClassNotFoundException {
        byte[] bytes = compiled.get(name);
        if (bytes == null) {
            throw new ClassNotFoundException(name);
        }
        return defineClass(name, bytes, 0, bytes.length);
    }
}
