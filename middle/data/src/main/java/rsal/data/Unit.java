package rsal.data;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/// The unit of a number in a reading, by which plots and tables name it: `m/s²`.
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface Unit {
    String value();

    /// Whether the number is the same in all readings of a device, so that there is nothing to plot.
    boolean isFixed() default false;
}
