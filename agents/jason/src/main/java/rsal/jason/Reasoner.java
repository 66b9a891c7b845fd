package rsal.jason;

import jason.architecture.AgArch;
import jason.asSemantics.Agent;
import jason.asSemantics.ArithFunction;
import jason.asSemantics.Circumstance;
import jason.asSemantics.DefaultArithFunction;
import jason.asSemantics.InternalAction;
import jason.asSemantics.TransitionSystem;
import jason.asSyntax.Term;
import java.lang.reflect.InvocationTargetException;
import java.util.Map;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;

/// Jason's agent without what it takes from the machine: internal actions come from the [Library], time and randomness
/// from the run.
final class Reasoner extends Agent {
    private static final long serialVersionUID = 1;
    private static final String CLOCK = "system.time";

    private final transient @Nullable Map<String, InternalAction> replaced;
    private final transient ArithFunction clock;
    private final Beliefs beliefs;
    private final transient Deliberation deliberation;

    static {
        JasonDefaults.override();
    }

    /// One that is only read, never run.
    Reasoner() {
        this(null, () -> 0, new AgArch(), new Circumstance());
    }

    /// @param replaced internal actions by name; null for one that never runs
    /// @param millis the run's time
    Reasoner(
            @Nullable Map<String, InternalAction> replaced,
            LongSupplier millis,
            AgArch architecture,
            Circumstance circumstance) {
        this.replaced = replaced;
        this.clock = new DefaultArithFunction() {
            private static final long serialVersionUID = 1;

            @Override
            public String getName() {
                return CLOCK;
            }

            @Override
            public double evaluate(TransitionSystem ts, Term[] args) {
                return millis.getAsLong();
            }
        };
        deliberation = new Deliberation(this, circumstance, architecture);
        this.beliefs = new Beliefs();
        setBB(beliefs);
        setPL(new Plans());
        initAg();
    }

    Beliefs beliefs() {
        return beliefs;
    }

    /// To be told before the first cycle.
    void complainTo(Diagnostics complaints) {
        deliberation.complainTo(complaints);
    }

    @Override
    public void addToMindInspectorWeb() {} // it would open a port

    @Override
    public void setLogger(AgArch architecture) {} // the deliberation's: a named one would stay for ever

    @Override
    public ArithFunction getFunction(String function, int arity) {
        return function.equals(CLOCK) ? clock : super.getFunction(function, arity);
    }

    /// @throws ClassNotFoundException when there is none of that name that agents may use
    @Override
    public InternalAction getIA(String name)
            throws ClassNotFoundException, InstantiationException, IllegalAccessException, InvocationTargetException,
                    NoSuchMethodException {
        if (Library.isAsItIs(name)) {
            return super.getIA(name);
        }
        InternalAction own = replaced == null ? null : replaced.get(name);
        if (own != null) {
            return own;
        }
        if (replaced == null) {
            return InternalActionOverrides.UNBOUND; // whether there is one of that name, the review tells
        }
        throw new ClassNotFoundException(
                "Internal action '%s' can't be used here. %s".formatted(name, Library.instead(name)));
    }
}
