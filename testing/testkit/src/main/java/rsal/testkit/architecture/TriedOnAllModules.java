package rsal.testkit.architecture;

import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.condition.DisabledIfSystemProperty;

/// Left out by `./rsal test`, which sets the system property `rsal.test.whole`: there one test of the command line's
/// tries the same on the classes of all modules at once. To read the classes takes most of the time, and longest in a
/// new process.
@Inherited
@Target(ElementType.TYPE)
@Retention(RetentionPolicy.RUNTIME)
@DisabledIfSystemProperty(named = "rsal.test.whole", matches = "true", disabledReason = "tried on all modules at once")
@interface TriedOnAllModules {}
