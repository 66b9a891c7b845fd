package rsal.jade;

import jade.core.AID;
import jade.core.Agent;
import jade.core.ServiceException;
import jade.core.behaviours.CyclicBehaviour;
import jade.core.messaging.TopicManagementHelper;
import jade.domain.DFService;
import jade.domain.FIPAAgentManagement.DFAgentDescription;
import jade.domain.FIPAAgentManagement.FIPAManagementVocabulary;
import jade.domain.FIPAAgentManagement.Property;
import jade.lang.acl.ACLMessage;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Queue;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import rsal.agent.ServiceDescription;
import rsal.time.Scheduler;

/// The JADE agent of one of ours: lends it its thread and speaks for it. What our agents do they do in turn, so that
/// several things that wait are done in one turn; what they say leaves when it is over, as JADE takes its time for
/// that.
///
/// Its methods are called in turn, but for [#execute], which any thread may call.
final class JadeAgent extends Agent implements Executor {
    private static final Logger LOG = System.getLogger(JadeAgent.class.getName());
    private static final int MOST_AT_ONCE = 100; // then others have their turn
    private static final Duration PATIENCE = Duration.ofSeconds(5); // as JADE's own

    private final String name;
    private final transient Scheduler run;
    private final transient Consumer<JadeAgent> gone;
    private final transient Queue<Runnable> tasks = new ConcurrentLinkedQueue<>();
    private final transient SortedMap<String, ServiceDescription> offers = new TreeMap<>(); // by name
    private final transient Queue<ACLMessage> said = new ArrayDeque<>(); // of its thread
    private final Work work = new Work();
    private volatile @Nullable Thread thread; // its own, once it has begun
    private boolean leaving;

    /// @param name of our agent
    /// @param gone told, on a thread of JADE's, when it has ended, no matter who wanted it, and its name is free
    JadeAgent(String name, Scheduler run, Consumer<JadeAgent> gone) {
        this.name = name;
        this.run = run;
        this.gone = gone;
    }

    String name() {
        return name;
    }

    /// Does something on its thread, soon.
    @Override
    public void execute(Runnable task) {
        tasks.add(task);
        if (!isHere()) { // else it is at work already
            work.restart();
        }
    }

    private boolean isHere() {
        return Thread.currentThread().equals(thread);
    }

    /// Sends what is said in its name or another's.
    void say(ACLMessage message) {
        if (isHere()) {
            said.add(message);
        } else {
            execute(() -> said.add(message));
        }
    }

    /// Ends it once it has done what it was to do before.
    void leave() {
        leaving = true;
        execute(this::doDelete);
    }

    /// Whether it was told to end.
    boolean isLeaving() {
        return leaving;
    }

    void listen(AID topic) {
        try {
            topics().register(topic);
        } catch (ServiceException e) {
            throw new IllegalStateException(
                    "JADE can't deliver topic '%2$s' to agent '%1$s'.".formatted(name, topic), e);
        }
    }

    void ignore(AID topic) {
        try {
            topics().deregister(topic);
        } catch (ServiceException e) {
            throw new IllegalStateException("JADE can't keep '%s' from agent '%s'.".formatted(topic, name), e);
        }
    }

    private TopicManagementHelper topics() throws ServiceException {
        return (TopicManagementHelper) getHelper(TopicManagementHelper.SERVICE_NAME);
    }

    void offer(ServiceDescription capability) {
        boolean first = offers.isEmpty();
        offers.put(capability.name(), capability);
        ask(first ? FIPAManagementVocabulary.REGISTER : FIPAManagementVocabulary.MODIFY);
    }

    void withdraw(ServiceDescription capability) {
        offers.remove(capability.name());
        ask(offers.isEmpty() ? FIPAManagementVocabulary.DEREGISTER : FIPAManagementVocabulary.MODIFY);
    }

    /// Asks the directory facilitator, whose answer it does not wait for.
    private void ask(String action) {
        var entry = new DFAgentDescription();
        entry.setName(getAID());
        offers.values().forEach(capability -> entry.addServices(service(capability)));
        send(DFService.createRequestMessage(this, getDefaultDF(), action, entry, null));
    }

    private static jade.domain.FIPAAgentManagement.ServiceDescription service(ServiceDescription capability) {
        var service = new jade.domain.FIPAAgentManagement.ServiceDescription();
        service.setName(capability.name());
        service.setType(capability.name());
        service.addOntologies(Utterance.ONTOLOGY);
        capability.details().forEach((detail, value) -> service.addProperties(new Property(detail, value)));
        return service;
    }

    @Override
    protected void setup() {
        thread = Thread.currentThread();
        addBehaviour(work);
    }

    /// No matter who wanted its end, the facilitator is told; it would keep what it was told before.
    @Override
    protected void takeDown() {
        run.exclusively(() -> {
            if (!offers.isEmpty()) {
                offers.clear();
                ask(FIPAManagementVocabulary.DEREGISTER);
            }
        });
    }

    @Override
    public void clean(boolean regular) {
        super.clean(regular);
        gone.accept(this);
    }

    /// Waits until its thread has ended, but not for ever: as JADE does, which tells the terminal of one that never
    /// returns.
    @Override
    public void join() {
        Thread own = thread;
        if (own == null || isHere()) {
            return;
        }
        try {
            if (!own.join(PATIENCE)) {
                LOG.log(Level.WARNING, () -> "Agent '%s' never returns. Its thread still runs.".formatted(name));
                own.interrupt();
            }
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt(); // those that want it to end wait no more
        }
    }

    private void hear(ACLMessage message) {
        if (message instanceof Utterance utterance) {
            utterance.arrive(name);
        } else if (isNoAnswer(message.getPerformative())) {
            ACLMessage answer = message.createReply();
            answer.setPerformative(ACLMessage.NOT_UNDERSTOOD);
            answer.setContent("'%s' understands only what agents of its run say.".formatted(name));
            send(answer);
        } else if (message.getSender().equals(getDefaultDF())
                && message.getPerformative() != ACLMessage.AGREE
                && message.getPerformative() != ACLMessage.INFORM) {
            LOG.log(
                    Level.WARNING,
                    () -> "JADE's facilitator does not do what agent '%s' asked: %s".formatted(name, message));
        }
    }

    /// What the directory facilitator and the management system say are answers. To answer an answer may never end.
    private static boolean isNoAnswer(int performative) {
        return switch (performative) {
            case ACLMessage.AGREE,
                    ACLMessage.FAILURE,
                    ACLMessage.INFORM,
                    ACLMessage.NOT_UNDERSTOOD,
                    ACLMessage.REFUSE -> false;
            default -> true;
        };
    }

    /// Does what it is handed and hears what it is told, then waits for more.
    private final class Work extends CyclicBehaviour {
        @Override
        public void action() {
            block(); // before it looks, so that what comes after that wakes it
            Runnable first = next();
            if (first != null) {
                run.exclusively(() -> work(first));
                for (ACLMessage message = said.poll(); message != null; message = said.poll()) {
                    send(message);
                }
                if (!tasks.isEmpty() || getCurQueueSize() > 0) {
                    restart();
                }
            }
        }

        private void work(Runnable first) {
            first.run();
            for (int done = 1; done < MOST_AT_ONCE; done++) {
                Runnable task = next();
                if (task == null) {
                    return;
                }
                task.run();
            }
        }

        private @Nullable Runnable next() {
            Runnable task = tasks.poll();
            if (task != null) {
                return task;
            }
            ACLMessage message = receive();
            return message == null ? null : () -> hear(message);
        }

        // JADE's own two set a flag in two steps: one step of each in between would leave it asleep.

        @Override
        protected synchronized void handleBlockEvent() {
            super.handleBlockEvent();
        }

        @Override
        public synchronized void handleRestartEvent() {
            super.handleRestartEvent();
        }
    }
}
