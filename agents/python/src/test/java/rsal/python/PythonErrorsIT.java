package rsal.python;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rsal.agent.AgentSpec;
import rsal.agent.AgentType;
import rsal.agent.OutsideCode;
import rsal.agent.Topic;
import rsal.agent.platform.AgentPlatform;
import rsal.agent.platform.AgentTurns;
import rsal.agent.platform.PlainHost;
import rsal.data.PlaceObjective;
import rsal.data.Pose2d;
import rsal.device.Device;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.PlaceFinder;
import rsal.robot.DeviceDriver;
import rsal.settings.Arguments;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.RobotBench;
import rsal.testkit.fake.FakeProvider;
import rsal.testkit.fake.TestedType;

/// What goes wrong around agents in Python, in simulated time.
class PythonErrorsIT extends RobotBench {
    private final List<String> lines = new ArrayList<>(); // printed
    private final AgentTurns turns = new AgentTurns();
    private AgentPlatform platform;

    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }

    @Override
    protected List<DeviceDriver> drivers() {
        return List.of(new LostFinder.Driver());
    }

    /// Of which the connection is lost while it looks.
    private static final class LostFinder extends DeviceCore implements PlaceFinder {
        LostFinder(DeviceInfo info) {
            super(info);
        }

        @Override
        public CompletionStage<Result> find(
                Pose2d mapFromStart, int count, double clearance, PlaceObjective objective) {
            return CompletableFuture.<Result>failedFuture(new IllegalStateException("The connection is lost."))
                    .thenApply(found -> found);
        }

        static final class Driver implements DeviceDriver {
            @Override
            public String key() {
                return "lost-finder";
            }

            @Override
            public String description() {
                return "Finds nothing.";
            }

            @Override
            public Class<? extends Device> makes() {
                return PlaceFinder.class;
            }

            @Override
            public LostFinder create(Context context, Arguments arguments) {
                return new LostFinder(new DeviceInfo(context.robot().id(), context.name(), key()));
            }
        }
    }

    @BeforeEach
    void gather() {
        platform = new AgentPlatform(run, new PlainHost(run), system().simulation(), turns);
        platform.onPrint(print -> lines.add(print.line()));
    }

    @AfterEach
    void close() {
        platform.close();
    }

    /// @param body of the class
    private void start(String name, String body) {
        AgentType type = Texts.type(
                name + ".py",
                Map.of(
                        name + ".py",
                        "import rsal\nfrom rsal.agents.devices import *\nfrom rsal.agents.values import *\nclass A(rsal.Agent):\n"
                                + body.indent(4)));
        platform.start(new AgentSpec(name, "tested", type, Arguments.defaults(List.of()), Optional.of(robot()), 1));
    }

    private String state(String name) {
        return platform.view(name).orElseThrow().state();
    }

    @Test
    void whatFailsLaterIsAnErrorWhereItIsAwaited() {
        String find = "self.robot.require(PlaceFinder).find(Pose2d(0, 0, 0), 1, 0.5)";
        start("amy", """
                async def on_start(self):
                    try:
                        await %s
                    except rsal.RsalError as error:
                        print(error)
                    await %s
                """.formatted(find, find));
        start("bob", """
                def on_start(self):
                    %s.on_result(print)
                """.formatted(find));
        advance(0.1);
        assertThat(lines).containsExactly("The connection is lost.");
        assertThat(state("amy")).isEqualTo("amy.py:10 in on_start: RsalError: The connection is lost.");
        assertThat(state("bob")).isEqualTo("RsalError: asked for at bob.py:6 in on_start: The connection is lost.");
    }

    @Test
    void wrongNamesAndTypesAreNamedAsPythonDoes() {
        start("amy", """
                def on_start(self):
                    self.robot.lasr
                """);
        start("bob", """
                def on_start(self):
                    from rsal.agents.messages import PoseReport
                    self.publish(PoseReport(3, '', Pose2d(0, 0, 0)))
                """);
        advance(0.1);
        assertThat(state("amy"))
                .startsWith("amy.py:6 in on_start: AttributeError: Robot 'r1' has no attribute 'lasr'. Maybe 'laser'? ")
                .contains("Its devices: ");
        assertThat(state("bob")).contains("Field 'robot' of 'PoseReport': '3' is not a 'str'.");
    }

    @Test
    void aCoroutineThatNobodyAwaitsIsNamed() {
        start("amy", """
                def on_start(self):
                    self.later()
                async def later(self):
                    pass
                """);
        advance(0.1);
        assertThat(lines).containsExactly("amy.py:6: RuntimeWarning: coroutine 'A.later' was never awaited");
    }

    @Test
    void aTopicWhoseNameIsNearlyOneOfRsalIsAskedAboutOnce() {
        start("amy", """
                def on_start(self):
                    from rsal import Topic
                    for topic in ("posee", "posee", "weather"):
                        self.publish(Topic(topic, dict), {})
                """);
        advance(0.1);
        assertThat(lines).containsExactly("Topic 'posee' is one of its own, not one of RSAL. Maybe 'pose' was meant?");
    }

    @Test
    void bidsWithoutANumberCountAsNone() {
        for (String bid : List.of("{'cost': 3}", "{'price': 1}", "{'cost': float('nan')}", "{'cost': 'low'}")) {
            start("b" + lines.size() + bid.length(), """
                    def on_start(self):
                        self.bid("haul", lambda call: %s, lambda question: {})
                    """.formatted(bid));
        }
        start("boss", """
                async def on_start(self):
                    names = [each.name for each in self.agents() if each.name != "boss"]
                    awards = await self.call("haul", {}, names, least="cost", count=4)
                    print([award.bid for award in awards])
                """);
        advance(5);
        assertThat(lines)
                .hasSize(4)
                .endsWith("[{'cost': 3}]")
                .contains("The bid of 'b012' has no number 'cost', and is left out: {price=1}");
        assertThat(platform.view("boss").orElseThrow().status()).isEqualTo(AgentPlatform.Status.RUNNING);
    }

    @Test
    void codeThatNeverReturnsEndsWithItsProcess() throws InterruptedException {
        start("amy", """
                def on_start(self):
                    self.after(0.1, self.spin)
                def spin(self):
                    while True:
                        pass
                """);
        start("java", new TestedType(self -> self.scheduler().after(Duration.ofSeconds(1), () -> self.print("lives"))));
        Thread killer = Thread.ofPlatform().start(() -> {
            try {
                while (turns.outside("amy").isEmpty() || !turns.inProgress().containsKey("amy")) {
                    TimeUnit.MILLISECONDS.sleep(5);
                }
                TimeUnit.MILLISECONDS.sleep(500); // its start is over by then
                turns.outside("amy").ifPresent(OutsideCode::kill);
            } catch (InterruptedException _) {
                Thread.currentThread().interrupt();
            }
        });
        advance(2);
        killer.join();
        assertThat(state("amy")).startsWith("Python ended with code ");
        assertThat(lines).containsExactly("lives");
    }

    @Test
    void whatIsTooLongForAFrameIsSaid() {
        var numbers = new Topic<>("numbers", Map.class);
        start("amy", """
                def on_start(self):
                    self.subscribe(rsal.Topic("numbers", dict), lambda message: print(len(message.content["text"])))
                    self.after(1.0, lambda: self.show("x", "y" * 40_000_000))
                """);
        start("java", new TestedType(self -> {
            self.publish(numbers, Map.of("text", "short"));
            self.scheduler()
                    .after(Duration.ofMillis(500), () -> self.publish(numbers, Map.of("text", "x".repeat(1 << 26))));
        }));
        advance(2);
        assertThat(lines).containsExactly("5");
        assertThat(state("amy")).matches("A frame has \\d+ bytes; at most 67108864 can be sent\\.");
    }

    private void start(String name, AgentType type) {
        platform.start(new AgentSpec(name, "tested", type, Arguments.defaults(List.of()), Optional.empty(), 1));
    }
}
