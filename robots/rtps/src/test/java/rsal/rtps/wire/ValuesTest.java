package rsal.rtps.wire;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/// Values in both byte orders, against slow and obvious versions.
class ValuesTest {
    private static final List<ByteOrder> ORDERS = List.of(ByteOrder.BIG_ENDIAN, ByteOrder.LITTLE_ENDIAN);

    private final SplittableRandom random = new SplittableRandom(1);

    private static ByteBuffer buffer(ByteOrder order) {
        return ByteBuffer.allocate(100).order(order);
    }

    /// A table takes the lowest bits of a hash, after adding the highest ones to them.
    @Test
    void idsOfOneParticipantAreSpreadInHashTables() {
        int buckets = 4096;
        int[] load = new int[buckets];
        for (int number = 1; number <= buckets / 2; number++) {
            for (EntityId id : List.of(EntityId.writer(number), EntityId.reader(number))) {
                int hash = new Guid(new GuidPrefix(0x0152_0000_1234_5678L, 9), id).hashCode();
                load[(hash ^ hash >>> 16) & buckets - 1]++;
            }
        }
        assertThat(Arrays.stream(load).max().orElseThrow()).isLessThan(9); // random hashes: 7 on average
    }

    @Test
    void nanosecondsSurviveOnTheWire() {
        for (int i = 0; i < 100_000; i++) {
            long time = random.nextLong(4_000_000_000_000_000_000L);
            for (ByteOrder order : ORDERS) {
                ByteBuffer bytes = buffer(order);
                Timestamp.writeTime(bytes, time);
                assertThat(Timestamp.readTime(bytes.flip())).isEqualTo(time);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {0, 1, 100_000_000, 20_000_000_000L, Timestamp.INFINITE})
    void durationsSurviveToo(long duration) {
        ByteBuffer bytes = buffer(ByteOrder.LITTLE_ENDIAN);
        Timestamp.writeDuration(bytes, duration);
        assertThat(Timestamp.readDuration(bytes.flip())).isEqualTo(duration);
    }

    @Test
    void setsHaveTheNumbersThatWerePutIn() throws Exception {
        for (int i = 0; i < 5_000; i++) {
            long base = random.nextLong(1, 1L << 40);
            var numbers = new TreeSet<Long>();
            for (int k = random.nextInt(20); k > 0; k--) {
                numbers.add(base + random.nextInt(300));
            }
            NumberSet set = NumberSet.of(base, numbers.stream().mapToLong(Long::longValue));
            long[] expected = numbers.headSet(base + NumberSet.MOST).stream()
                    .mapToLong(Long::longValue)
                    .toArray();
            assertThat(set.numbers().toArray()).isEqualTo(expected);
            assertThat(set.isEmpty()).isEqualTo(expected.length == 0);
            for (ByteOrder order : ORDERS) {
                ByteBuffer bytes = buffer(order);
                set.writeNumbers(bytes);
                assertThat(NumberSet.readNumbers(bytes.flip())).isEqualTo(set);
                assertThat(bytes.remaining()).isZero();
            }
        }
    }

    @Test
    void setsOfTooManyNumbersAreRefused() {
        ByteBuffer bytes = buffer(ByteOrder.LITTLE_ENDIAN).putInt(0).putInt(1).putInt(257);
        assertThatThrownBy(() -> NumberSet.readNumbers(bytes.flip()))
                .isInstanceOf(InvalidRtps.class)
                .hasMessage("A set of 257 numbers; the most are 256.");
    }

    @Test
    void guidsAndEntitiesHaveNoByteOrder() {
        var guid = new Guid(new GuidPrefix(0x0152_0304_0506_0708L, 0x090a0b0c), EntityId.PUBLICATION_WRITER);
        for (ByteOrder order : ORDERS) {
            ByteBuffer bytes = ByteBuffer.allocate(Guid.BYTES).order(order);
            guid.write(bytes);
            assertThat(bytes.array()).containsExactly(1, 0x52, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 0, 0, 3, 0xc2);
            assertThat(Guid.read(bytes.flip())).isEqualTo(guid);
            assertThat(bytes.order()).isEqualTo(order);
        }
        assertThat(guid).hasToString("0152030405060708090a0b0c:000003c2");
    }

    @Test
    void onlyAddressesOfOneMachineAreReached() throws Exception {
        var address = new InetSocketAddress(InetAddress.getByName("192.168.1.5"), 7410);
        Locator locator = Locator.udp(address);
        ByteBuffer bytes = buffer(ByteOrder.LITTLE_ENDIAN);
        locator.write(bytes);
        assertThat(Locator.read(bytes.flip())).isEqualTo(locator);
        assertThat(locator.unicast()).contains(address);
        for (Locator other : List.of(
                new Locator(16, 7410, 0, 1), // shared memory
                new Locator(1, 0, 0, 0x7f00_0001L),
                new Locator(1, 70_000, 0, 0x7f00_0001L),
                new Locator(1, 7410, 0, 0),
                new Locator(1, 7410, 0, 0xefff_0001L))) { // multicast
            assertThat(other.unicast()).as(other.toString()).isEmpty();
        }
    }

    @Test
    void textsOfParametersAreReadAsTheyWereWritten() throws Exception {
        for (String text : List.of("", "a", "rt/scan", "größer")) {
            ByteBuffer bytes = buffer(ByteOrder.LITTLE_ENDIAN);
            new ParameterList.Writer(bytes).putText(5, text).putOctets(44, text).end();
            ParameterList list = ParameterList.read(bytes.flip());
            assertThat(list.text(5)).contains(text);
            assertThat(list.octets(44)).contains(text);
            assertThat(list.text(7)).isEmpty();
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"no end", "too long", "odd"})
    void brokenListsAreRefused(String how) {
        ByteBuffer bytes = buffer(ByteOrder.LITTLE_ENDIAN);
        switch (how) {
            case "no end" -> bytes.putInt(0x0004_0005).putInt(1);
            case "too long" -> bytes.putInt(0x0400_0005).putInt(1);
            default -> bytes.putInt(0x0003_0005).putInt(1);
        }
        assertThatThrownBy(() -> ParameterList.read(bytes.flip())).isInstanceOf(InvalidRtps.class);
    }
}
