package rsal.settings;

import java.util.LinkedHashMap;
import java.util.Map;

/// A plugin that somebody chose, with values for its parameters. As text it is its key.
public record PluginChoice(Plugin plugin, Arguments arguments) {
    /// The plugin as what it is.
    public <T extends Plugin> T as(Class<T> type) {
        return type.cast(plugin);
    }

    /// As it is written: its key, or a map with that as its `type` when something is not as usual.
    Object written() {
        Map<String, Object> set = arguments.written();
        if (set.equals(usual())) {
            return plugin.key();
        }
        var group = new LinkedHashMap<String, Object>();
        group.put("type", plugin.key());
        group.putAll(set);
        return group;
    }

    private Map<String, Object> usual() {
        var usual = new LinkedHashMap<String, Object>();
        plugin.parameters()
                .forEach(parameter -> parameter
                        .fallback()
                        .ifPresent(value -> usual.put(
                                parameter.name(), value instanceof PluginChoice chosen ? chosen.written() : value)));
        return usual;
    }

    @Override
    public String toString() {
        return plugin.key();
    }
}
