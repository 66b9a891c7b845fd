package rsal.sim;

import java.time.Instant;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.GripperState;
import rsal.data.GripperState.Lift;
import rsal.data.GripperState.Paddles;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.GoalHandle;
import rsal.device.Gripper;
import rsal.device.Health;
import rsal.robot.RobotModel.Part;
import rsal.sim.world.Body;
import rsal.sim.world.GripperGeometry;
import rsal.sim.world.World;

/// A simulated gripper. Closing, its paddles take the first thing that can be gripped and that they are down to
/// the width of, and slide it to their middle. It is in nobody's way then and goes where the gripper goes, up
/// with the lift as well, until they open: then it stands where it is, or they stay closed where it has no
/// room. The lift raises the paddles by their own height. The paddles themselves are in nobody's way. Its
/// motors are off when its robot's are.
///
/// The beams cross from paddle to paddle at 1/4 (outer) and 3/4 (inner) of their length from the tips and, as
/// contacts do, notice only what can be gripped, as in Stage. Stage takes things at the first touch of either
/// paddle and puts them into the middle of the gripper's body.
final class SimGripper extends SimActuatedDevice<GripperState> implements Gripper {
    private static final double OUTER = 0.75; // of the paddles, from their root
    private static final double INNER = 0.25;

    private final Part.Gripper part;
    private final World world;
    private final Things things;
    private final Body robot;
    private final SimDrive drive;
    private final DeviceMount mount;
    private final GripperGeometry jaws;
    private final GripperMotion paddles;
    private final GripperMotion lift;
    private @Nullable Held held;
    private GripperState state;
    private boolean ready = true; // to snatch what comes: when nothing was between the open paddles before

    /// @param baseFromThing when actuators are at home
    /// @param above how high the thing's base is above ground then, and when the lift is down [m]
    private record Held(Body thing, Pose2d baseFromThing, double above) {}

    /// @param height of its underside above the base [m]
    SimGripper(
            DeviceInfo info,
            Part.Gripper part,
            World world,
            Things things,
            Body robot,
            SimDrive drive,
            double height,
            DeviceMount mount) {
        super(info, info.id(), part.period());
        this.part = part;
        this.world = world;
        this.things = things;
        this.robot = robot;
        this.drive = drive;
        this.mount = mount;
        this.jaws = new GripperGeometry(
                world,
                robot,
                part.baseFromGripper(),
                part.length() / 2 - part.paddleLength(),
                part.paddleLength(),
                part.opening(),
                height,
                part.height());
        this.paddles = new GripperMotion(part.closingTime(), part.closed() ? 1 : 0);
        this.lift = new GripperMotion(part.liftingTime(), part.raised() ? 1 : 0);
        this.state = sense();
    }

    @Override
    public GoalHandle<GripperState, Result> open() {
        Optional<String> stuck = letGo();
        GoalHandle<GripperState, Result> goal = paddles.goTo(stuck.isPresent() ? paddles.position() : 0);
        stuck.ifPresent(why -> paddles.end(new Result.Stuck(state, why)));
        return goal;
    }

    @Override
    public GoalHandle<GripperState, Result> close() {
        return paddles.goTo(held == null ? 1 : paddles.position());
    }

    @Override
    public GoalHandle<GripperState, Result> lift() {
        GoalHandle<GripperState, Result> goal = lift.goTo(part.hasLift() ? 1 : 0);
        if (!part.hasLift()) {
            lift.end(new Result.Stuck(state, "It has no lift."));
        }
        return goal;
    }

    @Override
    public GoalHandle<GripperState, Result> lower() {
        return lift.goTo(0);
    }

    /// Puts down what it holds.
    ///
    /// @return why that can't be
    private Optional<String> letGo() {
        Held now = held;
        if (now == null) {
            return Optional.empty();
        }
        Pose2d there = now.thing.pose();
        if (!world.putDown(now.thing, there, Math.max(0, now.above))) {
            return Optional.of("There is no room for '%s' at %s: '%s' is in the way."
                    .formatted(
                            now.thing.name(),
                            SpawnPlacement.at(there.x(), there.y()),
                            world.obstacle().map(Body::name).orElse(World.WALL)));
        }
        held = null;
        return Optional.empty();
    }

    /// Its robot is taken out of the world: what it holds stays, even where it has no room.
    void leaveBehind() {
        Held now = held;
        if (now != null && letGo().isPresent()) {
            held = null;
            world.drop(now.thing, Math.max(0, now.above));
        }
    }

    /// Somebody else takes a thing out of its paddles.
    void lose(Body thing) {
        if (held != null && held.thing == thing) {
            held = null;
            paddles.end(new Result.Cancelled());
        }
    }

    boolean holds(Body thing) {
        return held != null && held.thing == thing;
    }

    @Override
    void work(Instant now, double dt) {
        double driven = drive.enabled() ? dt : 0;
        lift.moveTo(lift.next(driven));
        jaws.follow(mount.now(), lifted());
        if (part.snatches()) {
            snatch();
        }
        double next = paddles.next(driven);
        Optional<GripperGeometry.Grip> grip = held == null && paddles.direction() > 0
                ? jaws.widest(gap(paddles.position()), things::contains).filter(g -> g.width() >= gap(next))
                : Optional.empty();
        paddles.moveTo(grip.map(this::closedAt).orElse(next));
        grip.ifPresent(this::hold);
        carry();
        state = sense();
        if (isDue(now)) {
            take(state, now);
        } else if (paddles.done() || lift.done()) {
            takeNow(state, now);
        }
    }

    /// Closes when something has come as far as the inner beam. What is put down is not taken again at once.
    private void snatch() {
        boolean open = paddles.position() == 0 && paddles.arrived();
        boolean free = !jaws.isAcross(INNER, part.opening(), null);
        if (open && ready && !free) {
            paddles.goTo(1);
        }
        ready = open && free;
    }

    /// How far the paddles close around a thing, if they are not closer already.
    private double closedAt(GripperGeometry.Grip grip) {
        return Math.max(paddles.position(), 1 - grip.width() / part.opening());
    }

    private void hold(GripperGeometry.Grip grip) {
        Pose2d gripperFromThing = robot.pose()
                .compose(mount.now().moved(part.baseFromGripper()))
                .inverse()
                .compose(grip.thing().pose());
        Pose2d inTheMiddle =
                new Pose2d(gripperFromThing.x(), gripperFromThing.y() - grip.middle(), gripperFromThing.theta());
        held = new Held(
                grip.thing(),
                part.baseFromGripper().compose(inTheMiddle),
                grip.thing().height() - raised());
        world.pickUp(grip.thing(), robot);
        paddles.stopHere();
    }

    /// Takes what it holds along to where the robot is.
    void carry() {
        if (held != null) {
            Pose2d baseFromThing = mount.now().moved(held.baseFromThing);
            world.carry(held.thing, robot.pose().compose(baseFromThing), Math.max(0, held.above + raised()));
        }
    }

    /// By the lift [m].
    private double lifted() {
        return lift.position() * part.height();
    }

    /// By the lift, and by what it stands on [m].
    private double raised() {
        return lifted() + mount.now().rise();
    }

    private double gap(double closed) {
        return part.opening() * (1 - closed);
    }

    private GripperState sense() {
        double closed = paddles.position();
        double raised = lift.position();
        double gap = gap(closed);
        Body thing = held == null ? null : held.thing;
        jaws.follow(mount.now(), lifted());
        Paddles standing = closed == 0 ? Paddles.OPEN : closed == 1 || held != null ? Paddles.CLOSED : Paddles.STOPPED;
        Lift level = raised == 0 ? Lift.DOWN : raised == 1 ? Lift.UP : Lift.STOPPED;
        return new GripperState(
                moving(paddles, Paddles.CLOSING, Paddles.OPENING).orElse(standing),
                closed,
                moving(lift, Lift.RISING, Lift.SINKING).orElse(level),
                raised,
                jaws.isAcross(INNER, gap, thing),
                jaws.isAcross(OUTER, gap, thing),
                held != null || jaws.isAlong(gap / 2, thing),
                held != null || jaws.isAlong(-gap / 2, thing),
                held != null);
    }

    private <M> Optional<M> moving(GripperMotion stroke, M up, M down) {
        return drive.enabled() ? stroke.moving(up, down) : Optional.empty();
    }

    @Override
    void reported(Stamped<GripperState> reading) {
        paddles.reported(reading);
        lift.reported(reading);
    }

    @Override
    void close(Health.Lost why) {
        super.close(why);
        paddles.end(new Result.Stuck(state, why.reason()));
        lift.end(new Result.Stuck(state, why.reason()));
    }
}
