package rsal.settings;

import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/// A kind of plugins: those that are installed, and the interface that one of people's own implements.
///
/// @param word what to call one in messages: `controller`
/// @param installed by key, in the order of the keys
public record PluginKind(String word, Class<? extends Plugin> type, Map<String, Plugin> installed) {
    public PluginKind {
        installed = Collections.unmodifiableMap(new TreeMap<>(installed));
    }

    /// @throws IllegalArgumentException when two have the same key
    public static <P extends Plugin> PluginKind of(String word, Class<P> type, Iterable<P> installed) {
        var byKey = new TreeMap<String, Plugin>();
        for (P plugin : installed) {
            if (byKey.putIfAbsent(plugin.key(), plugin) != null) {
                throw new IllegalArgumentException("There are two %ss called '%s'.".formatted(word, plugin.key()));
            }
        }
        return new PluginKind(word, type, byKey);
    }

    public Optional<Plugin> find(String key) {
        return Optional.ofNullable(installed.get(key));
    }

    public List<String> keys() {
        return List.copyOf(installed.keySet());
    }

    public Collection<Plugin> all() {
        return installed.values();
    }

    /// One by its key, with the defaults of its parameters.
    ///
    /// @throws IllegalArgumentException with a sentence when there is none
    PluginChoice choose(String key) {
        return choose(key, Map.of());
    }

    /// @throws IllegalArgumentException with a sentence when there is none, or values don't fit
    PluginChoice choose(String key, Map<String, ?> values) {
        Plugin plugin = find(key)
                .orElseThrow(() -> new IllegalArgumentException(
                        "There is no %s '%s'. %s".formatted(word, key, Suggestion.among(key, keys()))));
        return new PluginChoice(plugin, Arguments.of(plugin.parameters(), values));
    }
}
