package rsal.jason;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.agent.AgentOutline;
import rsal.agent.AgentType;
import rsal.behavior.Pilot;
import rsal.device.Battery;
import rsal.device.BlobFinder;
import rsal.device.DriveBase;
import rsal.device.Gripper;
import rsal.device.LaserScanner;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.settings.InvalidSettings;
import rsal.settings.Parameter;
import rsal.settings.Problem;

class AgentSpeakTest {
    private static void refuses(String text, String... words) {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> Texts.type(text))
                .withMessageContainingAll(words);
    }

    @Test
    void beliefsOfOneNumberOrTextAreParameters() {
        AgentType type = Texts.type("""
                // Goes about.
                speed(0.4).   // How fast it drives [m/s].
                back(-1).
                color('#2ca02c').
                greeting("good day").
                careful(true).
                place(1, 2).
                friend(amy). friend(bob).
                tall(X) :- X > 2.
                free.
                !go.
                +!go.
                """);
        assertThat(type.key()).isEqualTo("a.asl");
        assertThat(type.description()).isEqualTo("Goes about.");
        assertThat(type.parameters())
                .extracting(Parameter::name)
                .containsExactly("speed", "back", "color", "greeting", "careful");
        assertThat(type.parameters())
                .extracting(parameter -> parameter.fallback().orElseThrow())
                .containsExactly(0.4, -1.0, "#2ca02c", "good day", true);
        assertThat(type.parameters().getFirst().description()).isEqualTo("How fast it drives [m/s].");
    }

    @Test
    void needsTheDevicesOfItsPerceptsAndActions() {
        assertThat(Texts.type("+!go <- goto(1, 2).").needs()).containsExactly(Navigator.class);
        assertThat(Texts.type("+!go <- drive(1, 0); stop.").needs()).containsExactly(DriveBase.class);
        assertThat(Texts.type("+!go <- if (true) { follow_wall } else { wander }.")
                        .needs())
                .containsExactly(Pilot.class);
        assertThat(Texts.type("+!go <- grip; release.").needs()).containsExactly(Gripper.class);
        assertThat(Texts.type("near(X) :- pose(X, _, _).").needs()).containsExactly(Localizer.class);
        assertThat(Texts.type("+!go : not (scan_min(F, _, _) & F < 1) <- .wait(battery(1)).")
                        .needs())
                .containsExactlyInAnyOrder(LaserScanner.class, Battery.class);
        assertThat(Texts.type("+blob(_, X, _) <- .print(X).").needs()).containsExactly(BlobFinder.class);
        assertThat(Texts.type("+heard(pose, _, pose_report(_, _, pose(X, _, _))) <- .print(X).")
                        .needs())
                .as("the pose of another")
                .isEmpty();
    }

    @Test
    void needsNothingForWhatOthersBelieve() {
        assertThat(Texts.type("+holding[source(R)] : R \\== percept <- .print(R).")
                        .needs())
                .isEmpty();
        assertThat(Texts.type("+!go : pose(X, _, _)[source(amy)] <- .print(X).").needs())
                .isEmpty();
        assertThat(Texts.type("+!go <- .broadcast(tell, pose(1, 2, 3)); .send(amy, askOne, battery(_), B).")
                        .needs())
                .isEmpty();
        assertThat(Texts.type("+!go : pose(X, _, _)[source(percept)] <- .print(X).")
                        .needs())
                .containsExactly(Localizer.class);
        assertThat(Texts.type("+!go <- .findall(X, pose(X, _, _), L); .send(amy, tell, L).")
                        .needs())
                .containsExactly(Localizer.class);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "limit(X + 1).",
                "limit(- X).",
                "limit([1, X * 2]).",
                "limit(p(q(X - 1))).",
                "limit(math.round(X)).",
                "~limit(X ** 2)[source(self)]."
            })
    void beliefsThatCountWithAVariableAreRefusedWhereTheyAre(String belief) {
        refuses("+!s.\n" + belief, ":2:", "Belief 'limit' counts with a variable", "limit(Y) :- …");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "limit(X).",
                "limit(_).",
                "limit([X|T]).",
                "limit(1 / 0).",
                "limit(0 / 0).",
                "limit(X) :- X = 3 + 1."
            })
    void whatIsNoNumberIsNoParameter(String belief) {
        assertThat(Texts.type(belief).parameters()).isEmpty();
    }

    @Test
    void whatIsCountedIsANumber() {
        assertThat(Texts.type("limit(3 + 4).").parameters())
                .singleElement()
                .satisfies(parameter -> assertThat(parameter.fallback()).contains(7.0));
    }

    @Test
    void filesMayIncludeOthersBesideThem() {
        AgentType type = Texts.type(Map.of(
                "a.asl", "{ include(\"b.asl\") } speed(1).", "b.asl", "{include(\"a.asl\")} turn(2). +!go <- stop."));
        assertThat(type.parameters()).extracting(Parameter::name).containsExactly("turn", "speed");
        assertThat(type.needs()).containsExactly(DriveBase.class);
    }

    @Test
    void reportsWhatStandsInItsFile() {
        AgentOutline outline = Texts.type(Map.of(
                        "a.asl",
                        """
                        !go.
                        { include("b.asl") }
                        @first +!go : pose(X, _, _) & X > 1
                           <- publish(text, "far");
                              .send(amy, tell, far(X)).
                        +!go.
                        """,
                        "b.asl",
                        "\n+heard(goal_reached, _, _) <- if (true) { .broadcast(tell, there) }."))
                .outline()
                .orElseThrow();
        assertThat(outline.goals()).extracting(Object::toString).containsExactly("Line[text=go, at=a.asl:1:2]");
        assertThat(outline.plans())
                .extracting(line -> line.text() + " " + line.at())
                .containsExactly(
                        "+heard(goal_reached,_,_) b.asl:2:2",
                        "+!go : (pose(X,_,_) & (X > 1)) a.asl:3:10",
                        "+!go a.asl:6:3");
        assertThat(outline.hears()).containsExactly("goal_reached");
        assertThat(outline.says())
                .extracting(line -> line.text() + " " + line.at())
                .containsExactly(
                        ".broadcast(tell,there) b.asl:2:43",
                        "publish(text,\"far\") a.asl:4:7",
                        ".send(amy,tell,far(X)) a.asl:5:7");
    }

    @Test
    void goalsThatNoPlanHandlesAndEventsThatNothingRaisesAreHintedAt() {
        assertThat(Texts.type("!gaurd(1).\n+!guard(N) <- !!guard(3 - N); !stand. +herd(_, _, _) <- stop.")
                        .warnings())
                .extracting(Problem::toString)
                .anyMatch(hint -> hint.contains("a.asl:1:")
                        && hint.contains("No plan handles goal '!gaurd(1)'.")
                        && hint.contains("Maybe '!guard' was meant."))
                .anyMatch(hint -> hint.contains("a.asl:2:") && hint.contains("'!stand'"))
                .anyMatch(hint -> hint.contains("'+herd'") && hint.contains("Maybe '+heard'"))
                .hasSize(3);
        assertThat(Texts.type("!go(1). +!go <- stop.").warnings())
                .singleElement()
                .asString()
                .contains("There are plans for go/0.");
    }

    /// Others may tell it something of any name, and a plan for any goal handles all.
    @Test
    void nothingIsHintedAtThatMayBeMeant() {
        assertThat(Texts.type("!go. +!go <- +seen(1); !G. +!G <- stop. +seen(N) <- .print(N). +price(P)[source(S)]"
                                + " <- .print(P, S). +offer(P) <- .print(P). +battery(B) <- .print(B).")
                        .warnings())
                .isEmpty();
    }

    @Test
    void allFilesThatAreMissingAreReportedAtOnce() {
        refuses(
                "{ include(\"no.asl\") }\n{ include(\"$jasonJar/x.asl\") }\n{ begin namespace(x) }\na(1).\n{ end }",
                "a.asl:1:11: There is no file 'no.asl'",
                "a.asl:2:11: File '$jasonJar/x.asl' can't be included: '$jasonJar' is a folder",
                "a.asl:3:3: Directive 'begin' is not read here.",
                "a.asl:5:3: Directive 'end'");
    }

    @Test
    void aSemicolonIsProposedWhereOneIsMissing() {
        refuses("!go.\n+!go <- stop\n   drive(1, 0).", "a.asl:3:4: 'drive' can't stand here.", "Maybe a semicolon");
    }

    @Test
    void errorsAreReportedWithFileAndLine() {
        refuses("!go.\n+!go <- stop\n   .print(1).", "a.asl:3:4: '.print' can't stand here.", "full stop");
        refuses("!go.\n+!go <- stop", "a.asl:2:", "The file ends within");
        refuses("p(1).\n  @#$", "a.asl:2:", "This is not AgentSpeak");
        refuses("p(\"no end).", "a.asl:1:", "This is not AgentSpeak");
        refuses("p(1).\n\n X.", "a.asl:3:", "variables cannot be beliefs");
        refuses("!go.\n+!go <- stop;\n   gto(1,2).", "a.asl:3:4: There is no action 'gto'.", "Maybe 'goto'");
        refuses("+!go <- goto(1).", "a.asl:1:9: Action 'goto' takes 2 to 3 terms, not 1.");
        refuses("+!go <- .prnt(1).", "a.asl:1:9: Internal action '.prnt' can't be used here.", "Maybe '.print'");
        refuses("+!go <- my.own.action(1).", "a.asl:1:", "my.own.action");
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> Texts.type("+!go <- .current_intention(I); .qqqqqqqq."))
                .satisfies(e -> assertThat(e.getMessage().lines())
                        .containsExactly(
                                "a.asl:1:9: Internal action '.current_intention' can't be used here.",
                                "    Maybe .intention(Id, State, Stack, current).",
                                "a.asl:1:32: Internal action '.qqqqqqqq' can't be used here.",
                                "    docs/reference/agentspeak.md lists those that can."));
        refuses("+heard(poes, _, _) <- stop.", "a.asl:1:2: There is no topic 'poes'.", "Maybe 'pose'");
        refuses("+!go <- publish(caugt, 1).", "a.asl:1:9: There is no topic 'caugt'.", "Maybe 'caught'");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                ".stopMAS",
                ".create_agent(a, \"a.asl\")",
                ".kill_agent(a)",
                ".clone(a)",
                ".save_agent(\"f\")",
                ".include(\"a.asl\")",
                ".list_files(\"/\", \".*\", L)",
                ".nano_time(T)",
                ".set_random_seed(1)",
                "jason.stdlib.stopMAS"
            })
    void whatReachesOutOfTheAgentIsRefused(String action) {
        refuses("+!go\n  <- " + action + ".", "a.asl:2:6: ", action.replaceAll("\\(.*", ""));
        refuses("+!go : " + action + " <- stop.", "a.asl:1:", action.replaceAll("\\(.*", ""));
        refuses("+!go <- if (x) { " + action + " }.", "a.asl:1:", action.replaceAll("\\(.*", ""));
    }

    @Test
    void directivesButIncludeAreRefused() {
        refuses("p.\n{ register_function(\"java.lang.System\") }", "a.asl:2:", "'register_function' is not read here");
        refuses("{ begin bc(p) } +!p. { end }", "a.asl:1:", "'begin' is not read here");
        refuses("p. { include(\"c.asl\") }", "a.asl:1:", "There is no file 'c.asl'");
    }

    @Test
    void errorsOfIncludedFilesAreReportedWithTheirs() {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> Texts.type(Map.of("a.asl", "{include(\"b.asl\")}", "b.asl", "p(1")))
                .withMessageContaining("b.asl:1:");
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> Texts.type(Map.of("a.asl", "{include(\"b.asl\")}", "b.asl", "\n+!go <- gto.")))
                .withMessageContaining("b.asl:2:9: There is no action 'gto'.");
    }

    /// Whatever is in a file, its author hears of errors, never of what goes on in here.
    @Test
    void noTextBringsTheReaderDown() {
        String[] parts = {
            "+!go",
            "-!go",
            "<-",
            ".",
            ";",
            ":",
            "p(1)",
            "X",
            "_",
            "\"a\"",
            "\"",
            "'b'",
            "[",
            "]",
            "|",
            "{",
            "}",
            "(",
            ")",
            "!",
            "!!",
            "?",
            "&",
            "not",
            "~",
            "::",
            "@l",
            "[atomic]",
            ".print(1)",
            ".wait",
            "goto(1,2)",
            "1/0",
            "**",
            "=..",
            "if",
            "else",
            "while",
            "for",
            "true",
            "false",
            "begin",
            "end",
            "include(\"a.asl\")",
            "\n",
            "//",
            "/*",
            "*/",
            "\0",
            "é",
            "heard(pose,_,P)",
            ":-",
            "<=",
            "\\==",
            "-",
            "+",
            "1e999",
            "99999999999",
            "^",
            "pose(X,Y,Z)",
            "div",
            ","
        };
        for (long seed = 1; seed <= 3000; seed++) {
            var random = new SplittableRandom(seed);
            var text = new StringBuilder();
            for (int i = random.nextInt(1, 25); i > 0; i--) {
                text.append(parts[random.nextInt(parts.length)]).append(random.nextBoolean() ? " " : "");
            }
            try {
                Texts.type(text.toString());
            } catch (InvalidSettings e) {
                assertThat(e.problems()).as("seed %d", seed).isNotEmpty().allSatisfy(problem -> {
                    assertThat(problem.location().file()).isEqualTo("a.asl");
                    assertThat(problem.location().line()).isPositive();
                });
            } catch (RuntimeException | Error e) {
                throw new AssertionError("seed %d: %s".formatted(seed, text), e);
            }
        }
        refuses("p(".repeat(100_000), "a.asl:1:");
    }
}
