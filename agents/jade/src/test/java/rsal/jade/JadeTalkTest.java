package rsal.jade;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.tuple;

import jade.core.AID;
import jade.domain.DFService;
import jade.domain.FIPAAgentManagement.DFAgentDescription;
import jade.domain.FIPAAgentManagement.Property;
import jade.domain.JADEAgentManagement.KillAgent;
import jade.domain.JADEAgentManagement.ShutdownPlatform;
import jade.lang.acl.ACLMessage;
import java.awt.GraphicsEnvironment;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Semaphore;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.ServiceDescription;
import rsal.agent.Topic;
import rsal.agent.platform.AgentPlatform.Status;
import rsal.agent.protocol.Request;
import rsal.testkit.LongTest;
import rsal.time.WallScheduler;

/// What agents and tools of JADE's see of ours.
@Timeout(60)
class JadeTalkTest {
    private static final Topic<String> WORDS = new Topic<>("words", String.class);

    /// Written by agents, in turn.
    private final List<String> log = new ArrayList<>();

    @Test
    void whatIsForAllIsAnInformToTheTopic() {
        try (var run = new JadeRun()) {
            Witness witness = run.witness("witness", "words").ready();
            run.start("amy", self -> self.publish(WORDS, "good morning"));
            ACLMessage heard = witness.hears();
            assertThat(heard.getPerformative()).isEqualTo(ACLMessage.INFORM);
            assertThat(heard.getSender().getLocalName()).isEqualTo("amy");
            assertThat(((AID) heard.getAllReceiver().next()).getLocalName()).isEqualTo("words");
            assertThat(heard.getOntology()).isEqualTo("rsal");
            assertThat(heard.getContent()).isEqualTo("good morning");
        }
    }

    @Test
    void whatIsForOneNamesItsTopic() {
        try (var run = new JadeRun()) {
            Witness witness = run.witness("witness").ready();
            run.start("amy", self -> self.send("witness", WORDS, "psst"));
            ACLMessage heard = witness.hears();
            assertThat(heard.getUserDefinedParameter("X-topic")).isEqualTo("words");
            assertThat(heard.getContent()).isEqualTo("psst");
            assertThat(heard.toString()).contains("X-topic", "psst"); // as it stands in files and windows
        }
    }

    @Test
    void conversationsAreAclMessagesOfTheirProtocol() {
        try (var run = new JadeRun()) {
            Witness witness = run.witness("witness").ready();
            run.start(
                    "amy",
                    self -> new Request<>(self, "help", String.class, String.class)
                            .ask("witness", "carry", how -> log.add(how.toString())));
            ACLMessage heard = witness.hears();
            assertThat(heard.getPerformative()).isEqualTo(ACLMessage.REQUEST);
            assertThat(heard.getProtocol()).isEqualTo("fipa-request");
            assertThat(heard.getConversationId()).startsWith("amy:help:");
            assertThat(heard.getUserDefinedParameter("X-topic")).isEqualTo("help");
            assertThat(heard.getContent()).isEqualTo("carry");
        }
    }

    @Test
    void peopleSpeakInTheirName() {
        try (var run = new JadeRun()) {
            Witness witness = run.witness("witness", "words").ready();
            run.act(() -> run.platform().publish("operator", WORDS, "go on"));
            assertThat(witness.hears().getSender().getLocalName()).isEqualTo("operator");
        }
    }

    @Test
    void strangersAreNotUnderstood() {
        try (var run = new JadeRun()) {
            Witness witness = run.witness("stranger").ready();
            run.start("amy", _ -> log.add("begun"));
            run.until("it has begun", () -> !log.isEmpty());
            for (int performative : List.of(ACLMessage.FAILURE, ACLMessage.NOT_UNDERSTOOD, ACLMessage.REQUEST)) {
                var asked = new ACLMessage(performative);
                asked.addReceiver(witness.getAID("amy"));
                asked.setConversationId("conversation " + performative);
                witness.send(asked);
            }
            ACLMessage answer = witness.hears();
            assertThat(answer.getPerformative()).isEqualTo(ACLMessage.NOT_UNDERSTOOD);
            assertThat(answer.getConversationId()).isEqualTo("conversation " + ACLMessage.REQUEST);
            assertThat(witness.hasHeardAll()).isTrue(); // nothing to the others
        }
    }

    @Test
    void theDirectoryFacilitatorKnowsWhatAgentsOffer() {
        try (var run = new JadeRun()) {
            Witness witness = run.witness("witness").ready();
            run.start("amy", self -> {
                var gripper = self.offer(new ServiceDescription("gripper", Map.of("reach", "0.3 m")));
                self.offer(ServiceDescription.of("lift"));
                self.subscribe(WORDS, _ -> gripper.cancel());
                log.add("offered");
            });
            run.until("it has offered", () -> !log.isEmpty());
            assertThat(find(witness, "gripper", 1)).isEqualTo(List.of("amy reach=0.3 m"));
            assertThat(find(witness, "lift", 1)).isEqualTo(List.of("amy"));
            run.act(() -> run.platform().send("operator", "amy", WORDS, "drop it"));
            assertThat(find(witness, "gripper", 0)).isEmpty();
            run.act(() -> run.platform().stop("amy"));
            assertThat(find(witness, "lift", 0)).isEmpty();
        }
    }

    /// Asks the facilitator again until so many offer that.
    private static List<String> find(Witness witness, String service, int wanted) {
        var description = new jade.domain.FIPAAgentManagement.ServiceDescription();
        description.setType(service);
        var template = new DFAgentDescription();
        template.addServices(description);
        List<String> found = List.of();
        for (int look = 0; look < 500 && (look == 0 || found.size() != wanted); look++) {
            found = witness.does(() -> {
                var names = new ArrayList<String>();
                for (DFAgentDescription entry : DFService.search(witness, template)) {
                    var words = new StringBuilder(entry.getName().getLocalName());
                    var services = entry.getAllServices();
                    while (services.hasNext()) {
                        var properties = ((jade.domain.FIPAAgentManagement.ServiceDescription) services.next())
                                .getAllProperties();
                        while (properties.hasNext()) {
                            var property = (Property) properties.next();
                            if (service.equals("gripper")) {
                                words.append(' ')
                                        .append(property.getName())
                                        .append('=')
                                        .append(property.getValue());
                            }
                        }
                    }
                    names.add(words.toString());
                }
                return names;
            });
        }
        return found;
    }

    @Test
    void whomAPersonEndsByAToolEndsHereToo() {
        try (var run = new JadeRun()) {
            Witness witness = run.witness("tool").ready();
            run.start(
                    "bob",
                    self -> self.directory()
                            .onDeparture(went -> log.add(went.agent().name() + " went")));
            run.start("amy", new Agent() {
                @Override
                public void start(AgentContext self) {
                    self.scheduler().every(Duration.ofMillis(10), () -> log.add("amy lives"));
                }

                @Override
                public void stop(AgentContext self) {
                    log.add("last words");
                }
            });
            run.until("it lives", () -> log.contains("amy lives"));
            var kill = new KillAgent();
            kill.setAgent(witness.getAID("amy"));
            witness.asksTheSystem(kill);
            run.until("the other knows", () -> log.contains("amy went"));
            assertThat(log).containsSubsequence("last words", "amy went").endsWith("amy went");
            assertThat(run.ask(() -> run.platform().views()))
                    .extracting(view -> view.agent().name(), view -> view.status())
                    .containsExactly(tuple("bob", Status.RUNNING), tuple("amy", Status.ENDED));
        }
    }

    @Test
    void whoEndsThePlatformByAToolEndsAllAgents() throws InterruptedException {
        try (var run = new JadeRun()) {
            Witness witness = run.witness("tool").ready();
            run.start("amy", self -> self.atEnd(() -> log.add("amy")));
            run.start("bob", self -> self.atEnd(() -> log.add("bob")));
            run.start("eve", self -> self.scheduler().execute(() -> log.add("begun")));
            run.until("they have begun", () -> log.contains("begun"));
            witness.asksTheSystem(new ShutdownPlatform());
            run.until("they have ended", () -> log.contains("amy") && log.contains("bob"));
            run.until(
                    "all have", () -> run.platform().views().stream().allMatch(view -> view.status() == Status.ENDED));
        }
        awaitEnds();
        try (var next = new JadeRun()) {
            next.start("amy", _ -> log.add("next"));
            next.until("it has begun", () -> log.contains("next"));
        }
    }

    @Test
    void onesMayComeAndGoFasterThanJadeForgetsThem() {
        try (var run = new JadeRun()) {
            run.act(() -> {
                for (String word : List.of("first", "second", "third")) {
                    run.start("amy", _ -> log.add(word));
                    run.platform().stop("amy");
                }
                run.start("amy", self -> self.subscribe(WORDS, m -> log.add(m.content())));
                run.start(
                        "bob", self -> self.scheduler().every(Duration.ofMillis(50), () -> self.publish(WORDS, "hi")));
            });
            run.until("the last of them hears", () -> log.contains("hi"));
            assertThat(log).containsOnly("hi");
        }
    }

    @Test
    void runsSideBySideKeepToThemselves() {
        try (var one = new JadeRun();
                var other = new JadeRun()) {
            var here = new ArrayList<String>();
            var there = new ArrayList<String>();
            one.start("amy", self -> self.subscribe(WORDS, m -> here.add(m.content())));
            other.start("amy", self -> self.subscribe(WORDS, m -> there.add(m.content())));
            for (int i = 0; i < 3; i++) {
                one.start(
                        "bob-" + i,
                        self -> self.scheduler().after(Duration.ofMillis(200), () -> self.publish(WORDS, "one")));
                other.start(
                        "bob-" + i,
                        self -> self.scheduler().after(Duration.ofMillis(200), () -> self.publish(WORDS, "other")));
            }
            one.until("all is heard here", () -> here.size() == 3);
            other.until("and there", () -> there.size() == 3);
            assertThat(here).containsOnly("one");
            assertThat(there).containsOnly("other");
        }
    }

    @Test
    void oneRunMayFollowAnother() throws InterruptedException {
        for (int i = 0; i < 4; i++) {
            try (var run = new JadeRun()) {
                run.start("amy", self -> self.subscribe(WORDS, m -> log.add(m.content())));
                run.start(
                        "bob", self -> self.scheduler().every(Duration.ofMillis(50), () -> self.publish(WORDS, "hi")));
                run.until("they talk", () -> !log.isEmpty());
                log.clear();
            }
            if (i % 2 == 1) {
                awaitEnds(); // what JADE has once for the process has ended, too
            }
        }
    }

    @Test
    void leavesNoFileAndNoWordOnTheTerminal() throws InterruptedException {
        awaitEnds(); // JADE may print that a timer of a bare agent outlived it
        PrintStream out = System.out;
        PrintStream err = System.err;
        var said = new ByteArrayOutputStream();
        var terminal = new PrintStream(said, true, StandardCharsets.UTF_8);
        System.setOut(terminal);
        System.setErr(terminal);
        try {
            try (var run = new JadeRun()) {
                run.start("amy", self -> self.subscribe(WORDS, m -> log.add(m.content())));
                run.start("bob", self -> {
                    self.offer(ServiceDescription.of("lift"));
                    self.scheduler().every(Duration.ofMillis(10), () -> self.publish(WORDS, "hi"));
                    self.send("nobody", WORDS, "hello?");
                });
                run.until("they talk", () -> log.size() > 10);
            }
            awaitEnds();
        } finally {
            System.setOut(out);
            System.setErr(err);
        }
        assertThat(said.toString(StandardCharsets.UTF_8)).isEmpty();
        assertThat(Path.of("APDescription.txt")).doesNotExist();
    }

    @Test
    @LongTest
    void anAgentThatNeverReturnsIsLeftAndLoggedAsTheRestIs() throws InterruptedException {
        awaitEnds(); // as above
        var said = new ByteArrayOutputStream();
        PrintStream out = System.out;
        var begun = new CountDownLatch(1);
        var released = new Semaphore(0);
        try (var time = new WallScheduler("tested run", Runnable::run)) {
            System.setOut(new PrintStream(said, true, StandardCharsets.UTF_8));
            JadePlatform platform = JadePlatform.start();
            var amy = new JadeAgent("amy", time, _ -> {});
            platform.start("amy", amy);
            amy.execute(() -> {
                begun.countDown();
                released.acquireUninterruptibly();
            });
            begun.await();
            platform.end();
            released.release();
        } finally {
            System.setOut(out);
        }
        assertThat(said.toString(StandardCharsets.UTF_8)).isEmpty();
    }

    private static void awaitEnds() throws InterruptedException {
        for (Thread thread : Thread.getAllStackTraces().keySet()) {
            if (thread.getName().equals("end of JADE")) {
                thread.join(Duration.ofSeconds(20));
                assertThat(thread.isAlive()).isFalse();
            }
        }
    }

    @Test
    void namesThatJadeHasAreRefused() {
        try (var run = new JadeRun()) {
            assertThatExceptionOfType(AssertionError.class)
                    .isThrownBy(() -> run.start("df", _ -> {}))
                    .havingCause()
                    .withMessageStartingWith("JADE can't start an agent 'df'");
            assertThat(run.ask(() -> run.platform().views())).isEmpty();
        }
    }

    @Test
    void windowsNeedADisplay() {
        Assumptions.assumeTrue(GraphicsEnvironment.isHeadless());
        try (var time = new WallScheduler("tested run", Runnable::run)) {
            assertThatExceptionOfType(UncheckedIOException.class)
                    .isThrownBy(() -> JadeHost.start(time, Set.of(Tool.SNIFFER)))
                    .havingCause()
                    .withMessage("JADE's windows need a display, and there is none. Maybe remove [sniffer].");
        }
    }
}
