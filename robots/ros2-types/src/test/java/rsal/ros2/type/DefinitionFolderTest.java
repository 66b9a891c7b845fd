package rsal.ros2.type;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.testkit.Rounds;

class DefinitionFolderTest {
    @TempDir
    Path folder;

    private Path write(String file, String text) throws IOException {
        Path path = folder.resolve(file);
        Files.createDirectories(path.getParent());
        return Files.writeString(path, text);
    }

    @Test
    void readsMessagesServicesAndActionsOfAWorkspace() throws IOException {
        write("src/gas/my_msgs/msg/Gas.msg", "Header header\nfloat32 co2 # ppm\n");
        write("src/gas/my_msgs/srv/Heat.srv", "bool on\n---\nbool success\n");
        write("src/gas/my_msgs/action/Sniff.action", "float32 time\n---\nGas worst\n---\nGas now\n");
        write("src/gas/my_msgs/msg/.#Gas.msg", "left by an editor");
        write("src/gas/my_msgs/README.md", "Gas.");
        assertThat(DefinitionFolder.read(folder))
                .extracting(RosType::name)
                .contains(
                        "my_msgs/msg/Gas",
                        "my_msgs/srv/Heat_Request",
                        "my_msgs/srv/Heat_Response",
                        "my_msgs/action/Sniff_Goal",
                        "my_msgs/action/Sniff_FeedbackMessage")
                .doesNotHaveDuplicates();
    }

    /// By the hash that ROS computes for the same file.
    @Test
    void aDefinitionOfRosHasTheHashThatItHasThere() throws IOException {
        write("sensor_msgs/msg/Range.msg", """
                uint8 ULTRASOUND=0
                std_msgs/Header header
                uint8 radiation_type
                float32 field_of_view # [rad]
                float32 min_range
                float32 max_range
                float32 range
                float32 variance
                """);
        TypeLibrary jazzy = TypeLibrary.of(Distribution.JAZZY);
        TypeLibrary read = TypeLibrary.of(Distribution.HUMBLE).with(DefinitionFolder.read(folder));
        String name = "sensor_msgs/msg/Range";
        assertThat(read.hash(name)).isEqualTo(jazzy.hash(name)).isPresent();
        assertThat(TypeLibrary.of(Distribution.HUMBLE).hash(name)).isNotEqualTo(read.hash(name));
    }

    @Test
    void equalDefinitionsMayBeThereTwiceAndOthersNot() throws IOException {
        write("src/my_msgs/msg/Gas.msg", "float32 co2\n");
        write("install/share/my_msgs/msg/Gas.msg", "# installed\nfloat32 co2\n");
        assertThat(DefinitionFolder.read(folder)).hasSize(1);
        write("install/share/my_msgs/msg/Gas.msg", "float64 co2\n");
        assertThatThrownBy(() -> DefinitionFolder.read(folder))
                .isInstanceOf(InvalidDefinition.class)
                .hasMessageContainingAll(
                        "src/my_msgs", "install/share/my_msgs", "define 'my_msgs/msg/Gas' differently");
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`', delimiter = '|', textBlock = """
            my_msgs/msg/Gas.msg       | float32 co2;float32       | my_msgs/msg/Gas.msg:2: 'float32' is not a field. Write a type
            my_msgs/srv/Heat.srv      | bool on;---;#;bool        | my_msgs/srv/Heat.srv:4: 'bool' is not a field
            my_msgs/srv/Heat.srv      | bool on                   | my_msgs/srv/Heat.srv has 1 parts, separated by '---', instead of 2
            my_msgs/action/Sniff.action | int8 a;---;---;int8[0] b | my_msgs/action/Sniff.action:4: 'b' needs a number above 0
            my-msgs/msg/Gas.msg       | float32 co2               | 'my-msgs' is not a name in ROS
            my_msgs/msg/2Gas.msg      | float32 co2               | '2Gas' is not a name in ROS
            """)
    void whatIsWrongIsSaidWithItsFileAndLine(String file, String text, String message) throws IOException {
        write(file, text.replace(';', '\n'));
        assertThatThrownBy(() -> DefinitionFolder.read(folder))
                .isInstanceOf(InvalidDefinition.class)
                .hasMessageStartingWith(folder.resolve(file).toString())
                .hasMessageContaining(message);
    }

    @Test
    void aFolderThatIsNoneOrHasNothingIsRefused() throws IOException {
        assertThatThrownBy(() -> DefinitionFolder.read(folder.resolve("none")))
                .hasMessageContaining("is not a folder. Give one with files such as my_msgs/msg/Gas.msg.");
        assertThatThrownBy(() -> DefinitionFolder.read(folder)).hasMessageContaining("has no definitions");
        Files.write(Files.createDirectories(folder.resolve("a/msg")).resolve("A.msg"), new byte[] {(byte) 0xff, 0});
        assertThatThrownBy(() -> DefinitionFolder.read(folder)).hasMessageContaining("is not text in UTF-8");
        Files.write(folder.resolve("a/msg/A.msg"), new byte[1_000_001]);
        assertThatThrownBy(() -> DefinitionFolder.read(folder)).hasMessageContaining("has more than 1000000 bytes");
    }

    @Test
    void damagedFilesAreReadOrRefused() throws IOException {
        byte[] text = "Header header\nfloat32[<=3] co2 [1, 2]\nstring<=5 name \"a\"\nint8 A=1\n---\nbool b\n"
                .getBytes(StandardCharsets.UTF_8);
        var random = new SplittableRandom(7);
        for (long i = 0; i < Rounds.of(20_000, 1_000_000); i++) {
            byte[] damaged = text.clone();
            for (int change = random.nextInt(5); change >= 0; change--) {
                damaged[random.nextInt(damaged.length)] = (byte) random.nextInt(128);
            }
            try {
                DefinitionReader.file("a/srv/A", new String(damaged, StandardCharsets.UTF_8), "A.srv");
            } catch (InvalidDefinition e) {
                assertThat(e).hasMessageStartingWith("A.srv");
            }
        }
    }
}
