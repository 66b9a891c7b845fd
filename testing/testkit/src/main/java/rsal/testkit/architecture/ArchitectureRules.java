package rsal.testkit.architecture;

import java.util.List;

/// What all classes of a module keep to. Each module has one subclass of this among its tests, named after it:
///
/// ```java
/// class SimArchitectureTest extends ArchitectureRules {
///     SimArchitectureTest() {
///         super(SimProvider.class); // any class of the module
///     }
/// }
/// ```
///
/// Those of `data`, `devices` and `agents` are among the testkit's own tests, which those modules can't depend on.
@TriedOnAllModules
public abstract class ArchitectureRules extends ClassRules {
    /// @param anchor any class of the module, to find the others by
    protected ArchitectureRules(Class<?> anchor) {
        super(List.of(home(anchor)));
    }
}
