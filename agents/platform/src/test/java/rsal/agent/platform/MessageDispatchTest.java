package rsal.agent.platform;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import rsal.agent.Message;
import rsal.agent.Topic;
import rsal.agent.platform.MessageDispatch.Hearer;
import rsal.device.Listeners;
import rsal.device.Subscription;

class MessageDispatchTest {
    private static final Topic<String> TOPIC = new Topic<>("talk", String.class);

    /// Who listens, and what it hears.
    private static final class Listener implements Hearer<String> {
        private final int number;
        private final int ways;
        private final Random random;
        private final List<String> heard;

        /// @param ways to take it; 1: as it is, or not
        Listener(int number, int ways, Random random, List<String> heard) {
            this.number = number;
            this.ways = ways;
            this.random = random;
            this.heard = heard;
        }

        /// Takes it, or not, or as copies.
        void take(MessageDispatch<String> reported, List<String> right) {
            if (random.nextInt(5) == 0) {
                return;
            }
            switch (random.nextInt(ways)) {
                case 1 -> {
                    for (int copy = 0; copy < 2; copy++) {
                        reported.addOnce(this);
                        right.add(number + reported.message().content());
                    }
                }
                case 2 -> {
                    reported.add(this);
                    reported.add(this);
                    right.add(number + reported.message().content());
                    right.add(number + reported.message().content());
                }
                default -> {
                    reported.add(this);
                    right.add(number + reported.message().content());
                }
            }
        }

        @Override
        public void reach(MessageDispatch<String> reported) {
            heard.add(number + reported.message().content());
        }
    }

    @Test
    void whoTookItHearsItInOrderWhoeverComesAndGoesMeanwhile() {
        for (long seed = 0; seed < 300; seed++) {
            var random = new Random(seed);
            boolean copies = random.nextBoolean();
            var heard = new ArrayList<String>();
            var right = new ArrayList<String>();
            var channel = new TopicBus<>(
                    TOPIC,
                    "test",
                    () -> new Listeners<>(e -> {
                        throw e;
                    }));
            var open = new ArrayList<Subscription>();
            var waiting = new ArrayList<MessageDispatch<String>>();
            int number = 0;
            for (int i = 0; i < 60; i++) {
                if (random.nextInt(4) > 0) {
                    var listener = new Listener(number++, copies ? 8 : 1, random, heard);
                    open.add(channel.add("a" + number, reported -> listener.take(reported, right)));
                } else if (!open.isEmpty()) {
                    open.remove(random.nextInt(open.size())).cancel();
                }
                int before = right.size();
                var publishing = new MessageDispatch<>(new Message<>(TOPIC, "x", "", Instant.EPOCH, "-" + i));
                channel.deliver(publishing);
                assertThat(publishing.isHeard()).isEqualTo(right.size() > before);
                waiting.add(publishing);
            }
            waiting.forEach(MessageDispatch::run);
            assertThat(heard).as("seed %d", seed).isEqualTo(right);
            waiting.forEach(MessageDispatch::run);
            assertThat(heard).as("told once, seed %d", seed).hasSameSizeAs(right);
        }
    }
}
