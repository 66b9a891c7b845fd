package rsal.jason;

import java.util.Arrays;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import rsal.behavior.Pilot;
import rsal.device.Device;
import rsal.device.DriveBase;
import rsal.device.Gripper;
import rsal.device.Navigator;

/// What an agent can do. SI units and radians.
enum Action {
    /// `goto(X,Y)`, `goto(X,Y,Th)`: drives there on the map [m, rad]. Ends when the robot is there, and fails
    /// with `reason(no_path)`, `reason(stuck)`, `reason(unsure)` when it is not localized there, or
    /// `reason(cancelled)` when something else drives it.
    GOTO("goto", 2, 3, Navigator.class),
    /// `goto_near(X,Y,Distance)`: the same, until it is that near [m], whichever way it looks.
    GOTO_NEAR("goto_near", 3, 3, Navigator.class),
    /// `drive(V,W)`: forward [m/s] and counter-clockwise [rad/s] from now on. A robot with a pilot slows down before
    /// what is in its way, and stops there; one without does not.
    DRIVE("drive", 2, 2, DriveBase.class),
    /// `follow_wall`: along the wall on its left from now on.
    FOLLOW_WALL("follow_wall", 0, 0, Pilot.class),
    /// `wander`: about, around all that is in its way, from now on.
    WANDER("wander", 0, 0, Pilot.class),
    /// `stop`: ends all of these.
    STOP("stop", 0, 0, DriveBase.class),
    /// `grip`: closes the gripper and lifts; fails with `reason(empty)` when it holds nothing then.
    GRIP("grip", 0, 0, Gripper.class),
    /// `release`: lowers and opens the gripper.
    RELEASE("release", 0, 0, Gripper.class),
    /// `publish(Topic, ...)`: says a message made of the terms to all.
    PUBLISH("publish", 1, 20),
    /// `state(Text, ...)`: says in some words what it is doing, for people.
    STATE("state", 1, 20),
    /// `show(Name, Value)`: shows something it believes, for people.
    SHOW("show", 2, 2);

    private final String functor;
    private final int least;
    private final int most;
    private final @Nullable Class<? extends Device> device;

    Action(String functor, int least, int most) {
        this.functor = functor;
        this.least = least;
        this.most = most;
        this.device = null;
    }

    Action(String functor, int least, int most, Class<? extends Device> device) {
        this.functor = functor;
        this.least = least;
        this.most = most;
        this.device = device;
    }

    static Optional<Action> of(String functor) {
        return Arrays.stream(values())
                .filter(action -> action.functor.equals(functor))
                .findFirst();
    }

    static Set<String> names() {
        return new TreeSet<>(
                Arrays.stream(values()).map(action -> action.functor).toList());
    }

    boolean takes(int terms) {
        return terms >= least && terms <= most;
    }

    /// How many terms it takes, in words.
    String size() {
        return least == most ? Integer.toString(least) : "%d to %d".formatted(least, most);
    }

    /// What the robot must have for it; empty when it needs no robot.
    Optional<Class<? extends Device>> device() {
        return Optional.ofNullable(device);
    }
}
