package rsal.java;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Modifier;
import java.util.List;
import java.util.function.Supplier;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// The class in a Java file of somebody's own, of which RSAL makes objects.
///
/// @param at its file
record JavaClass(Constructor<?> constructor, Location at) {
    /// What such a class is for.
    ///
    /// @param what to call it in messages: `agent`
    /// @param kinds of which it must be one
    /// @param remedy what to do when it is none
    record Use(String what, List<Class<?>> kinds, String remedy) {
        Use {
            kinds = List.copyOf(kinds);
        }

        private String withArticle() {
            return ("aeiou".indexOf(what.charAt(0)) >= 0 ? "an " : "a ") + what;
        }
    }

    /// @throws InvalidSettings when the file has no class that can be used
    static JavaClass of(Sources sources, FolderClasses classes, Use use) {
        Location at = Location.of(sources.path());
        return new JavaClass(constructor(type(sources, classes, use, at), use, at), at);
    }

    /// Whether a file has a class of its name, which is of a kind.
    static boolean isOf(Class<?> kind, Sources sources, FolderClasses classes) {
        try {
            return kind.isAssignableFrom(classes.loadClass(sources.className()));
        } catch (ClassNotFoundException | LinkageError _) {
            return false;
        }
    }

    private static Class<?> type(Sources sources, FolderClasses classes, Use use, Location at) {
        String name = sources.className();
        Class<?> type;
        try {
            type = classes.loadClass(name);
        } catch (ClassNotFoundException | LinkageError _) {
            throw new InvalidSettings(
                    at,
                    "There is no class '%s' in this file.".formatted(sources.simpleName()),
                    "Give the class the name of the file.");
        }
        if (type.getClassLoader() != classes) {
            throw new InvalidSettings(
                    at, "RSAL has a class '%s' already.".formatted(name), "Rename the class and its file.");
        }
        if (use.kinds().stream().noneMatch(kind -> kind.isAssignableFrom(type))) {
            throw new InvalidSettings(
                    at, "Class '%s' is not of the kind '%s'.".formatted(name, use.what()), use.remedy());
        }
        return type;
    }

    private static Constructor<?> constructor(Class<?> type, Use use, Location at) {
        try {
            if (Modifier.isPublic(type.getModifiers()) && !Modifier.isAbstract(type.getModifiers())) {
                return type.getConstructor();
            }
        } catch (NoSuchMethodException | LinkageError _) {
            // told below
        }
        throw new InvalidSettings(
                at,
                "Class '%s' can't be used as %s.".formatted(type.getName(), use.withArticle()),
                "Make it public, not abstract, and give it a public constructor without parameters.");
    }

    boolean is(Class<?> kind) {
        return kind.isAssignableFrom(constructor.getDeclaringClass());
    }

    /// @throws InvalidSettings when the class fails
    <T> T create(Class<T> kind) {
        try {
            return kind.cast(constructor.newInstance());
        } catch (InvocationTargetException e) {
            throw failed(e.getTargetException());
        } catch (ReflectiveOperationException | LinkageError e) {
            throw failed(e);
        }
    }

    /// Asks an object of the class for something.
    ///
    /// @throws InvalidSettings when the class fails
    <T> T blaming(Supplier<T> asked) {
        try {
            return asked.get();
        } catch (RuntimeException | LinkageError e) {
            throw failed(e);
        }
    }

    private InvalidSettings failed(Throwable why) {
        String name = constructor.getDeclaringClass().getName();
        Throwable cause = why instanceof ExceptionInInitializerError && why.getCause() != null ? why.getCause() : why;
        Location where = List.of(cause.getStackTrace()).stream()
                .filter(call -> call.getClassName().startsWith(name) && call.getLineNumber() > 0)
                .findFirst()
                .map(call -> new Location(at.file(), call.getLineNumber(), 1))
                .orElse(at);
        return new InvalidSettings(where, "Class '%s' fails: %s.".formatted(name, cause), "");
    }
}
