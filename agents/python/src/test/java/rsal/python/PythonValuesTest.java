package rsal.python;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.Method;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import rsal.agent.Topic;
import rsal.agent.Topics;
import rsal.behavior.Decision;
import rsal.device.Device;
import rsal.device.Health;
import rsal.device.SensorCore;
import rsal.device.SimulationControl;
import rsal.robot.DeviceKind;
import rsal.robot.DeviceKinds;

/// What Python has of Java's values is what Java has. `-Drsal.update=true` writes it again.
class PythonValuesTest {
    private static final Path HOME = Path.of("../../clients/python/src/rsal/agents");

    private static PythonSourceWriter values() {
        var values = new PythonSourceWriter(Map.of());
        values.add(Health.class);
        DeviceCalls.all().values().forEach(values::addContract);
        DeviceKinds.all().stream().map(DeviceKind::reads).forEach(values::add);
        values.add(Decision.class);
        values.add(SimulationControl.Placement.class);
        values.add(SimulationControl.Contact.class);
        return values;
    }

    @Test
    void devicesHaveTheValuesOfJava() throws IOException {
        same("values.py", values().text("Values of devices: SI units, radians, frames as REP 105 has them.", Map.of()));
    }

    @Test
    void topicsHaveTheMessagesOfJava() throws IOException {
        var messages = new PythonSourceWriter(values().names());
        var topics = new LinkedHashMap<Class<?>, String>();
        for (Topic<?> topic : Topics.installed()) {
            if (!topic.name().startsWith("test") && messages.add(topic.type())) {
                topics.put(topic.type(), topic.name());
            }
        }
        same("messages.py", messages.text("Messages of the topics that come with RSAL.", topics));
    }

    @Test
    void eachMethodOfADeviceCanBeCalled() throws IOException {
        String devices = Files.readString(HOME.resolve("devices.py"));
        List<String> ofAll = Stream.of(
                        Device.class.getMethods(), SensorCore.class.getMethods(), Object.class.getMethods())
                .flatMap(Stream::of)
                .map(Method::getName)
                .toList();
        DeviceCalls.all()
                .forEach((name, contract) -> assertThat(Stream.of(contract.getMethods())
                                .map(Method::getName)
                                .filter(method -> !ofAll.contains(method))
                                .distinct()
                                .filter(method -> !devices.contains("\"" + method + "\"")))
                        .as(name)
                        .isEmpty());
        assertThat(DeviceCalls.all().keySet())
                .allSatisfy(name -> assertThat(devices).contains("contract = \"" + name + "\""));
    }

    private static void same(String file, String text) throws IOException {
        if (Boolean.getBoolean("rsal.update")) {
            Files.writeString(HOME.resolve(file), text);
        }
        assertThat(HOME.resolve(file))
                .as("mv agents/python test -Dtest=PythonValuesTest -Drsal.update=true")
                .hasContent(text);
    }
}
