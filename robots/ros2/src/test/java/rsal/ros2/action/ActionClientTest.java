package rsal.ros2.action;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.TwoTimes;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.time.LockstepScheduler;

class ActionClientTest {
    private final LockstepScheduler real = new LockstepScheduler();
    private final LockstepScheduler ofSimulator = new LockstepScheduler();
    private final List<String> heard = new ArrayList<>();

    private final class Ears implements ActionClient.Listener {
        @Override
        public void onFeedback(RosMessage message) {
            heard.add("feedback");
        }

        @Override
        public void onRefused() {
            heard.add("refused");
        }

        @Override
        public void onResult(RosMessage response) {
            heard.add("result");
        }

        @Override
        public void onFailure(String why) {
            heard.add(why);
        }
    }

    /// A simulator that is fast must not shorten the time that a robot's program has for its answer.
    @Test
    void goalsAreAnsweredInRealTime() {
        var network = new MemoryNetwork();
        network.serve("/r1/spin/_action/send_goal", _ -> new CompletableFuture<>());
        var client = new ActionClient(
                network.join(),
                TypeLibrary.of(Distribution.JAZZY),
                "/r1/spin",
                "nav2_msgs/action/Spin",
                new TwoTimes(real, ofSimulator),
                new SplittableRandom(1));
        client.send(goal -> goal.float32(1.5f).int32(0).int32(0).bool(false), new Ears());
        ofSimulator.advance(Duration.ofSeconds(60));
        real.advance(Duration.ofSeconds(4));
        client.look(ofSimulator.instant());
        assertThat(heard).isEmpty();
        real.advance(Duration.ofSeconds(2));
        client.look(ofSimulator.instant());
        assertThat(heard).containsExactly("The robot did not answer within 5 s.");
    }
}
