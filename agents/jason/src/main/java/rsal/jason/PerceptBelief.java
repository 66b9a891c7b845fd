package rsal.jason;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.Structure;
import jason.bb.BeliefBase;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import rsal.agent.AgentContext;
import rsal.data.Angles;
import rsal.data.BatteryState;
import rsal.data.Blobs;
import rsal.data.LaserScan;
import rsal.data.PoseEstimate;
import rsal.device.Battery;
import rsal.device.BlobFinder;
import rsal.device.Device;
import rsal.device.Gripper;
import rsal.device.LaserScanner;
import rsal.device.Localizer;
import rsal.device.Sensor;
import rsal.robot.Robot;

/// What an agent believes of its robot by itself, as long as it is so: the newest reading of a device in place of the
/// one before. SI units and radians.
enum PerceptBelief {
    /// `pose(X,Y,Th)`: where the robot believes to be in the map [m, m, rad].
    POSE("pose", 3, Localizer.class, PerceptBelief::pose),
    /// `scan_min(Front,Left,Right)`: how far the nearest thing is that its laser sees [m], within 30° of ahead and
    /// between there and 100° to the left and right; as far as the laser sees where there is nothing.
    SCAN_MIN("scan_min", 3, LaserScanner.class, PerceptBelief::nearest),
    /// `blob(Color,X,Y)`: each patch of color whose distance its camera knows; ahead and to the left of the robot [m].
    BLOB("blob", 3, BlobFinder.class, PerceptBelief::blobs),
    /// `battery(Level)`: from 0 to 1.
    BATTERY("battery", 1, Battery.class, PerceptBelief::level),
    /// `between`: something is between the paddles of its gripper.
    BETWEEN("between", 0, Gripper.class, state -> flag("between", state.innerBeamBroken())),
    /// `holding`: its gripper holds something.
    HOLDING("holding", 0, Gripper.class, state -> flag("holding", state.holding()));

    private static final double AHEAD = Math.toRadians(30);
    private static final double ASIDE = Math.toRadians(100);
    private static final double PER_UNIT = 1000; // a millimetre and a thousandth are the least that is told

    private final String functor;
    private final int arity;
    private final Class<? extends Device> device;

    @SuppressWarnings("ImmutableEnumChecker") // it holds nothing but a class and a function
    private final Watch watch;

    /// @param literals what a reading says
    <T> PerceptBelief(
            String functor, int arity, Class<? extends Sensor<T>> device, Function<T, List<Literal>> literals) {
        this.functor = functor;
        this.arity = arity;
        this.device = device;
        this.watch = (self, robot, now) -> publish(self, robot.require(device), literals, now);
    }

    /// What beliefs of it are called.
    String functor() {
        return functor;
    }

    /// What a formula asks for; empty when it names a source that is not the robot, as `holding[source(amy)]`.
    static Optional<PerceptBelief> of(Literal literal) {
        Literal source = literal.getAnnot("source");
        if (source != null && !(source.hasTerm() && source.getTerm(0).equals(BeliefBase.APercept))) {
            return Optional.empty();
        }
        for (PerceptBelief percept : values()) {
            if (percept.functor.equals(literal.getFunctor()) && percept.arity == literal.getArity()) {
                return Optional.of(percept);
            }
        }
        return Optional.empty();
    }

    Class<? extends Device> device() {
        return device;
    }

    /// Tells what is so from now on, on the agent's lane.
    void watch(AgentContext self, Robot robot, Consumer<List<Literal>> now) {
        watch.begin(self, robot, now);
    }

    private interface Watch {
        void begin(AgentContext self, Robot robot, Consumer<List<Literal>> now);
    }

    private static <T> void publish(
            AgentContext self, Sensor<T> sensor, Function<T, List<Literal>> literals, Consumer<List<Literal>> now) {
        sensor.latest().ifPresent(reading -> now.accept(literals.apply(reading.value())));
        self.subscribe(sensor, reading -> now.accept(literals.apply(reading.value())));
    }

    private static List<Literal> pose(PoseEstimate estimate) {
        return estimate.mapFromBase().isFinite() ? List.of(literal(Terms.pose(estimate.mapFromBase()))) : List.of();
    }

    private static Literal literal(Structure structure) {
        return ASSyntax.createLiteral(structure.getFunctor(), structure.getTermsArray());
    }

    private static List<Literal> nearest(LaserScan scan) {
        double front = scan.rangeMax();
        double left = scan.rangeMax();
        double right = scan.rangeMax();
        for (int beam = 0; beam < scan.count(); beam++) {
            if (!scan.isHit(beam)) {
                continue;
            }
            double bearing = Angles.wrap(scan.baseFromLaser().theta() + scan.angle(beam));
            double range = scan.ranges()[beam];
            if (Math.abs(bearing) <= AHEAD) {
                front = Math.min(front, range);
            } else if (bearing > 0 && bearing <= ASIDE) {
                left = Math.min(left, range);
            } else if (bearing < 0 && bearing >= -ASIDE) {
                right = Math.min(right, range);
            }
        }
        return List.of(ASSyntax.createLiteral(
                "scan_min", Terms.number(fine(front)), Terms.number(fine(left)), Terms.number(fine(right))));
    }

    private static List<Literal> blobs(Blobs image) {
        var seen = new ArrayList<Literal>();
        for (Blobs.Blob blob : image.blobs()) {
            image.baseFromBlob(blob)
                    .ifPresent(place -> seen.add(ASSyntax.createLiteral(
                            "blob",
                            Terms.text(blob.color().toString()),
                            Terms.number(fine(place.x())),
                            Terms.number(fine(place.y())))));
        }
        return seen;
    }

    private static List<Literal> level(BatteryState state) {
        return Double.isFinite(state.level())
                ? List.of(ASSyntax.createLiteral("battery", Terms.number(fine(state.level()))))
                : List.of();
    }

    private static List<Literal> flag(String name, boolean holds) {
        return holds ? List.of(ASSyntax.createLiteral(name)) : List.of();
    }

    private static double fine(double value) {
        return Math.rint(value * PER_UNIT) / PER_UNIT;
    }

    /// `pose/3`, for messages.
    @Override
    public String toString() {
        return String.format(Locale.ROOT, "%s/%d", functor, arity);
    }
}
