package rsal.jason;

import jason.asSyntax.Literal;
import jason.asSyntax.Plan;
import jason.asSyntax.Term;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import rsal.agent.Agent;
import rsal.agent.AgentOutline;
import rsal.agent.AgentOutline.Line;
import rsal.agent.AgentType;
import rsal.device.Device;
import rsal.settings.Arguments;
import rsal.settings.InvalidSettings;
import rsal.settings.Parameter;
import rsal.settings.Problem;

/// A kind of agent that somebody wrote in AgentSpeak. Its parameters are its initial beliefs of one number or text,
/// as `catch_distance(1.5)`, of which there is but one of that name; its fallback is what is written there.
final class AgentSpeakType implements AgentType {
    private final Program program;
    private final List<Parameter<?>> parameters;
    private final List<Class<? extends Device>> needs;
    private final AgentOutline outline;
    private final List<Problem> warnings;

    /// @throws InvalidSettings with what the agent names that there is not
    AgentSpeakType(Program program) {
        this.program = program;
        var reasoner = new Reasoner();
        program.into(reasoner);
        StaticChecker review = StaticChecker.of(program, reasoner);
        review.problems().throwIfAny();
        this.parameters = parameters(program, reasoner.getInitialBels());
        this.needs = review.devices();
        this.warnings = review.warnings();
        this.outline = new AgentOutline(
                reasoner.getInitialGoals().stream()
                        .map(goal -> line(goal.toString(), goal))
                        .toList(),
                reasoner.getPL().getPlans().stream().map(this::line).toList(),
                review.topics().stream().map(TopicEvents::name).toList(),
                review.said().stream().map(said -> line(said.toString(), said)).toList());
    }

    private Line line(String text, Literal literal) {
        return new Line(Terms.masked(text), program.locationOf(literal));
    }

    private Line line(Plan plan) {
        String context = plan.getContext() == null ? "" : " : " + plan.getContext();
        return line(plan.getTrigger() + context, plan.getTrigger().getLiteral());
    }

    private static List<Parameter<?>> parameters(Program program, List<Literal> beliefs) {
        Map<String, Long> times =
                beliefs.stream().collect(Collectors.groupingBy(Literal::getFunctor, Collectors.counting()));
        var parameters = new ArrayList<Parameter<?>>();
        for (Literal belief : beliefs) {
            if (isSetting(belief) && times.getOrDefault(belief.getFunctor(), 0L) == 1) {
                parameters.add(
                        parameter(belief.getFunctor(), belief.getTerm(0), program.comment(program.locationOf(belief))));
            }
        }
        return List.copyOf(parameters);
    }

    /// Whether it can be set by those who use the agent.
    static boolean isSetting(Literal belief) {
        return !belief.isRule()
                && !belief.negated()
                && belief.getArity() == 1
                && !belief.hasAnnot()
                && belief.getNS().equals(Literal.DefaultNS)
                && (Terms.isNumber(belief.getTerm(0))
                        || belief.getTerm(0).isString()
                        || belief.getTerm(0).isAtom());
    }

    private static Parameter<?> parameter(String name, Term value, String comment) {
        if (Terms.isNumber(value)) {
            return Parameter.number(
                    name, Terms.number(value), Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, "", comment);
        }
        if (value.equals(Literal.LTrue) || value.equals(Literal.LFalse)) {
            return Parameter.flag(name, value.equals(Literal.LTrue), comment);
        }
        return Parameter.text(name, Terms.words(value), comment);
    }

    @Override
    public String key() {
        return program.path();
    }

    @Override
    public String description() {
        return program.title();
    }

    @Override
    public List<Parameter<?>> parameters() {
        return parameters;
    }

    @Override
    public List<Class<? extends Device>> needs() {
        return needs;
    }

    @Override
    public List<Problem> warnings() {
        return warnings;
    }

    @Override
    public Optional<AgentOutline> outline() {
        return Optional.of(outline);
    }

    @Override
    public Agent create(Arguments arguments) {
        return new AgentSpeakAgent(
                program,
                parameters.stream()
                        .collect(Collectors.toMap(
                                Parameter::name, set -> arguments.asMap().get(set.name()))));
    }
}
