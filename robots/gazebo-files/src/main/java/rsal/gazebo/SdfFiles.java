package rsal.gazebo;

import java.io.File;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import rsal.model.xml.XmlElement;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// Files that a world names by a URI: beside the file that names them or beside the world, `model://` also in a folder
/// `models` there or beside that of the world, and in the folders of the environment's resource paths when all files
/// may be read. Nothing is fetched from a network.
final class SdfFiles {
    private static final int MOST_BYTES = 1 << 26; // of a description
    private static final int MOST_ELEMENTS = 500_000; // of a file
    private static final int MOST_MESH_BYTES = 1 << 26;
    private static final int MOST_FILES = 1_000;
    private static final Pattern NETWORK = Pattern.compile("(?i)[a-z]+://.*");
    private static final Pattern DESCRIPTION = Pattern.compile("(?i).*\\.(sdf|world|xml|model|urdf)");
    private static final List<String> SEARCHED =
            List.of("GZ_SIM_RESOURCE_PATH", "IGN_GAZEBO_RESOURCE_PATH", "SDF_PATH", "GAZEBO_MODEL_PATH");

    private final FileSource source;
    private final String world;
    private final List<String> searchPath;
    private final Map<String, Optional<XmlElement>> known = new HashMap<>();
    private int read;

    /// @param world its path
    /// @param environment variables of the process
    SdfFiles(FileSource source, String world, Map<String, String> environment) {
        this.source = source;
        this.world = world;
        this.searchPath = source.everywhere() ? searchPath(environment) : List.of();
    }

    private static List<String> searchPath(Map<String, String> environment) {
        return SEARCHED.stream()
                .flatMap(name -> Stream.of(environment.getOrDefault(name, "").split(File.pathSeparator)))
                .filter(folder -> !folder.isBlank())
                .toList();
    }

    /// The world itself.
    ///
    /// @throws InvalidSettings when it can't be read
    XmlElement world() {
        return parsed(world, source.text(world, MOST_BYTES, Location.of(world)));
    }

    private static XmlElement parsed(String path, String text) {
        String xml = text.startsWith("\uFEFF") ? text.substring(1) : text;
        return XmlElement.read(xml, path, MOST_ELEMENTS, "");
    }

    /// The description of a model that is to be included; empty when there is none.
    ///
    /// @param askedAt where it is named
    /// @throws InvalidSettings when it is there and can't be read
    Optional<XmlElement> model(String uri, Location askedAt) {
        for (String path : paths(uri, askedAt.file())) {
            Optional<XmlElement> found = DESCRIPTION.matcher(path).matches()
                    ? description(path, askedAt)
                    : description(inFolder(path, askedAt), askedAt);
            if (found.isPresent()) {
                return found;
            }
        }
        return Optional.empty();
    }

    private Optional<XmlElement> description(String path, Location askedAt) {
        Optional<XmlElement> before = known.get(path);
        if (before != null) {
            return before;
        }
        Optional<XmlElement> found = text(path, askedAt).map(text -> parsed(path, text));
        known.put(path, found);
        return found;
    }

    /// The file that a model's folder names in its `model.config`.
    private String inFolder(String folder, Location askedAt) {
        return description(folder + "/model.config", askedAt)
                .flatMap(config -> config.all("sdf").reduce((_, last) -> last))
                .map(XmlElement::text)
                .filter(name -> !name.isEmpty() && !name.contains(".."))
                .map(name -> folder + "/" + name)
                .orElse(folder + "/model.sdf");
    }

    private Optional<String> text(String path, Location askedAt) {
        if (++read > MOST_FILES) {
            throw new InvalidSettings(askedAt, "This world names more than %d files.".formatted(MOST_FILES), "");
        }
        try {
            source.read(path, MOST_BYTES, askedAt);
        } catch (InvalidSettings _) {
            return Optional.empty();
        }
        return Optional.of(source.text(path, MOST_BYTES, askedAt));
    }

    /// A mesh, with the path where it is; empty when there is none that can be read.
    Optional<byte[]> mesh(String uri, Location askedAt) {
        for (String path : paths(uri, askedAt.file())) {
            try {
                return Optional.of(source.read(path, MOST_MESH_BYTES, askedAt));
            } catch (InvalidSettings _) {
                // the next
            }
        }
        return Optional.empty();
    }

    /// Where what a URI names may be, the likeliest first.
    ///
    /// @param asking the file that names it
    private List<String> paths(String uri, String asking) {
        var paths = new LinkedHashSet<String>();
        if (uri.startsWith("model://") || uri.startsWith("package://")) {
            String name = uri.substring(uri.indexOf("://") + 3);
            for (String folder : List.of("", "models/", "../", "../models/")) {
                paths.add(folder(world) + folder + name);
            }
            searchPath.forEach(folder -> paths.add(folder + "/" + name));
        } else if (uri.startsWith("file://") || !NETWORK.matcher(uri).matches()) {
            String name = uri.startsWith("file://") ? uri.substring("file://".length()) : uri;
            if (name.startsWith("/")) {
                paths.add(name);
            } else {
                paths.add(folder(asking) + name);
                paths.add(folder(world) + name);
                searchPath.forEach(folder -> paths.add(folder + "/" + name));
            }
        }
        return new ArrayList<>(paths);
    }

    /// Whether a URI names something in a network.
    static boolean isFar(String uri) {
        return NETWORK.matcher(uri).matches()
                && !uri.startsWith("model://")
                && !uri.startsWith("package://")
                && !uri.startsWith("file://");
    }

    /// The folder of a path with its slash; empty when there is none.
    private static String folder(String path) {
        return path.substring(0, path.lastIndexOf('/') + 1);
    }
}
