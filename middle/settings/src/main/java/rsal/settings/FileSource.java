package rsal.settings;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;

/// Where files that settings name are looked for: a person's folder, or what comes with the program. Nothing
/// outside is ever read, unless the person who asks could read it anyway ([#disk]), and nothing without bound.
public interface FileSource {
    /// @param path relative to the source, `/` between names
    /// @param most bytes to read; more is refused
    /// @param askedAt where the path was written, for messages
    /// @throws InvalidSettings when there is no such file, it lies outside, is too large or can't be read
    byte[] read(String path, int most, Location askedAt);

    /// Whether it reads all files of the machine, not only those of one folder.
    default boolean everywhere() {
        return false;
    }

    /// Whether programs among its files may be run: those in a folder that a person named, and those that come
    /// with the program. Files that only claim to be such, as those in a recording, are not.
    default boolean isTrusted() {
        return false;
    }

    /// A text in UTF-8.
    default String text(String path, int most, Location askedAt) {
        try {
            return StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(ByteBuffer.wrap(read(path, most, askedAt)))
                    .toString();
        } catch (CharacterCodingException _) {
            throw new InvalidSettings(Location.of(path), "This is not text in UTF-8.", "Maybe it is another file.");
        }
    }

    /// A folder on disk. Links are followed as long as they stay in it.
    static FileSource folder(Path folder) {
        return trusted((path, most, askedAt) -> {
            Path file;
            try {
                Path root = folder.toRealPath();
                Path asked = root.resolve(path).normalize();
                if (!asked.startsWith(root)) {
                    throw outside(path, folder, askedAt);
                }
                file = asked.toRealPath();
                if (!file.startsWith(root)) {
                    throw outside(path, folder, askedAt);
                }
            } catch (IOException | InvalidPathException _) {
                throw missing(
                        path,
                        NearbyFiles.maybe(folder, path).orElse("It is looked for in '%s'.".formatted(folder)),
                        askedAt);
            }
            if (!Files.isRegularFile(file)) {
                boolean folders = Files.isDirectory(file);
                throw new InvalidSettings(
                        askedAt,
                        "'%s' is %s.".formatted(path, folders ? "a folder, not a file" : "not a file"),
                        folders ? "Name a file in it." : "");
            }
            try (InputStream in = Files.newInputStream(file)) {
                return bounded(in, path, most, askedAt);
            } catch (IOException e) {
                throw new InvalidSettings(askedAt, "File '%s' can't be read: %s.".formatted(path, e.getMessage()), "");
            }
        });
    }

    /// All files that this process may read, for those that a person names on the command line. Paths are relative
    /// to where the process was started.
    static FileSource disk() {
        return new FileSource() {
            @Override
            public byte[] read(String path, int most, Location askedAt) {
                Path file;
                try {
                    file = Path.of(path).toAbsolutePath();
                } catch (InvalidPathException _) {
                    throw missing(path, "", askedAt);
                }
                Path root = file.getRoot();
                try {
                    return folder(root == null ? file : root).read(file.toString(), most, askedAt);
                } catch (InvalidSettings e) {
                    Problem why = e.problems().getFirst();
                    String remedy = Files.exists(file) || root == null
                            ? why.remedy()
                            : NearbyFiles.maybe(root, file.toString()).orElse("");
                    throw new InvalidSettings(askedAt, why.message().replace(file.toString(), path), remedy);
                }
            }

            @Override
            public boolean everywhere() {
                return true;
            }

            @Override
            public boolean isTrusted() {
                return true;
            }
        };
    }

    /// Resources beside a class of the module that holds them.
    ///
    /// @param folder absolute in the class path, `/rsal/maps/`
    static FileSource resources(Class<?> owner, String folder) {
        return trusted((path, most, askedAt) -> {
            if (path.contains("..")) {
                throw missing(path, "", askedAt);
            }
            try (InputStream in = owner.getResourceAsStream(folder + path)) {
                if (in == null) {
                    throw missing(path, "", askedAt);
                }
                return bounded(in, path, most, askedAt);
            } catch (IOException e) {
                throw new InvalidSettings(
                        askedAt, "Resource '%s' can't be read: %s.".formatted(path, e.getMessage()), "");
            }
        });
    }

    /// The same files, of which programs may be run.
    static FileSource trusted(FileSource files) {
        return new FileSource() {
            @Override
            public byte[] read(String path, int most, Location askedAt) {
                return files.read(path, most, askedAt);
            }

            @Override
            public boolean everywhere() {
                return files.everywhere();
            }

            @Override
            public boolean isTrusted() {
                return true;
            }
        };
    }

    private static byte[] bounded(InputStream in, String path, int most, Location askedAt) throws IOException {
        byte[] bytes = in.readNBytes(most);
        if (in.read() >= 0) {
            throw new InvalidSettings(
                    askedAt,
                    "File '%s' has more than %s, and no more is read.".formatted(path, size(most)),
                    "Maybe it is another kind of file.");
        }
        return bytes;
    }

    private static String size(int bytes) {
        return bytes % (1 << 20) == 0 ? (bytes >> 20) + " MiB" : bytes + " bytes";
    }

    private static InvalidSettings missing(String path, String remedy, Location askedAt) {
        return new InvalidSettings(askedAt, "There is no file '%s'.".formatted(path), remedy);
    }

    private static InvalidSettings outside(String path, Path folder, Location askedAt) {
        return new InvalidSettings(
                askedAt, "'%s' lies outside of '%s'.".formatted(path, folder), "Put the file into that folder.");
    }
}
