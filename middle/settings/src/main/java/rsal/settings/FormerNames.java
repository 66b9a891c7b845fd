package rsal.settings;

import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.Set;

/// Names that keys, parameters, types and metrics had in earlier versions. Each module lists its own in the resource
/// [#RESOURCE], as `args = parameters arguments`: the former name, then the names that replace it, each in its place.
final class FormerNames {
    static final String RESOURCE = "META-INF/rsal/former-names.properties";

    private static final Map<String, Set<String>> NAMES = read();

    private FormerNames() {}

    /// The name that replaces a former one.
    ///
    /// @param known names that are valid where it was read
    static Optional<String> replacement(String read, Collection<String> known) {
        return NAMES.getOrDefault(read, Set.of()).stream()
                .filter(known::contains)
                .findFirst();
    }

    private static Map<String, Set<String>> read() {
        var names = new HashMap<String, Set<String>>();
        try {
            for (URL file : Collections.list(FormerNames.class.getClassLoader().getResources(RESOURCE))) {
                var properties = new Properties();
                try (Reader text = new InputStreamReader(file.openStream(), StandardCharsets.UTF_8)) {
                    properties.load(text);
                }
                properties
                        .stringPropertyNames()
                        .forEach(former -> names.computeIfAbsent(former, _ -> new LinkedHashSet<>())
                                .addAll(List.of(
                                        properties.getProperty(former).strip().split("\\s+", -1))));
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return names;
    }
}
