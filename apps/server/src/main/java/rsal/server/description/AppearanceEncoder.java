package rsal.server.description;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Prism;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.device.SimulationControl.Carried;
import rsal.device.SimulationControl.Standing;
import rsal.engine.report.Teammate;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.server.message.Messages.CarriedInfo;
import rsal.server.message.Messages.GripperInfo;
import rsal.server.message.Messages.LightInfo;
import rsal.server.message.Messages.PieceInfo;
import rsal.server.message.Messages.RobotInfo;
import rsal.server.message.Messages.ThingInfo;

/// Puts what bodies look like into messages.
public final class AppearanceEncoder {
    private static final int MOST_CORNERS = 400; // of a robot
    private static final double PLACES = 1e4; // tenths of millimetres, and of milliradians

    private AppearanceEncoder() {}

    public static RobotInfo robot(Teammate mate) {
        var spec = mate.spec();
        List<PieceInfo> pieces = mate.body()
                .map(body -> pieces(body, spec.color()))
                .filter(all -> all.stream()
                                .map(PieceInfo::corners)
                                .mapToInt(Collection::size)
                                .sum()
                        <= MOST_CORNERS)
                .orElse(List.of());
        return new RobotInfo(
                spec.id(),
                spec.role(),
                spec.color(),
                spec.model().title(),
                corners(spec.model().footprint()),
                pieces,
                part(spec.model(), Part.Gripper.class, (name, part) -> gripper(name, part, spec.model())),
                part(spec.model(), Part.Light.class, AppearanceEncoder::light));
    }

    private static <P extends Part, I> Optional<I> part(
            RobotModel model, Class<P> type, BiFunction<String, P, I> describe) {
        return model.sensors().entrySet().stream()
                .filter(sensor -> type.isInstance(sensor.getValue()))
                .findFirst()
                .map(sensor -> describe.apply(sensor.getKey(), type.cast(sensor.getValue())));
    }

    private static GripperInfo gripper(String name, Part.Gripper part, RobotModel model) {
        var pose = part.baseFromGripper();
        double low = model.level(name);
        return new GripperInfo(
                name,
                pose.x(),
                pose.y(),
                pose.theta(),
                part.length(),
                part.width(),
                part.paddleLength(),
                part.paddleWidth(),
                rounded(low),
                rounded(low + part.height()),
                part.hasLift() ? part.height() : 0);
    }

    private static LightInfo light(String name, Part.Light part) {
        var pose = part.baseFromLight();
        return new LightInfo(name, pose.x(), pose.y(), part.color().toString());
    }

    static CarriedInfo carried(Carried load) {
        var pose = load.baseFromMoved();
        return new CarriedInfo(
                load.devices(),
                load.pieces(),
                rounded(pose.x()),
                rounded(pose.y()),
                rounded(pose.theta()),
                rounded(load.rise()));
    }

    public static ThingInfo thing(Standing thing) {
        var pose = thing.mapFromThing();
        return new ThingInfo(
                thing.number(),
                thing.name(),
                pose.x(),
                pose.y(),
                pose.theta(),
                thing.height(),
                pieces(thing.body(), ""));
    }

    private static List<PieceInfo> pieces(Solid body, String own) {
        return body.pieces().stream()
                .sorted(Comparator.comparingDouble(Prism::top))
                .map(piece -> piece(piece, own))
                .toList();
    }

    private static PieceInfo piece(Prism piece, String own) {
        Optional<String> color = piece.color().map(Object::toString).filter(other -> !other.equals(own));
        double low = rounded(piece.bottom());
        double high = rounded(piece.top());
        return switch (piece.shape()) {
            case Shape.Disc disc ->
                new PieceInfo(color, List.of(corner(disc.center())), rounded(disc.radius()), low, high);
            case Shape.Polygon polygon ->
                new PieceInfo(
                        color,
                        polygon.corners().stream()
                                .map(AppearanceEncoder::corner)
                                .toList(),
                        0,
                        low,
                        high);
        };
    }

    private static List<List<Double>> corners(Footprint footprint) {
        return footprint.corners().stream().map(AppearanceEncoder::corner).toList();
    }

    private static List<Double> corner(Point2d corner) {
        return List.of(rounded(corner.x()), rounded(corner.y()));
    }

    private static double rounded(double meters) {
        return Math.round(meters * PLACES) / PLACES;
    }
}
