package rsal.jason;

import jason.JasonException;
import jason.asSemantics.ActionExec;
import jason.asSemantics.Event;
import jason.asSemantics.Intention;
import jason.asSemantics.Message;
import jason.asSemantics.TransitionSystem;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.StringTermImpl;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;
import jason.asSyntax.Trigger.TEOperator;
import jason.asSyntax.Trigger.TEType;
import jason.bb.BeliefBase;
import java.time.Duration;
import java.time.Instant;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.Topic;
import rsal.agent.bdi.Mind;
import rsal.robot.Robot;
import rsal.time.Task;

/// An agent that reasons as its author wrote it. Whenever there is something to do (a percept has changed, a message or
/// a timer has come, an action has ended) its reasoning cycles run, at that instant, until there is nothing left to do.
final class AgentSpeakAgent implements Agent {
    /// How many cycles may run at one instant: an agent that never finds an end would stop the run.
    static final int LIMIT = 10_000;

    private static final int MOST_WORDS = 200;

    private final Program program;
    private final Map<String, Object> settings;
    private final Map<PerceptBelief, List<Literal>> percepts = new EnumMap<>(PerceptBelief.class);
    private @Nullable Life life;
    private String state = "";
    private boolean awake;
    private boolean thinking;

    /// What it has once it has started.
    private record Life(
            AgentContext self,
            Diagnostics complaints,
            Reasoner reasoner,
            ExternalActions deeds,
            MessageSender post,
            SuspendedIntentions waits) {}

    /// @param settings values of its initial beliefs, by name
    AgentSpeakAgent(Program program, Map<String, Object> settings) {
        this.program = program;
        this.settings = settings;
    }

    @Override
    public void start(AgentContext self) {
        if (AgentSpeak.TAKEN.contains(self.name())) {
            throw new IllegalArgumentException(
                    "An agent in AgentSpeak can't be called '%s': that is a source of its own beliefs."
                            .formatted(self.name()));
        }
        var complaints = new Diagnostics(self.name());
        var waits = new SuspendedIntentions(this);
        var post = new MessageSender(self, this);
        // The reasoner's actions ask for the agent's parts only when they run, which is after all are there.
        var architecture = new Architecture(this, self.name());
        var replaced = InternalActionOverrides.of(self, this, waits, post);
        var reasoner =
                new Reasoner(replaced, () -> self.scheduler().instant().toEpochMilli(), architecture, new Pending());
        life = new Life(self, complaints, reasoner, new ExternalActions(self, this), post, waits);
        TransitionSystem deliberation = reasoner.getTS();
        reasoner.complainTo(complaints);
        deliberation.getC().addEventListener(waits);
        program.into(reasoner);
        reasoner.getInitialBels().replaceAll(this::set);
        StaticChecker review = StaticChecker.of(program, reasoner);
        know(self);
        begin(reasoner);
        self.reveal(Mind.View.class, () -> Thoughts.of(reasoner, complaints.last()));
        self.reveal(Mind.Program.class, () -> Thoughts.program(reasoner));
        self.robot().ifPresent(robot -> perceive(self, robot, review));
        review.topics().forEach(topic -> listen(self, topic));
        post.begin();
        wake();
    }

    private Literal set(Literal belief) {
        Object value = AgentSpeakType.isSetting(belief) ? settings.get(belief.getFunctor()) : null;
        if (value == null) {
            return belief;
        }
        Term term = switch (value) {
            case Number number -> Terms.number(number.doubleValue());
            case Boolean flag -> flag ? Literal.LTrue : Literal.LFalse;
            default ->
                belief.getTerm(0).isString() ? new StringTermImpl(value.toString()) : Terms.text(value.toString());
        };
        return ASSyntax.createLiteral(belief.getFunctor(), term);
    }

    private void know(AgentContext self) {
        believe(ASSyntax.createLiteral("me", Terms.atom(self.name()), Terms.atom(self.role())));
        self.robot()
                .ifPresent(robot ->
                        believe(ASSyntax.createLiteral("robot", Terms.atom(robot.id()), Terms.atom(robot.role()))));
    }

    private static void begin(Reasoner reasoner) {
        try {
            reasoner.addInitialBelsInBB();
            reasoner.addInitialGoalsInTS();
            reasoner.loadKqmlPlans();
            reasoner.addInitialBelsInBB();
        } catch (Exception e) { // all that Jason declares
            throw new IllegalStateException("The agent can't begin: %s".formatted(e.getMessage()), e);
        }
    }

    private void perceive(AgentContext self, Robot robot, StaticChecker review) {
        review.percepts().forEach(percept -> percept.watch(self, robot, now -> perceive(percept, now)));
    }

    private <M> void listen(AgentContext self, Topic<M> topic) {
        self.subscribe(topic, message -> {
            event(TEOperator.add, TopicEvents.of(message));
            wake();
        });
    }

    Reasoner reasoner() {
        return alive().reasoner;
    }

    MessageSender post() {
        return alive().post;
    }

    Instant now() {
        return alive().self.scheduler().instant();
    }

    private Life alive() {
        if (life == null) {
            throw new IllegalStateException("The agent has not started yet.");
        }
        return life;
    }

    Task after(Duration delay, Runnable task) {
        return alive().self.scheduler().after(delay, task);
    }

    /// Prints a line.
    void say(String words) {
        alive().self.print(shortened(words));
    }

    /// Says what it does. That is a line when it changes, and none when the program says it again.
    void state(String words) {
        if (words.equals(state)) {
            alive().self.state(shortened(words)); // something else may have been printed since
        } else {
            state = words;
            say(words);
        }
    }

    private static String shortened(String words) {
        return words.length() <= MOST_WORDS ? words : words.substring(0, MOST_WORDS) + "…";
    }

    void unhandled(String goal, String where) {
        alive().self.unhandled(goal, where);
    }

    void complain(String words) {
        reasoner().getTS().getLogger().warning(words);
    }

    void act(ActionExec deed) {
        alive().deeds.begin(deed);
    }

    void hear(Message message) {
        reasoner().getTS().getC().addMsg(message);
        wake();
    }

    /// Something may be to do.
    void wake() {
        awake = true;
        if (!thinking) {
            thinking = true;
            alive().self.scheduler().execute(this::think);
        }
    }

    private void think() {
        Life own = alive();
        TransitionSystem deliberation = own.reasoner.getTS();
        int cycles = 0;
        while (awake || !deliberation.canSleep()) {
            awake = false;
            if (++cycles > LIMIT) {
                throw new IllegalStateException(
                        "Agent '%s' did not stop after %d reasoning cycles at one time: %s. Maybe a goal calls itself endlessly; '.wait' lets time pass."
                                .formatted(own.self.name(), LIMIT, Thoughts.newest(own.reasoner)));
            }
            try {
                deliberation.reasoningCycle();
                own.waits.check();
            } catch (StackOverflowError _) {
                throw endless(own);
            }
            if (own.complaints.endless()) {
                throw endless(own);
            }
            own.deeds.check();
            own.complaints.broken().ifPresent(why -> {
                throw new IllegalStateException(
                        "The interpreter of agent '%s' failed: %s".formatted(own.self.name(), why));
            });
        }
        thinking = false;
    }

    private IllegalStateException endless(Life own) {
        String rule = own.reasoner
                .beliefs()
                .askedRule()
                .map(asked -> " Rule '%s' at %s depends on itself."
                        .formatted(asked.getPredicateIndicator(), program.locationOf(asked)))
                .orElse("");
        return new IllegalStateException(
                "Agent '%s' searched endlessly at: %s.%s Maybe the rule should begin with the case in which it ends."
                        .formatted(own.self.name(), Thoughts.newest(own.reasoner), rule));
    }

    /// What a device tells takes the place of what it told before; what has changed makes events.
    private void perceive(PerceptBelief percept, List<Literal> now) {
        List<Literal> before = percepts.getOrDefault(percept, List.of());
        percepts.put(percept, now);
        boolean changed = false;
        for (Literal gone : before) {
            if (!now.contains(gone)) {
                forget(gone);
                changed = true;
            }
        }
        for (Literal come : now) {
            if (!before.contains(come)) {
                believe(come);
                changed = true;
            }
        }
        if (changed) {
            wake();
        }
    }

    private void believe(Literal belief) {
        try {
            Literal percept = belief.copy().forceFullLiteralImpl();
            percept.addAnnot(BeliefBase.TPercept);
            reasoner().getBB().add(percept);
            event(TEOperator.add, belief);
        } catch (JasonException e) {
            throw new IllegalStateException("'%s' can't be a belief.".formatted(belief), e);
        }
    }

    private void forget(Literal belief) {
        Literal percept = belief.copy().forceFullLiteralImpl();
        percept.addAnnot(BeliefBase.TPercept);
        reasoner().getBB().remove(percept);
        event(TEOperator.del, belief);
    }

    /// Lets plans for it begin; without any it is no event.
    private void event(TEOperator operator, Literal literal) {
        Life own = alive();
        Literal percept = literal.copy().forceFullLiteralImpl();
        percept.addAnnot(BeliefBase.TPercept);
        var trigger = new Trigger(operator, TEType.belief, percept);
        boolean matters = own.reasoner.getPL().hasCandidatePlan(trigger)
                || own.reasoner.getPL().hasPlansForUpdateEvents()
                || own.waits.forEvents();
        if (matters) {
            own.reasoner.getTS().updateEvents(new Event(trigger, Intention.EmptyInt));
        }
    }
}
