package rsal.ros2.system;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import rsal.device.Mapper;
import rsal.testkit.contract.DeviceContract;

/// The map that a robot publishes, whatever it is reached by.
abstract class OwnMapContract extends DeviceContract<Mapper> {
    OwnMapContract() {
        super(Mapper.class);
    }

    @Override
    protected Map<String, String> parts() {
        return Map.of("map", "own-map");
    }

    @Test
    void isTheWholeMapAsItIsSent() {
        advance(1);
        assertThat(device().latest().orElseThrow().value())
                .usingRecursiveComparison()
                .isEqualTo(WORLD.grid());
        assertThat(device().isComplete()).isTrue();
    }
}
