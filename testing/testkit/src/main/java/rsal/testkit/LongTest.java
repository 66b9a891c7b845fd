package rsal.testkit;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;

/// A test that takes too long for each landing: only `./rsal test --all` runs it, which sets the system property
/// `rsal.test.all`.
@Target({ElementType.METHOD, ElementType.TYPE})
@Retention(RetentionPolicy.RUNTIME)
@EnabledIfSystemProperty(named = LongTest.PROPERTY, matches = "true", disabledReason = "runs by ./rsal test --all")
public @interface LongTest {
    /// The system property that says whether long tests run.
    String PROPERTY = "rsal.test.all";
}
