package rsal.jason;

import jason.JasonException;
import jason.asSyntax.Literal;
import jason.asSyntax.Plan;
import jason.asSyntax.Pred;
import jason.pl.PlanLibrary;
import java.util.List;

/// The plans of an agent. Labels of those that have none are counted for this agent, as `p__3`; Jason's own count would
/// go on through the whole process.
final class Plans extends PlanLibrary {
    private static final long serialVersionUID = 1;
    private static final String COUNTED = "p__";

    private int labels;

    /// Whether nobody has given it.
    static boolean isCounted(Literal label) {
        return label.getFunctor().startsWith(COUNTED);
    }

    @Override
    public Pred getUniqueLabel() {
        String label;
        do {
            label = COUNTED + ++labels;
        } while (get(label) != null);
        return new Pred(label);
    }

    @Override
    public Plan add(Plan plan, boolean before) throws JasonException {
        if (plan.hasSubPlans()) {
            label(plan.getSubPlans());
        }
        return super.add(ContextFreePlan.of(plan), before);
    }

    /// Those of a plan of its own are labelled before it is added.
    private void label(PlanLibrary inner) throws JasonException {
        List<Plan> plans = List.copyOf(inner.getPlans());
        inner.clear();
        for (Plan plan : plans) {
            if (isCounted(plan.getLabel())) {
                Pred label = getUniqueLabel();
                label.addAnnots(plan.getLabel().getAnnots());
                plan.setLabel(label);
            }
            if (plan.hasSubPlans()) {
                label(plan.getSubPlans());
            }
            inner.add(plan, false);
        }
    }
}
