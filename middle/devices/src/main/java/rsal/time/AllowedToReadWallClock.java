package rsal.time;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/// Marks a class that may ask the machine for the time or wait for it. All others take theirs from a [Scheduler] or
/// an [java.time.InstantSource], so that a run can be repeated. The architecture tests look for this.
@Retention(RetentionPolicy.CLASS)
@Target(ElementType.TYPE)
public @interface AllowedToReadWallClock {
    /// Why it must.
    String value();
}
