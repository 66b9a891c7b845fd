package rsal.java;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Modifier;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.agent.Outline;
import rsal.device.Device;
import rsal.settings.Arguments;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Parameter;
import rsal.settings.Problem;

/// A kind of agent that somebody wrote in a Java file of their own: as it says of itself, but called by the
/// file.
///
/// @param key path of the file
record JavaType(String key, String description, List<Parameter> parameters, AgentType own) implements AgentType {
    JavaType {
        parameters = List.copyOf(parameters);
    }

    /// @throws InvalidSettings when the file has no class that can be used
    static AgentType of(Sources sources, FolderClasses classes) {
        Location at = Location.of(sources.path());
        Constructor<?> constructor = constructor(type(sources, classes, at), at);
        if (Agent.class.isAssignableFrom(constructor.getDeclaringClass())) {
            return new JavaType(
                    sources.path(),
                    sources.description(),
                    List.of(),
                    new Plain(sources.path(), sources.description(), () -> (Agent) created(constructor, at)));
        }
        var own = (AgentType) created(constructor, at);
        try {
            return new JavaType(sources.path(), own.description(), own.parameters(), own);
        } catch (RuntimeException | LinkageError e) {
            throw failed(at, constructor.getDeclaringClass(), e);
        }
    }

    private static Class<?> type(Sources sources, FolderClasses classes, Location at) {
        String name = sources.className();
        Class<?> type;
        try {
            type = classes.loadClass(name);
        } catch (ClassNotFoundException | LinkageError _) {
            throw new InvalidSettings(
                    at,
                    "There is no class '%s' in this file.".formatted(sources.simpleName()),
                    "Call the class as the file is called.");
        }
        if (type.getClassLoader() != classes) {
            throw new InvalidSettings(
                    at, "RSAL has a class '%s' already.".formatted(name), "Rename the class and its file.");
        }
        if (!AgentType.class.isAssignableFrom(type) && !Agent.class.isAssignableFrom(type)) {
            throw new InvalidSettings(
                    at,
                    "Class '%s' is no agent.".formatted(name),
                    "Let it implement rsal.agent.Agent, or rsal.agent.AgentType when it has parameters.");
        }
        return type;
    }

    private static Constructor<?> constructor(Class<?> type, Location at) {
        try {
            if (Modifier.isPublic(type.getModifiers()) && !Modifier.isAbstract(type.getModifiers())) {
                return type.getConstructor();
            }
        } catch (NoSuchMethodException | LinkageError _) {
            // told below
        }
        throw new InvalidSettings(
                at,
                "Class '%s' can't be used as an agent.".formatted(type.getName()),
                "Make it public, not abstract, and give it a public constructor without parameters.");
    }

    private static Object created(Constructor<?> constructor, Location at) {
        try {
            return constructor.newInstance();
        } catch (InvocationTargetException e) {
            throw failed(at, constructor.getDeclaringClass(), e.getTargetException());
        } catch (ReflectiveOperationException | LinkageError e) {
            throw failed(at, constructor.getDeclaringClass(), e);
        }
    }

    private static InvalidSettings failed(Location at, Class<?> type, Throwable why) {
        Throwable cause = why instanceof ExceptionInInitializerError && why.getCause() != null ? why.getCause() : why;
        StackTraceElement[] trace = cause.getStackTrace();
        Location where = List.of(trace).stream()
                .filter(call -> call.getClassName().startsWith(type.getName()) && call.getLineNumber() > 0)
                .findFirst()
                .map(call -> new Location(at.file(), call.getLineNumber(), 1))
                .orElse(at);
        return new InvalidSettings(where, "Class '%s' fails: %s.".formatted(type.getName(), cause), "");
    }

    /// A kind of agent without anything that can be set.
    private record Plain(String key, String description, Supplier<Agent> maker) implements AgentType {
        @Override
        public Agent create(Arguments arguments) {
            return maker.get();
        }
    }

    @Override
    public List<Class<? extends Device>> needs() {
        return own.needs();
    }

    @Override
    public List<Class<? extends Device>> needs(Arguments arguments) {
        return own.needs(arguments);
    }

    @Override
    public boolean drives(Arguments arguments) {
        return own.drives(arguments);
    }

    @Override
    public boolean yields() {
        return own.yields();
    }

    @Override
    public Optional<Outline> outline() {
        return own.outline();
    }

    @Override
    public List<Problem> warnings() {
        return own.warnings();
    }

    @Override
    public Agent create(Arguments arguments) {
        return own.create(arguments);
    }
}
