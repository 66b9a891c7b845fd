package rsal.engine.arbitration;

import java.time.Duration;
import java.util.Optional;
import rsal.data.Twist2d;
import rsal.system.CommandTimeout;
import rsal.system.CommandWatch;

/// Somebody drives a robot by keys, and must say so again and again: in real time, since it is a person's hand that is
/// watched.
public final class KeyboardDriving {
    /// When nobody was heard for this long the robot is given back.
    public static final Duration LEASE = Duration.ofSeconds(5);

    /// Between two looks at the clock: twice a step of the world, so that the robot is told to stand still
    /// within [CommandTimeout#USUAL].
    private static final Duration LOOK = Duration.ofMillis(200);

    private final String driver;
    private final CommandWatch watch;
    private Twist2d wanted = Twist2d.STOP;
    private boolean released; // from all keys, since the motors were switched off

    /// @param driver who drives, as that page calls itself
    /// @param now [ns]
    KeyboardDriving(String driver, long now, boolean motors) {
        this.driver = driver;
        this.watch = new CommandWatch(Optional.of(CommandTimeout.USUAL), now);
        this.released = motors;
    }

    String driver() {
        return driver;
    }

    Twist2d wanted() {
        return wanted;
    }

    /// The driver wants this. After an emergency stop nothing counts until the keys were released once.
    void want(Twist2d velocity, long now, boolean motors) {
        watch.heard(now);
        released = motors && (released || velocity.equals(Twist2d.STOP));
        wanted = released ? velocity : Twist2d.STOP;
    }

    /// The motors are switched off.
    void halt() {
        released = false;
        wanted = Twist2d.STOP;
    }

    /// Looks at the clock.
    ///
    /// @return whether that has stopped it
    boolean fadesAt(long now) {
        boolean fades = watch.isSilent(now, LOOK) && !wanted.equals(Twist2d.STOP);
        if (fades) {
            wanted = Twist2d.STOP;
        }
        return fades;
    }

    boolean isOverAt(long now) {
        return watch.silence(now).compareTo(LEASE) > 0;
    }
}
