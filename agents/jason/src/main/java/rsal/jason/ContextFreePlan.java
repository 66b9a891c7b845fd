package rsal.jason;

import jason.asSemantics.Unifier;
import jason.asSyntax.ListTerm;
import jason.asSyntax.ListTermImpl;
import jason.asSyntax.Literal;
import jason.asSyntax.Plan;
import jason.asSyntax.Term;
import java.util.List;

/// A plan without a context, which holds always. Taken apart (`P =.. [Label, Trigger, Context, Body]`) its context is
/// `true`; Jason 3.3.0 puts a null there, which fails.
final class ContextFreePlan extends Plan {
    private static final long serialVersionUID = 1;

    private ContextFreePlan(Plan same) {
        super(same.getLabel(), same.getTrigger(), null, same.getBody());
        setSrcInfo(same.getSrcInfo());
        setSourceFile(same.getSourceFile());
        setAsPlanTerm(same.isPlanTerm());
        setScope(same.getScope()); // the library that it is in
    }

    /// The same plan. One that has a context, a condition for its goal, or plans of its own, is as it was.
    static Plan of(Plan plan) {
        boolean isPlain = plan.getContext() == null && !plan.hasGoalCondition() && !plan.hasSubPlans();
        return isPlain ? new ContextFreePlan(plan) : plan;
    }

    @Override
    public ListTerm getAsListOfTerms() {
        var terms = new ListTermImpl();
        terms.addAll(List.of(getLabel(), getTrigger(), Literal.LTrue, getBody()));
        return terms;
    }

    @Override
    public Plan capply(Unifier u) {
        return of(super.capply(u));
    }

    @Override
    public Term clone() {
        return of((Plan) super.clone());
    }
}
