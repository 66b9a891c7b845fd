package rsal.player.device;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.data.Point2d;
import rsal.data.Rgb;
import rsal.data.Sketch;
import rsal.data.Sketch.Stroke;
import rsal.device.Canvas;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.Health;
import rsal.player.device.RemoteServer.Order;
import rsal.player.message.Graphics2d;
import rsal.player.message.PlayerColor;
import rsal.player.message.Point;
import rsal.player.wire.Address;

/// A canvas behind `graphics2d`, as Stage has for each robot: what is drawn there moves along with that, and stays
/// until it is wiped. With each new connection it is drawn again.
final class PlayerCanvas extends DeviceCore implements Canvas, Remote {
    private static final int OPAQUE = 0;
    private static final PlayerColor BLACK = new PlayerColor(OPAQUE, 0, 0, 0);

    private final Address address;
    private final RemoteServer server;
    private Sketch shown = Sketch.EMPTY;
    private boolean connected;

    PlayerCanvas(DeviceInfo info, Address address, RemoteServer server) {
        super(info);
        this.address = address;
        this.server = server;
    }

    @Override
    public Address address() {
        return address;
    }

    @Override
    public void show(Sketch sketch) {
        if (!sketch.equals(shown)) {
            shown = sketch;
            if (connected) {
                draw();
            }
        }
    }

    private void draw() {
        var orders = new ArrayList<Order>();
        orders.add(new Order(Graphics2d.CLEAR, Optional.empty()));
        shown.strokes().forEach(stroke -> orders.add(order(stroke)));
        server.commands(address, orders);
    }

    private static Order order(Stroke stroke) {
        List<Point> points = stroke.points().stream()
                .map((Point2d point) -> new Point(point.x(), point.y()))
                .toList();
        PlayerColor color = color(stroke.color());
        return switch (stroke) {
            case Sketch.Dots _ -> new Order(Graphics2d.POINTS, Optional.of(new Graphics2d.Points(points, color)));
            case Sketch.Line _ -> new Order(Graphics2d.POLYLINE, Optional.of(new Graphics2d.Points(points, color)));
            case Sketch.Area area ->
                new Order(
                        Graphics2d.POLYGON,
                        Optional.of(new Graphics2d.Polygon(
                                points,
                                color,
                                area.fill().map(PlayerCanvas::color).orElse(BLACK),
                                area.fill().isPresent() ? 1 : 0)));
        };
    }

    private static PlayerColor color(Rgb color) {
        return new PlayerColor(OPAQUE, color.red(), color.green(), color.blue());
    }

    @Override
    public void connected() {
        connected = true;
        health(Health.ok());
        if (!shown.equals(Sketch.EMPTY)) {
            draw();
        }
    }

    /// Wipes it.
    @Override
    public void end() {
        show(Sketch.EMPTY);
    }

    /// It tells nothing.
    @Override
    public void take(Instant time, Record body) {}

    @Override
    public void lost(String reason) {
        connected = false;
        health(new Health.Lost(reason));
    }
}
