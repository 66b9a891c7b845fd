package rsal.player.message;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.lang.reflect.RecordComponent;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.player.Recorded;
import rsal.player.wire.Address;
import rsal.player.wire.CountOf;
import rsal.player.wire.Header;
import rsal.player.wire.Layout;
import rsal.player.wire.MalformedException;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.testkit.Trials;
import tools.jackson.databind.JsonNode;

class ProtocolTest {
    static Stream<Recorded.Vector> vectors() {
        return Recorded.vectors().stream();
    }

    @ParameterizedTest
    @MethodSource("vectors")
    void whatPlayerEncodedIsReadAndWrittenAsItWas(Recorded.Vector vector) throws IOException {
        Packet packet = packet(vector);
        Record body = Protocol.V3_1.read(packet).orElseThrow();
        assertThat(numbers(body)).isEqualTo(numbers(vector.value()));
        assertThat(write(packet.header(), body).bytes()).isEqualTo(packet.bytes());
    }

    /// The same with a header, as the vectors have bodies only.
    private static Packet packet(Recorded.Vector vector) throws IOException {
        var bytes = ByteBuffer.allocate(Header.BYTES + vector.bytes().length);
        bytes.putInt(0)
                .putInt(0)
                .putInt(vector.interf())
                .putInt(0)
                .putInt(vector.type())
                .putInt(vector.subtype());
        bytes.putDouble(0).putInt(0).putInt(vector.bytes().length).put(vector.bytes());
        return Packet.read(new ByteArrayInputStream(bytes.array())).orElseThrow();
    }

    private static Packet write(Header header, Record body) {
        return Packet.of(header.address(), header.kind(), header.subtype(), header.time(), body)
                .withSequence(header.sequence());
    }

    /// All numbers in their order, but not counts of arrays.
    private static List<Double> numbers(JsonNode value) {
        var numbers = new ArrayList<Double>();
        if (value.isNumber()) {
            numbers.add(value.asDouble());
        } else if (value.isString()) {
            for (byte each : HexFormat.of().parseHex(value.asString())) {
                numbers.add((double) each);
            }
        } else if (value.isArray()) {
            value.forEach(each -> numbers.addAll(numbers(each)));
        } else {
            value.properties().forEach(property -> {
                String counted = property.getKey().replaceAll("_count$", "");
                if (counted.equals(property.getKey()) || !value.has(counted)) {
                    numbers.addAll(numbers(property.getValue()));
                }
            });
        }
        return numbers;
    }

    private static List<Double> numbers(Object value) {
        var numbers = new ArrayList<Double>();
        switch (value) {
            case Integer number -> numbers.add((double) number);
            case Long number -> numbers.add((double) number);
            case Float number -> numbers.add((double) number);
            case Double number -> numbers.add(number);
            case byte[] bytes -> {
                for (byte each : bytes) {
                    numbers.add((double) each);
                }
            }
            case float[] floats -> {
                for (float each : floats) {
                    numbers.add((double) each);
                }
            }
            case double[] doubles -> {
                for (double each : doubles) {
                    numbers.add(each);
                }
            }
            case Collection<?> all -> all.forEach(each -> numbers.addAll(numbers(each)));
            case Record some -> {
                for (RecordComponent component : some.getClass().getRecordComponents()) {
                    if (component.getAnnotation(CountOf.class) == null) {
                        numbers.addAll(numbers(get(component, some)));
                    }
                }
            }
            default -> throw new AssertionError(value.getClass());
        }
        return numbers;
    }

    private static Object get(RecordComponent component, Record of) {
        try {
            return component.getAccessor().invoke(of);
        } catch (ReflectiveOperationException e) {
            throw new LinkageError(e.getMessage(), e);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"simple", "semantics"})
    void sessionsWithAServerAreReadAndWrittenAsTheyWere(String name) throws IOException {
        int bodies = 0;
        for (Recorded.Message message : Recorded.session(name)) {
            Packet packet =
                    Packet.read(new ByteArrayInputStream(message.bytes())).orElseThrow();
            assertThat(packet.header().kind()).isNotEqualTo(MessageKind.UNKNOWN);
            assertThat(packet.bytes()).isEqualTo(message.bytes());
            Record body = Protocol.V3_1.read(packet).orElse(null);
            if (body != null) {
                bodies++;
                assertThat(write(packet.header(), body).bytes()).as("%s", body).isEqualTo(message.bytes());
            } else {
                assertThat(packet.body()).as("%s", packet.header()).isEmpty();
            }
        }
        assertThat(bodies).isGreaterThan(100);
    }

    @Test
    void aSessionSaysWhatItWas() throws IOException {
        List<Recorded.Message> session = Recorded.session("simple");
        Packet devices =
                Packet.read(new ByteArrayInputStream(session.get(1).bytes())).orElseThrow();
        assertThat(devices.body(Session.Devices.class).devices())
                .extracting(Address::interf)
                .containsExactly(
                        Interface.SIMULATION.code(),
                        Interface.POSITION2D.code(),
                        Interface.RANGER.code(),
                        Interface.RANGER.code(),
                        Interface.LASER.code());
        assertThat(devices.header().address().robot()).isEqualTo(6665);
        Packet driver =
                Packet.read(new ByteArrayInputStream(session.get(3).bytes())).orElseThrow();
        assertThat(Chars.text(driver.body(Session.Driver.class).name())).isEqualTo("stage");
    }

    @ParameterizedTest
    @CsvSource({
        "Player v.3.1.1-dev, true",
        "Player v.3.1.0, true",
        "Player v.3.0.2, false",
        "Player v.2.1.3, false",
        "Player v.4.0.0, true",
        "something else, true"
    })
    void aServerIsUnderstoodByItsVersion(String ident, boolean newest) {
        assertThat(Protocol.of(ident)).isSameAs(newest ? Protocol.V3_1 : Protocol.V3_0);
    }

    @Test
    void whatChangedSincePlayer30IsReadAsItWasThen() throws IOException {
        var hypothesis = new Version30.Hypothesis(new Pose(1, 2, 3), new double[] {4, 5, 6}, 0.5);
        Packet packet = Packet.of(
                Address.of(Interface.LOCALIZE.code(), 0),
                MessageKind.DATA,
                Localize.HYPOTHESES,
                0,
                new Version30.Hypotheses(0, 0, List.of(hypothesis, hypothesis)));
        assertThat(packet.body()).hasSize(4 + 8 + 4 + 4 + 2 * 56);
        Record read = Protocol.V3_0.read(packet).orElseThrow();
        assertThat(numbers(read))
                .containsExactly(0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 0.5);
    }

    /// A million messages in all, a tenth of them at each landing: bodies and headers, whole and cut off, at once and
    /// byte by byte. Nothing of them stays.
    @Trials({"1", "2", "3", "4", "5", "6", "7", "8", "9", "10"})
    void noiseIsReadOrRefused(long seed) throws IOException {
        var random = new SplittableRandom(seed);
        List<byte[]> messages = new ArrayList<>();
        for (Recorded.Vector vector : Recorded.vectors()) {
            messages.add(packet(vector).bytes());
        }
        assertThat(read(random, messages, 10_000)).isGreaterThan(50);
        long before = used();
        assertThat(read(random, messages, 90_000)).isGreaterThan(1000);
        assertThat(used() - before).isLessThan(4 << 20);
    }

    /// @return how many of the messages could be read, noisy as they are
    private static int read(SplittableRandom random, List<byte[]> messages, int count) throws IOException {
        int read = 0;
        for (int i = 0; i < count; i++) {
            byte[] bytes = noisy(messages.get(random.nextInt(messages.size())).clone(), random);
            try (InputStream stream = i % 8 == 0 ? new Dribble(bytes) : new ByteArrayInputStream(bytes)) {
                Optional<Packet> packet = Packet.read(stream);
                if (packet.isPresent() && Protocol.V3_1.read(packet.get()).isPresent()) {
                    rewrites(
                            Protocol.V3_1.body(packet.get().header()).orElseThrow(),
                            packet.get().body());
                    read++;
                }
            } catch (MalformedException | EOFException e) {
                assertThat(e).hasMessageMatching("\\w.*");
            }
        }
        return read;
    }

    private static byte[] noisy(byte[] message, SplittableRandom random) {
        int body = message.length - Header.BYTES;
        switch (random.nextInt(6)) {
            case 0 -> {
                var noise = new byte[body];
                random.nextBytes(noise);
                System.arraycopy(noise, 0, message, Header.BYTES, body);
            }
            case 1 -> { // another length, which its header tells
                byte[] other = Arrays.copyOf(message, Header.BYTES + random.nextInt(2 * body + 1));
                ByteBuffer.wrap(other).putInt(Header.BYTES - Integer.BYTES, other.length - Header.BYTES);
                return other;
            }
            case 2 -> message[Header.BYTES + random.nextInt(body)] ^= (byte) (1 << random.nextInt(8));
            case 3 -> // a huge count, or none, where there is one
                ByteBuffer.wrap(message).putInt(Header.BYTES + 4 * random.nextInt(body / 4), random.nextInt());
            case 4 -> message[random.nextInt(Header.BYTES)] = (byte) random.nextInt();
            default -> {
                return Arrays.copyOf(message, random.nextInt(message.length)); // cut off
            }
        }
        return message;
    }

    /// What is reachable [B].
    private static long used() {
        System.gc();
        return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
    }

    private static <T extends Record> void rewrites(Class<T> type, byte[] body) throws MalformedException {
        Layout<T> layout = Layout.of(type);
        assertThat(layout.bytes(layout.read(body))).hasSameSizeAs(body);
    }

    /// As sockets may have it.
    @Test
    void messagesThatComeByteByByteAreTheSame() throws IOException {
        for (Recorded.Vector vector : Recorded.vectors()) {
            Packet packet = packet(vector);
            Packet read = Packet.read(new Dribble(packet.bytes())).orElseThrow();
            assertThat(read.header()).isEqualTo(packet.header());
            assertThat(read.body()).isEqualTo(packet.body());
        }
    }

    @Test
    void messagesThatEndEarlyAreRefused() throws IOException {
        for (Recorded.Vector vector : Recorded.vectors()) {
            byte[] bytes = packet(vector).bytes();
            for (int length = 1; length < Math.min(bytes.length, 200); length++) {
                byte[] start = Arrays.copyOf(bytes, length);
                assertThatExceptionOfType(EOFException.class).isThrownBy(() -> Packet.read(new Dribble(start)));
            }
        }
    }

    /// Gives one byte at a time, however many are asked for.
    private static final class Dribble extends FilterInputStream {
        Dribble(byte[] bytes) {
            super(new ByteArrayInputStream(bytes));
        }

        @Override
        public int read(byte[] to, int offset, int length) throws IOException {
            return super.read(to, offset, Math.min(1, length));
        }
    }

    @Test
    void headersThatCanNotBeAreRefused() {
        var bytes = ByteBuffer.allocate(Header.BYTES).putInt(36, Header.MOST + 1);
        assertThatExceptionOfType(MalformedException.class)
                .isThrownBy(() -> Packet.read(new ByteArrayInputStream(bytes.array())))
                .withMessageContaining("33554433 bytes");
        bytes.putInt(36, -1);
        assertThatExceptionOfType(MalformedException.class)
                .isThrownBy(() -> Packet.read(new ByteArrayInputStream(bytes.array())))
                .withMessageContaining("4294967295 bytes");
    }

    @Test
    void theWorkedExampleOfASubscription() {
        Packet packet = Packet.of(
                        Address.of(Interface.PLAYER.code(), 0),
                        MessageKind.REQUEST,
                        Session.DEVICE,
                        0,
                        new Session.Subscription(Address.of(Interface.POSITION2D.code(), 0), Session.OPEN, new byte[0]))
                .withSequence(1);
        assertThat(HexFormat.of().formatHex(packet.bytes()))
                .isEqualTo("0000000000000000000000010000000000000003000000030000000000000000000000010000001c"
                        + "00000000000000000000000400000000000000010000000000000000");
    }
}
