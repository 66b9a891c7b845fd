package rsal.java;

import java.io.File;
import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.jar.Attributes;
import java.util.jar.JarFile;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticCollector;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.ToolProvider;
import org.eclipse.jdt.internal.compiler.tool.EclipseCompiler;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problems;

/// Compiles Java from text to classes in memory. It writes no file and runs nothing of what it compiles. It takes
/// the JDK's compiler; in a Java runtime without one, as some releases of RSAL carry, Eclipse's.
final class Compiler {
    /// Names of symbols that another file may declare, in the words of either compiler.
    private static final Pattern MISSING_CLASS = Pattern.compile(
            "symbol:\\s+(?:class|variable) (\\p{javaUpperCase}\\w*)|(\\p{javaUpperCase}\\w*) cannot be resolved");

    private static final int MOST_PROBLEMS = 50;
    private static final String CLASS_PATH = classPath();

    private Compiler() {}

    /// @return classes by their names
    /// @throws InvalidSettings with all errors, each where it is
    static Map<String, byte[]> compile(Sources sources) {
        return compile(
                sources,
                Optional.ofNullable(ToolProvider.getSystemJavaCompiler()).orElseGet(EclipseCompiler::new));
    }

    static Map<String, byte[]> compile(Sources sources, JavaCompiler compiler) {
        var reported = new DiagnosticCollector<JavaFileObject>();
        List<MemoryFiles.Source> units = sources.texts().entrySet().stream()
                .map(file -> new MemoryFiles.Source(file.getKey(), file.getValue()))
                .toList();
        try (var standard = compiler.getStandardFileManager(reported, Locale.ENGLISH, StandardCharsets.UTF_8);
                var files = new MemoryFiles(standard)) {
            if (!compiler.getTask(Writer.nullWriter(), files, reported, options(), null, units)
                    .call()) {
                throw errors(sources, reported.getDiagnostics());
            }
            return files.compiled();
        } catch (IOException e) {
            throw new InvalidSettings(
                    Location.of(sources.path()), "This can't be compiled: %s.".formatted(e.getMessage()), "");
        }
    }

    /// What this process can use, agents can: its classes are found as they are by the process itself.
    private static List<String> options() {
        var options = new ArrayList<>(List.of("-proc:none", "-nowarn", "-g", "-parameters"));
        String version = Integer.toString(Runtime.version().feature());
        options.addAll(List.of("-source", version, "-target", version));
        String modules = System.getProperty("jdk.module.path", "");
        if (!modules.isEmpty()) {
            options.addAll(List.of("--module-path", modules, "--add-modules", "ALL-MODULE-PATH"));
        }
        options.addAll(List.of("-classpath", CLASS_PATH));
        return options;
    }

    /// The class path with all jars that its first one names, as that of a release does: Eclipse's compiler reads no
    /// manifests.
    private static String classPath() {
        String path = System.getProperty("java.class.path", "");
        if (!path.endsWith(".jar") || path.contains(File.pathSeparator)) {
            return path;
        }
        Path jar = Path.of(path);
        try (var file = new JarFile(path)) {
            String named = Optional.ofNullable(file.getManifest())
                    .map(manifest -> manifest.getMainAttributes().getValue(Attributes.Name.CLASS_PATH))
                    .orElse("");
            return Stream.concat(
                            Stream.of(path),
                            Arrays.stream(named.split(" "))
                                    .filter(name -> !name.isEmpty())
                                    .map(name -> jar.resolveSibling(name).toString()))
                    .collect(Collectors.joining(File.pathSeparator));
        } catch (IOException _) { // then nothing of RSAL could have been loaded from it
            return path;
        }
    }

    private static InvalidSettings errors(Sources sources, List<Diagnostic<? extends JavaFileObject>> reported) {
        var problems = new Problems(MOST_PROBLEMS);
        for (Diagnostic<? extends JavaFileObject> one : reported) {
            if (one.getKind() == Diagnostic.Kind.ERROR) {
                String message = one.getMessage(Locale.ENGLISH);
                problems.add(
                        at(sources, one),
                        "Java can't compile this: %s."
                                .formatted(message.strip()
                                        .replaceAll("\\s*\\R\\s*", ", ")
                                        .replaceAll("\\s+", " ")),
                        remedy(message));
            }
        }
        problems.throwIfAny();
        return new InvalidSettings(Location.of(sources.path()), "Java can't compile this.", "");
    }

    private static Location at(Sources sources, Diagnostic<? extends JavaFileObject> reported) {
        String file = fileOf(sources, reported);
        return reported.getLineNumber() == Diagnostic.NOPOS
                ? Location.of(file)
                : new Location(file, (int) reported.getLineNumber(), (int) reported.getColumnNumber());
    }

    /// The path of the file in which it is, as its author knows it.
    private static String fileOf(Sources sources, Diagnostic<? extends JavaFileObject> reported) {
        if (reported.getSource() instanceof MemoryFiles.Source source) {
            return source.path();
        }
        // Eclipse's compiler says the file only where that is on disk. It is the one that has what is wrong at that
        // place.
        return sources.texts().entrySet().stream()
                .max(Comparator.comparingInt(file -> evidence(file.getValue(), reported)))
                .map(Map.Entry::getKey)
                .orElseThrow();
    }

    /// How well an error fits to a text: 0 where its line is another one, 2 where its message has the words of the
    /// text.
    private static int evidence(String text, Diagnostic<?> reported) {
        long start = reported.getStartPosition();
        long end = reported.getEndPosition() + 1;
        if (start < 0 || end < start || end > text.length()) {
            return 0;
        }
        long line = 1
                + text.substring(0, (int) start).chars().filter(c -> c == '\n').count();
        if (line != reported.getLineNumber()) {
            return 0;
        }
        return reported.getMessage(Locale.ENGLISH).contains(text.substring((int) start, (int) end)) ? 2 : 1;
    }

    private static String remedy(String message) {
        Matcher missing = MISSING_CLASS.matcher(message);
        return missing.find()
                ? "Maybe an import is missing, or a file '%s%s' beside it."
                        .formatted(
                                Optional.ofNullable(missing.group(1)).orElseGet(() -> missing.group(2)), Sources.SUFFIX)
                : "";
    }
}
