package rsal.ros2.type;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

/// Against hashes that were gathered per distribution from published packages and an independent implementation.
class TypeHashTest {
    private record Published(Distribution distribution, String type, String hash) {}

    private static List<Published> published() throws IOException {
        try (var in = Objects.requireNonNull(TypeHashTest.class.getResourceAsStream("/hashes.csv"))) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8)
                    .lines()
                    .skip(1)
                    .map(line -> line.split(","))
                    .map(cells ->
                            new Published(Distribution.valueOf(cells[0].toUpperCase(Locale.ROOT)), cells[1], cells[2]))
                    .filter(each -> !each.type().endsWith("_Event"))
                    .toList();
        }
    }

    @Test
    void eachTypeOfEachDistributionHasItsPublishedHash() throws IOException {
        var wrong = new TreeMap<String, String>();
        int count = 0;
        for (Published each : published()) {
            TypeLibrary library = TypeLibrary.of(each.distribution());
            RosType type = library.find(each.type()).orElse(null);
            if (type == null) {
                continue; // a service or an action as a whole, which is not a message
            }
            count++;
            String hash = TypeHash.of(type, library);
            if (!hash.equals(each.hash())) {
                wrong.put(each.distribution() + " " + each.type(), hash);
            }
        }
        assertThat(wrong).isEmpty();
        assertThat(count).isEqualTo(1_497);
    }

    @Test
    void aTypeOfOnesOwnIsHashedToo() {
        RosType type = DefinitionReader.message("my_msgs/msg/Pose", "geometry_msgs/Pose pose # where\nint8 ONE=1\n");
        TypeLibrary library = TypeLibrary.of(Distribution.JAZZY).with(List.of(type));
        assertThat(TypeHash.of(type, library)).startsWith("RIHS01_").hasSize(71);
        assertThatThrownBy(() -> TypeHash.of(type, TypeLibrary.of(List.of(type))))
                .isInstanceOf(InvalidDefinition.class)
                .hasMessageContaining("'geometry_msgs/msg/Pose'");
    }
}
