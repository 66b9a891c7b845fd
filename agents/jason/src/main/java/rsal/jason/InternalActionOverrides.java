package rsal.jason;

import jason.JasonException;
import jason.asSemantics.Agent;
import jason.asSemantics.DefaultInternalAction;
import jason.asSemantics.Event;
import jason.asSemantics.Intention;
import jason.asSemantics.InternalAction;
import jason.asSemantics.Message;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Atom;
import jason.asSyntax.ListTerm;
import jason.asSyntax.StringTerm;
import jason.asSyntax.StringTermImpl;
import jason.asSyntax.Structure;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;
import jason.asSyntax.VarTerm;
import jason.stdlib.add_plan;
import jason.stdlib.concat;
import jason.stdlib.delete;
import jason.stdlib.desire;
import jason.stdlib.intend;
import jason.stdlib.intention;
import jason.stdlib.lower_case;
import jason.stdlib.replace;
import jason.stdlib.substring;
import jason.stdlib.upper_case;
import java.time.Duration;
import java.time.ZoneOffset;
import java.time.ZonedDateTime;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import rsal.agent.AgentContext;
import rsal.agent.Directory;
import rsal.agent.ServiceDescription;
import rsal.data.Pose2d;
import rsal.device.Localizer;
import rsal.device.Subscription;
import rsal.robot.LineOfSight;

/// Internal actions of Jason's that would read the machine's clock, make up random numbers, start threads, or write to
/// the console, done by what the run gives an agent instead. They take what Jason's take.
///
/// Longer than 500 lines, since it is a list: a class for each action.
final class InternalActionOverrides {
    static final Set<String> NAMES = Set.of(
            ".wait",
            ".at",
            ".concat",
            ".random",
            ".shuffle",
            ".date",
            ".time",
            ".print",
            ".println",
            ".log",
            ".metric",
            ".in_sight",
            ".send",
            ".broadcast",
            ".all_names",
            ".df_register",
            ".df_deregister",
            ".df_search",
            ".term2string",
            ".upper_case",
            ".lower_case",
            ".replace",
            ".substring",
            ".delete",
            ".add_plan",
            ".fail_goal",
            ".intention",
            ".intend",
            ".desire");

    /// What stands for any of them in an agent that is only read.
    static final InternalAction UNBOUND = new Simple(0, Integer.MAX_VALUE, (_, _, _) -> false);

    private static final InternalAction LISTS = new concat();
    private static final InternalAction PLANS = new add_plan();
    private static final Pattern DELAY = Pattern.compile("now\\s*\\+\\s*(\\d{1,9})\\s*([a-z]*)");
    private static final int MOST_TRIES = 10_000;

    private final AgentContext self;
    private final AgentSpeakAgent agent;
    private final Map<String, Subscription> offers = new HashMap<>(); // by service

    private final SuspendedIntentions waits;
    private final MessageSender post;

    private InternalActionOverrides(
            AgentContext self, AgentSpeakAgent agent, SuspendedIntentions waits, MessageSender post) {
        this.self = self;
        this.agent = agent;
        this.waits = waits;
        this.post = post;
    }

    /// Those of one agent, by name.
    static Map<String, InternalAction> of(
            AgentContext self, AgentSpeakAgent agent, SuspendedIntentions waits, MessageSender post) {
        return new InternalActionOverrides(self, agent, waits, post).all();
    }

    private Map<String, InternalAction> all() {
        var all = new HashMap<String, InternalAction>();
        all.put(".wait", new Wait(waits));
        all.put(".at", new At());
        all.put(".random", new FromRun(Random.from(self.random())));
        all.put(".shuffle", new Simple(2, 2, this::shuffle));
        all.put(".date", new Simple(3, 3, this::date));
        all.put(".time", new Simple(1, 4, this::time));
        all.put(".print", new Simple(0, Integer.MAX_VALUE, this::print));
        all.put(".println", all.get(".print"));
        all.put(
                ".log",
                new Simple(
                        1,
                        Integer.MAX_VALUE,
                        (ts, un, terms) -> print(ts, un, Arrays.copyOfRange(terms, 1, terms.length))));
        all.put(".in_sight", new Simple(2, 2, this::inSight));
        all.put(".metric", new Simple(2, 2, false, this::metric));
        all.put(".concat", new Simple(2, Integer.MAX_VALUE, this::concat));
        all.put(".send", new Send());
        all.put(".broadcast", new Simple(2, 2, false, this::broadcast));
        all.put(".all_names", new Simple(1, 1, this::allNames));
        all.put(".df_register", new Simple(1, 2, false, this::register));
        all.put(".df_deregister", new Simple(1, 2, false, this::deregister));
        all.put(".df_search", new Simple(2, 3, this::search));
        all.put(".term2string", new Simple(2, 2, InternalActionOverrides::termAndString));
        all.put(".upper_case", ofText(new upper_case(), 0));
        all.put(".lower_case", ofText(new lower_case(), 0));
        all.put(".replace", ofText(new replace(), 0));
        all.put(".substring", ofText(new substring(), 0, 1));
        all.put(".delete", ofText(new delete(), 1));
        all.put(".add_plan", new Simple(1, 3, InternalActionOverrides::addPlan));
        all.put(".fail_goal", new FailGoal());
        var intentions = new Intentions();
        all.put(".intention", intentions.numbered(new intention(), 0));
        all.put(".intend", intentions.numbered(new intend(), 1));
        all.put(".desire", intentions.numbered(new desire(), 1));
        return all;
    }

    // ── Time ─────────────────────────────────────────────────────────────────────────────────────────────────────

    /// `.at("now +3 s", {+!goal})`, the unit ms without one. Jason's actions that drop all cancel what it has set.
    private final class At extends jason.stdlib.at {
        private static final long serialVersionUID = 1;

        private int dropped; // how often

        @Override
        public boolean canBeUsedInContext() {
            return false;
        }

        @Override
        public Object execute(TransitionSystem ts, Unifier un, Term[] terms) throws Exception {
            checkArguments(terms);
            Matcher said = DELAY.matcher(Terms.words(terms[0]).strip());
            Trigger event = Trigger.tryToGetTrigger(terms[1]);
            if (!said.matches() || event == null) {
                throw new JasonException("'.at' takes a time as \"now +3 s\" and an event as {+!goal}, not (%s, %s)."
                        .formatted(terms[0], terms[1]));
            }
            int before = dropped;
            agent.after(delay(said), () -> {
                if (dropped == before) {
                    ts.getC().addEvent(new Event(event, Intention.EmptyInt));
                    agent.wake();
                }
            });
            return true;
        }

        private static Duration delay(Matcher said) {
            long count = Long.parseLong(said.group(1));
            String unit = said.group(2);
            if (unit.isEmpty() || unit.startsWith("ms")) {
                return Duration.ofMillis(count);
            }
            return switch (unit.charAt(0)) {
                case 's' -> Duration.ofSeconds(count);
                case 'm' -> Duration.ofMinutes(count);
                case 'h' -> Duration.ofHours(count);
                case 'd' -> Duration.ofDays(count);
                default -> Duration.ofMillis(count);
            };
        }

        @Override
        public void cancelAts() {
            dropped++;
        }
    }

    private ZonedDateTime now() {
        return self.scheduler().instant().atZone(ZoneOffset.UTC);
    }

    private Object date(TransitionSystem ts, Unifier un, Term[] terms) {
        ZonedDateTime now = now();
        return unifies(un, terms, now.getYear(), now.getMonthValue(), now.getDayOfMonth());
    }

    private Object time(TransitionSystem ts, Unifier un, Term[] terms) {
        ZonedDateTime now = now();
        return unifies(un, terms, now.getHour(), now.getMinute(), now.getSecond(), now.getNano() / 1_000_000);
    }

    private static boolean unifies(Unifier un, Term[] terms, int... values) {
        return IntStream.range(0, Math.min(terms.length, values.length))
                .allMatch(i -> un.unifies(terms[i], ASSyntax.createNumber(values[i])));
    }

    // ── Randomness ───────────────────────────────────────────────────────────────────────────────────────────────

    private Object shuffle(TransitionSystem ts, Unifier un, Term[] terms) throws JasonException {
        var shuffled = new ArrayList<>(Terms.list(terms[0])
                .orElseThrow(() -> new JasonException("'.shuffle' takes a list, not '%s'.".formatted(terms[0]))));
        Collections.shuffle(shuffled, Random.from(self.random()));
        return un.unifies(terms[1], ASSyntax.createList(shuffled));
    }

    /// `.random(X)`, `.random(X, tries)` and `.random([a, b], X)`; Jason's own functions ask it for its generator.
    private static final class FromRun extends jason.stdlib.random {
        private static final long serialVersionUID = 1;

        private final Random random;

        FromRun(Random random) {
            this.random = random;
        }

        @Override
        public Random getRandomGenerator() {
            return random;
        }

        @Override
        public Object execute(TransitionSystem ts, Unifier un, Term[] terms) throws Exception {
            checkArguments(terms);
            Optional<List<Term>> list = Terms.list(terms[0]);
            if (list.isPresent()) {
                List<Term> choices = list.get();
                return !choices.isEmpty() && un.unifies(terms[1], choices.get(random.nextInt(choices.size())));
            }
            int tries = terms.length > 1 ? (int) Terms.number(terms[1]) : 1;
            if (tries < 1 || tries > MOST_TRIES) {
                throw new JasonException(
                        "'.random' can be tried from 1 to %d times, not '%d'.".formatted(MOST_TRIES, tries));
            }
            if (tries == 1) {
                return un.unifies(terms[0], ASSyntax.createNumber(random.nextDouble()));
            }
            return IntStream.range(0, tries)
                    .mapToObj(_ -> {
                        Unifier one = un.clone();
                        return one.unifies(terms[0], ASSyntax.createNumber(random.nextDouble()))
                                ? Optional.of(one)
                                : Optional.<Unifier>empty();
                    })
                    .flatMap(Optional::stream)
                    .iterator();
        }
    }

    // ── Words ────────────────────────────────────────────────────────────────────────────────────────────────────

    private Object print(TransitionSystem ts, Unifier un, Term[] terms) {
        agent.say(Terms.words(List.of(terms)));
        return true;
    }

    /// `.in_sight(X, Y)`: no wall stands between the robot and a place, as far as it knows. Not one of Jason's.
    private Object inSight(TransitionSystem ts, Unifier un, Term[] terms) {
        var mapFromPlace = new Pose2d(Terms.number(terms[0]), Terms.number(terms[1]), 0);
        return self.robot()
                .flatMap(robot -> robot.find(Localizer.class)
                        .flatMap(Localizer::latest)
                        .map(estimate -> estimate.value().mapFromBase())
                        .filter(mapFromBase -> LineOfSight.isBlocked(robot, mapFromBase, mapFromPlace)))
                .isEmpty();
    }

    /// `.metric(load, 0.4)`: a value for the results. Not one of Jason's.
    private Object metric(TransitionSystem ts, Unifier un, Term[] terms) throws JasonException {
        String name = Terms.words(terms[0]);
        double value = Terms.number(terms[1]);
        try {
            self.metric(name, value);
        } catch (IllegalArgumentException e) {
            throw new JasonException(e.getMessage());
        }
        return true;
    }

    /// Jason's own for lists; of texts it would keep the quotes of names.
    private Object concat(TransitionSystem ts, Unifier un, Term[] terms) throws Exception {
        if (terms[0].isList()) {
            return LISTS.execute(ts, un, terms);
        }
        Term last = terms[terms.length - 1];
        String words = Terms.words(List.of(terms).subList(0, terms.length - 1));
        return un.unifies(last, new StringTermImpl(words));
    }

    /// One of Jason's that takes terms as the texts that they are written as: with our numbers of variables,
    /// not those of the process.
    ///
    /// @param at which of its terms are taken so
    private static Simple ofText(DefaultInternalAction jasons, int... at) {
        return new Simple(jasons.getMinArgs(), jasons.getMaxArgs(), (ts, un, terms) -> {
            Term[] texts = terms.clone();
            for (int i : at) {
                if (i < terms.length && terms[i].isStructure() && !terms[i].isList() && !terms[i].isGround()) {
                    texts[i] = new StringTermImpl(Terms.written(terms[i]));
                }
            }
            return jasons.execute(ts, un, texts);
        });
    }

    // ── Plans and goals ──────────────────────────────────────────────────────────────────────────────────────────

    /// Jason's own, but that plans in texts are read with the functions of this agent.
    private static Object addPlan(TransitionSystem ts, Unifier un, Term[] terms) throws Exception {
        Term[] read = terms.clone();
        read[0] = Terms.list(terms[0])
                .<Term>map(all -> ASSyntax.createList(
                        all.stream().map(each -> plan(each, ts.getAg())).toList()))
                .orElseGet(() -> plan(terms[0], ts.getAg()));
        return PLANS.execute(ts, un, read);
    }

    private static Term plan(Term term, Agent reader) {
        return term instanceof StringTerm text ? Terms.plan(text.getString(), reader) : term;
    }

    /// Jason's own lets an intention go on that has failed its own goal.
    private static final class FailGoal extends jason.stdlib.fail_goal {
        private static final long serialVersionUID = 1;

        private boolean own; // whether the intention that said it last has failed by that

        @Override
        public boolean suspendIntention() {
            return own;
        }

        @Override
        public Object execute(TransitionSystem ts, Unifier un, Term[] terms) throws Exception {
            Intention intention = ts.getC().getSelectedIntention();
            int before = intention == null ? 0 : intention.size();
            Object done = super.execute(ts, un, terms);
            own = intention != null && intention.size() < before;
            return done;
        }
    }

    // ── Others ───────────────────────────────────────────────────────────────────────────────────────────────────

    private Object allNames(TransitionSystem ts, Unifier un, Term[] terms) {
        return un.unifies(terms[0], names(self.directory().agents()));
    }

    /// `.term2string(T, S)`, whichever of the two is known.
    private static Object termAndString(TransitionSystem ts, Unifier un, Term[] terms) {
        return terms[0].isVar()
                ? un.unifies(terms[0], Terms.read(Terms.words(terms[1]), ts.getAg()))
                : un.unifies(terms[1], new StringTermImpl(Terms.written(terms[0])));
    }

    private static ListTerm names(List<Directory.Entry> agents) {
        return ASSyntax.createList(
                agents.stream().<Term>map(entry -> Terms.atom(entry.name())).toList());
    }

    private Object broadcast(TransitionSystem ts, Unifier un, Term[] terms) {
        post.broadcast(new Message(terms[0].toString(), "", null, terms[1], ""));
        return true;
    }

    private Object register(TransitionSystem ts, Unifier un, Term[] terms) {
        String service = Terms.words(terms[0]);
        Map<String, String> details = terms.length > 1 ? Map.of("type", Terms.words(terms[1])) : Map.of();
        offers.put(service, self.offer(new ServiceDescription(service, details)));
        return true;
    }

    private Object deregister(TransitionSystem ts, Unifier un, Term[] terms) {
        Subscription offer = offers.remove(Terms.words(terms[0]));
        if (offer != null) {
            offer.cancel();
        }
        return true;
    }

    /// `.df_search(service, Names)` or `.df_search(service, type, Names)`.
    private Object search(TransitionSystem ts, Unifier un, Term[] terms) {
        String service = Terms.words(terms[0]);
        List<Directory.Entry> offering = self.directory().offering(service).stream()
                .filter(entry -> terms.length < 3
                        || terms[1].isVar()
                        || self.directory().capabilities(entry.name()).stream()
                                .anyMatch(offered -> offered.name().equals(service)
                                        && Terms.words(terms[1])
                                                .equals(offered.details().get("type"))))
                .toList();
        return un.unifies(terms[terms.length - 1], names(offering));
    }

    /// `.send(to, performative, content)`, and with an answer to wait for, in milliseconds if not for ever.
    private final class Send extends OwnAction {
        private static final long serialVersionUID = 1;

        private boolean asks; // the intention that said it last

        Send() {
            super(3, 5, false);
        }

        @Override
        public boolean suspendIntention() {
            return asks;
        }

        @Override
        Object act(TransitionSystem ts, Unifier un, Term[] terms) throws Exception {
            asks = false;
            List<Term> receivers = Terms.list(terms[0]).orElseGet(() -> List.of(terms[0]));
            var message = new Message(terms[1].toString(), "", null, terms[2], "");
            boolean isAsking = message.isAsk() && terms.length > 3;
            Optional<Duration> limit =
                    isAsking && terms.length == 5 ? Optional.of(Terms.millis(terms[4])) : Optional.empty();
            message.setMsgId(post.nextId(isAsking ? Message.msgIdSyncAskPrefix : Message.msgIdPrefix));
            if (!message.isAsk() && terms.length > 3) {
                message.setInReplyTo(terms[3].toString());
            }
            for (Term receiver : receivers) {
                String name = Terms.words(receiver);
                message.setReceiver(name.equals("self") ? self.name() : name);
                post.send(message);
            }
            if (isAsking) {
                String id = message.getMsgId();
                asks = true;
                ts.getC()
                        .addPendingIntention(
                                id, new Atom("waiting_ask"), ts.getC().getSelectedIntention(), false);
                limit.ifPresent(time ->
                        waits.limit(id, time, () -> ts.runAtBeginOfNextCycle(() -> giveUp(ts, id, terms[0].isList()))));
            }
            return true;
        }

        /// Nobody has answered, or not all: then the answers are those that came. Where the answer is to be
        /// of some form, the step fails: what stands in that form has no value.
        private void giveUp(TransitionSystem ts, String id, boolean many) {
            Intention intention = ts.getC().removePendingIntention(id);
            if (intention == null) {
                return;
            }
            Unifier un = intention.peek().getUnif();
            Term answer = new Atom("timeout");
            if (many) {
                Term some = un.get(new VarTerm("AnsList___" + id)); // where Jason collects them
                answer = some == null ? ASSyntax.createList() : some;
            }
            if (intention.peek().getCurrentStep().getBodyTerm() instanceof Structure send
                    && !un.unifies(send.getTerm(3), answer)) {
                fail(ts, intention, send);
                return;
            }
            intention.peek().removeCurrentStep();
            ts.getC().resumeIntention(intention, new Atom("send_ask_msg_timeout"));
        }

        private void fail(TransitionSystem ts, Intention intention, Structure send) {
            try {
                ts.generateGoalDeletion(
                        intention,
                        JasonException.createBasicErrorAnnots(
                                "ask_timeout",
                                "Nobody has answered in time with '%s'.".formatted(Terms.written(send.getTerm(3)))),
                        new Atom("ask_timeout"));
            } catch (JasonException e) {
                agent.complain(String.valueOf(e.getMessage()));
            }
        }
    }

    /// What an internal action does.
    @FunctionalInterface
    interface Deed {
        Object execute(TransitionSystem ts, Unifier un, Term[] terms) throws Exception;
    }

    static final class Simple extends OwnAction {
        private static final long serialVersionUID = 1;

        private final transient Deed deed;

        Simple(int least, int most, Deed deed) {
            this(least, most, true, deed);
        }

        Simple(int least, int most, boolean inConditions, Deed deed) {
            super(least, most, inConditions);
            this.deed = deed;
        }

        @Override
        Object act(TransitionSystem ts, Unifier un, Term[] terms) throws Exception {
            return deed.execute(ts, un, terms);
        }
    }
}
