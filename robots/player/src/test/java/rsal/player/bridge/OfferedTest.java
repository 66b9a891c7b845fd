package rsal.player.bridge;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.device.DeviceInfo;
import rsal.device.Subscription;
import rsal.player.message.Interface;
import rsal.player.message.Session;
import rsal.player.wire.Address;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.time.LockstepScheduler;

class OfferedTest {
    private final LockstepScheduler scheduler = new LockstepScheduler();
    private final List<Packet> obeyed = new ArrayList<>();

    private final Offered offered =
            new Offered(Interface.POSITION2D, 0, new DeviceInfo("r1", "base", "test"), scheduler) {
                @Override
                Subscription listen() {
                    return () -> {};
                }

                @Override
                Optional<Answer> answer(Packet request) {
                    return Optional.empty();
                }

                @Override
                void obey(Packet command) {
                    obeyed.add(command);
                }
            };

    private static Packet command(int subtype, int number) {
        return Packet.of(
                Address.of(Interface.POSITION2D.code(), 0), MessageKind.COMMAND, subtype, 0, new Session.Lost(number));
    }

    @Test
    void ofCommandsThatWereNotDoneTheNewestOfEachKindIs() {
        for (int i = 0; i < 1000; i++) {
            offered.command(command(1, i));
            offered.command(command(2, -i));
        }
        scheduler.runPending();
        assertThat(obeyed).hasSize(2);
        assertThat(obeyed.getFirst().body()).isEqualTo(command(1, 999).body());
        assertThat(obeyed.getLast().body()).isEqualTo(command(2, -999).body());
        offered.command(command(1, 5));
        scheduler.runPending();
        assertThat(obeyed).hasSize(3);
    }

    @Test
    void theNewestIsDoneLast() {
        offered.command(command(1, 1));
        offered.command(command(2, 2));
        offered.command(command(1, 3));
        scheduler.runPending();
        assertThat(obeyed).extracting(packet -> packet.header().subtype()).containsExactly(2, 1);
    }
}
