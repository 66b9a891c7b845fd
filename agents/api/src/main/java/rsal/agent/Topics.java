package rsal.agent;

import java.util.Comparator;
import java.util.List;
import java.util.ServiceLoader;

/// The topics that each [TopicProvider] of this installation brings, in the order of their names.
public final class Topics {
    private static final List<Topic<?>> INSTALLED = load();

    private Topics() {}

    public static List<Topic<?>> installed() {
        return INSTALLED;
    }

    private static List<Topic<?>> load() {
        return ServiceLoader.load(TopicProvider.class, TopicProvider.class.getClassLoader()).stream()
                .flatMap(provider -> provider.get().topics().stream())
                .<Topic<?>>map(topic -> topic)
                .sorted(Comparator.comparing(Topic::name))
                .toList();
    }
}
