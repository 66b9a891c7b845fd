package rsal.scenario.installed;

import java.util.Collections;
import java.util.Map;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.TreeMap;
import java.util.function.Function;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// Finds what is installed here: kinds of agents, drivers of devices, robot systems, hosts.
public final class Providers {
    private Providers() {}

    /// @return providers by key, in the order of the keys
    /// @throws InvalidSettings when one can't be loaded or two have the same key: then somebody who adds one of
    /// his own made an error
    public static <P> Map<String, P> byKey(Class<P> kind, Function<P, String> key) {
        var byKey = new TreeMap<String, P>();
        var list = Location.of("META-INF/services/" + kind.getName());
        try {
            for (P provider : ServiceLoader.load(kind)) {
                P other = byKey.putIfAbsent(key.apply(provider), provider);
                if (other != null) {
                    throw new InvalidSettings(
                            list,
                            "'%s' and '%s' are both called '%s'."
                                    .formatted(
                                            other.getClass().getName(),
                                            provider.getClass().getName(),
                                            key.apply(provider)),
                            "Rename one of them.");
                }
            }
        } catch (ServiceConfigurationError e) {
            throw new InvalidSettings(
                    list,
                    "A class that is named there can't be used: %s.".formatted(e.getMessage()),
                    "It must be a public %s with a public constructor without parameters, named like package.Class."
                            .formatted(kind.getSimpleName()));
        }
        return Collections.unmodifiableMap(byKey);
    }
}
