package rsal.player.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.data.Point2d;
import rsal.data.Rgb;
import rsal.data.Sketch;
import rsal.player.message.Graphics2d;
import rsal.player.message.Interface;
import rsal.player.message.PlayerColor;
import rsal.player.message.Point;
import rsal.player.wire.Address;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;

/// What is drawn on a server's canvas, as that is told.
@Timeout(60)
class PlayerCanvasTest extends ScriptedBench {
    private static final Address CANVAS = Address.of(Interface.GRAPHICS2D.code(), 0);
    private static final List<Point2d> CORNERS = List.of(new Point2d(0, 0), new Point2d(1, 0.5), new Point2d(-2, 3));
    private static final List<Point> SENT = List.of(new Point(0, 0), new Point(1, 0.5), new Point(-2, 3));
    private static final PlayerColor RED = new PlayerColor(0, 255, 0, 0);

    private PlayerCanvas canvas;

    PlayerCanvasTest() {
        super(CANVAS);
    }

    @BeforeEach
    void begin() throws IOException {
        meet(IDENT);
        awaitKnown();
        run(() -> {
            canvas = new PlayerCanvas(info("canvas"), CANVAS, remote);
            remote.add(canvas);
        });
        start();
    }

    private void show(Sketch sketch) {
        run(() -> canvas.show(sketch));
    }

    private Packet next(int subtype) throws IOException {
        Packet next = client.next();
        while (!next.header().address().equals(CANVAS)) {
            next = client.next(); // of the connection itself
        }
        assertThat(next.header().kind()).isEqualTo(MessageKind.COMMAND);
        assertThat(next.header().subtype()).isEqualTo(subtype);
        return next;
    }

    private static Sketch line(Rgb color) {
        return new Sketch(List.of(new Sketch.Line(CORNERS, color)));
    }

    @Test
    void whatWasDrawnBeforeIsWipedAndAllStrokesAreDrawnInTheirOrder() throws IOException {
        var red = new Rgb(255, 0, 0);
        show(new Sketch(List.of(
                new Sketch.Dots(CORNERS, red),
                new Sketch.Line(CORNERS, red),
                new Sketch.Line(CORNERS.subList(0, 2), red),
                new Sketch.Area(CORNERS, red, Optional.of(new Rgb(0, 0, 255))),
                new Sketch.Area(CORNERS, red, Optional.empty()))));
        assertThat(next(Graphics2d.CLEAR).body()).isEmpty();
        assertThat(next(Graphics2d.POINTS).body(Graphics2d.Points.class)).isEqualTo(new Graphics2d.Points(SENT, RED));
        assertThat(next(Graphics2d.POLYLINE).body(Graphics2d.Points.class)).isEqualTo(new Graphics2d.Points(SENT, RED));
        assertThat(next(Graphics2d.POLYLINE).body(Graphics2d.Points.class).points())
                .isEqualTo(SENT.subList(0, 2));
        assertThat(next(Graphics2d.POLYGON).body(Graphics2d.Polygon.class))
                .isEqualTo(new Graphics2d.Polygon(SENT, RED, new PlayerColor(0, 0, 0, 255), 1));
        assertThat(next(Graphics2d.POLYGON).body(Graphics2d.Polygon.class).filled())
                .isZero();
    }

    @Test
    void whatIsThereAlreadyIsNotDrawnAgainUnlessTheConnectionIsNew() throws IOException {
        show(line(new Rgb(255, 0, 0)));
        next(Graphics2d.CLEAR);
        next(Graphics2d.POLYLINE);
        show(line(new Rgb(255, 0, 0)));
        show(line(new Rgb(0, 255, 0)));
        next(Graphics2d.CLEAR);
        assertThat(next(Graphics2d.POLYLINE).body(Graphics2d.Points.class).color())
                .isEqualTo(new PlayerColor(0, 0, 255, 0));
        client.close();
        meet(IDENT);
        start();
        next(Graphics2d.CLEAR);
        next(Graphics2d.POLYLINE);
        show(Sketch.EMPTY);
        next(Graphics2d.CLEAR);
    }
}
