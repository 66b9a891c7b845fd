package rsal.python;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rsal.agent.Agent;
import rsal.agent.AgentSpec;
import rsal.agent.AgentType;
import rsal.agent.Message;
import rsal.agent.OutsideCode;
import rsal.agent.Topic;
import rsal.agent.bdi.Mind;
import rsal.agent.board.TeamBoard;
import rsal.agent.message.PoseReport;
import rsal.agent.platform.AgentPlatform;
import rsal.agent.platform.AgentTurns;
import rsal.agent.platform.PlainHost;
import rsal.agent.protocol.Auction;
import rsal.agent.protocol.ContractNet;
import rsal.agent.protocol.Conversation;
import rsal.agent.protocol.Propose;
import rsal.agent.protocol.Request;
import rsal.agent.protocol.Subscribe;
import rsal.behavior.PilotDriver;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.robot.DeviceDriver;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.system.RobotSystemProvider;
import rsal.testkit.OfficialPython;
import rsal.testkit.contract.RobotBench;
import rsal.testkit.fake.FakeLocalizer;
import rsal.testkit.fake.FakeNavigator;
import rsal.testkit.fake.FakePlanner;
import rsal.testkit.fake.FakeProvider;
import rsal.testkit.fake.TestedType;

/// Agents in Python, in simulated time.
@SuppressWarnings("rawtypes") // contents are told by a class, which has no parameters
class PythonAgentIT extends RobotBench {
    private final List<String> lines = new ArrayList<>(); // printed
    private final List<Message<?>> said = new ArrayList<>();
    private final Map<String, Double> metrics = new HashMap<>();
    private final AgentTurns turns = new AgentTurns();
    private AgentPlatform platform;

    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }

    @Override
    protected Map<String, String> parts() {
        return Map.of("battery", "pioneer-battery", "gripper", "pioneer-gripper");
    }

    @Override
    protected List<DeviceDriver> drivers() {
        return List.of(
                new PilotDriver(), new FakeLocalizer.Driver(), new FakeNavigator.Driver(), new FakePlanner.Driver());
    }

    @BeforeEach
    void gather() {
        platform = new AgentPlatform(run, new PlainHost(run), system().simulation(), turns);
        platform.onMessage(said::add);
        platform.onPrint(print -> lines.add(print.line()));
        platform.onMetric(metric -> metrics.put(metric.name(), metric.value()));
    }

    @AfterEach
    void close() {
        platform.close();
    }

    private void start(String name, String body) {
        start(name, body, Map.of(), Optional.empty());
    }

    private void startOnRobot(String body) {
        start("a", body, Map.of(), Optional.of(robot()));
    }

    /// @param body of the class
    private void start(String name, String body, Map<String, Object> arguments, Optional<Robot> robot) {
        AgentType type = type(name + ".py", """
                import math, random, sys, time
                import rsal
                from rsal.agents.devices import *
                from rsal.agents.messages import *
                from rsal.agents import Refusal
                from rsal.agents.values import *
                BIDS = rsal.Topic("bids", dict)
                class A(rsal.Agent):
                """ + body.indent(4));
        platform.start(new AgentSpec(
                name, "tested", type, Arguments.of(type.parameters(), arguments), robot, name.hashCode()));
    }

    private static AgentType type(String file, String text) {
        return Texts.type(file, Map.of(file, text));
    }

    private void start(String name, Agent agent) {
        platform.start(new AgentSpec(
                name, "tested", new TestedType(agent), Arguments.defaults(List.of()), Optional.empty(), 1));
    }

    private AgentPlatform.View view(String name) {
        return platform.view(name).orElseThrow();
    }

    @Test
    void itHasItsArgumentsItsNameAndItsTime() {
        start("amy", """
                pace: float = rsal.Param(0.5)
                words: str = rsal.Param("hi")
                def on_start(self):
                    print(self.name, self.role, self.pace, self.words, self.time)
                    self.after(1.5, self.later, "later")
                    beats = self.every(0.4, self.beat)
                    self.after(1.0, beats.cancel)
                def later(self, word):
                    print(word, self.time)
                def beat(self):
                    print("beat", round(self.time, 3))
                """, Map.of("pace", 2), Optional.empty());
        advance(3);
        assertThat(lines).containsExactly("amy tested 2.0 hi 0.0", "beat 0.4", "beat 0.8", "later 1.5");
    }

    @Test
    void itReadsItsDevicesAndDrives() {
        startOnRobot("""
                def on_start(self):
                    self.robot.laser.subscribe(self.on_scan)
                    self.scans = 0
                    print([each.name for each in self.robot.devices])
                    print(self.robot.base.latest is None, self.robot.find(Imu))
                def on_scan(self, scan):
                    self.scans += 1
                    self.robot.base.command(0.2)
                    if self.scans == 5:
                        value = scan.value
                        print(scan.frame, value.ranges.dtype, len(value.ranges) == len(value.angles), math.isclose(scan.time, self.time))
                        self.show("nearest", round(value.nearest(-0.3, 0.3), 1))
                        self.show("x", self.simulation.truth("r1").x > -16)
                        print(self.robot.base.enabled, type(self.robot.localizer.latest.value.map_from_base).__name__, self.robot.battery.health)
                """);
        Pose2d before = truth();
        advance(5);
        assertThat(lines)
                .contains("r1/laser float32 True True", "True Pose2d HealthOk()")
                .anySatisfy(line -> assertThat(line).contains("'laser'", "'fake-navigator'"));
        assertThat(view("a").beliefs()).containsKey("nearest").containsEntry("x", "True");
        assertThat(truth().x()).isGreaterThan(before.x() + 0.5);
    }

    @Test
    void itWaitsForGoalsAndPlans() {
        startOnRobot("""
                async def on_start(self):
                    await self.sleep(0.5)
                    here = self.robot.localizer.latest.value.map_from_base
                    goal = Pose2d(here.x + 1, here.y, 0.0)
                    costs = await self.robot.planner.costs(here, [goal, here])
                    print(len(costs), costs[1] <= costs[0])
                    drive = self.robot.navigator.go_to(goal, distance=0.2)
                    drive.on_feedback(self.on_feedback)
                    self.far = 0.0
                    match await drive:
                        case Navigator.Reached(map_from_base=there):
                            print("reached", there.distance_to(goal) < 0.3, self.far > 0.5)
                    drive = self.robot.navigator.go_to(here)
                    self.after(0.5, drive.cancel)
                    print(type(await drive).__name__)
                    print(type(await self.robot.gripper.close()).__name__)
                def on_feedback(self, progress):
                    self.far = max(self.far, progress.value.remaining)
                """);
        advance(20);
        assertThat(lines).containsExactly("2 True", "reached True True", "NavigatorCancelled", "GripperReached");
    }

    @Test
    void topicsAreSharedWithJava() {
        var heard = new ArrayList<Object>();
        start("java", self -> {
            self.subscribe(new Topic<>("bids", Map.class), message -> {
                heard.add(message.content());
                self.send("amy", new Topic<>("bids", Map.class), Map.of("price", 4, "of", List.of("a", 1.5)));
            });
            self.subscribe(PoseReport.TOPIC, message -> heard.add(message.content()));
        });
        start("amy", """
                def on_start(self):
                    self.subscribe(BIDS, self.on_bid)
                    self.subscribe(PoseReport, self.on_pose, at_most_every=1.0)
                    self.publish(PoseReport("r9", "role", Pose2d(1, 2.5, 3)))
                    self.publish(BIDS, {"price": 3, "who": None})
                def on_bid(self, message):
                    print(message.sender, message.to, message.content)
                def on_pose(self, message):
                    print(message.content.map_from_base.x)
                """);
        start("bob", """
                def on_start(self):
                    self.x = 0
                    self.every(0.3, self.report)
                def report(self):
                    self.x += 1
                    self.publish(PoseReport("r8", "role", Pose2d(self.x, 0, 0)))
                """);
        advance(2);
        assertThat(heard)
                .contains(new PoseReport("r9", "role", new Pose2d(1, 2.5, 3)))
                .anySatisfy(content -> assertThat(content).hasToString("{price=3, who=null}"));
        assertThat(lines).containsExactly("java amy {'of': ['a', 1.5], 'price': 4}", "1.0", "5.0");
    }

    @Test
    void itFindsOthersAndKeepsNotes() {
        start(
                "java",
                self -> self.scheduler().after(Duration.ofSeconds(1), () -> {
                    throw new IllegalStateException("gone");
                }));
        start("amy", """
                def on_start(self):
                    self.on_departure(lambda name, why: print("went", name, why))
                    self.offer("gripper", reach="0.3 m")
                    self.blackboard.write(PoseReport, "last", PoseReport("r", "s", Pose2d(1, 2, 3)), lifetime=1.0)
                    self.blackboard.write(BIDS, "own", {"a": 1})
                    self.after(0.5, self.look)
                    self.after(2.0, self.look)
                def look(self):
                    print([each.name for each in self.agents()], [each.services for each in self.agents(offering="gripper")])
                    print([note.content.map_from_base.y for note in self.blackboard.read(PoseReport)], self.blackboard.read(BIDS)[0].content)
                """);
        advance(3);
        assertThat(lines)
                .containsExactly(
                        "['java', 'amy'] [{'gripper': {'reach': '0.3 m'}}]",
                        "[2.0] {'a': 1}",
                        "went java gone",
                        "['amy'] [{'gripper': {'reach': '0.3 m'}}]",
                        "[] {'a': 1}");
    }

    @Test
    void requestsGoBothWays() {
        start("java", self -> {
            var weight = new Request<>(self, "weight", Map.class, Map.class);
            weight.answer(
                    asked -> asked.inform(Map.of("kg", 2, "of", asked.what().get("thing"))));
            var doubled = new Request<>(self, "double", Map.class, Map.class);
            self.scheduler().after(Duration.ofSeconds(1), () -> {
                doubled.ask("amy", Map.of("n", 21), ending -> self.print(ending.toString()));
                doubled.ask("amy", Map.of("n", -1), ending -> self.print(ending.toString()));
            });
        });
        start("amy", """
                async def on_start(self):
                    self.answer("double", self.double)
                    result = await self.ask("java", "weight", {"thing": "box"})
                    print(result.informed, result.content)
                    result = await self.ask("nobody", "weight", {})
                    print(result.how)
                async def double(self, question):
                    await self.sleep(0.5)
                    if question.content["n"] < 0:
                        raise Refusal("too little")
                    return {"n": 2 * question.content["n"]}
                """);
        advance(10);
        assertThat(lines)
                .contains("True {'kg': 2, 'of': 'box'}", "silent", "Informed[result={n=42}]", "Failed[why=too little]");
    }

    @Test
    void contractNetsGoBothWays() {
        start(
                "java",
                self -> new ContractNet<>(self, "haul", Map.class, Map.class, Map.class)
                        .answer(new ContractNet.Contractor<>() {
                            @Override
                            public void called(ContractNet.Call<Map, Map> call) {
                                call.propose(Map.of("cost", 3));
                            }

                            @Override
                            public void accepted(ContractNet.Contract<Map, Map> contract) {
                                contract.inform(Map.of("by", "java"));
                            }
                        }));
        String bidder = """
                def on_start(self):
                    self.bid("haul", self.propose, self.haul)
                def propose(self, call):
                    return {"cost": len(self.name)} if call.task["thing"] == "box" else None
                async def haul(self, question):
                    await self.sleep(1.0)
                    return {"by": self.name, "at": round(self.time, 1)}
                """;
        start("al", bidder);
        start("barbara", bidder);
        start("boss", """
                async def on_start(self):
                    names = ["java", "al", "barbara"]
                    for award in await self.call("haul", {"thing": "box"}, names, least="cost", count=2):
                        print(award.sender, award.bid, award.result.content)
                    for award in await self.call("haul", {"thing": "can"}, names, most="cost"):
                        print(award.sender)
                    print(await self.call("haul", {"thing": "can"}, ["nobody"], most="cost", within=0.5))
                """);
        advance(12);
        assertThat(lines)
                .containsExactly(
                        "java {'cost': 3} {'by': 'java'}", "al {'cost': 2} {'by': 'al', 'at': 1.0}", "java", "[]");
    }

    @Test
    void auctionsGoBothWays() {
        start("java", self -> {
            var trucks = Auction.english(self, "truck", Map.class);
            Auction.dutch(self, "box", Map.class).answer((lot, price) -> price <= 4);
            self.scheduler()
                    .after(
                            Duration.ofSeconds(1),
                            () -> trucks.sell(
                                    List.of("al", "barbara"),
                                    Map.of("thing", "truck"),
                                    new Auction.Prices(1, 1, 2),
                                    Duration.ofSeconds(1),
                                    sale -> self.print(sale.winner().orElse("nobody") + " " + sale.price())));
        });
        String bidder = """
                def on_start(self):
                    self.buy("truck", self.pays, on_end=self.ended)
                async def pays(self, offer):
                    await self.sleep(0.2)
                    return offer.price <= len(self.name) and offer.lot["thing"] == "truck"
                def ended(self, lot, sale):
                    print(lot["thing"], sale)
                """;
        start("al", bidder);
        start("barbara", bidder);
        start("boss", """
                async def on_start(self):
                    await self.sleep(20.0)
                    print(await self.sell("box", {"thing": "box"}, ["java"], first=6, step=-1, reserve=2))
                    print(await self.sell("box", {"thing": "can"}, ["java"], first=9, step=-1, reserve=6))
                    await self.sell("box", {}, "java", first=1, step=1)
                """);
        advance(50);
        assertThat(lines)
                .containsExactlyInAnyOrder(
                        "barbara 7.0",
                        "truck Sale(winner='barbara', price=7.0, why='')",
                        "truck Sale(winner='barbara', price=7.0, why='')",
                        "Sale(winner='java', price=4.0, why='')",
                        "Sale(winner='', price=6.0, why='')");
        assertThat(view("boss").state()).contains("TypeError: A call goes to a list of names, not to the text 'java'.");
    }

    @Test
    void proposalsGoBothWays() {
        start("java", self -> {
            var swap = new Propose<>(self, "swap", Map.class);
            swap.answer(offer -> offer.what().get("goal").equals(1)
                    ? Propose.Verdict.accept()
                    : Propose.Verdict.reject("not that one"));
            self.scheduler().after(Duration.ofSeconds(1), () -> {
                for (int goal = 1; goal <= 3; goal++) {
                    swap.propose("amy", Map.of("goal", goal), ending -> self.print(ending.toString()));
                }
            });
        });
        start("amy", """
                async def on_start(self):
                    self.judge("swap", self.decide)
                    print((await self.propose("java", "swap", {"goal": 1})).informed)
                    print(await self.propose("java", "swap", {"goal": 2}))
                    print((await self.propose("nobody", "swap", {})).how)
                async def decide(self, question):
                    await self.sleep(0.5)
                    if question.content["goal"] == 3:
                        raise Refusal("busy")
                    return question.content["goal"] == 1
                """);
        advance(10);
        assertThat(lines)
                .containsExactlyInAnyOrder(
                        "True",
                        "Result(how='refused', content={}, why='not that one')",
                        "silent",
                        "Informed[result=]",
                        "Refused[why=]",
                        "Refused[why=busy]");
    }

    @Test
    void newsGoBothWays() {
        start("java", self -> {
            var prices = new Subscribe<>(self, "prices", Map.class, Map.class);
            prices.answer(subscriber -> {
                subscriber.inform(Map.of("n", 1));
                subscriber.inform(Map.of("n", 2));
                self.scheduler().after(Duration.ofSeconds(1), () -> subscriber.fail("sold out"));
            });
            var ticks = new Subscribe<>(self, "ticks", Map.class, Map.class);
            self.scheduler().after(Duration.ofSeconds(2), () -> {
                ticks.subscribe("amy", Map.of("who", "no"), news -> {}, ending -> self.print(ending.toString()));
                Conversation talk = ticks.subscribe(
                        "amy",
                        Map.of("who", "yes"),
                        news -> self.print(news.toString()),
                        ending -> self.print(ending.toString()));
                self.scheduler().after(Duration.ofMillis(2500), talk::cancel);
            });
        });
        start("amy", """
                def on_start(self):
                    self.follow("java", "prices", {}, lambda news: print(news["n"]), on_end=lambda end: print(end.how, end.why))
                    self.admit("ticks", self.tell)
                async def tell(self, subscriber):
                    if subscriber.content["who"] == "no":
                        return self.turn_down(subscriber)
                    subscriber.on_end(lambda: print(subscriber.sender, "went"))
                    while not subscriber.gone:
                        await self.sleep(1.0)
                        subscriber.inform({"at": self.time})
                def turn_down(self, subscriber):
                    subscriber.fail("not you")
                """);
        advance(8);
        assertThat(lines)
                .containsExactly(
                        "1",
                        "2",
                        "failed sold out",
                        "Failed[why=not you]",
                        "{at=3.0}",
                        "{at=4.0}",
                        "Cancelled[]",
                        "java went");
    }

    @Test
    void itSharesABoardWithItsTeam() {
        start("master", """
                def on_start(self):
                    self.keep_board("finds")
                """);
        start("java", self -> {
            var board = new TeamBoard(self, "finds", _ -> {});
            self.scheduler()
                    .after(
                            Duration.ofSeconds(1),
                            () -> board.write(
                                    new Topic<>("bids", Map.class),
                                    "b",
                                    Map.of("price", 2),
                                    new Point2d(9, 9),
                                    Duration.ofSeconds(3)));
        });
        start("amy", """
                async def on_start(self):
                    board = self.team_board("finds")
                    board.on_event(lambda event: print(event.kind, event.about))
                    watch = board.watch(BIDS, self.on_change)
                    board.write(BIDS, "a", {"price": 1}, lifetime=60, place=Pose2d(1, 2, 3))
                    await self.sleep(2.0)
                    found = await board.ask(BIDS, near=Point2d(1, 1), distance=3)
                    print([note.content for note in found.notes], found.notes[0].place, found.left, found.why == "")
                    print(board.keeper, len((await board.ask(BIDS, author="java")).notes), watch.current)
                    await self.sleep(3.0)
                    print([note.name for note in watch.notes])
                    watch.cancel()
                    board.erase(BIDS, "a")
                    await self.sleep(1.0)
                    print((await board.ask(BIDS)).notes)
                    self.publish(BIDS, {"over": True})
                    await self.sleep(1.0)
                def on_change(self, watch):
                    print([f"{note.name} of {note.author}" for note in watch.notes])
                """);
        advance(12);
        assertThat(lines)
                .containsSubsequence(
                        "kept master",
                        "['a of amy']",
                        "['b of java', 'a of amy']",
                        "[{'price': 1}] Point2d(x=1.0, y=2.0) 0 True",
                        "master 1 True",
                        "['a']",
                        "[]");
    }

    @Test
    void behaviorsDriveItsRobot() {
        startOnRobot("""
                async def on_start(self):
                    pilot = self.robot.pilot
                    self.called = 0
                    pilot.engage(self.creep, "creep")
                    layers = []
                    pilot.subscribe(lambda decision: layers.append(decision.value.in_charge))
                    await self.sleep(3.0)
                    print(self.called, self.robot.base.latest.value.velocity.vx, "creep" in layers, pilot.engaged)
                    pilot.engage("wander")
                    await self.sleep(3.0)
                    print(self.called, self.robot.base.latest.value.velocity.vx > 0.3, "wander" in layers)
                    pilot.release()
                    await self.sleep(1.0)
                    print(self.robot.base.latest.value.velocity.vx, pilot.engaged)
                    pilot.engage("fly")
                def creep(self, percept):
                    self.called += 1
                    return Twist2d(0.1 if percept.nearest(-0.3, 0.3) > 0.5 else 0.0, 0.0, 0.0)
                """);
        advance(8);
        assertThat(lines).containsExactly("29 0.1 True True", "29 True True", "0.0 False");
        assertThat(view("a").state()).startsWith("a.py:23 in on_start: There is no behavior 'fly'.");
    }

    @Test
    void itUsesModulesInFolders() {
        AgentType type = Texts.type(
                "own/amy.py",
                Map.of(
                        "own/amy.py",
                        """
                        import rsal
                        from parts.scan import near
                        import bare.deep as deep
                        class A(rsal.Agent):
                            def on_start(self):
                                print(near(2), deep.__name__, __name__)
                                near(None)
                        """,
                        "own/parts/__init__.py",
                        "SIZE = 20\n",
                        "own/parts/scan.py",
                        "from . import SIZE\ndef near(x):\n    return x + SIZE\n",
                        "own/bare/deep.py",
                        ""));
        platform.start(new AgentSpec("amy", "tested", type, Arguments.defaults(List.of()), Optional.empty(), 1));
        advance(0.1);
        assertThat(lines).containsExactly("22 bare.deep amy");
        assertThat(view("amy").state()).startsWith("own/parts/scan.py:3 in near: TypeError");
    }

    @Test
    void itIsInAnInstalledPackage() throws Exception {
        Path site = Path.of(OfficialPython.run("import site; print(site.getsitepackages()[0])")
                .strip());
        Path module = Files.createDirectories(site.resolve("rsal_tested")).resolve("agents.py");
        Files.writeString(module, """
                import rsal
                from . import agents as itself
                class Guard(rsal.Agent):
                    speed: float = rsal.Param(0.4)
                    def on_start(self):
                        print(self.speed, itself.__name__)
                        self.after(1.0, lambda: {}["so"])
                """);
        AgentType type = Texts.type("python:rsal_tested.agents:Guard", Map.of());
        assertThat(type.key()).isEqualTo("python:rsal_tested.agents:Guard");
        platform.start(new AgentSpec(
                "amy", "tested", type, Arguments.of(type.parameters(), Map.of("speed", 1)), Optional.empty(), 1));
        advance(2);
        assertThat(lines).containsExactly("1.0 rsal_tested.agents");
        assertThat(view("amy").state()).isEqualTo(module.toRealPath() + ":7 in <lambda>: KeyError: 'so'");
    }

    @Test
    void itsMindAndItsMetricsAreShown() {
        start("amy", """
                def on_start(self):
                    self.mind.believe("door", "open")
                    self.mind.pursue("guard", "go to the door")
                    self.mind.pursue("rest")
                    self.mind.reach("rest")
                    self.metric("seen", 3)
                    self.state("guarding")
                """);
        advance(0.1);
        Mind.View mind = platform.look("amy", Mind.View.class).orElseThrow();
        assertThat(mind.beliefs()).containsEntry("door", "open");
        assertThat(mind.goals())
                .extracting(goal -> goal.name() + " " + goal.state())
                .containsExactly("guard SUSPENDED", "rest REACHED");
        assertThat(metrics).containsEntry("seen", 3.0);
        assertThat(view("amy").state()).isEqualTo("guarding");
    }

    @Test
    void anErrorEndsOneAgentAndSaysWhere() {
        String body = """
                def on_start(self):
                    self.after(1.0, self.tick, self.name)
                    self.after(2.0, print, "alive")
                def tick(self, name):
                    if name == "amy":
                        return {}["prey"]
                    if name == "bob":
                        self.robot
                    if name == "eve":
                        self.metric("", 1.0)
                    if name == "sue":
                        sys.exit(3)
                """;
        for (String name : List.of("amy", "bob", "eve", "sue", "zoe")) {
            start(name, body);
        }
        advance(3);
        assertThat(lines).containsExactly("alive");
        assertThat(view("amy").state()).isEqualTo("amy.py:14 in tick: KeyError: 'prey'");
        assertThat(view("bob").state()).startsWith("bob.py:16 in tick: LookupError: Agent 'bob' has no robot.");
        assertThat(view("eve").state()).startsWith("eve.py:18 in tick: A metric has a name");
        assertThat(view("sue").state()).isEqualTo("sue.py:20 in tick: SystemExit: 3");
    }

    @Test
    void turnsOfOneInstantAreOneAfterTheOtherWhateverHappensInThem() {
        String body = """
                def on_start(self):
                    self.subscribe(BIDS, self.on_bid)
                    self.after(1.0, self.first)
                    self.after(1.0, self.second)
                    self.after(2.0, self.first)
                def first(self):
                    if self.name == "bob" and self.time > 1.5:
                        raise KeyError("gone")
                    print(self.name, "first", [each.name for each in self.agents()])
                    self.publish(BIDS, {"of": self.name})
                def second(self):
                    print(self.name, "second")
                def on_bid(self, message):
                    print(self.name, "hears", message.content["of"])
                    if self.name == "amy" and self.time > 1.5:
                        self.metric("", 1.0)
                """;
        start("amy", body);
        start("bob", body);
        start("cleo", body);
        advance(1.5);
        assertThat(lines)
                .containsExactly(
                        "amy first ['amy', 'bob', 'cleo']",
                        "amy second",
                        "bob first ['amy', 'bob', 'cleo']",
                        "bob second",
                        "cleo first ['amy', 'bob', 'cleo']",
                        "cleo second",
                        "bob hears amy",
                        "bob hears cleo",
                        "cleo hears amy",
                        "cleo hears bob",
                        "amy hears bob",
                        "amy hears cleo");
        lines.clear();
        advance(1);
        assertThat(view("bob").state()).endsWith("KeyError: 'gone'");
        assertThat(view("amy").state()).contains("A metric has a name");
        assertThat(lines).contains("cleo first ['amy', 'cleo']", "cleo hears amy");
        platform.stop("cleo");
        assertThat(platform.directory().agents()).isEmpty();
    }

    @Test
    void anEndlessLoopIsNamed() throws Exception {
        Path end = Files.createTempFile("end", "");
        String body = """
                def on_start(self):
                    self.after(1.0, self.tick)
                def tick(self):
                    if self.name == "bob":
                        self.spin()
                    print(self.name)
                def spin(self):
                    import os
                    while os.path.exists('%s'):
                        pass
                """.formatted(end.toString().replace('\\', '/'));
        start("amy", body);
        start("bob", body);
        Thread running = Thread.currentThread();
        var seen = new ArrayList<String>();
        Thread looker = Thread.ofPlatform().start(() -> {
            try {
                for (int i = 0; i < 1000 && seen.isEmpty(); i++) {
                    TimeUnit.MILLISECONDS.sleep(10);
                    for (String name : List.of("bob", "amy")) {
                        turns.outside(name).flatMap(OutsideCode::place).ifPresent(seen::add);
                    }
                }
                Files.delete(end);
            } catch (IOException | InterruptedException e) {
                running.interrupt();
            }
        });
        advance(2);
        looker.join();
        assertThat(lines).containsExactly("amy", "bob");
        assertThat(seen).hasSize(2);
        assertThat(seen.getFirst()).matches("bob.py:1[789] in spin");
        assertThat(seen.getLast()).matches("bob.py:1[789] in spin of agent 'bob'");
    }

    @Test
    void itCannotWaitForTheClockOfTheMachine() {
        start("amy", """
                async def on_start(self):
                    import asyncio
                    await asyncio.sleep(1)
                """);
        advance(0.1);
        assertThat(view("amy").status()).isEqualTo(AgentPlatform.Status.FAILED);
        assertThat(view("amy").state()).startsWith("amy.py:11 in on_start: ");
    }

    @Test
    void aProcessThatDiesEndsItsAgentsWithItsLastWords() {
        String body = """
                def on_start(self):
                    self.after(1.0, self.tick)
                    self.after(2.0, print, "alive")
                def tick(self):
                    if self.name == "amy":
                        import os
                        os.write(2, b"my last words\\n")
                        os._exit(9)
                """;
        start("amy", body);
        start("bob", body);
        start("java", self -> self.scheduler().after(Duration.ofSeconds(2), () -> self.print("java lives")));
        advance(3);
        assertThat(lines).containsExactly("java lives");
        for (String name : List.of("amy", "bob")) {
            assertThat(view(name).state()).isEqualTo("Python ended with code 9. Its last words: my last words");
        }
    }

    @Test
    void whatItPrintsDoesNotDisturbFrames() {
        start("amy", """
                def on_start(self):
                    sys.stdout.write("one\\ntwo")
                    import os
                    os.write(1, b"raw\\n")
                def on_stop(self):
                    print("bye")
                """);
        advance(0.1);
        platform.stop("amy");
        assertThat(lines).containsExactly("one", "two", "bye");
    }

    @Test
    void equalSeedsGiveEqualRandomness() {
        String body = """
                def on_start(self):
                    print(self.random.random(), self.rng.integers(1000), list({"a", "b", "c", "dd"}))
                """;
        start("amy", body);
        start("bob", body);
        advance(0.1);
        platform.stop("amy");
        start("amy", body);
        advance(0.1);
        assertThat(lines).hasSize(3);
        assertThat(lines.get(2)).isEqualTo(lines.get(0)).isNotEqualTo(lines.get(1));
    }
}
