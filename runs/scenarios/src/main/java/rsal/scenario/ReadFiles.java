package rsal.scenario;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// Files, and what was read of them: a run can be made again from that alone. Any thread may read.
final class ReadFiles implements FileSource {
    private final FileSource files;
    private final Optional<Edited> edited;
    private final boolean keeps;
    private final Map<String, byte[]> read = Collections.synchronizedMap(new LinkedHashMap<>());

    /// A file's text that counts instead of what is in the file.
    private record Edited(String path, byte[] text) {
        boolean isIn(FileSource files) {
            try {
                return Arrays.equals(files.read(path, text.length, Location.of(path)), text);
            } catch (InvalidSettings _) { // it is longer, or gone
                return false;
            }
        }
    }

    ReadFiles(FileSource files) {
        this(files, Optional.empty(), false);
    }

    /// @param keeps whether each is read once, whatever is written to it from then on
    private ReadFiles(FileSource files, Optional<Edited> edited, boolean keeps) {
        this.files = files;
        this.edited = edited;
        this.keeps = keeps;
    }

    /// Those that were read before, and no others.
    ///
    /// @param everywhere whether they were from anywhere on the machine
    /// @param trusted whether programs among them may be run
    static ReadFiles again(Map<String, byte[]> known, boolean everywhere, boolean trusted) {
        return new ReadFiles(new FileSource() {
            @Override
            public byte[] read(String path, int most, Location askedAt) {
                byte[] bytes = known.get(path);
                if (bytes == null || bytes.length > most) {
                    throw new InvalidSettings(
                            askedAt, "There is no file '%s' among those that were recorded.".formatted(path), "");
                }
                return bytes.clone();
            }

            @Override
            public boolean everywhere() {
                return everywhere;
            }

            @Override
            public boolean isTrusted() {
                return trusted;
            }
        });
    }

    /// The same files, one of them with another text. Nothing else is: another that had one is again as it was found.
    ReadFiles with(String path, String text) {
        return new ReadFiles(files, Optional.of(new Edited(path, text.getBytes(StandardCharsets.UTF_8))), keeps);
    }

    /// The same, of which each is read once: as it was read already, or as it is then.
    ReadFiles kept() {
        var kept = new ReadFiles(files, edited, true);
        kept.read.putAll(all());
        return kept;
    }

    /// Whether one of them has another text than it is found with now.
    boolean isEdited() {
        return edited.isPresent() && !edited.get().isIn(files);
    }

    @Override
    public byte[] read(String path, int most, Location askedAt) {
        byte[] known = keeps ? read.get(path) : null;
        if (known != null && known.length <= most) {
            return known.clone();
        }
        byte[] bytes = edited.isPresent() && edited.get().path().equals(path)
                ? editedText(edited.get(), most, askedAt)
                : files.read(path, most, askedAt);
        read.putIfAbsent(path, bytes.clone());
        return bytes;
    }

    private static byte[] editedText(Edited edited, int most, Location askedAt) {
        if (edited.text().length > most) {
            throw new InvalidSettings(askedAt, "The text has more than %d bytes.".formatted(most), "");
        }
        return edited.text().clone();
    }

    @Override
    public boolean everywhere() {
        return files.everywhere();
    }

    @Override
    public boolean isTrusted() {
        return files.isTrusted();
    }

    Map<String, byte[]> all() {
        synchronized (read) {
            return new LinkedHashMap<>(read);
        }
    }
}
