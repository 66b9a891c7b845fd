package rsal.server;

import java.lang.reflect.AnnotatedParameterizedType;
import java.lang.reflect.AnnotatedType;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import rsal.engine.OperatorCommand;
import rsal.engine.report.Answer;
import rsal.settings.Parameter;

/// Writes records as TypeScript interfaces.
final class TypeScript {
    private TypeScript() {}

    /// Of all records inside a class, in alphabetical order.
    static String of(Class<?> home) {
        return "// Generated from the Java records in %s by PageTypesTest. Do not edit.\n\n"
                        .formatted(home.getName().replace('.', '/'))
                + Arrays.stream(home.getDeclaredClasses())
                        .flatMap(type -> Stream.concat(Stream.of(type), Arrays.stream(type.getDeclaredClasses())))
                        .sorted((a, b) -> a.getSimpleName().compareTo(b.getSimpleName()))
                        .map(TypeScript::declaration)
                        .collect(Collectors.joining("\n"));
    }

    /// What commands take and answer.
    static String of(List<OperatorCommand> commands) {
        return commands.stream().map(TypeScript::declaration).collect(Collectors.joining("", """

                        /** Commands that people give to runs, from OperatorCommands: what each takes and answers. */
                        export interface Commands {
                        """, "}\n"));
    }

    private static String declaration(OperatorCommand command) {
        String takes = command.parameters().isEmpty()
                ? "Record<string, never>"
                : command.parameters().stream()
                        .map(each -> each.name() + (each.fallback().isEmpty() ? ": " : "?: ") + name(each))
                        .collect(Collectors.joining("; ", "{ ", " }"));
        String answers = command.answer() == Answer.Done.class
                ? "object"
                : command.answer().getSimpleName();
        String name = command.name().contains("-") ? "'" + command.name() + "'" : command.name();
        return "  /** %s */\n  %s: { takes: %s; answers: %s };\n"
                .formatted(command.description(), name, takes, answers);
    }

    private static String name(Parameter<?> parameter) {
        return switch (parameter.kind()) {
            case NUMBER, INTEGER -> "number";
            case FLAG -> "boolean";
            case TEXTS -> "Record<string, string>";
            case TEXT ->
                parameter.options().isEmpty()
                        ? "string"
                        : parameter.options().stream()
                                .map(option -> "'" + option + "'")
                                .collect(Collectors.joining(" | "));
            case ROBOTS, PLACES, POINTS, PLUGIN, PLUGINS -> "string";
        };
    }

    private static String declaration(Class<?> type) {
        if (type.isEnum()) {
            return Arrays.stream(type.getEnumConstants())
                    .map(constant -> "'" + constant + "'")
                    .collect(Collectors.joining(" | ", "export type " + type.getSimpleName() + " = ", ";\n"));
        }
        return Arrays.stream(type.getRecordComponents())
                .map(TypeScript::member)
                .collect(Collectors.joining("", "export interface " + type.getSimpleName() + " {\n", "}\n"));
    }

    private static String member(RecordComponent component) {
        return "  %s: %s;\n".formatted(component.getName(), name(component.getAnnotatedType()));
    }

    private static String name(AnnotatedType type) {
        String name = type instanceof AnnotatedParameterizedType generic
                ? generic(generic)
                : plain((Class<?>) type.getType());
        return type.isAnnotationPresent(Nullable.class) ? name + " | null" : name;
    }

    private static String generic(AnnotatedParameterizedType type) {
        Type raw = ((ParameterizedType) type.getType()).getRawType();
        AnnotatedType[] arguments = type.getAnnotatedActualTypeArguments();
        if (raw == List.class) {
            String element = name(arguments[0]);
            return (element.contains(" | ") ? "(%s)" : "%s").formatted(element) + "[]";
        }
        if (raw == Optional.class) {
            return name(arguments[0]) + " | null";
        }
        if (raw == Map.class) {
            return "Record<string, " + name(arguments[1]) + ">";
        }
        throw new IllegalArgumentException("There is no TypeScript for " + type + ".");
    }

    private static String plain(Class<?> type) {
        if (type == String.class) {
            return "string";
        }
        if (type == boolean.class || type == Boolean.class) {
            return "boolean";
        }
        if (type.isPrimitive() || Number.class.isAssignableFrom(type)) {
            return "number";
        }
        return type.getSimpleName(); // another record, which tsc looks for
    }
}
