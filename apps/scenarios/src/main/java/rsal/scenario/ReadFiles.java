package rsal.scenario;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// Files, and what was read of them: a run can be made again from that alone. Any thread may read.
final class ReadFiles implements FileSource {
    private final FileSource files;
    private final Map<String, byte[]> read = Collections.synchronizedMap(new LinkedHashMap<>());

    ReadFiles(FileSource files) {
        this.files = files;
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
