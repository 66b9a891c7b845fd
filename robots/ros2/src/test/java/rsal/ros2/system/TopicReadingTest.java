package rsal.ros2.system;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.tuple;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosTopic;
import rsal.ros2.type.DefinitionReader;
import rsal.ros2.type.RosType;
import rsal.system.Diagnosis.Finding;

class TopicReadingTest {
    private static final Duration PATIENCE = Duration.ofMillis(20);
    private static final RosType GAS = DefinitionReader.message("my_msgs/msg/Gas", "float32 co2\nstring unit\n");

    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink there = network.join();
    private final RosLink here = network.join();

    private void publish(String topic, String type, byte[] message) {
        there.advertise(new RosTopic(topic, type), Profile.LATCHED).publish(message);
    }

    private void publishGas() {
        publish("/r1/gas", GAS.name(), new CdrWriter().float32(412).text("ppm").toBytes());
    }

    private List<Finding> look(List<RosType> own, String topic) throws InterruptedException {
        return new TopicReading(here, own).look(topic, PATIENCE);
    }

    @Test
    void aMessageOfATypeOfOnesOwnIsShown() throws InterruptedException {
        publishGas();
        assertThat(look(List.of(GAS), "/r1/gas"))
                .containsExactly(
                        new Finding("topic", true, "'/r1/gas' has messages of my_msgs/msg/Gas", ""),
                        new Finding("fields", true, "float32 co2\nstring unit", ""),
                        new Finding("message", true, "{\n  \"co2\": 412.0,\n  \"unit\": \"ppm\"\n}", ""));
    }

    @Test
    void aTypeWithoutDefinitionSaysWhatToDo() throws InterruptedException {
        publishGas();
        Finding last = look(List.of(), "/r1/gas").getLast();
        assertThat(last.ok()).isFalse();
        assertThat(last.found()).contains("no definition of 'my_msgs/msg/Gas'");
        assertThat(last.remedy()).contains("--set definitions=FOLDER");
    }

    @Test
    void aTopicThatIsMissingNamesASimilarOne() throws InterruptedException {
        publishGas();
        assertThat(look(List.of(), "/r1/gass"))
                .containsExactly(
                        new Finding("topic", false, "nobody publishes '/r1/gass'", "Maybe '/r1/gas' was meant?"));
    }

    /// By the hash that its publishers announce.
    @Test
    void aDefinitionThatIsNotTheRobotsIsDistinguished() throws InterruptedException {
        publish("/r1/flag", "std_msgs/msg/Bool", new CdrWriter().bool(true).toBytes());
        assertThat(look(List.of(), "/r1/flag"))
                .extracting(Finding::what, Finding::ok)
                .containsExactly(tuple("topic", true), tuple("fields", true), tuple("message", true));
        RosType other = DefinitionReader.message("std_msgs/msg/Bool", "bool flag\n");
        assertThat(look(List.of(other), "/r1/flag"))
                .filteredOn(each -> each.what().equals("definition"))
                .extracting(Finding::found)
                .containsExactly("the robot's definition of std_msgs/msg/Bool is another one than that here");
    }

    @Test
    void aSilentTopicAndADamagedMessageAreNamed() throws InterruptedException {
        there.advertise(new RosTopic("/r1/silent", "std_msgs/msg/Bool"), Profile.DEFAULT);
        assertThat(look(List.of(), "/r1/silent").getLast())
                .isEqualTo(
                        new Finding("message", false, "none has come within 0.0 s", "Wait for longer: --set time=30"));
        publish("/r1/text", "std_msgs/msg/String", new CdrWriter().int32(1_000).toBytes());
        assertThat(look(List.of(), "/r1/text").getLast().found()).startsWith("a message of 8 bytes does not fit:");
    }

    @Test
    void aFolderThatCantBeReadIsOneSentence() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> TopicReading.definitions("/nowhere/msgs"))
                .withMessage("'/nowhere/msgs' is not a folder. Give one with files such as my_msgs/msg/Gas.msg.");
        assertThat(TopicReading.definitions("")).isEmpty();
    }
}
