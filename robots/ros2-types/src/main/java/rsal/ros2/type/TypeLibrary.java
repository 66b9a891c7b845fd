package rsal.ros2.type;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Collection;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;

/// Types by name. They never change. Safe for several threads.
public final class TypeLibrary {
    private static final String COMMON = "common"; // what is the same in all distributions
    private static final List<String> PACKAGES = List.of(
            "action_msgs",
            "builtin_interfaces",
            "control_msgs",
            "diagnostic_msgs",
            "geographic_msgs",
            "geometry_msgs",
            "irobot_create_msgs",
            "lifecycle_msgs",
            "map_msgs",
            "nav2_msgs",
            "nav_msgs",
            "rcl_interfaces",
            "rmw_dds_common",
            "rosgraph_msgs",
            "sensor_msgs",
            "service_msgs",
            "simulation_interfaces",
            "std_msgs",
            "std_srvs",
            "tf2_msgs",
            "trajectory_msgs",
            "type_description_interfaces",
            "unique_identifier_msgs",
            "vision_msgs",
            "visualization_msgs");
    private static final Map<Distribution, TypeLibrary> KNOWN = new EnumMap<>(Distribution.class);

    private final Map<String, RosType> types;
    private final Map<String, String> hashes = new ConcurrentHashMap<>(); // of those that were asked for

    private TypeLibrary(Map<String, RosType> types) {
        this.types = types;
    }

    /// The types of a distribution that come with RSAL. Read once.
    public static TypeLibrary of(Distribution distribution) {
        synchronized (KNOWN) {
            return KNOWN.computeIfAbsent(distribution, TypeLibrary::read);
        }
    }

    /// Types that need no others.
    public static TypeLibrary of(Collection<RosType> types) {
        return new TypeLibrary(Map.of()).with(types);
    }

    private static TypeLibrary read(Distribution distribution) {
        var types = new HashMap<String, RosType>();
        for (String folder : List.of(COMMON, distribution.words())) {
            for (String name : PACKAGES) {
                definitions("%s/%s.msgs".formatted(folder, name)).forEach(type -> types.put(type.name(), type));
            }
        }
        return new TypeLibrary(Map.copyOf(types));
    }

    private static Stream<RosType> definitions(String file) {
        try (InputStream in = TypeLibrary.class.getResourceAsStream(file)) {
            return in == null
                    ? Stream.empty()
                    : DefinitionReader.blocks(new String(in.readAllBytes(), StandardCharsets.UTF_8)).stream();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /// Also with these, which replace those of the same names.
    public TypeLibrary with(Collection<RosType> others) {
        var all = new HashMap<>(types);
        others.forEach(type -> all.put(type.name(), type));
        return new TypeLibrary(Map.copyOf(all));
    }

    /// @param name in full
    public Optional<RosType> find(String name) {
        return Optional.ofNullable(types.get(name));
    }

    /// @param name in full
    /// @throws InvalidDefinition when there is none
    public RosType get(String name) {
        return find(name)
                .orElseThrow(() -> new InvalidDefinition(
                        "There is no definition of '%s'. Add its file to your folder of definitions.".formatted(name)));
    }

    /// The hash of a type: `RIHS01_64c1…`; empty when it is not known.
    ///
    /// @param name in full
    public Optional<String> hash(String name) {
        return find(name).map(type -> hashes.computeIfAbsent(name, _ -> TypeHash.of(type, this)));
    }

    /// Whether a type has all fields that it has in another library, of the same types, and so have those within. It
    /// may have more: distributions add fields.
    ///
    /// @param name in full
    public boolean isLike(String name, TypeLibrary other) {
        return isLike(name, other, new HashSet<>());
    }

    private boolean isLike(String name, TypeLibrary other, Set<String> compared) {
        if (!compared.add(name)) {
            return true;
        }
        Optional<RosType> ours = find(name);
        return ours.isPresent()
                && other.get(name).fields().stream()
                        .allMatch(field -> ours.get().fields().stream()
                                        .anyMatch(our -> our.name().equals(field.name())
                                                && our.type().equals(field.type()))
                                && (!(field.type().element() instanceof Element.Nested(String within))
                                        || isLike(within, other, compared)));
    }

    /// All of them, in no order.
    public Collection<RosType> all() {
        return types.values();
    }
}
