package rsal.jason;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.entry;
import static org.assertj.core.api.Assertions.within;

import jason.architecture.MindInspectorWeb;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.StringTermImpl;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.agent.Agent;
import rsal.agent.AgentSpec;
import rsal.agent.AgentType;
import rsal.agent.Message;
import rsal.agent.bdi.Mind;
import rsal.agent.message.GoalReached;
import rsal.agent.message.PoseReport;
import rsal.agent.message.Text;
import rsal.agent.platform.AgentPlatform;
import rsal.agents.pursuit.Caught;
import rsal.behavior.Pilot;
import rsal.behavior.PilotDriver;
import rsal.data.BatteryState;
import rsal.data.BatteryState.Charging;
import rsal.data.GripperState;
import rsal.data.LaserScan;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.device.Battery;
import rsal.device.Gripper;
import rsal.device.LaserScanner;
import rsal.device.Navigator;
import rsal.device.SimulationControl.Thing;
import rsal.robot.DeviceDriver;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.InvalidSettings;
import rsal.system.RobotSystemProvider;
import rsal.testkit.LongTest;
import rsal.testkit.Rounds;
import rsal.testkit.contract.Ports;
import rsal.testkit.contract.RobotBench;
import rsal.testkit.fake.FakeBattery;
import rsal.testkit.fake.FakeLaserScanner;
import rsal.testkit.fake.FakeLocalizer;
import rsal.testkit.fake.FakeNavigator;
import rsal.testkit.fake.FakeProvider;
import rsal.testkit.fake.TestedType;
import rsal.time.LockstepScheduler;
import rsal.time.Scheduler;
import rsal.time.Task;

class AgentSpeakAgentTest extends RobotBench {
    private final List<String> states = new ArrayList<>();
    private final List<Message<?>> said = new ArrayList<>();
    private AgentPlatform platform;

    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }

    @Override
    protected Map<String, String> parts() {
        return Map.of("battery", "pioneer-battery", "camera", "blob-camera", "gripper", "pioneer-gripper");
    }

    @Override
    protected List<DeviceDriver> drivers() {
        return List.of(new FakeLocalizer.Driver(), new FakeNavigator.Driver(), new PilotDriver());
    }

    @BeforeEach
    void gather() {
        platform = new AgentPlatform(
                run, new JasonHostProvider().create(Arguments.defaults(List.of()), run), Optional.empty());
        platform.onMessage(said::add);
        platform.onChange(view -> states.add(view.agent().name() + ": " + view.state()));
        platform.onPrint(print -> states.add(print.agent() + ": " + print.line()));
    }

    private void start(String name, String text) {
        start(name, text, Map.of(), Optional.empty());
    }

    private void startOnRobot(String text) {
        start("a", text, Map.of(), Optional.of(robot()));
    }

    private void start(String name, String text, Map<String, Object> arguments, Optional<Robot> robot) {
        AgentType type = Texts.type(text);
        platform.start(new AgentSpec(
                name, "tested", type, Arguments.of(type.parameters(), arguments), robot, name.hashCode()));
    }

    private void start(String name, Agent agent) {
        platform.start(new AgentSpec(
                name, "tested", new TestedType(agent), Arguments.defaults(List.of()), Optional.empty(), 1));
    }

    private static Thing can(Pose2d mapFromCan) {
        var body = Solid.standing(new Shape.Disc(new Point2d(0, 0), 0.08), 0.5);
        return Thing.of("can", mapFromCan, body, Rgb.of(0x2ca02c));
    }

    private AgentPlatform.View view(String name) {
        return platform.views().stream()
                .filter(view -> view.agent().name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void aStateIsALineOnlyWhenItChanges() {
        var lines = new ArrayList<String>();
        platform.onPrint(print -> lines.add(print.line()));
        start("a", """
                !go.
                +!go <- state(waits); .wait(100); state(waits); .print(beep); state(waits); state(goes); state(waits); .print(beep).
                """);
        run.advance(Duration.ofSeconds(1));
        assertThat(lines).containsExactly("waits", "beep", "goes", "waits", "beep");
        assertThat(view("a").state()).isEqualTo("beep");
    }

    // ── Beliefs ──────────────────────────────────────────────────────────────────────────────────────────────────

    @Test
    void itsArgumentsAreItsBeliefs() {
        String text = """
                speed(1). who(amy). words("good day"). fast(false).
                !go.
                +!go : speed(S) & who(W) & words(T) & fast(F) & me(Me, Role) <- state(S, " ", W, " ", T, " ", F, " ", Me, " ", Role).
                """;
        start("a-1", text);
        advance(0);
        assertThat(view("a-1").state()).isEqualTo("1 amy good day false a-1 tested");
        start("b-2", text, Map.of("speed", 2.5, "who", "bob-1", "words", "hi", "fast", true), Optional.empty());
        advance(0);
        assertThat(view("b-2").state()).isEqualTo("2.5 bob-1 hi true b-2 tested");
    }

    @Test
    void itKnowsItsRobotAndWhereThatIs() {
        startOnRobot("""
                !go.
                +!go <- .wait(pose(_, _, _)); ?pose(X, Y, Th); ?robot(Id, Role); publish(pose, Id, Role, pose(X, Y, Th)).
                """);
        advance(1);
        assertThat(said).hasSize(1);
        var report = (PoseReport) said.getFirst().content();
        assertThat(report.robot()).isEqualTo("r1");
        assertThat(report.mapFromBase().distanceTo(START)).isLessThan(0.05);
    }

    @Test
    void aReadingTakesThePlaceOfTheOneBefore() {
        startOnRobot("""
                seen(0).
                !go.
                +!go <- drive(0.2, 0); .wait(2000); .count(pose(_, _, _), N); state(N, " pose").
                +pose(_, _, _) : seen(N) <- -+seen(N + 1); M = N + 1; show(seen, M).
                """);
        advance(2.05);
        assertThat(view("a").state()).isEqualTo("1 pose");
        assertThat(Integer.parseInt(view("a").beliefs().get("seen"))).isBetween(15, 22);
        platform.stop("a");
        advance(1);
        start(
                "still",
                "seen(0). +pose(_, _, _) : seen(N) <- -+seen(N + 1); M = N + 1; show(seen, M).",
                Map.of(),
                Optional.of(robot()));
        advance(3);
        assertThat(view("still").beliefs()).as("the same again is no event").containsEntry("seen", "1");
    }

    @Test
    void itSeesWallsAndBlobs() {
        put(can(new Pose2d(START.x() + 1, START.y(), 0)));
        startOnRobot("""
                !go.
                +!go <- .wait(blob(_, _, _)); ?blob(C, X, Y); ?scan_min(F, L, R); state(C, " ", X, " ", Y); show(front, F).
                """);
        advance(1);
        String[] words = view("a").state().split(" ", -1);
        assertThat(words[0]).isEqualTo("#2ca02c");
        assertThat(Double.parseDouble(words[1])).isCloseTo(1, within(0.15));
        assertThat(Double.parseDouble(words[2])).isCloseTo(0, within(0.1));
        assertThat(Double.parseDouble(view("a").beliefs().get("front"))).isPositive();
    }

    /// Ahead is within 30°, left and right are from there to 100°.
    @Test
    void itKnowsHowNearTheNearestIsAheadLeftAndRight() {
        var laser = (FakeLaserScanner) robot().require(LaserScanner.class);
        LaserScan scan = await(laser.next()).value();
        showByBearing(laser, scan, degrees -> {
            double aside = Math.abs(degrees);
            if (aside > 100.5) {
                return 0.5; // behind
            }
            return aside < 30.5 ? 3.25 : degrees > 0 ? 1.5 : 2.25;
        });
        startOnRobot("+scan_min(F, L, R) <- state(F, \" \", L, \" \", R).");
        advance(1);
        assertThat(view("a").state()).isEqualTo("3.25 1.5 2.25");
        showByBearing(laser, scan, degrees -> 25 < degrees && degrees < 29.5 ? 0.75 : Double.POSITIVE_INFINITY);
        advance(1);
        assertThat(view("a").state()).as("as far as it sees where nothing is").isEqualTo("0.75 5.6 5.6");
        showByBearing(laser, scan, degrees -> -99 < degrees && degrees < -95 ? 0.25 : Double.POSITIVE_INFINITY);
        advance(1);
        assertThat(view("a").state()).isEqualTo("5.6 5.6 0.25");
    }

    /// @param range in m, by degrees from ahead, counter-clockwise
    private static void showByBearing(FakeLaserScanner laser, LaserScan scan, DoubleUnaryOperator range) {
        var ranges = new float[scan.count()];
        for (int beam = 0; beam < ranges.length; beam++) {
            ranges[beam] = (float) range.applyAsDouble(Math.toDegrees(scan.angle(beam)));
        }
        laser.show(ranges);
    }

    @Test
    void itKnowsWhatIsInItsBattery() {
        var battery = (FakeBattery) robot().require(Battery.class);
        startOnRobot("""
                +battery(L) <- state(L).
                -battery(_) : not battery(_) <- state(unknown).
                """);
        advance(1);
        double level = battery.latest().orElseThrow().value().level();
        assertThat(Double.parseDouble(view("a").state())).isCloseTo(level, within(0.0005));
        battery.show(BatteryState.of(43_210, 100_000, -10, Charging.DISCHARGING));
        advance(1);
        assertThat(view("a").state()).isEqualTo("0.432");
        battery.show(BatteryState.of(0, 100_000, 0, Charging.DISCHARGING));
        advance(1);
        assertThat(view("a").state()).isEqualTo("0");
        battery.show(BatteryState.of(Double.NaN, 100_000, -10, Charging.UNKNOWN));
        advance(1);
        assertThat(view("a").state()).isEqualTo("unknown");
    }

    // ── Actions ──────────────────────────────────────────────────────────────────────────────────────────────────

    @Test
    @LongTest
    void oneIntentionWaitsForItsWayWhileOthersGoOn() {
        Pose2d goal = WORLD.pose('a', 0);
        startOnRobot("""
                !go. !count.
                +!go <- goto(%f, %f); ?counted(N); state("there after ", N).
                counted(0).
                +!count : counted(N) <- -+counted(N + 1); .wait(1000); !!count.
                """.formatted(goal.x(), goal.y()));
        advance(40);
        assertThat(truth().distanceTo(goal)).isLessThan(0.5);
        assertThat(view("a").state()).matches("there after \\d+");
        assertThat(Integer.parseInt(view("a").state().replace("there after ", "")))
                .isGreaterThan(5);
    }

    @Test
    void aWayThatFailsIsAGoalThatFailsWithTheReason() {
        Pose2d behind = WORLD.pose('x', 0);
        startOnRobot("""
                !go.
                +!go <- goto(%f, %f).
                -!go[reason(R), error(E)] <- state(E, " ", R).
                """.formatted(behind.x(), behind.y()));
        advance(1);
        assertThat(view("a").state()).isEqualTo("action_failed no_path");
    }

    @Test
    void aNewerWayTakesOverAndADroppedOneIsGivenUp() {
        Pose2d a = WORLD.pose('a', 0);
        Pose2d b = WORLD.pose('b', 0);
        startOnRobot("""
                !go(%f, %f). !later.
                +!go(X, Y) <- goto(X, Y); state("there").
                -!go(_, _)[reason(R)] <- state(R).
                +!later <- .wait(1000); !!go(%f, %f); .wait(1000); .drop_desire(go(_, _)).
                """.formatted(a.x(), a.y(), b.x(), b.y()));
        advance(1.05);
        assertThat(view("a").state()).isEqualTo("cancelled");
        var navigator = (FakeNavigator) robot().require(Navigator.class);
        assertThat(navigator.goal()).contains(b);
        advance(1);
        assertThat(navigator.goal()).isEmpty();
        assertThat(states).doesNotContain("a: there");
    }

    @Test
    void drivingGoesOnUntilItStops() {
        startOnRobot("!go. +!go <- drive(0.2, 0); .wait(3000); stop; .wait(1000); state(\"stands\").");
        advance(3);
        double driven = truth().distanceTo(START);
        assertThat(driven).isBetween(0.4, 0.65); // longer than a base drives after one command
        advance(2);
        assertThat(truth().distanceTo(START)).isLessThan(driven + 0.1);
        assertThat(view("a").state()).isEqualTo("stands");
    }

    @Test
    void itFollowsTheWallOnItsLeft() {
        startOnRobot("!go. +!go <- follow_wall; .wait(20000); stop; state(\"stands\").");
        advance(2);
        var pilot = robot().require(Pilot.class);
        assertThat(pilot.latest().orElseThrow().value().opinions())
                .extracting(opinion -> opinion.layer())
                .contains("follow-wall");
        double nearest = Double.POSITIVE_INFINITY;
        double distance = 0;
        for (Pose2d before = truth(); view("a").state().isEmpty(); before = truth()) {
            advance(0.5);
            distance += truth().distanceTo(before);
            nearest = Math.min(nearest, toTheLeft());
        }
        assertThat(distance).isBetween(3.0, 20.0);
        assertThat(nearest).isBetween(0.3, 0.7); // 0.875 where it starts
        assertThat(view("a").state()).isEqualTo("stands");
        advance(1);
        Pose2d there = truth();
        advance(1);
        assertThat(truth().distanceTo(there)).isLessThan(1e-3);
    }

    /// How far it is to the next wall straight to the left of the laser [m].
    private double toTheLeft() {
        LaserScan scan =
                robot().require(LaserScanner.class).latest().orElseThrow().value();
        return IntStream.range(0, scan.count())
                .filter(beam -> Math.abs(scan.angle(beam) - Math.PI / 2) < scan.angleIncrement())
                .mapToDouble(beam -> scan.ranges()[beam])
                .min()
                .orElseThrow();
    }

    @Test
    void itLetsGoOfWhatItHolds() {
        put(can(new Pose2d(START.x() + 0.264, START.y(), 0)).asGrippable());
        startOnRobot("""
                !go.
                +!go <- grip; .wait(holding); state(holds); .wait(1000); release; state(free); .wait(not holding); state(empty).
                -!go[error_msg(M)] <- state(M).
                """);
        var gripper = robot().require(Gripper.class);
        for (int step = 0; step < 100 && view("a").state().isEmpty(); step++) {
            advance(0.1);
        }
        assertThat(view("a").state()).isEqualTo("holds");
        assertThat(gripper.latest().orElseThrow().value().lift()).isEqualTo(GripperState.Lift.UP);
        advance(15);
        assertThat(states).containsSubsequence("a: holds", "a: free", "a: empty");
        GripperState state = gripper.latest().orElseThrow().value();
        assertThat(state.holding()).isFalse();
        assertThat(state.paddles()).isEqualTo(GripperState.Paddles.OPEN);
        assertThat(state.lift()).isEqualTo(GripperState.Lift.DOWN);
    }

    @Test
    void aGripperThatHoldsNothingHasFailed() {
        startOnRobot("!go. +!go <- release; grip. -!go[reason(R)] <- state(R).");
        advance(20);
        assertThat(view("a").state()).isEqualTo("empty");
    }

    @Test
    void theRobotStandsWhenItsAgentEnds() {
        startOnRobot("!go. +!go <- drive(0.2, 0).");
        advance(1);
        platform.stop("a");
        advance(1);
        Pose2d there = truth();
        advance(1);
        assertThat(truth().distanceTo(there)).isLessThan(1e-3);
    }

    @Test
    void whatCantBeDoneFails() {
        start("a", """
                !go.
                +!go <- publish(caught, 1).
                -!go[reason(R), error_msg(M)] <- state(R, ": ", M).
                """);
        advance(0);
        assertThat(view("a").state()).startsWith("wrong: 'caught' takes 3 terms, not 1: prey, hunter, distance.");
    }

    // ── Others ───────────────────────────────────────────────────────────────────────────────────────────────────

    @Test
    void messagesOfTopicsAreEvents() {
        start("a", """
                +heard(caught, From, caught(Prey, Hunter, D)) <- state(From, " ", Prey, " ", Hunter, " ", D).
                +heard(goal_reached, _, goal_reached(R, pose(X, Y, _), How, Why)) <- state(R, " ", X, " ", How, " ", Why).
                """);
        advance(0);
        platform.publish("operator", Caught.TOPIC, new Caught("prey-1", "hunter-2", 1.25));
        advance(0);
        assertThat(view("a").state()).isEqualTo("operator prey-1 hunter-2 1.25");
        platform.publish(
                "operator", GoalReached.TOPIC, new GoalReached("r1", new Pose2d(1, 2, 0), "stuck", "A box is ahead."));
        advance(0);
        assertThat(view("a").state()).isEqualTo("r1 1 stuck A box is ahead.");
    }

    @Test
    void theySpeakToEachOther() {
        start("amy-1", """
                price(3).
                +!sell(What)[source(S)] : me(Me, _) <- .send(S, tell, sold(What, Me)).
                +?color(X) <- X = red.
                """);
        start("bob-2", """
                !go.
                +!go <- .all_names(All); .print(All);
                        .send('amy-1', achieve, sell("a box"));
                        .send('amy-1', askOne, price(_), price(P)); .print("price ", P);
                        .send('amy-1', askOne, color(_), color(C)); .print("color ", C);
                        .send('amy-1', askOne, weight(_), W, 500); .print("weight ", W).
                +sold(What, Who)[source(S)] : S == Who <- show(sold, What).
                """);
        advance(1);
        assertThat(states)
                .contains("bob-2: ['amy-1','bob-2']", "bob-2: price 3", "bob-2: color red", "bob-2: weight false");
        assertThat(view("bob-2").beliefs()).containsEntry("sold", "a box");
    }

    @Test
    @LongTest
    void theyInformEachOtherHow() {
        start("amy", """
                what("a \\"fine\\" thing").
                +!cook(What) : what(W) <- .print("cook ", What, " and\\n", W).
                """);
        start("bob", """
                !go.
                what(soup).
                +!go <- .send(amy, askHow, {+!cook(_)}, Plans, 500); .add_plan(Plans, amy); !cook(rice);
                        .send(amy, tellHow, { @cleaning[atomic] +!clean(X) : X > 1 & not dirty <- if (X < 3) { +done(X) } else { .print(no) }; .print("clean") });
                        .send(amy, tellHow, "+!sweep <- .print(\\"swept at \\", system.time).");
                        .wait(100); .send(amy, achieve, clean(2)); .send(amy, achieve, sweep);
                        .wait(100); .send(amy, untellHow, cleaning); .wait(100); .send(amy, achieve, clean(3)).
                """);
        advance(1);
        assertThat(states).contains("bob: cook rice and\nsoup", "amy: clean", "amy: swept at 100");
        assertThat(states).doesNotContain("amy: no");
        assertThat(view("amy").status()).isEqualTo(AgentPlatform.Status.RUNNING);
    }

    @Test
    void agentsTakeBackWhatTheySaidAskForAllAndSignal() {
        start("a", """
                likes(tea). likes(milk).
                +rain <- .print("rain").
                -rain <- .print("dry").
                +!dance <- .print("dances"); .wait(500); .print("has danced").
                +greeting(N) <- .print("greeting ", N).
                """);
        start("amy", """
                !talk.
                +!talk
                   <- .send(a, tell, rain); .wait(10); .send(a, untell, rain);
                      .send(a, achieve, dance); .wait(10); .send(a, unachieve, dance);
                      .send(a, askAll, likes(_), Likes); .length(Likes, N); .print(N);
                      .send(a, signal, greeting(3)).
                """);
        advance(10);
        assertThat(states)
                .contains("a: rain", "a: dry", "a: dances", "a: greeting 3", "amy: 2")
                .doesNotContain("a: has danced");
    }

    @Test
    void textsAreHeardAsTheyWereSaid() {
        start("amy", "+said(X) <- .print(X).");
        start("bob", "!go. +!go <- .send(amy, tell, said(\"one\\n\\\"two\\\" \\tthree\")).");
        advance(0.1);
        assertThat(states).contains("amy: one\n\"two\" \\tthree");
        start("java", self -> self.send("amy", Speech.TOPIC, new Speech("tell", said("C:\\dir\r\n\\"), "", "")));
        advance(0.1);
        assertThat(states).as("with what AgentSpeak has for them").contains("amy: C:\\\\dir \n\\\\");
    }

    private static String said(String text) {
        return Terms.written(ASSyntax.createStructure("said", new StringTermImpl(text)));
    }

    @Test
    void anAnswerIsWaitedForOnlySoLong() {
        start("amy", _ -> {});
        start("bob", "!go. +!go <- .send(amy, askOne, price(_), P, 500); .print(P).");
        advance(0.45);
        assertThat(states).doesNotContain("bob: timeout");
        advance(0.1);
        assertThat(states).contains("bob: timeout");
    }

    /// What stands in the form of the answer would have no value.
    @Test
    void anAnswerOfSomeFormThatDoesNotComeFailsThePlan() {
        start("amy", _ -> {});
        start(
                "bob",
                "!go. +!go <- .send(amy, askOne, price(_), price(P), 500); .print(\"got \", P)."
                        + " -!go[error(E), error_msg(M)] <- .print(E, \": \", M).");
        advance(1);
        assertThat(states)
                .contains("bob: ask_timeout: Nobody has answered in time with 'price(V1)'.")
                .noneMatch(state -> state.startsWith("bob: got"));
    }

    @Test
    void javaAgentsHearThemAndSpeakToThem() {
        start(
                "java",
                self -> self.subscribe(
                        Speech.TOPIC,
                        heard -> self.send(
                                heard.sender(),
                                Speech.TOPIC,
                                new Speech("tell", "heard(" + heard.content().content() + ")", "", ""))));
        start("asl-1", "!go. +!go <- .broadcast(tell, here(\"a \\\"word\\\"\", X, Y, X)). +heard(H) <- .print(H).");
        advance(0);
        assertThat(said).hasSize(2);
        assertThat(said.getFirst().content()).hasToString("tell: here(\"a \\\"word\\\"\",V1,V2,V1)");
    }

    @Test
    void someoneWhoIsNotThereCantBeSpokenTo() {
        start("a", "!go. +!go <- .send(bob, tell, x). -!go[error(E), error_msg(M)] <- .print(E, \": \", M).");
        advance(0);
        assertThat(view("a").state()).isEqualTo("receiver_not_found: There is no agent 'bob'. Known are: a.");
    }

    @Test
    void theyOfferWhatTheyCanDo() {
        start("a", "!go. +!go <- .df_register(carry, heavy).");
        start("b", "!go. +!go <- .df_search(carry, L); .print(L); .df_search(carry, light, M); .print(M).");
        advance(0);
        assertThat(states).contains("b: [a]", "b: []");
    }

    @Test
    void wordsAreJoinedWithoutQuotes() {
        start("a", """
                !go.
                +!go <- .concat("Halt, ", 'r-1', "!", W); .concat([1, 2], [3], L); .concat("p", 1, P); .print(W, L, P).
                """);
        advance(0);
        assertThat(view("a").state()).isEqualTo("Halt, r-1![1,2,3]p1");
    }

    @Test
    @LongTest
    void itDrivesAsNearAsItIsAsked() {
        Pose2d goal = WORLD.pose('a', 0);
        startOnRobot("!go. +!go <- goto_near(%f, %f, 1.5); state(\"near\").".formatted(goal.x(), goal.y()));
        advance(30);
        assertThat(view("a").state()).isEqualTo("near");
        assertThat(truth().distanceTo(goal)).isBetween(1.2, 1.6);
    }

    // ── Time and chance ──────────────────────────────────────────────────────────────────────────────────────────

    @Test
    void timeIsTheRuns() {
        start("a", """
                !wait. !event. !formula. !late. !took. !deadline.
                +!wait <- .wait(1500); .print("waited ", system.time).
                +!event <- .at("now +2 s", {+!alarm}); .wait({+!alarm}); .print("alarm").
                +!alarm <- .time(H, M, S); .print("alarm at ", H, ":", M, ":", S); +rung.
                +!formula <- .wait(rung); .print("rung").
                +!late <- .wait({+never}, 700).
                -!late[error(E)] <- .print(E).
                +!took <- .wait({+never}, 800, T); .print("took ", T).
                +!deadline <- !long[hard_deadline(900)].
                +!long <- .wait(100000).
                -!deadline[error(E)] <- .print(E).
                """);
        advance(0.65);
        assertThat(states).containsExactly("a: ");
        advance(3);
        assertThat(states)
                .containsExactly(
                        "a: ",
                        "a: wait_timeout",
                        "a: took 800",
                        "a: deadline_reached",
                        "a: waited 1500",
                        "a: alarm",
                        "a: alarm at 0:0:2",
                        "a: rung");
    }

    @Test
    void timeIsTheRunsAlsoInWhatIsReadWhileItRuns() {
        start("a", """
                !text. !word.
                +!text <- .wait(1500); .term2string(T, "system.time"); X = T + 0; .print("text ", X).
                +!word <- .term2string(p(1,"two"), S); .print(S).
                +!told(T) <- X = T + 0; .print("told ", X).
                """);
        start("b", "!go. +!go <- .wait(2000); .send(a, achieve, told(system.time + 0)).");
        advance(3);
        assertThat(states).contains("a: text 1500", "a: p(1,\"two\")", "a: told 2000");
    }

    @Test
    void whoDropsAllForgetsAlsoWhatWasToComeLater() {
        start("a", """
                !go. !other.
                +!go <- .at("now +1 s", {+!alarm}); .wait(500); .drop_all_intentions.
                +!other <- .wait(700); .print("other").
                +!alarm <- .print("alarm").
                """);
        advance(2);
        assertThat(states).containsExactly("a: ");
    }

    @Test
    void nothingOfJasonsRunsBesideTheRun() throws ReflectiveOperationException {
        Set<Thread> before = Thread.getAllStackTraces().keySet();
        Set<String> portsBefore = Ports.listening();
        start("amy", _ -> {});
        start("a", """
                !wait. !ask. !deadline.
                +!wait <- .at("now +100 ms", {+!alarm}); .wait({+never}, 500).
                +!alarm <- .broadcast(tell, alarm).
                +!ask <- .send(amy, askOne, price(_), P, 100).
                +!deadline <- !long[hard_deadline(100)].
                +!long <- .wait(1000).
                """);
        advance(2);
        assertThat(Ports.listening()).isSubsetOf(portsBefore);
        platform.close();
        assertThat(Thread.getAllStackTraces().keySet()).isSubsetOf(before);
        assertThat(Ports.listening()).isSubsetOf(portsBefore);
        assertThat(MindInspectorWeb.isRunning()).isFalse();
        var scheduler = jason.asSemantics.Agent.class.getDeclaredField("scheduler");
        scheduler.setAccessible(true);
        assertThat(scheduler.get(null)).isNull();
    }

    /// Jason numbers intentions, messages and variables for the whole process.
    @Test
    void equalRunsAreEqualHoweverManyWereBefore() {
        String text = """
                !begin.
                +!begin <- for (.range(I, 1, 5)) { !!go(I); !!wait(I) }; .wait(100); .drop_desire(go(_)); .drop_desire(wait(_));
                           .wait(100); !missing(Unknown).
                +!go(I) <- goto(100, 100 + I).
                -!go(I) <- .print("gone ", I).
                +!wait(I) <- .wait({+never}).
                -!wait(I) <- .print("waited ", I).
                -!begin[error_msg(Why)] <- .print(Why); .broadcast(tell, why(Why, Unknown)).
                """;
        var transcripts = new HashSet<List<String>>();
        for (int i = 0; i < 40; i++) {
            states.clear();
            said.clear();
            startOnRobot(text);
            advance(1);
            platform.stop("a");
            var all = new ArrayList<>(states);
            said.forEach(message -> all.add(message.content().toString()));
            transcripts.add(all);
        }
        assertThat(transcripts).hasSize(1);
        assertThat(transcripts.iterator().next()).anyMatch(line -> line.contains("missing(_)"));
    }

    /// Jason 3.3.0 does so only for those with a context.
    @Test
    void aPlanIsTakenApartAndPutTogether() {
        start("a", """
                b(10).
                !start.
                +!pa : b(10) <- .print("pa").
                @two +!pb <- .print("pb").
                +!start <- .relevant_plans({+!pa}, [A|_]); A =.. LA; .length(LA, N); .print(N);
                           .relevant_plans({+!pb}, [B|_]); B =.. [Label, Trigger, Context, Body];
                           .print(Context, " ", Body); !pb.
                """);
        advance(0.5);
        assertThat(states).containsSubsequence("a: 4", "a: true { .print(\"pb\") }", "a: pb");
    }

    /// What Jason counts for the whole process: labels of plans, intentions, variables, also within formulas.
    @Test
    void nothingThatJasonCountsIsSeen() {
        String text = """
                !go. !other.
                +!go <- .relevant_plans({+!other}, _, Labels); .print(Labels);
                        .intention(I, S, _, current); .print("I am ", I); .intention(J, waiting); .print("there is ", J);
                        .desire(go, K); .print(K == I);
                        .broadcast(tell, seen({ X > Y & not p(X, _) }, { +!g(Z) : p(Z, _) <- .print(Z) }));
                        .upper_case(f(_, _), U); .concat("can", "_1", N); .print(U, N).
                +!other <- .wait(1000).
                +!rest <- .wait(1). { +x <- .print(x). }
                """;
        var transcripts = new HashSet<List<String>>();
        for (int i = 0; i < 3; i++) {
            states.clear();
            said.clear();
            start("a", text);
            advance(0.5);
            platform.stop("a");
            var all = new ArrayList<>(states);
            said.forEach(message -> all.add(message.content().toString()));
            transcripts.add(all);
        }
        assertThat(transcripts).hasSize(1);
        assertThat(transcripts.iterator().next())
                .contains(
                        "a: [p__2[source(self),url(\"a.asl\")]]",
                        "a: I am 1",
                        "a: there is 2",
                        "a: F(V1,V2)can_1",
                        "tell: seen({ ((V1 > V2) & not (p(V1,V3))) },{ +!g(V4) : p(V4,V5) <- .print(V4) })");
    }

    @Test
    void suspendedEventsGoOnInTheOrderInWhichTheyCame() {
        start("a", """
                !go.
                +!go <- for (.range(I, 1, 9)) { !!count(I) }; .suspend(count(_)); .wait(10); .resume(count(_)).
                +!count(I) <- .print(I).
                """);
        advance(0.1);
        assertThat(states)
                .containsExactlyElementsOf(Stream.concat(
                                Stream.of("a: "), IntStream.rangeClosed(1, 9).mapToObj(i -> "a: " + i))
                        .toList());
    }

    /// An agent may fail, and says why; the others go on.
    @Test
    void whateverOneDoesHarmsNobodyElse() {
        String[] steps = {
            "goto(a, b)",
            "goto(1, 2)",
            "drive(1/0, 0)",
            "drive(x, Y)",
            "publish(pose, 1, 2, 3)",
            "publish(X)",
            "publish(text, Y)",
            "publish(caught, a, b, -1)",
            "grip",
            "release",
            "stop",
            "wander",
            "state(X)",
            "show(1, [])",
            ".wait(-1)",
            ".wait(a)",
            ".wait({+!x})",
            ".send(X, tell, 1)",
            ".send(a, Y, Z)",
            ".send(a, askOne, p(_), A, b)",
            ".broadcast(1, 2)",
            ".at(1, 2)",
            ".at(\"now +1 s\", {+!x})",
            ".random(X, 0)",
            ".random([], X)",
            ".shuffle(1, X)",
            ".print(X, [Y | Z])",
            ".fail",
            "!x",
            "!!x",
            "?y(X)",
            "+z(X)",
            "-z(_)",
            "X = 1",
            "X + 1 > a",
            ".df_search(a, X)",
            ".df_register(\"\")",
            ".drop_all_intentions",
            ".drop_all_events",
            ".suspend",
            ".suspend(go)",
            ".resume(go)",
            ".abolish(_)",
            ".add_plan(1)",
            ".remove_plan(X)",
            ".term2string(X, \"p(\")",
            ".succeed_goal(go)",
            ".fail_goal(go)",
            ".concat(X, Y)",
            ".time(a)",
            "X",
            "goto(X, 1)",
            ".fork(and, {!x}, {stop})",
            ".eval(X, .fail)",
            ".member(X, X)",
            ".nth(-1, [a], X)",
            "for (.member(X, 1)) { stop }"
        };
        for (long seed = 1; seed <= Rounds.of(80, 400); seed++) {
            var random = new SplittableRandom(seed);
            var body = new ArrayList<String>();
            for (int i = random.nextInt(1, 8); i > 0; i--) {
                body.add(steps[random.nextInt(steps.length)]);
            }
            String text = "y(1). !go. +!go <- %s. +!x <- %s.%s"
                    .formatted(
                            String.join("; ", body),
                            steps[random.nextInt(steps.length)],
                            random.nextBoolean() ? " -!go <- stop." : "");
            try {
                startOnRobot(text);
                advance(0.5);
                AgentPlatform.View after = view("a");
                assertThat(after.status() == AgentPlatform.Status.RUNNING
                                || after.state().contains("did not stop after"))
                        .as("seed %d: %s: %s", seed, text, after.state())
                        .isTrue();
                platform.stop("a");
            } catch (InvalidSettings e) {
                assertThat(e.problems())
                        .as("seed %d: %s", seed, text)
                        .isNotEmpty()
                        .allSatisfy(problem -> assertThat(problem.toString()).startsWith("a.asl:1:"));
            } catch (RuntimeException e) {
                throw new AssertionError("seed %d: %s".formatted(seed, text), e);
            }
        }
        start("b", "!go. +!go <- .print(\"lives\").");
        advance(0.1);
        assertThat(view("b").state()).isEqualTo("lives");
    }

    @Test
    void chanceComesFromTheSeed() {
        String text = """
                !go.
                +!go <- .random(X); .random([a, b, c, d], Y); .shuffle([1, 2, 3, 4, 5, 6], Z); W = math.random(100);
                        .findall(R, .random(R, 3), L); .length(L, N); .print(X, Y, Z, W, " ", N).
                """;
        start("a", text);
        advance(0);
        String first = view("a").state();
        platform.stop("a");
        start("a", text);
        start("b", text);
        advance(0);
        assertThat(first).endsWith(" 3");
        assertThat(platform.views()).extracting(AgentPlatform.View::state).contains(first);
        assertThat(view("b").state()).isNotEqualTo(first);
    }

    @Test
    void oneThatFindsNoEndIsEndedAlone() {
        start("a", "!go. +!go <- .wait(1000); !on. +!on <- !off. +!off <- !on.");
        start("b", "!go. +!go <- .wait(2000); .print(\"lives\").");
        advance(3);
        assertThat(view("a").status()).isEqualTo(AgentPlatform.Status.FAILED);
        assertThat(view("a").state()).contains("did not stop after 10000 reasoning cycles", "'.wait'");
        assertThat(view("b").state()).isEqualTo("lives");
    }

    @Test
    void oneThatRecursEndlesslyIsEndedAlone() {
        start("a", "p(X) :- p(X). !go. +!go : p(1) <- stop.".replace("stop", ".print(1)"));
        start("b", "!go. +!go <- .print(\"lives\").");
        advance(1);
        assertThat(view("a").status()).isEqualTo(AgentPlatform.Status.FAILED);
        assertThat(view("a").state())
                .contains("Agent 'a' searched endlessly", "Rule 'p/1' at a.asl:1:1 depends on itself.");
        assertThat(view("b").state()).isEqualTo("lives");
        start("c", "q(X) :- q(X).\n!go.\n+!go <- .findall(X, q(X), L); .print(L).");
        advance(1);
        assertThat(view("c").state()).contains("searched endlessly at: go", "a.asl:3", "Rule 'q/1' at a.asl:1:1");
    }

    @Test
    void aFailurePlanThatFailsEndsItsIntention() {
        start("a", """
                !go. !wait.
                +!go <- .fail.
                -!go <- .print("tried");
                        .fail.
                +!wait <- .wait(5000).
                """);
        advance(1);
        assertThat(states).containsExactly("a: ", "a: tried");
        assertThat(view("a").status()).isEqualTo(AgentPlatform.Status.RUNNING);
        List<Mind.GoalView> left =
                platform.look("a", Mind.View.class).orElseThrow().goals();
        assertThat(left).extracting(Mind.GoalView::name).containsExactly("wait");
        assertThat(left.getFirst().failure())
                .isEqualTo("Goal 'go' has failed, and so has the plan for that at a.asl:4: .fail.");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "+!go <- !helpp(1).           | There is no plan for goal 'helpp(1)' at a.asl:2.",
                "+!go <- !!helpp(1).          | There is no plan for goal 'helpp(1)' at a.asl:2.",
                "+!go <- ?helpp(1).           | Goal 'go' has failed at a.asl:2: ?helpp(1) (Failed to test 'helpp(1)'). There is no plan for that.",
                "+!gone.                      | There is no plan for goal 'go' at a.asl:1.",
                "+!go : no.                   | No plan for goal 'go' at a.asl:1 applies now.",
                "+!go <- !x(2). +!x(N) : N>2. | No plan for goal 'x(2)' at a.asl:2 applies now.",
            })
    void aGoalWithoutAPlanIsReportedWithItsPlace(String plans, String words) {
        start("a", "!wait. !go.\n%s\n+!wait <- .wait(5000).".formatted(plans));
        advance(1);
        assertThat(failure("a")).isEqualTo(words);
    }

    @Test
    void aGoalOfOthersWithoutAPlanIsReportedWithWhoAskedForIt() {
        start("a", "!wait.\n+!wait <- .wait(5000).");
        start("amy", "!ask.\n+!ask <- .wait(10); .send(a, achieve, dance(2)).");
        advance(1);
        assertThat(failure("a")).isEqualTo("There is no plan for goal 'dance(2)', which 'amy' asked for.");
    }

    @Test
    void aGoalWithAPlanForItsFailureIsNoMatterOfComplaint() {
        start("a", "!wait. !go.\n-!go <- .print(\"no way\").\n+!wait <- .wait(5000).");
        advance(1);
        assertThat(states).contains("a: no way");
        assertThat(failure("a")).isEmpty();
    }

    @Test
    void whatGoesWrongInAnInternalActionIsReportedOnceWithItsPlaceAndWhy() {
        start("a", "!wait. !go.\n+!go <- .map.get(5, key, X).\n+!wait <- .wait(5000).");
        advance(1);
        assertThat(failure("a"))
                .startsWith("Goal 'go' has failed at a.asl:2: .map.get(5,key,")
                .contains(" (Cannot invoke ") // as the Java machine says it
                .endsWith(" is null). There is no plan for that.");
    }

    @Test
    void aPlanForAFailureLearnsWhatAnInternalActionThrew() {
        start("a", "!go.\n+!go <- .map.get(5, key, X).\n-!go[error_msg(Why)] <- .print(Why).");
        advance(1);
        assertThat(states).anyMatch(state -> state.startsWith("a: Cannot invoke "));
    }

    /// Not the rest of the plan, nor what other variables stand for.
    @Test
    void aPlanForAFailureLearnsWhichConstraintDidNotHold() {
        start(
                "a",
                "!go.\n+!go <- Y = other; X = 3;\n  X > 5; .print(rest, Y).\n"
                        + "-!go[error(E), error_msg(Why)] <- .print(E, \": \", Why).");
        advance(1);
        assertThat(states).contains("a: constraint_failed: Constraint (X > 5) does not hold: (3 > 5) at a.asl:3");
    }

    /// What the agent complained of last.
    private String failure(String name) {
        return platform.look(name, Mind.View.class)
                .orElseThrow()
                .goals()
                .getFirst()
                .failure();
    }

    @Test
    void aGoalThatFailsItselfFails() {
        start("a", """
                !go. !outer. !bare. !wait.
                +!go <- .fail_goal(go); .print("not here").
                -!go <- .print("go failed").
                +!outer <- !inner; .print("not here").
                -!outer <- .print("outer failed").
                +!inner <- .fail_goal(inner); .print("not here").
                +!bare <- .fail_goal(bare); .print("not here").
                +!wait <- .wait(100); .fail_goal(wait2); .print("goes on").
                """);
        advance(1);
        assertThat(states)
                .contains("a: go failed", "a: outer failed", "a: goes on")
                .doesNotContain("a: not here");
        assertThat(view("a").status()).isEqualTo(AgentPlatform.Status.RUNNING);
    }

    @Test
    void noAgentIsCalledLikeASourceOfBeliefs() {
        start("self", "!go. +!go <- .print(1).");
        advance(0);
        assertThat(view("self").status()).isEqualTo(AgentPlatform.Status.FAILED);
        assertThat(view("self").state()).contains("can't be called 'self'");
    }

    @Test
    void limitsThatWereNotNeededAreNoTimersAnyMore() {
        var clock = new LockstepScheduler();
        var timers = new HashSet<Object>();
        var counted = counting(timers, clock);
        platform = new AgentPlatform(
                counted, new JasonHostProvider().create(Arguments.defaults(List.of()), counted), Optional.empty());
        start("amy", "price(1).");
        start("a", """
                !event. !ask. !goal.
                +!event <- .wait({+come}, 1000000).
                +!ask <- .wait(10); +come; .send(amy, askOne, price(_), P, 2000000).
                +!goal <- !sub[hard_deadline(3000000)].
                +!sub <- .wait(10).
                """);
        clock.advance(Duration.ofMillis(5));
        assertThat(timers).hasSize(4);
        clock.advance(Duration.ofSeconds(1));
        assertThat(timers).isEmpty();
    }

    /// A scheduler that notes which timers have neither run nor been cancelled.
    private static Scheduler counting(Set<Object> timers, Scheduler scheduler) {
        InvocationHandler handler = (_, method, arguments) -> {
            if (!method.getName().equals("after")) {
                return method.invoke(scheduler, arguments);
            }
            var timer = new Object();
            var task = (Runnable) arguments[arguments.length - 1];
            arguments[arguments.length - 1] = (Runnable) () -> {
                timers.remove(timer);
                task.run();
            };
            timers.add(timer);
            var made = (Task) method.invoke(scheduler, arguments);
            return (Task) () -> {
                timers.remove(timer);
                made.cancel();
            };
        };
        return (Scheduler)
                Proxy.newProxyInstance(Scheduler.class.getClassLoader(), new Class<?>[] {Scheduler.class}, handler);
    }

    @Test
    void aTimeWithoutAnEndIsWaitedFor() {
        start("a", "!go. +!go <- .wait(1e18); .print(\"over\").");
        start("b", "!go. +!go <- .wait({+never}, 1.0E300).");
        advance(10);
        assertThat(states).containsExactly("a: ", "b: ");
        assertThat(Terms.millis(Terms.number(1e18))).isLessThan(Duration.ofNanos(Long.MAX_VALUE / 2));
    }

    // ── For people ───────────────────────────────────────────────────────────────────────────────────────────────

    @Test
    void itsMindCanBeLookedInto() {
        startOnRobot("""
                likes(tea). likes(milk).
                !go.
                +!go <- !drink(tea).
                +!drink(What) <- .wait(5000).
                """);
        advance(1);
        Mind.View mind = platform.look("a", Mind.View.class).orElseThrow();
        assertThat(mind.beliefs())
                .containsEntry("likes", "likes(tea)[source(self)]; likes(milk)[source(self)]")
                .containsEntry("robot", "robot(r1,tested)[source(percept)]");
        assertThat(mind.goals()).hasSize(1);
        assertThat(mind.goals().getFirst().state()).isEqualTo(Mind.GoalState.SUSPENDED);
        assertThat(mind.goals().getFirst().steps())
                .anySatisfy(step -> assertThat(step).contains("drink(tea)", ".wait(5000)"));
        assertThat(mind.goals().getFirst().plans()).containsExactly("a.asl:3", "a.asl:4");
    }

    @Test
    void whatVariablesStandForIsSeenWhereSomethingIsComputed() {
        start("a", """
                !go(2.5).
                +!go(Seconds) <- .wait(Seconds*1000).
                """);
        advance(1);
        Mind.View mind = platform.look("a", Mind.View.class).orElseThrow();
        assertThat(mind.goals().getFirst().steps()).containsExactly("+!go(2.5): .wait((2.5*1000))");
    }

    @Test
    void itsRulesAndPlansCanBeRead() {
        start("a", """
                post(1, 2).
                near(Post) :- post(Post, X) & X < 3.
                @home[atomic] +!go(_) : near(Post) & not tired <- .print(Post); !!go(Post).
                +!rest.
                """);
        advance(0);
        Mind.Program program = platform.look("a", Mind.Program.class).orElseThrow();
        assertThat(program.rules()).containsExactly("near(Post) :- (post(Post,X) & (X < 3))");
        assertThat(program.plans())
                .hasSize(2)
                .containsEntry("home", "@home[atomic] +!go(_) : (near(Post) & not (tired)) <- .print(Post); !!go(Post)")
                .containsEntry("a.asl:4", "+!rest");
    }

    @Test
    void plansThatBeginInOneLineCanAllBeRead() {
        start("a", "+!rest. +!go <- .print(go).");
        advance(0);
        assertThat(platform.look("a", Mind.Program.class).orElseThrow().plans())
                .containsExactly(entry("a.asl:1", "+!rest\n+!go <- .print(go)"));
    }

    @Test
    void textIsForPeopleToo() {
        start("a", "!go. +!go <- publish(text, \"good day to all\").");
        advance(0);
        assertThat(said.getFirst().content()).isEqualTo(new Text("good day to all"));
    }
}
