package rsal.stage;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.Footprint;
import rsal.data.Interval;
import rsal.data.Point2d;
import rsal.data.Prism;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Axis;
import rsal.robot.RobotModel.Drive;
import rsal.robot.RobotModel.OdometryNoise;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotModel.Steering;
import rsal.robot.SimulationLimits;
import rsal.scene.Block;
import rsal.stage.PartMaker.Device;
import rsal.stage.Pieces.Piece;

/// Makes robot models of bases with all that stands on them. Bases of one make share theirs.
public final class RobotMaker {
    private static final String BASE = "base"; // as the simulation calls it
    private static final double SPECK = 0.02; // side of a robot that has no body [m]
    private static final double SLOWEST = 1e-6; // [m/s, rad/s], of what can't move that way
    private static final double WHEEL_ANGLE = Math.toRadians(45); // how far a car's wheels turn
    private static final double USUAL_DISTANCE_ERROR = 0.015 / Math.sqrt(3); // of Stage's uniform ±1.5 %
    private static final double USUAL_TURN_ERROR = 0.025 / Math.sqrt(3); // of Stage's uniform ±2.5 %

    private final Duration step;
    private final WorldProblems findings;
    private final Pieces pieces;
    private final Map<Make, Made> made = new HashMap<>();
    private final IdentityHashMap<Traits, Integer> numbers = new IdentityHashMap<>();

    /// @param step between two states of the world
    RobotMaker(Duration step, WorldProblems findings) {
        this.step = step;
        this.findings = findings;
        this.pieces = new Pieces(findings);
    }

    /// What makes two robots alike.
    ///
    /// @param traits number of those it has: copies of a macro share them, and to compare them would take long
    private record Make(int traits, String macro, Placement place, List<Make> children) {}

    private Make make(StageModel model, Placement place) {
        return new Make(
                numbers.computeIfAbsent(model.traits(), _ -> numbers.size()),
                model.macro(),
                place,
                model.children().stream()
                        .map(child -> make(child, child.parentFromModel()))
                        .toList());
    }

    /// A kind of robot.
    ///
    /// @param pieces of its body, in its base frame
    /// @param blocks the same, when no color of it is drawn
    record Made(RobotModel model, List<Piece> pieces, Optional<List<Block>> blocks) {
        /// Its body, what is drawn in a color.
        List<Block> blocks(Rgb color) {
            return blocks.orElseGet(
                    () -> pieces.stream().map(piece -> piece.in(color)).toList());
        }
    }

    /// Names of the devices that a base and what stands on it become, by the names of those models: of each its
    /// first.
    ///
    /// @param base of kind [ModelKind.Position]
    /// @param step between two states of the world
    public static Map<String, String> devices(StageModel base, Duration step) {
        var parts = new PartMaker(step);
        base.forEach(model -> parts.add(model, Placement.ORIGIN, Optional.empty()));
        var names = new LinkedHashMap<String, String>();
        parts.devices().forEach(device -> names.putIfAbsent(device.model().name(), device.name()));
        names.put(base.name(), BASE);
        return names;
    }

    /// @param base of kind [ModelKind.Position]
    Made make(StageModel base) {
        return made.computeIfAbsent(make(base, Placement.ORIGIN), _ -> makeNew(base));
    }

    private Made makeNew(StageModel base) {
        var body = new ArrayList<Piece>();
        var parts = new PartMaker(step);
        double use = collect(base, Placement.ORIGIN, Optional.empty(), body, parts);
        parts.battery(base, use);
        boolean drawn = body.stream().anyMatch(Piece::drawn);
        List<Block> blocks = List.copyOf(body.stream()
                .map(piece -> new Block(piece.prism(), piece.surface(), piece.carrier()))
                .toList()); // a copy, as that is what lists of robots share
        return new Made(
                model(base, solid(body, base.traits().color()), parts.devices()),
                List.copyOf(body),
                drawn ? Optional.empty() : Optional.of(blocks));
    }

    /// @param carrier the actuator that the model stands on
    /// @return what the models use while they work [W]
    private double collect(
            StageModel model, Placement reported, Optional<String> carrier, List<Piece> body, PartMaker parts) {
        Placement robotFromModel = model.traits().kind() instanceof ModelKind.Actuator actuator
                ? reported.compose(PartMaker.atStart(actuator))
                : reported;
        Optional<String> carrierOfChildren = parts.add(model, robotFromModel, carrier);
        pieces.of(model, robotFromModel).forEach(piece -> body.add(piece.on(carrierOfChildren)));
        double use = model.traits().energy().use();
        double top = model.traits().stacksChildren() ? model.traits().size().z() : 0;
        for (StageModel child : model.children()) {
            Placement robotFromChild = robotFromModel.raised(top).compose(child.parentFromModel());
            use += collect(child, robotFromChild, carrierOfChildren, body, parts);
        }
        return use;
    }

    /// What it takes for itself when it keeps out of the way: what runs into things, if anything does.
    ///
    /// @param color of the robot, which its pieces need not tell
    private static Solid solid(List<Piece> body, Optional<StageColor> color) {
        Optional<Rgb> own = color.map(c -> Rgb.of(c.rgb()));
        List<Piece> solid =
                body.stream().filter(piece -> piece.surface().obstacle()).toList();
        List<Prism> prisms = (solid.isEmpty() ? body : solid)
                .stream()
                        .map(piece -> new Prism(
                                piece.prism().shape(),
                                piece.prism().bottom(),
                                piece.prism().top(),
                                piece.drawn()
                                                || own.equals(Optional.of(
                                                        piece.surface().color()))
                                        ? Optional.empty()
                                        : Optional.of(piece.surface().color())))
                        .toList();
        return prisms.isEmpty()
                ? Solid.standing(Shape.Polygon.of(Footprint.box(SPECK, SPECK, new Point2d(0, 0))), SPECK)
                : new Solid(prisms);
    }

    private RobotModel model(StageModel base, Solid body, List<Device> devices) {
        ModelKind.Position position = (ModelKind.Position) base.traits().kind();
        var parts = new LinkedHashMap<String, Part>();
        var heights = new HashMap<String, Double>();
        var carriers = new HashMap<String, String>();
        Drive drive = possible(base, body, drive(position));
        for (Device device : devices) {
            var alone = new RobotModel(base.macro(), base.macro(), body, drive, Map.of(device.name(), device.part()));
            List<String> problems = SimulationLimits.problems(alone);
            if (problems.isEmpty()) {
                parts.put(device.name(), device.part());
                heights.put(device.name(), device.height());
                device.carrier().ifPresent(carrier -> carriers.put(device.name(), carrier));
            } else {
                findings.warn(
                        device.model().location(),
                        "A part of '%s' is ignored. %s"
                                .formatted(WorldProblems.shortened(base.macro()), String.join(" ", problems)),
                        "");
            }
        }
        return new RobotModel(base.macro(), base.macro(), body, drive, parts, heights, carriers);
    }

    private static Drive drive(ModelKind.Position position) {
        Steering steering = switch (position.drive()) {
            case DIFFERENTIAL -> new Steering.Differential();
            case OMNIDIRECTIONAL -> new Steering.Omnidirectional();
            case CAR -> new Steering.Car(position.wheelbase(), WHEEL_ANGLE);
        };
        ModelKind.Limits speeds = position.speeds();
        ModelKind.Limits accelerations = position.accelerations();
        return new Drive(
                steering,
                axis(speeds.x(), accelerations.x()),
                position.drive() == ModelKind.Drive.OMNIDIRECTIONAL ? axis(speeds.y(), accelerations.y()) : Axis.NONE,
                axis(speeds.turn(), accelerations.turn()),
                noise(position));
    }

    private static Axis axis(rsal.stage.ValueRange speed, rsal.stage.ValueRange acceleration) {
        return new Axis(around0(speed), around0(acceleration));
    }

    private static Interval around0(rsal.stage.ValueRange bounds) {
        return new Interval(
                Math.min(-SLOWEST, Math.min(bounds.min(), bounds.max())),
                Math.max(SLOWEST, Math.max(bounds.min(), bounds.max())));
    }

    private static OdometryNoise noise(ModelKind.Position position) {
        if (position.localization() == ModelKind.Localization.GPS) {
            return new OdometryNoise(0, 0, 0);
        }
        return position.odometryError()
                .map(e -> new OdometryNoise(Math.abs(e.x()), 0, Math.abs(e.turn())))
                .orElse(new OdometryNoise(USUAL_DISTANCE_ERROR, 0, USUAL_TURN_ERROR));
    }

    /// The drive, or the nearest to it that can be simulated.
    private Drive possible(StageModel base, Solid body, Drive wanted) {
        List<String> problems =
                SimulationLimits.problems(new RobotModel(base.macro(), base.macro(), body, wanted, Map.of()));
        if (problems.isEmpty()) {
            return wanted;
        }
        findings.warn(
                base.location(),
                "'%s' gets a plain drive. %s"
                        .formatted(WorldProblems.shortened(base.macro()), String.join(" ", problems)),
                "");
        return new Drive(
                new Steering.Differential(),
                symmetric(wanted.forward()),
                Axis.NONE,
                symmetric(wanted.turn()),
                wanted.odometryNoise());
    }

    private static Axis symmetric(Axis axis) {
        return Axis.symmetric(
                Math.max(-axis.speed().least(), axis.speed().most()),
                Math.max(-axis.acceleration().least(), axis.acceleration().most()));
    }
}
