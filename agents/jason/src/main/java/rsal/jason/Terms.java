package rsal.jason;

import jason.NoValueException;
import jason.asSemantics.Agent;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Atom;
import jason.asSyntax.ListTerm;
import jason.asSyntax.Literal;
import jason.asSyntax.NumberTerm;
import jason.asSyntax.NumberTermImpl;
import jason.asSyntax.Plan;
import jason.asSyntax.Pred;
import jason.asSyntax.StringTerm;
import jason.asSyntax.StringTermImpl;
import jason.asSyntax.Structure;
import jason.asSyntax.Term;
import jason.asSyntax.parser.ParseException;
import jason.asSyntax.parser.TokenMgrError;
import jason.asSyntax.parser.as2j;
import jason.asSyntax.parser.as2jConstants;
import java.io.StringReader;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.settings.ColorNames;

/// Values of Java as terms of AgentSpeak, and back. Numbers are numbers in SI units; a text of one word is an atom, in
/// quotes where it needs them (`prey`, `'hunter-1'`, `'#2ca02c'`), and else a string; a pose is `pose(X,Y,Th)`, a place
/// `point(X,Y)`; any other record is called like its class (`GoalReached` → `goal_reached(...)`).
final class Terms {
    private static final Pattern PLAIN = Pattern.compile("[a-z][A-Za-z0-9_]*");
    private static final Pattern WORD = Pattern.compile("[A-Za-z0-9_#.:+/-]+");
    private static final Pattern VARIABLE = Pattern.compile("(?<!\\w)_\\d+\\w*");
    private static final Set<String> KEYWORDS =
            Set.of("true", "false", "not", "div", "mod", "begin", "end", "if", "else", "elif", "for", "while");

    private static final double LONGEST = 3.15576e12; // ms, which clocks still count in nanoseconds

    private Terms() {}

    /// A name as AgentSpeak writes it as an atom: `prey`, `'hunter-1'`.
    static String quoted(String name) {
        return PLAIN.matcher(name).matches() && !KEYWORDS.contains(name) ? name : "'" + name + "'";
    }

    /// The name that an atom stands for.
    static String unquoted(String functor) {
        return functor.length() > 1 && functor.startsWith("'") && functor.endsWith("'")
                ? functor.substring(1, functor.length() - 1)
                : functor;
    }

    static Atom atom(String name) {
        return new Atom(quoted(name));
    }

    static Term text(String text) {
        return WORD.matcher(text).matches() ? atom(text) : new StringTermImpl(text);
    }

    static Term number(double value) {
        return Double.isFinite(value)
                ? new NumberTermImpl(value)
                : atom(Double.isNaN(value) ? "nan" : value > 0 ? "inf" : "neg_inf");
    }

    /// What a term says as a text: an atom's name, a string's letters, else the term as it is written.
    static String words(Term term) {
        return switch (term) {
            case StringTerm string -> string.getString();
            case Atom atom when atom.isAtom() -> unquoted(atom.getFunctor());
            default -> written(term);
        };
    }

    /// The members of a list; empty for what is none, as a variable, which is a ListTerm too.
    static Optional<List<Term>> list(Term term) {
        return term.isList() && term instanceof ListTerm list ? Optional.of(list.getAsList()) : Optional.empty();
    }

    /// What they say one after the other.
    static String words(List<Term> terms) {
        return terms.stream().map(Terms::words).collect(Collectors.joining());
    }

    /// Whether a term stands for a number: one that is written, or counted of such.
    static boolean isNumber(Term term) {
        try {
            return Double.isFinite(number(term));
        } catch (IllegalArgumentException _) {
            return false;
        }
    }

    /// The number that a term stands for.
    ///
    /// @throws IllegalArgumentException when it is none
    static double number(Term term) {
        if (term instanceof NumberTerm number) {
            try {
                return number.solve();
            } catch (NoValueException _) {
                // said below
            }
        }
        throw new IllegalArgumentException("'%s' is not a number.".formatted(written(term)));
    }

    // ── From Java ────────────────────────────────────────────────────────────────────────────────────────────────

    static Term of(Object value) {
        return switch (value) {
            case Number number -> number(number.doubleValue());
            case Boolean flag -> flag ? Literal.LTrue : Literal.LFalse;
            case Enum<?> constant -> text(constant.name().toLowerCase(Locale.ROOT));
            case Pose2d pose -> pose(pose);
            case Point2d(double x, double y) -> ASSyntax.createStructure("point", number(x), number(y));
            case Rgb color -> text(color.toString());
            case Optional<?> maybe -> maybe.<Term>map(Terms::of).orElseGet(() -> atom("none"));
            case List<?> list ->
                ASSyntax.createList(list.stream().map(Terms::of).toList());
            case Record row -> structure(row);
            default -> text(value.toString());
        };
    }

    static Structure pose(Pose2d pose) {
        return ASSyntax.createStructure("pose", number(pose.x()), number(pose.y()), number(pose.theta()));
    }

    private static Structure structure(Record row) {
        var terms = new ArrayList<Term>();
        for (RecordComponent component : row.getClass().getRecordComponents()) {
            try {
                terms.add(of(component.getAccessor().invoke(row)));
            } catch (IllegalAccessException | InvocationTargetException _) { // not for others to look into
                return ASSyntax.createStructure(functor(row.getClass()), new StringTermImpl(row.toString()));
            }
        }
        return ASSyntax.createStructure(functor(row.getClass()), terms.toArray(Term[]::new));
    }

    /// `GoalReached` → `goal_reached`.
    static String functor(Class<?> type) {
        return type.getSimpleName().replaceAll("(?<=[a-z0-9])(?=[A-Z])", "_").toLowerCase(Locale.ROOT);
    }

    // ── To Java ──────────────────────────────────────────────────────────────────────────────────────────────────

    /// A record made of terms for its components.
    ///
    /// @throws IllegalArgumentException with a sentence when they do not fit
    static <M> M record(Class<M> type, List<Term> terms) {
        RecordComponent[] components = type.getRecordComponents();
        if (components == null) {
            if (terms.size() == 1) {
                return type.cast(value(type, terms.getFirst()));
            }
            throw new IllegalArgumentException("'%s' takes one term.".formatted(functor(type)));
        }
        if (components.length != terms.size()) {
            throw new IllegalArgumentException("'%s' takes %d terms, not %d: %s."
                    .formatted(
                            functor(type),
                            components.length,
                            terms.size(),
                            String.join(
                                    ", ",
                                    Arrays.stream(components)
                                            .map(RecordComponent::getName)
                                            .toList())));
        }
        var values = new Object[components.length];
        var types = new Class<?>[components.length];
        for (int i = 0; i < components.length; i++) {
            types[i] = components[i].getType();
            values[i] = value(components[i].getGenericType(), terms.get(i));
        }
        try {
            return type.getDeclaredConstructor(types).newInstance(values);
        } catch (InvocationTargetException e) {
            throw new IllegalArgumentException(
                    "'%s' can't be made: %s"
                            .formatted(functor(type), e.getTargetException().getMessage()),
                    e.getTargetException());
        } catch (ReflectiveOperationException e) {
            throw new IllegalArgumentException("'%s' can't be made of terms.".formatted(functor(type)), e);
        }
    }

    private static Object value(Type type, Term term) {
        if (type instanceof ParameterizedType list && list.getRawType().equals(List.class)) {
            return list(term)
                    .orElseThrow(() -> new IllegalArgumentException("'%s' is not a list.".formatted(written(term))))
                    .stream()
                    .map(each -> value(list.getActualTypeArguments()[0], each))
                    .toList();
        }
        if (!(type instanceof Class<?> kind)) {
            throw new IllegalArgumentException("'%s' can't be made of a term.".formatted(type));
        }
        if (kind == double.class || kind == Double.class) {
            return number(term);
        }
        if (kind == int.class || kind == Integer.class) {
            return Math.toIntExact(Math.round(number(term)));
        }
        if (kind == long.class || kind == Long.class) {
            return Math.round(number(term));
        }
        if (kind == boolean.class || kind == Boolean.class) {
            return words(term).equals("true");
        }
        if (kind == String.class) {
            return words(term);
        }
        if (kind == Rgb.class) {
            return ColorNames.parse(words(term))
                    .orElseThrow(() -> new IllegalArgumentException("'%s' is not a color, #rrggbb or a name. %s"
                            .formatted(words(term), ColorNames.advice(words(term)))));
        }
        if (kind.isEnum()) {
            return Arrays.stream(kind.getEnumConstants())
                    .filter(constant -> ((Enum<?>) constant).name().equalsIgnoreCase(words(term)))
                    .findFirst()
                    .orElseThrow(() -> new IllegalArgumentException(
                            "'%s' is not one of %s.".formatted(words(term), Arrays.toString(kind.getEnumConstants()))));
        }
        if (kind.isRecord() && term instanceof Structure structure) {
            return record(kind, structure.getTerms());
        }
        throw new IllegalArgumentException("'%s' can't be a '%s'.".formatted(written(term), functor(kind)));
    }

    // ── As text ──────────────────────────────────────────────────────────────────────────────────────────────────

    /// A term as it can be read again: variables are numbered as they come, as Jason's own names of them differ
    /// from run to run.
    static String written(Term term) {
        return TermText.of(term);
    }

    /// What Jason says of terms, without its numbers of variables: they differ from run to run.
    static String masked(String message) {
        return VARIABLE.matcher(message).replaceAll("_");
    }

    /// @param reader whose functions it names: Jason's own of the process would read the machine's clock
    /// @throws IllegalArgumentException when it is not a term
    static Term read(String text, Agent reader) {
        return read(text, parser(text, reader));
    }

    static as2j parser(String text, Agent reader) {
        var parser = new as2j(new StringReader(text));
        parser.setAg(reader);
        return parser;
    }

    /// @param parser that is to read the text next
    static Term read(String text, as2j parser) {
        try {
            Term term = parser.term();
            if (parser.getNextToken().kind != as2jConstants.EOF) {
                throw new IllegalArgumentException("'%s' is more than one term.".formatted(text));
            }
            return labelled(term);
        } catch (ParseException | TokenMgrError e) {
            throw new IllegalArgumentException("'%s' is not a term.".formatted(text), e);
        }
    }

    /// Jason adds who said it to a plan's label, so it must have one.
    private static Term labelled(Term term) {
        if (term instanceof Plan plan && plan.getLabel() == null) {
            plan.setLabel(new Pred(TermText.UNNAMED));
        }
        list(term).orElse(List.of()).forEach(Terms::labelled);
        return term;
    }

    /// A plan that stands in a text.
    ///
    /// @throws IllegalArgumentException when it is none
    static Plan plan(String text, Agent reader) {
        String plan = text.strip();
        var parser = new as2j(new StringReader(plan.endsWith(".") ? plan : plan + "."));
        parser.setAg(reader);
        try {
            return parser.plan();
        } catch (ParseException | TokenMgrError e) {
            throw new IllegalArgumentException("'%s' is not a plan.".formatted(text), e);
        }
    }

    /// A time in milliseconds. What is longer than a hundred years lasts for ever, as far as runs go.
    ///
    /// @throws IllegalArgumentException when it is none
    static Duration millis(Term term) {
        double millis = number(term);
        if (!(millis >= 0)) {
            throw new IllegalArgumentException("'%s' is not a time in milliseconds.".formatted(written(term)));
        }
        return Duration.ofNanos(Math.round(Math.min(millis, LONGEST) * 1e6));
    }
}
