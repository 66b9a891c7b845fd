package rsal.cli;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/// What the source of a type tells those who use it, as Markdown.
///
/// @param about its doc comment
/// @param methods that others may call, in the order of the source
/// @param parameters what `@param` says of each
record SourceText(String about, List<Method> methods, Map<String, String> parameters) {
    private static final Path PROJECT = Path.of("../..");
    /// A method that others may call, on one line as the formatter leaves it.
    private static final Pattern METHOD = Pattern.compile(
            " {4}(public |default )?((?! |record|sealed|enum|class|static|private|protected|final)[\\w<>,.?\\[\\] ]+ \\w+\\(.*\\)) ?[;{]");

    record Method(String signature, String about) {}

    static SourceText of(Class<?> type) {
        String about = "";
        Map<String, String> parameters = Map.of();
        var methods = new ArrayList<Method>();
        var doc = new ArrayList<String>();
        for (String line : lines(type)) {
            String text = line.strip();
            if (text.startsWith("///")) {
                doc.add(text.substring(3).strip());
                continue;
            }
            if (text.startsWith("@")) {
                continue; // an annotation stands between a comment and what it is about
            }
            Matcher method = METHOD.matcher(line);
            if (text.startsWith("public ") && text.contains(" " + type.getSimpleName()) && about.isEmpty()) {
                about = reported(doc);
                parameters = parameters(doc);
            } else if (method.matches() && (type.isInterface() || "public ".equals(method.group(1)))) {
                methods.add(new Method(method.group(2), Markdown.firstSentence(reported(doc))));
            }
            doc.clear();
        }
        return new SourceText(about, methods, parameters);
    }

    /// A link to the source, from a page of the reference.
    static String link(Class<?> type) {
        return "[`%s`](../../%s)".formatted(type.getName(), PROJECT.relativize(file(type)));
    }

    /// In whichever module it is.
    private static Path file(Class<?> type) {
        String inModule = "src/main/java/" + type.getName().replace('.', '/') + ".java";
        return Stream.of("middle", "agents")
                .flatMap(layer -> folders(PROJECT.resolve(layer)))
                .map(module -> module.resolve(inModule))
                .filter(Files::exists)
                .findFirst()
                .orElseThrow();
    }

    private static Stream<Path> folders(Path layer) {
        try (Stream<Path> modules = Files.list(layer)) {
            return modules.toList().stream();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static List<String> lines(Class<?> type) {
        try {
            return Files.readAllLines(file(type));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /// The words of a doc comment, with names of other types as code.
    private static String reported(List<String> doc) {
        return joined(doc.stream().takeWhile(line -> !line.startsWith("@")));
    }

    private static Map<String, String> parameters(List<String> doc) {
        var parameters = new LinkedHashMap<String, String>();
        String name = "";
        for (String line : doc) {
            if (line.startsWith("@param ")) {
                String[] words = line.split(" ", 3);
                name = words[1];
                parameters.put(name, joined(Stream.of(words[2])));
            } else if (line.startsWith("@")) {
                name = "";
            } else if (!name.isEmpty()) {
                parameters.merge(name, joined(Stream.of(line)), (before, more) -> before + " " + more);
            }
        }
        return parameters;
    }

    private static String joined(Stream<String> lines) {
        return lines.map(line -> line.isEmpty() ? "\n\n" : line)
                .collect(Collectors.joining(" "))
                .replaceAll(" *\n\n *", "\n\n")
                .replaceAll("\\[([^\\]]+)\\]\\[[^\\]]+\\]", "$1")
                .replaceAll("\\[(?:#(\\w+)|([A-Z]\\w+))\\]", "`$1$2`") // no units: [m], [J]
                .replaceAll("\\[([A-Z]\\w+)#(\\w+)\\]", "`$1.$2`")
                .strip();
    }
}
