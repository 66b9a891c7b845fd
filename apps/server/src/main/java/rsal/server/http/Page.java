package rsal.server.http;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/// The built page, read into memory once: no request ever reaches the file system.
public final class Page {
    private static final String PACKED = ".gz";
    private static final Map<String, String> TYPES = Map.of(
            "html", "text/html; charset=utf-8",
            "js", "text/javascript; charset=utf-8",
            "css", "text/css; charset=utf-8",
            "svg", "image/svg+xml",
            "png", "image/png");

    private final Map<String, Asset> assets = new HashMap<>();

    /// @param packed the same by gzip, for those who take that; where the build has left it
    /// @param hashed whether its name changes with its content, so that browsers may keep it
    record Asset(byte[] content, Optional<byte[]> packed, String type, boolean hashed) {}

    /// @param directory what the page's build left: `index.html` and what it refers to
    /// @throws IOException when there is no page
    public Page(Path directory) throws IOException {
        if (!Files.isRegularFile(directory.resolve("index.html"))) {
            throw new IOException(
                    "There is no built page in '%s'. Build it: npm --prefix apps/web run build".formatted(directory));
        }
        try (Stream<Path> files = Files.walk(directory)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                String name = directory.relativize(file).toString().replace('\\', '/');
                if (!name.endsWith(PACKED)) {
                    assets.put("/" + name, asset(file, name));
                }
            }
        }
    }

    private static Asset asset(Path file, String name) throws IOException {
        Path packed = file.resolveSibling(file.getFileName() + PACKED);
        return new Asset(
                Files.readAllBytes(file),
                Files.isRegularFile(packed) ? Optional.of(Files.readAllBytes(packed)) : Optional.empty(),
                TYPES.getOrDefault(name.substring(name.lastIndexOf('.') + 1), "application/octet-stream"),
                name.startsWith("assets/"));
    }

    /// @param path of a request: `/`, `/assets/index-1a2b.js`
    Optional<Asset> find(String path) {
        return Optional.ofNullable(assets.get(path.equals("/") ? "/index.html" : path));
    }
}
