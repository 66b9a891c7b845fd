package rsal.settings;

import java.util.LinkedHashMap;

/// A plugin that somebody chose, with values for its parameters. As text it is its key.
public record PluginChoice(Plugin plugin, Arguments arguments) {
    /// The plugin as what it is.
    public <T extends Plugin> T as(Class<T> type) {
        return type.cast(plugin);
    }

    /// As it is written: its key, or a map with that as its `type` when something is not as usual.
    Object written() {
        if (isUsual()) {
            return plugin.key();
        }
        var group = new LinkedHashMap<String, Object>();
        group.put("type", plugin.key());
        group.putAll(arguments.written());
        return group;
    }

    private boolean isUsual() {
        return plugin.parameters().stream()
                .allMatch(parameter -> parameter
                        .fallback()
                        .filter(value -> value.equals(arguments.asMap().get(parameter.name())))
                        .isPresent());
    }

    @Override
    public String toString() {
        return plugin.key();
    }
}
