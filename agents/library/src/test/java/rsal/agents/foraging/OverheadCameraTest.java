package rsal.agents.foraging;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.agent.Message;
import rsal.agent.protocol.Act;
import rsal.agent.protocol.Performative;
import rsal.agents.FakeCamera;
import rsal.agents.FakeWorld;
import rsal.agents.Scene;
import rsal.data.Point2d;

class OverheadCameraTest {
    private final FakeWorld world = new FakeWorld();
    private final Scene scene = new Scene(Optional.of(world));

    /// What two sensors, over (0, 0) and (10, 0), have collected.
    private List<Object> asked() {
        scene.start("fetch", "master", Optional.empty(), Map.of());
        scene.start(
                "overhead-camera",
                "overhead-camera",
                Optional.empty(),
                Map.of("places", "0 0; 10 0", "things", "can", "range", 2.5));
        scene.advance(3);
        return scene.said.stream()
                .filter(message -> message.sender().equals("overhead-camera"))
                .map(Message::content)
                .filter(Act.class::isInstance)
                .map(Act.class::cast)
                .filter(act -> act.performative() == Performative.REQUEST)
                .map(Act::content)
                .toList();
    }

    private void lies(String name, double x, double y) {
        world.addDisc(name, FakeCamera.GREEN, x, y, 0);
    }

    private static CollectGoal at(double x, double y) {
        return new CollectGoal(FakeCamera.GREEN, new Point2d(x, y));
    }

    @Test
    void asksForWhatLiesUnderASensor() {
        lies("can", 2, 1);
        lies("can-12", 10, -2.4);
        assertThat(asked()).containsOnly(at(2, 1), at(10, -2.4));
    }

    @Test
    void leavesAloneWhatIsFartherOff() {
        lies("can-1", 0, 2.6);
        lies("can-2", 5, 0);
        assertThat(asked()).isEmpty();
    }

    @Test
    void leavesAloneWhatARobotHolds() {
        world.addDisc("can", FakeCamera.GREEN, 1, 0, 0.02);
        assertThat(asked()).isEmpty();
    }

    @Test
    void leavesAloneWhatIsCalledOtherwise() {
        lies("candle", 1, 0);
        lies("can-opener", 0, 1);
        lies("oilcan", -1, 0);
        assertThat(asked()).isEmpty();
    }
}
