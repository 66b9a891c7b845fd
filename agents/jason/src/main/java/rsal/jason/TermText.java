package rsal.jason;

import jason.asSemantics.Unifier;
import jason.asSyntax.ArithExpr;
import jason.asSyntax.Atom;
import jason.asSyntax.BinaryStructure;
import jason.asSyntax.ListTerm;
import jason.asSyntax.Literal;
import jason.asSyntax.MapTerm;
import jason.asSyntax.Plan;
import jason.asSyntax.PlanBody;
import jason.asSyntax.Pred;
import jason.asSyntax.Rule;
import jason.asSyntax.SetTerm;
import jason.asSyntax.StringTerm;
import jason.asSyntax.Structure;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;
import jason.asSyntax.VarTerm;
import jason.bb.BeliefBase;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/// A term as text that can be read again. Variables are numbered as they come and labels that nobody gave to plans are
/// left out, as Jason counts both for the whole process: they differ from run to run.
final class TermText {
    static final String UNNAMED = "undefined"; // Jason's label of plans without one in terms

    private final StringBuilder text = new StringBuilder();
    private final Map<String, String> variables = new LinkedHashMap<>();
    private final Unifier values;
    private final boolean named; // whether variables keep the names that were typed, and own sources are left out

    private TermText(Unifier values, boolean named) {
        this.values = values;
        this.named = named;
    }

    static String of(Term term) {
        return of(term, new Unifier());
    }

    /// With what its variables stand for. Nothing is computed, which could take from the agent's chance.
    static String of(Term term, Unifier values) {
        var written = new TermText(values, false);
        written.write(term);
        return written.text.toString();
    }

    /// As its author typed it, for people.
    static String typed(Rule rule) {
        var written = new TermText(new Unifier(), true);
        written.clause(rule);
        return written.text.toString();
    }

    /// As its author typed it, for people.
    static String typed(Plan plan) {
        var written = new TermText(new Unifier(), true);
        written.inner(plan);
        return written.text.toString();
    }

    private void write(Term term) {
        switch (term) {
            case VarTerm variable -> variable(variable);
            case StringTerm string ->
                text.append('"').append(escaped(string.getString())).append('"');
            case ListTerm list -> list(list);
            case SetTerm set -> all(set, "{", "}");
            case MapTerm map -> map(map);
            case Plan plan -> plan(plan);
            case Trigger event -> event(event, "{ ", " }");
            case PlanBody body -> braced(body);
            case Rule rule -> rule(rule);
            case ArithExpr sum -> operation(sum, sum.getArity() == 1 ? sum.getFunctor() : "");
            case BinaryStructure formula -> operation(formula, "");
            case Atom name when name.getClass() == Atom.class -> text.append(name.getFunctor());
            case Structure structure -> structure(structure);
            default -> text.append(term);
        }
    }

    /// A string's letters as AgentSpeak takes them. It takes backslashes before some letters only, and then leaves them
    /// in the string.
    private static String escaped(String letters) {
        var escaped = new StringBuilder();
        for (int i = 0; i < letters.length(); i++) {
            char letter = letters.charAt(i);
            switch (letter) {
                case '"' -> escaped.append("\\\"");
                case '\n' -> escaped.append("\\n");
                case '\r' -> escaped.append(' ');
                case '\\' -> {
                    boolean taken = i + 1 < letters.length() && "\\tbrf'".indexOf(letters.charAt(i + 1)) >= 0;
                    escaped.append('\\').append(taken ? letters.charAt(++i) : '\\');
                }
                default -> escaped.append(letter);
            }
        }
        return escaped.toString();
    }

    private void variable(VarTerm variable) {
        Term value = values.get(variable);
        if (value != null && !variable.negated() && !variable.hasAnnot()) {
            write(value);
            return;
        }
        namespace(variable);
        if (variable.negated()) {
            text.append('~');
        }
        if (named) {
            text.append(variable.isUnnamedVar() ? "_" : variable.getFunctor());
        } else {
            String name = "V" + (variables.size() + 1);
            text.append(variables.computeIfAbsent(variable.getFunctor(), _ -> name));
        }
        annotations(variable);
    }

    private void namespace(Literal literal) {
        if (!literal.getNS().equals(Literal.DefaultNS)) {
            write(literal.getNS());
            text.append("::");
        }
    }

    private void annotations(Literal literal) {
        List<Term> shown = literal.hasAnnot() ? literal.getAnnots().getAsList() : List.of();
        List<Term> others = shown.stream()
                .filter(each -> !named || !each.equals(BeliefBase.TSelf))
                .toList();
        if (!others.isEmpty()) {
            all(others, "[", "]");
        }
    }

    private void structure(Structure structure) {
        namespace(structure);
        if (structure.negated()) {
            text.append('~');
        }
        text.append(structure.getFunctor());
        if (structure.hasTerm()) {
            all(structure.getTerms(), "(", ")");
        }
        annotations(structure);
    }

    private void list(ListTerm list) {
        text.append('[');
        all(list.getAsList(), "", "");
        Optional<VarTerm> tail = Optional.ofNullable(list.getTail());
        tail.ifPresent(rest -> {
            text.append('|');
            write(rest);
        });
        text.append(']');
    }

    private void map(MapTerm map) {
        text.append('{');
        String separator = "";
        for (Term key : map.keys()) {
            text.append(separator);
            write(key);
            text.append("->");
            write(map.get(key));
            separator = ",";
        }
        text.append('}');
    }

    private void all(Iterable<Term> terms, String open, String close) {
        text.append(open);
        String separator = "";
        for (Term each : terms) {
            text.append(separator);
            write(each);
            separator = ",";
        }
        text.append(close);
    }

    /// @param sign before a single operand
    private void operation(Structure operation, String sign) {
        if (operation.getArity() == 1) {
            text.append(sign.isEmpty() ? operation.getFunctor() : "")
                    .append('(')
                    .append(sign);
            write(operation.getTerm(0));
        } else {
            text.append('(');
            write(operation.getTerm(0));
            text.append(operation.getFunctor());
            write(operation.getTerm(1));
        }
        text.append(')');
    }

    private void rule(Rule rule) {
        text.append("{ ");
        clause(rule);
        text.append(" }");
    }

    private void clause(Rule rule) {
        structure(rule);
        text.append(" :- ");
        write(rule.getBody());
    }

    // ── Plans ────────────────────────────────────────────────────────────────────────────────────────────────────

    private void plan(Plan plan) {
        text.append("{ ");
        inner(plan);
        text.append(" }");
    }

    private void inner(Plan plan) {
        Optional.ofNullable(plan.getLabel()).ifPresent(this::label);
        event(plan.getTrigger(), "", "");
        after(" : ", plan.getContext(), this::write);
        after(" <: ", plan.getGoalCondition(), this::write);
        if (!plan.getBody().isEmptyBody()) {
            text.append(" <- ");
            steps(plan.getBody());
        }
        if (plan.hasSubPlans()) {
            text.append(". { ");
            plan.getSubPlans().forEach(each -> {
                inner(each);
                text.append(". ");
            });
            text.append('}');
        }
    }

    private <T> void after(String sign, @Nullable T part, Consumer<T> write) {
        if (part != null) {
            text.append(sign);
            write.accept(part);
        }
    }

    private void label(Pred label) {
        boolean labelled = !label.getFunctor().equals(UNNAMED) && !Plans.isCounted(label);
        List<Term> annotations =
                new ArrayList<>(label.hasAnnot() ? label.getAnnots().getAsList() : List.of());
        annotations.removeIf(
                each -> each instanceof Literal about && about.getFunctor().equals("url"));
        if (named) {
            annotations.removeIf(BeliefBase.TSelf::equals);
        }
        if (labelled) {
            text.append('@').append(label.getFunctor());
        }
        if (!annotations.isEmpty()) {
            all(annotations, labelled ? "[" : "@[", "]");
        }
        if (labelled || !annotations.isEmpty()) {
            text.append(' ');
        }
    }

    private void event(Trigger event, String open, String close) {
        text.append(open).append(event.getOperator()).append(event.getType());
        write(event.getLiteral());
        text.append(close);
    }

    private void braced(PlanBody body) {
        text.append("{ ");
        steps(body);
        text.append(" }");
    }

    private void steps(PlanBody body) {
        String separator = "";
        for (PlanBody step = body; step != null; step = step.getBodyNext()) {
            if (step.getBodyTerm() != null) {
                text.append(separator);
                step(step);
                separator = "; ";
            }
        }
    }

    private void step(PlanBody step) {
        Term term = step.getBodyTerm();
        if (term instanceof Structure statement && statement.isInternalAction()) {
            switch (statement.getFunctor()) {
                case ".if_then_else" -> statement("if", statement);
                case ".foreach" -> statement("for", statement);
                case ".loop" -> statement("while", statement);
                case ".fork" -> fork(statement);
                default -> structure(statement);
            }
        } else {
            text.append(step.getBodyType());
            write(term);
        }
    }

    /// Jason keeps `if (x) { a } else { b }` as `.if_then_else(x,a,b)`, whose bodies of one step could not be told from
    /// events, were they read as terms.
    private void statement(String word, Structure statement) {
        text.append(word).append(" (");
        write(statement.getTerm(0));
        text.append(") ");
        write(statement.getTerm(1));
        if (statement.getArity() > 2) {
            text.append(" else ");
            write(statement.getTerm(2));
        }
    }

    private void fork(Structure fork) {
        String sign = fork.getTerm(0).toString().equals("and") ? " |&| " : " ||| ";
        for (int i = 1; i < fork.getArity(); i++) {
            text.append(i > 1 ? sign : "");
            if (fork.getTerm(i) instanceof PlanBody branch && branch.getPlanSize() == 1) {
                steps(branch);
            } else {
                write(fork.getTerm(i));
            }
        }
    }
}
