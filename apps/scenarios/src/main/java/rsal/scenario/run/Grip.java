package rsal.scenario.run;

import rsal.data.Twist2d;

/// Somebody drives a robot by keys, and must say so again and again: in real time, since it is a person's hand that is
/// watched.
final class Grip {
    /// When nobody was heard for this long the robot stands still, so that with a step of the world it takes no
    /// longer than half a second [ns].
    static final long DEADMAN = 400_000_000L;

    /// When nobody was heard for this long the robot is given back [ns].
    static final long LEASE = 5_000_000_000L;

    private final String driver;
    private Twist2d wanted = Twist2d.STOP;
    private long heard;
    private boolean released; // from all keys, since the motors were switched off

    /// @param driver who drives, as that page calls itself
    /// @param now [ns]
    Grip(String driver, long now, boolean motors) {
        this.driver = driver;
        this.heard = now;
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
        heard = Math.max(heard, now);
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
        boolean fades = now - heard > DEADMAN && !wanted.equals(Twist2d.STOP);
        if (fades) {
            wanted = Twist2d.STOP;
        }
        return fades;
    }

    boolean isOverAt(long now) {
        return now - heard > LEASE;
    }
}
