package rsal.player.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.time.Duration;
import java.util.Arrays;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.CompletionException;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.data.OccupancyGrid;
import rsal.data.Stamped;
import rsal.device.Health;
import rsal.player.message.Interface;
import rsal.player.message.MapInterface;
import rsal.player.message.Pose;
import rsal.player.message.Version30;
import rsal.player.wire.Address;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.testkit.Trials;

/// Maps of servers that say what a test has them say.
@Timeout(60)
class PlayerMapTest extends ScriptedBench {
    private static final Address MAP = Address.of(Interface.MAP.code(), 0);
    private static final byte[] VALUES = {-1, 0, 1};

    private static final Duration AGAIN = Duration.ofMillis(200);

    private PlayerMap map;

    PlayerMapTest() {
        super(MAP);
    }

    @BeforeEach
    void meet() throws IOException {
        meet(IDENT);
    }

    private void begin() throws IOException {
        awaitKnown();
        run(() -> {
            map = new PlayerMap(info("map"), MAP, remote, time, AGAIN);
            remote.add(map);
        });
        start();
    }

    private void publish(MapInterface.Extent extent) throws IOException {
        client.acknowledge(client.next(MAP, MapInterface.INFO), extent);
    }

    private static MapInterface.Extent extent(int width, int height) {
        return new MapInterface.Extent(0.05f, width, height, new Pose(-3.5, 2.25, 0));
    }

    private OccupancyGrid awaited() {
        Stamped<OccupancyGrid> newest = until(map::latest, Optional::isPresent).orElseThrow();
        assertThat(newest.frame()).isEqualTo("map");
        return newest.value();
    }

    private static byte[] random(int count) {
        var random = new SplittableRandom(count);
        var cells = new byte[count];
        for (int i = 0; i < count; i++) {
            cells[i] = VALUES[random.nextInt(3)];
        }
        return cells;
    }

    private static byte[] tile(byte[] cells, int width, MapInterface.Tile asked) {
        var tile = new byte[asked.width() * asked.height()];
        for (int row = 0; row < asked.height(); row++) {
            int from = (asked.row() + row) * width + asked.column();
            System.arraycopy(cells, from, tile, row * asked.width(), asked.width());
        }
        return tile;
    }

    /// Fast, as a server that is silent for long counts as lost, also while other tests take the processors.
    private static byte[] packed(byte[] cells) {
        var bytes = new ByteArrayOutputStream();
        try (var zip = new DeflaterOutputStream(bytes, new Deflater(Deflater.BEST_SPEED))) {
            zip.write(cells);
        } catch (IOException e) {
            throw new AssertionError(e);
        }
        return bytes.toByteArray();
    }

    private static MapInterface.Tile answer(MapInterface.Tile asked, int range, byte[] bytes) {
        return new MapInterface.Tile(
                asked.column(), asked.row(), asked.width(), asked.height(), bytes.length, range, bytes);
    }

    private static byte[] ours(byte[] cells) {
        byte[] ours = cells.clone();
        for (int i = 0; i < ours.length; i++) {
            ours[i] = switch (cells[i]) {
                case -1 -> OccupancyGrid.FREE;
                case 1 -> OccupancyGrid.OCCUPIED;
                default -> OccupancyGrid.UNKNOWN;
            };
        }
        return ours;
    }

    @Trials(
            value = {"1, 1, 1", "3, 2, 1", "1259, 312, 1", "4000, 4001, 3", "9000000, 2, 4"},
            landing = 3)
    void theWholeMapIsPutTogetherOfTiles(int width, int height, int tiles) throws IOException {
        begin();
        byte[] cells = random(width * height);
        publish(extent(width, height));
        for (int i = 0; i < tiles; i++) {
            Packet request = client.next(MAP, MapInterface.TILE);
            MapInterface.Tile asked = request.body(MapInterface.Tile.class);
            assertThat(asked.width() * asked.height()).isBetween(1, MapInterface.LARGEST_TILE);
            byte[] tile = tile(cells, width, asked);
            client.acknowledge(request, answer(asked, 1, i % 2 == 0 ? packed(tile) : tile));
        }
        OccupancyGrid map = awaited();
        assertThat(map.width()).isEqualTo(width);
        assertThat(map.height()).isEqualTo(height);
        assertThat(map.resolution()).isEqualTo(0.05);
        assertThat(map.originX()).isEqualTo(-3.5);
        assertThat(map.originY()).isEqualTo(2.25);
        assertThat(Arrays.equals(map.cells(), ours(cells))).isTrue();
        assertThat(on(this.map::health).isOk()).isTrue();
    }

    @Test
    void noMoreThanTwoTilesAreAskedForAtOnce() throws IOException {
        begin();
        publish(extent(8000, 5000));
        for (int i = 0; i < 2; i++) {
            client.next(MAP, MapInterface.TILE);
        }
        client.socket().setSoTimeout(300);
        assertThat(Stream.of(1, 2, 3).anyMatch(_ -> asksForATile())).isFalse();
    }

    private boolean asksForATile() {
        try {
            return client.next().header().address().equals(MAP);
        } catch (IOException e) {
            return false; // it asks for nothing
        }
    }

    @Test
    void shadesAreWhatIsNearer() throws IOException {
        begin();
        publish(extent(7, 1));
        Packet request = client.next(MAP, MapInterface.TILE);
        byte[] shades = {-100, -51, -50, 0, 50, 51, 100};
        client.acknowledge(request, answer(request.body(MapInterface.Tile.class), 100, shades));
        assertThat(awaited().cells()).containsExactly(ours(new byte[] {-1, -1, 0, 0, 0, 1, 1}));
    }

    @Test
    void itIsReadAgainWithEachConnectionAndWhenTheServerReportsAnother() throws IOException {
        begin();
        publishOne(1);
        assertThat(awaited().cells()).containsExactly(OccupancyGrid.OCCUPIED);
        client.send(Packet.of(MAP, MessageKind.DATA, MapInterface.INFO_DATA, 0, extent(1, 1)));
        publishOne(-1);
        until(OccupancyGrid.FREE);
        client.close();
        meet("Player v.3.1.0");
        start();
        publishOne(1);
        until(OccupancyGrid.OCCUPIED);
    }

    @Test
    void anOlderServerIsUnderstood() throws IOException {
        begin();
        client.close();
        meet("Player v.3.0.2");
        start();
        publish(extent(2, 1));
        Packet request = client.next(MAP, MapInterface.TILE);
        Version30.Tile asked = request.body(Version30.Tile.class);
        client.acknowledge(request, new Version30.Tile(asked.column(), asked.row(), 2, 1, packed(new byte[] {1, -1})));
        assertThat(awaited().cells()).containsExactly(OccupancyGrid.OCCUPIED, OccupancyGrid.FREE);
    }

    private void until(byte cell) {
        until(map::latest, newest -> newest.isPresent() && newest.get().value().cells()[0] == cell);
    }

    private void publishOne(int cell) throws IOException {
        publish(extent(1, 1));
        Packet request = client.next(MAP, MapInterface.TILE);
        client.acknowledge(request, answer(request.body(MapInterface.Tile.class), 1, new byte[] {(byte) cell}));
    }

    static Stream<Arguments> extentsThatCanNotBe() {
        var origin = new Pose(0, 0, 0);
        return Stream.of(
                Arguments.of(extent(40_000, 25_000), "(40000 × 25000) cells; at most 67108864"),
                Arguments.of(extent(65_536, 65_536), "(65536 × 65536) cells"),
                Arguments.of(extent(-1, 1), "(4294967295 × 1) cells"),
                Arguments.of(extent(0, 1), "(0 × 1) cells"),
                Arguments.of(new MapInterface.Extent(0, 1, 1, origin), "Its cells of (0.0 m)"),
                Arguments.of(new MapInterface.Extent(Float.NaN, 1, 1, origin), "Its cells of (NaN m)"),
                Arguments.of(new MapInterface.Extent(1, 1, 1, new Pose(0, Double.NaN, 0)), "from (0.0, NaN) on"));
    }

    @ParameterizedTest
    @MethodSource("extentsThatCanNotBe")
    void anExtentThatCanNotBeIsRefused(MapInterface.Extent extent, String why) throws IOException {
        begin();
        publish(extent);
        assertLost(why);
    }

    static Stream<Arguments> tilesThatCanNotBe() {
        return Stream.of(
                tampered(
                        "moved",
                        tile -> new MapInterface.Tile(1, 0, 4, 3, 12, 1, new byte[12]),
                        "(4 × 3) cells from (1, 0)"),
                tampered("larger", tile -> new MapInterface.Tile(0, 0, 5, 3, 15, 1, new byte[15]), "(5 × 3) cells"),
                tampered("too short", tile -> answer(tile, 1, new byte[11]), "The 11 bytes of (4 × 3) cells"),
                tampered("packed, too short", tile -> answer(tile, 1, packed(new byte[11])), "are not its cells"),
                tampered("packed, too long", tile -> answer(tile, 1, packed(new byte[13])), "are not its cells"),
                tampered("a bomb", tile -> answer(tile, 1, packed(new byte[20_000_000])), "are not its cells"),
                tampered(
                        "cut off",
                        tile -> answer(tile, 1, Arrays.copyOf(packed(new byte[12]), 9)),
                        "The 9 bytes of (4 × 3) cells"));
    }

    private static Arguments tampered(String what, UnaryOperator<MapInterface.Tile> answer, String why) {
        return Arguments.of(what, answer, why);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("tilesThatCanNotBe")
    void aTileThatCanNotBeIsRefused(String what, UnaryOperator<MapInterface.Tile> answer, String why)
            throws IOException {
        begin();
        publish(extent(4, 3));
        Packet request = client.next(MAP, MapInterface.TILE);
        client.acknowledge(request, answer.apply(request.body(MapInterface.Tile.class)));
        assertLost(why);
    }

    @Test
    void answersThatSayNothingAreRefused() throws IOException {
        begin();
        client.acknowledge(client.next(MAP, MapInterface.INFO));
        assertLost("The server does not report the size of its map.");
        publish(extent(4, 3));
        client.acknowledge(client.next(MAP, MapInterface.TILE));
        assertLost("The server reports nothing of (4 × 3) cells from (0, 0) on.");
    }

    @Test
    void aServerThatHasNoneYetIsAskedAgain() throws IOException {
        begin();
        client.refuse(client.next(MAP, MapInterface.INFO));
        assertLost("The server refuses request 1 of 'map:0'.");
        publishOne(1);
        until(OccupancyGrid.OCCUPIED);
        assertThat(on(map::health).isOk()).isTrue();
    }

    private void assertLost(String why) {
        Health lost =
                until(map::health, health -> health instanceof Health.Lost(String reason) && reason.contains(why));
        assertThat(lost)
                .isInstanceOfSatisfying(
                        Health.Lost.class, its -> assertThat(its.reason()).startsWith("Its map can't be read: "));
        assertThat(on(map::latest)).isEmpty();
    }

    @Test
    void anyTileIsUnpackedOrRefused() {
        var random = new SplittableRandom(1);
        byte[] packed = packed(random(400));
        int whole = 0;
        for (int i = 0; i < 20_000; i++) {
            byte[] bytes = Arrays.copyOf(packed, random.nextInt(4) == 0 ? random.nextInt(500) : packed.length);
            for (int flips = random.nextInt(3); flips > 0 && bytes.length > 0; flips--) {
                bytes[random.nextInt(bytes.length)] ^= (byte) (1 << random.nextInt(8));
            }
            var asked = new MapInterface.Tile(0, 0, 20, 20, 0, 0, new byte[0]);
            try {
                int range = random.nextInt(-200, 200);
                assertThat(MapReader.unpacked(asked, Optional.of(answer(asked, range, bytes))))
                        .hasSize(400);
                whole++;
            } catch (CompletionException e) {
                assertThat(e).hasMessageContaining("bytes of (20 × 20) cells");
            }
        }
        assertThat(whole).isBetween(1000, 19_000);
    }
}
