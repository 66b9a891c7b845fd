package rsal.scenario;

import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// Files, and what was read of them: a run can be made again from that alone. Any thread may read.
final class ReadFiles implements FileSource {
    private final FileSource files;
    private final boolean edited;
    private final Map<String, byte[]> read = Collections.synchronizedMap(new LinkedHashMap<>());

    ReadFiles(FileSource files) {
        this(files, false);
    }

    private ReadFiles(FileSource files, boolean edited) {
        this.files = files;
        this.edited = edited;
    }

    /// Those that were read before, and no others.
    ///
    /// @param everywhere whether they were from anywhere on the machine
    static ReadFiles again(Map<String, byte[]> known, boolean everywhere) {
        return new ReadFiles(new FileSource() {
            @Override
            public byte[] read(String path, int most, Location askedAt) {
                byte[] bytes = known.get(path);
                if (bytes == null || bytes.length > most) {
                    throw new InvalidSettings(
                            askedAt, "There is no file (%s) among those that were recorded.".formatted(path), "");
                }
                return bytes.clone();
            }

            @Override
            public boolean everywhere() {
                return everywhere;
            }
        });
    }

    /// The same, one of them with another text.
    ReadFiles with(String edited, String text) {
        byte[] written = text.getBytes(StandardCharsets.UTF_8);
        return new ReadFiles(
                (path, most, askedAt) -> {
                    if (!path.equals(edited)) {
                        return files.read(path, most, askedAt);
                    }
                    if (written.length > most) {
                        throw new InvalidSettings(askedAt, "The text has more than %d bytes.".formatted(most), "");
                    }
                    return written.clone();
                },
                true);
    }

    /// Whether one of them has another text than it was found with.
    boolean isEdited() {
        return edited;
    }

    @Override
    public byte[] read(String path, int most, Location askedAt) {
        byte[] bytes = files.read(path, most, askedAt);
        read.putIfAbsent(path, bytes.clone());
        return bytes;
    }

    @Override
    public boolean everywhere() {
        return files.everywhere();
    }

    Map<String, byte[]> all() {
        synchronized (read) {
            return new LinkedHashMap<>(read);
        }
    }
}
