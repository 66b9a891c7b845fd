package rsal.rtps;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.rtps.discovery.Qos;
import rsal.time.AllowedToReadWallClock;

/// Participants on the loopback network of this machine.
@AllowedToReadWallClock("A write waits in real time.")
class UdpParticipantTest {
    private static final String TYPE = "std_msgs::msg::dds_::String_";
    private static final Qos ALL = Qos.DEFAULT.keep(Qos.KEEP_ALL);
    private static final int DOMAIN = 61 + (int) (ProcessHandle.current().pid() % 40);

    private static UdpParticipant join(int seed) throws IOException {
        var random = new SplittableRandom(ProcessHandle.current().pid() * 10 + seed);
        return new UdpParticipant(
                UdpParticipant.Options.local(DOMAIN, "test"), System::nanoTime, random, GraphListener.NONE);
    }

    private static final class Full implements SampleListener {
        @Override
        public void onSample(Sample sample) {
            throw new AssertionError("It has no room.");
        }

        @Override
        public boolean hasRoom() {
            return false;
        }
    }

    /// Else two participants whose listeners write by the other one would wait for each other.
    @Test
    void aListenerDoesNotWaitForRoomOfAnotherParticipant() throws IOException {
        try (UdpParticipant one = join(1);
                UdpParticipant other = join(2)) {
            other.createReader("rt/full", TYPE, ALL, "", new Full());
            SampleWriter full = other.createWriter("rt/full", TYPE, ALL, "");
            for (int i = 0; i < RtpsLimits.DEFAULT.kept(); i++) {
                assertThat(other.write(full, 0, new byte[8])).isTrue();
            }
            List<Long> times = new ArrayList<>(); // ns
            one.createReader("rt/in", TYPE, ALL, "", _ -> {
                long begun = System.nanoTime();
                assertThat(other.write(full, 0, new byte[8])).isFalse();
                times.add(System.nanoTime() - begun);
            });
            SampleWriter in = one.createWriter("rt/in", TYPE, ALL, "");
            for (int i = 0; i < 5; i++) {
                one.write(in, 0, new byte[8]);
            }
            assertThat(times).hasSize(5);
            assertThat(Collections.min(times)).isLessThan(Qos.MAX_BLOCKING / 2);
            long begun = System.nanoTime();
            assertThat(other.write(full, 0, new byte[8])).isFalse();
            assertThat(System.nanoTime() - begun).isGreaterThanOrEqualTo(Qos.MAX_BLOCKING); // in no listener it waits
        }
    }
}
