package rsal.python;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.Method;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/// Writes Java's records and enumerations as Python's dataclasses, with what their comments say.
final class PythonSourceWriter {
    private static final Path ROOT = Path.of("../..");
    private static final Pattern CODE = Pattern.compile("`([^`]+)`");
    private static final Pattern LINK = Pattern.compile("\\[(?:[\\w.]*#)?([\\w.]+)\\](?!\\()");
    private static final Map<String, String> METHODS = Map.of(
            "Pose2d", "PoseMethods",
            "Point2d", "PointMethods",
            "LaserScan", "ScanMethods");

    private final Map<Class<?>, String> names = new LinkedHashMap<>(); // in Python, each after those that it needs
    private final Map<Class<?>, String> imported;
    private boolean arrays;

    /// @param imported what another module has, with the names there
    PythonSourceWriter(Map<Class<?>, String> imported) {
        this.imported = imported;
    }

    Map<Class<?>, String> names() {
        return names;
    }

    /// All records and enumerations in the type, if all of it can be had in Python.
    boolean add(Type type) {
        if (!isKnown(type)) {
            return false;
        }
        addAll(type);
        return true;
    }

    private static boolean isKnown(Type type) {
        if (type instanceof ParameterizedType several) {
            return (Collection.class.isAssignableFrom((Class<?>) several.getRawType())
                            || Map.class.isAssignableFrom((Class<?>) several.getRawType())
                            || several.getRawType() == Optional.class)
                    && Stream.of(several.getActualTypeArguments()).allMatch(PythonSourceWriter::isKnown);
        }
        if (!(type instanceof Class<?> plain)) {
            return false;
        }
        if (plain.isSealed() && plain.isInterface()) {
            return Stream.of(plain.getPermittedSubclasses()).allMatch(PythonSourceWriter::isKnown);
        }
        return simple(plain).isPresent()
                || plain.isEnum()
                || (plain.isRecord()
                        && plain.getTypeParameters().length == 0
                        && Stream.of(plain.getRecordComponents()).allMatch(each -> isKnown(each.getGenericType())));
    }

    private static Optional<String> simple(Class<?> type) {
        if (type == double.class || type == Double.class || type == Duration.class || type == Instant.class) {
            return Optional.of("float");
        }
        if (type == int.class || type == Integer.class || type == long.class) {
            return Optional.of("int");
        }
        if (type == boolean.class || type == Boolean.class) {
            return Optional.of("bool");
        }
        if (type == OptionalInt.class) {
            return Optional.of("int | None");
        }
        if (type == OptionalDouble.class) {
            return Optional.of("float | None");
        }
        if (type.isArray()) {
            Class<?> item = type.getComponentType();
            return item == float.class
                    ? Optional.of("npt.NDArray[np.float32]")
                    : item == double.class
                            ? Optional.of("npt.NDArray[np.float64]")
                            : item == byte.class ? Optional.of("npt.NDArray[np.int8]") : Optional.empty();
        }
        return type == String.class ? Optional.of("str") : Optional.empty();
    }

    private void addAll(Type type) {
        if (type instanceof ParameterizedType several) {
            Stream.of(several.getActualTypeArguments()).forEach(this::addAll);
        } else if (type instanceof Class<?> plain && !names.containsKey(plain) && !imported.containsKey(plain)) {
            if (plain.isSealed() && plain.isInterface()) {
                Stream.of(plain.getPermittedSubclasses()).forEach(this::addAll);
            } else if (plain.isRecord()) {
                Stream.of(plain.getRecordComponents()).forEach(each -> addAll(each.getGenericType()));
                names.put(plain, name(plain));
            } else if (plain.isEnum()) {
                names.put(plain, name(plain));
            }
        }
    }

    /// `NavigatorReached` for `Navigator.Result.Reached`; its own name where that is clear.
    private String name(Class<?> type) {
        String name = shortName(type);
        return imported.containsValue(name) || names.containsValue(name)
                ? type.getDeclaringClass().getSimpleName() + name
                : name;
    }

    private static String shortName(Class<?> type) {
        Class<?> outer = type.getDeclaringClass();
        if (outer == null) {
            return type.getSimpleName();
        }
        if (outer.getSimpleName().equals("Result")) {
            return outer.getDeclaringClass().getSimpleName() + type.getSimpleName();
        }
        boolean common =
                List.of("Progress", "Stage", "Kind", "Ok", "Stale", "Lost").contains(type.getSimpleName());
        return common ? outer.getSimpleName() + type.getSimpleName() : type.getSimpleName();
    }

    /// Types that methods of a contract take and return.
    void addContract(Class<?> contract) {
        for (Type each : contract.getGenericInterfaces()) {
            addInside(each);
        }
        for (Method method : sorted(contract.getDeclaredMethods())) {
            addInside(method.getGenericReturnType());
            Stream.of(method.getGenericParameterTypes()).forEach(this::addInside);
        }
    }

    private static List<Method> sorted(Method[] methods) {
        var all = new TreeMap<String, Method>();
        Stream.of(methods)
                .filter(method -> !method.isSynthetic())
                .forEach(method -> all.put(method.toGenericString(), method));
        return List.copyOf(all.values());
    }

    private void addInside(Type type) {
        if (!add(type) && type instanceof ParameterizedType several) {
            Stream.of(several.getActualTypeArguments()).forEach(this::addInside);
        }
    }

    private String written(Type type) {
        if (type instanceof ParameterizedType several) {
            Class<?> raw = (Class<?>) several.getRawType();
            List<String> inner = Stream.of(several.getActualTypeArguments())
                    .map(this::written)
                    .toList();
            return raw == Optional.class
                    ? inner.getFirst() + " | None"
                    : Map.class.isAssignableFrom(raw)
                            ? "dict[%s]".formatted(String.join(", ", inner))
                            : "list[%s]".formatted(inner.getFirst());
        }
        Class<?> plain = (Class<?>) type;
        if (plain.isSealed() && plain.isInterface()) {
            return Stream.of(plain.getPermittedSubclasses()).map(this::written).collect(Collectors.joining(" | "));
        }
        arrays |= plain.isArray();
        return simple(plain).or(() -> Optional.ofNullable(names.get(plain))).orElseGet(() -> imported.get(plain));
    }

    /// @param topics of messages, by their types
    String text(String doc, Map<Class<?>, String> topics) {
        var classes = new StringBuilder();
        names.forEach((type, name) ->
                classes.append("\n\n").append(type.isEnum() ? words(type, name) : fields(type, name, topics)));
        var text = new StringBuilder(
                "\"\"\"%s\n\nGenerated from Java by `PythonValuesTest`: do not edit.\n\"\"\"\n\n".formatted(doc));
        text.append("from __future__ import annotations\n\n");
        boolean enums = names.keySet().stream().anyMatch(Class::isEnum);
        text.append(enums ? "import enum\n" : "");
        text.append("from dataclasses import dataclass\nfrom typing import ClassVar\n");
        if (arrays) {
            text.append("\nimport numpy as np\nimport numpy.typing as npt\n");
        }
        String used = imported.values().stream()
                .filter(name ->
                        Pattern.compile("\\b" + name + "\\b").matcher(classes).find())
                .sorted()
                .collect(Collectors.joining(", "));
        if (!used.isEmpty()) {
            text.append("\nfrom rsal.agents.values import ").append(used).append('\n');
        }
        if (topics.isEmpty()) {
            text.append("\nfrom rsal.agents.geometry import ")
                    .append(METHODS.values().stream().sorted().collect(Collectors.joining(", ")))
                    .append('\n');
        }
        return text.append(classes).toString();
    }

    private String words(Class<?> type, String name) {
        var text = new StringBuilder("class %s(enum.Enum):\n".formatted(name));
        text.append(doc(comment(type), "    ")).append('\n');
        for (Object each : Objects.requireNonNull(type.getEnumConstants())) {
            String word = ((Enum<?>) each).name();
            text.append("    %s = \"%s\"\n".formatted(word, word));
        }
        return text.toString();
    }

    private String fields(Class<?> type, String name, Map<Class<?>, String> topics) {
        RecordComponent[] components = type.getRecordComponents();
        boolean hasArrays =
                Stream.of(components).anyMatch(each -> each.getType().isArray());
        var text =
                new StringBuilder("@dataclass(frozen=True%s)\n".formatted(hasArrays ? ", eq=False" : ", slots=True"));
        text.append("class %s%s:\n"
                .formatted(
                        name,
                        METHODS.containsKey(name) && topics.isEmpty() ? "(%s)".formatted(METHODS.get(name)) : ""));
        String doc = doc(comment(type), "    ");
        text.append(doc);
        String tag = "";
        if (Stream.of(type.getInterfaces()).anyMatch(Class::isSealed)) {
            tag += "    _type: ClassVar[str] = \"%s\"\n".formatted(type.getSimpleName());
        }
        if (topics.containsKey(type)) {
            tag += "    topic: ClassVar[str] = \"%s\"\n".formatted(topics.get(type));
        }
        text.append(doc.isEmpty() || tag.isEmpty() ? "" : "\n").append(tag);
        if (components.length > 0 && (!doc.isEmpty() || !tag.isEmpty())) {
            text.append('\n');
        }
        for (RecordComponent each : components) {
            text.append("    %s: %s\n".formatted(snake(each.getName()), written(each.getGenericType())));
        }
        if (doc.isEmpty() && tag.isEmpty() && components.length == 0) {
            text.append("    pass\n");
        }
        return text.toString();
    }

    static String snake(String name) {
        return Pattern.compile("(?<=[a-z0-9])([A-Z])")
                .matcher(name)
                .replaceAll(found -> "_" + found.group(1))
                .toLowerCase(Locale.ROOT);
    }

    /// The lines of a comment as a text of documentation.
    private static String doc(List<String> comment, String indent) {
        if (comment.isEmpty()) {
            return "";
        }
        var text = new StringBuilder();
        String last = "";
        for (String line : comment) {
            Matcher parameter = Pattern.compile("@param (\\w+) (.*)").matcher(line);
            if (parameter.matches()) {
                line = ":param %s: %s".formatted(snake(parameter.group(1)), parameter.group(2));
            } else if (last.startsWith(":param") && !line.isEmpty()) {
                line = "    " + line.strip();
            }
            text.append(line.isEmpty() ? "" : indent).append(line).append('\n');
            last = line.startsWith("    ") ? last : line;
        }
        String body = summaryFirst(text.toString().strip(), indent);
        return body.contains("\n")
                ? "%s\"\"\"%s\n%s\"\"\"\n".formatted(indent, body, indent)
                : "%s\"\"\"%s\"\"\"\n".formatted(indent, body);
    }

    /// The first sentence in a line of its own, as PEP 257 has it.
    private static String summaryFirst(String body, String indent) {
        int end = Stream.of(body.indexOf("\n\n"), body.indexOf("\n" + indent + ":param"))
                .filter(at -> at >= 0)
                .min(Integer::compare)
                .orElse(body.length());
        String paragraph = body.substring(0, end);
        if (!paragraph.contains("\n")) {
            return body;
        }
        String[] sentences = paragraph.replaceAll("\\s*\\n\\s*", " ").split("(?<=[.:;]) (?=\\S)", 2);
        if (sentences.length == 1) {
            return body;
        }
        var text = new StringBuilder(sentences[0].replaceFirst("[:;]$", ".")).append('\n');
        String line = "";
        String rest = sentences[1].substring(0, 1).toUpperCase(Locale.ROOT) + sentences[1].substring(1);
        for (String word : List.of(rest.split(" ", -1))) {
            if (line.isEmpty() || line.length() + word.length() > 110) {
                text.append(line.isEmpty() ? "" : line + "\n");
                line = indent + word;
            } else {
                line += " " + word;
            }
        }
        return text.insert(text.indexOf("\n"), "\n")
                .append(line)
                .append(body.substring(end))
                .toString();
    }

    /// What stands above a type in its Java file; its name in Java if nothing does.
    private static List<String> comment(Class<?> type) {
        List<String> written = written(type, source(type));
        return written.isEmpty()
                ? List.of("As `%s` in Java.".formatted(type.getCanonicalName().replaceFirst("^[a-z.]*", "")))
                : written;
    }

    private static List<String> written(Class<?> type, List<String> lines) {
        Pattern declaration = Pattern.compile(
                "\\s*(?:public |static |private )*(?:record|enum) %s\\b.*".formatted(type.getSimpleName()));
        var comment = new ArrayList<String>();
        for (String line : lines) {
            String bare = line.strip();
            if (bare.startsWith("///")) {
                comment.add(plain(bare.substring("///".length()).replaceFirst("^ ", "")));
            } else if (declaration.matcher(line).matches()) {
                return comment;
            } else if (!bare.startsWith("@")) {
                comment.clear();
            }
        }
        return List.of();
    }

    /// Names of variables as Python has them; those of classes stay.
    private static String inPython(String code) {
        return Pattern.compile("\\b[a-z]\\w*").matcher(code).replaceAll(found -> snake(found.group()));
    }

    private static String plain(String line) {
        String text = LINK.matcher(line.replace('–', '-').replace('−', '-').replace('×', 'x'))
                .replaceAll(found -> found.group(1).matches("[^A-Z]*\\d.*|m|rad|s|deg|px|W|J|V|Wh|mm")
                        ? Matcher.quoteReplacement(found.group())
                        : found.group(1));
        return CODE.matcher(text)
                .replaceAll(found -> Matcher.quoteReplacement("``%s``".formatted(inPython(found.group(1)))));
    }

    private static List<String> source(Class<?> type) {
        Class<?> top = type;
        while (top.getDeclaringClass() != null) {
            top = top.getDeclaringClass();
        }
        String path = top.getName().replace('.', '/') + ".java";
        try (Stream<Path> layers = Files.list(ROOT)) {
            for (Path layer : layers.filter(Files::isDirectory).sorted().toList()) {
                try (Stream<Path> modules = Files.list(layer)) {
                    Optional<Path> file = modules.map(
                                    module -> module.resolve("src/main/java").resolve(path))
                            .filter(Files::exists)
                            .findFirst();
                    if (file.isPresent()) {
                        return Files.readAllLines(file.get());
                    }
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        throw new IllegalStateException("There is no source of " + type);
    }
}
