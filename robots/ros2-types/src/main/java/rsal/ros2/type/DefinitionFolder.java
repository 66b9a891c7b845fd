package rsal.ros2.type;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.FileVisitOption;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/// Reads a folder of definitions, laid out as packages of ROS 2 are: `PACKAGE/msg/NAME.msg`, `PACKAGE/srv/NAME.srv` and
/// `PACKAGE/action/NAME.action`, in the folder or below it. So the sources of a workspace can be read, and
/// `/opt/ros/DISTRIBUTION/share`.
public final class DefinitionFolder {
    private static final Pattern KIND = Pattern.compile("msg|srv|action");
    private static final int DEEPEST = 8; // folders, down to the file
    private static final Pattern NAME = Pattern.compile("[A-Za-z]\\w*");
    private static final int MOST_FILES = 200_000; // of all kinds, with folders
    private static final int LARGEST = 1_000_000; // B, of a file

    private DefinitionFolder() {}

    /// A type, and where it was read.
    private record Found(RosType type, Path file) {}

    /// All types that are defined there. Equal definitions may be there twice, as in the sources of a workspace and in
    /// what was built of them.
    ///
    /// @throws InvalidDefinition when there are none, or one can't be read; its message says in which file and line
    public static List<RosType> read(Path folder) {
        if (!Files.isDirectory(folder)) {
            throw new InvalidDefinition(
                    "'%s' is not a folder. Give one with files such as my_msgs/msg/Gas.msg.".formatted(folder));
        }
        Map<String, Found> all = new LinkedHashMap<>();
        for (Path file : files(folder)) {
            for (RosType type : types(file)) {
                Found other = all.putIfAbsent(type.name(), new Found(type, file));
                if (other != null && !other.type.equals(type)) {
                    throw new InvalidDefinition("'%s' and '%s' define '%s' differently. Give a folder with one of them."
                            .formatted(other.file, file, type.name()));
                }
            }
        }
        if (all.isEmpty()) {
            throw new InvalidDefinition(
                    "'%s' has no definitions. They should be in files such as my_msgs/msg/Gas.msg.".formatted(folder));
        }
        return all.values().stream().map(Found::type).toList();
    }

    /// Of definitions, by their paths.
    private static List<Path> files(Path folder) {
        var files = new ArrayList<Path>();
        int seen = 0;
        try (Stream<Path> walk =
                Files.walk(folder.toAbsolutePath().normalize(), DEEPEST, FileVisitOption.FOLLOW_LINKS)) {
            for (Path file : (Iterable<Path>) walk::iterator) {
                if (++seen > MOST_FILES) {
                    throw new InvalidDefinition("'%s' has more than %d files. Give a folder with the packages alone."
                            .formatted(folder, MOST_FILES));
                }
                if (isDefinition(file)) {
                    files.add(file);
                }
            }
        } catch (IOException | UncheckedIOException e) {
            throw new InvalidDefinition("'%s' can't be read: %s".formatted(folder, e.getMessage()));
        }
        files.sort(null);
        return files;
    }

    /// Whether it is `PACKAGE/KIND/NAME.KIND`, and no hidden file, as editors leave them.
    private static boolean isDefinition(Path file) {
        int count = file.getNameCount();
        if (count < 3) {
            return false;
        }
        String kind = file.getName(count - 2).toString();
        String name = file.getName(count - 1).toString();
        return KIND.matcher(kind).matches() && name.endsWith("." + kind) && !name.startsWith(".");
    }

    private static List<RosType> types(Path file) {
        int count = file.getNameCount();
        String kind = file.getName(count - 2).toString();
        String last = file.getName(count - 1).toString();
        String name = last.substring(0, last.length() - kind.length() - 1);
        String of = file.getName(count - 3).toString();
        for (String each : List.of(of, name)) {
            if (!NAME.matcher(each).matches()) {
                throw new InvalidDefinition(
                        "%s: '%s' is not a name in ROS. It may have letters, digits and underscores."
                                .formatted(file, each));
            }
        }
        try {
            if (Files.size(file) > LARGEST) {
                throw new InvalidDefinition("%s has more than %d bytes.".formatted(file, LARGEST));
            }
            return DefinitionReader.file("%s/%s/%s".formatted(of, kind, name), Files.readString(file), file.toString());
        } catch (CharacterCodingException e) {
            throw new InvalidDefinition("%s is not text in UTF-8.".formatted(file));
        } catch (IOException e) {
            throw new InvalidDefinition("%s can't be read: %s".formatted(file, e.getMessage()));
        }
    }
}
