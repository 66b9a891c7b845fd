package rsal.python;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.agent.AgentType;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Parameter;

class PythonLanguageIT {
    private static final String HUNTER = """
            import rsal
            from rsal.agents.devices import Localizer, Navigator
            raise SystemError("nobody may run this file")

            class Hunter(rsal.Agent):
                '''Hunts
                one robot.

                More about it.
                '''
                prey: str = rsal.Param("prey", robots=True, description="Whom it hunts.")
                speed: float = rsal.Param(0.5, min=0.1, max=1, unit="m/s", description="How fast.")
                tries: int = rsal.Param(min=1)
                mode: str = rsal.Param("fixed", choices=["fixed", "nearest"])
                loud: bool = rsal.Param(False)
                other = 3
                needs = [Localizer, Navigator]
            """;

    @Test
    void aFileSaysWhatItNeedsWithoutBeingRun() {
        AgentType type = Texts.type(HUNTER);
        assertThat(type.key()).isEqualTo("a.py");
        assertThat(type.description()).isEqualTo("Hunts one robot.");
        assertThat(type.needs()).containsExactly(Localizer.class, Navigator.class);
        assertThat(type.parameters())
                .extracting(Parameter::name)
                .containsExactly("prey", "speed", "tries", "mode", "loud");
        assertThat(type.parameters())
                .extracting(Parameter::expected)
                .containsExactly(
                        "a role of robots or the id of one",
                        "a number from 0.1 to 1 [m/s]",
                        "a whole number of at least 1",
                        "one of fixed, nearest",
                        "true or false");
        assertThat(type.parameters().get(1).fallback()).isEqualTo(Optional.of(0.5));
        assertThat(type.parameters().get(2).fallback()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            speed: float = rsal.Param(1.0   | speed: float = rsal.Param(2 * pi        | a.py:5:31: The default of 'speed' is not a literal: '2 * pi'.
            speed: float = rsal.Param(1.0   | speed: list = rsal.Param(1.0            | a.py:5:12: A parameter cannot have the type 'list'.
            speed: float = rsal.Param(1.0   | speed = rsal.Param(1.0                  | a.py:5:5: Parameter 'speed' has no type.
            speed: float = rsal.Param(1.0   | speed: float = rsal.Param(3.0           | a.py:5:20: The default of 'speed' does not fit: '3.0'.
            speed: float = rsal.Param(1.0   | speed: float = rsal.Param(1.0, mx=2     | a.py:5:39: 'Param' has no 'mx'.
            needs = [Navigator]             | needs = [Navigater]                     | a.py:4:14: There is no device 'Navigater'.
            (rsal.Agent):                   | (object):                               | a.py:1:1: This file has no class that inherits from 'rsal.Agent'.
            needs = [Navigator]             | needs = [Navigator                      | a.py:4:13: This is not Python: '[' was never closed.
            """)
    void errorsSayWhereTheyAre(String right, String wrong, String message) {
        String text = """
                import rsal
                from rsal.agents.devices import Navigator
                class A(rsal.Agent):
                    needs = [Navigator]
                    speed: float = rsal.Param(1.0, min=0, max=2)
                """;
        assertThat(Texts.type(text).parameters()).hasSize(1);
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> Texts.type(text.replace(right, wrong)))
                .withMessageContaining(message);
    }

    @Test
    void callsThatMakeTheRunWaitAreWarnedOf() {
        AgentType type = Texts.type("""
                import asyncio as aio, time
                from time import sleep as rest
                import rsal
                class A(rsal.Agent):
                    def on_start(self):
                        time.sleep(1)
                        rest(2)
                        aio.run(self.go())
                        name = input("who?")
                        self.sleep(3)
                        time.time()
                """);
        assertThat(type.warnings())
                .extracting(problem ->
                        problem.location().line() + " " + problem.message().replaceFirst(" .*", ""))
                .containsExactly("6 'time.sleep'", "7 'time.sleep'", "8 'asyncio.run'", "9 'input'");
        assertThat(type.warnings().getFirst().toString()).contains("a.py:6:9", "await self.sleep(seconds)");
    }

    @Test
    void oneOfSeveralAgentsIsNamed() {
        String text = """
                import rsal
                class A(rsal.Agent):
                    size: int = rsal.Param(1)
                class B(rsal.Agent):
                    '''The other.'''
                class C(A):
                    more: int = rsal.Param(2)
                """;
        assertThat(Texts.type("a.py:B", Map.of("a.py", text)).description()).isEqualTo("The other.");
        assertThat(Texts.type("a.py:C", Map.of("a.py", text)).parameters())
                .extracting(Parameter::name)
                .containsExactly("size", "more");
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> Texts.type(text))
                .withMessageContaining("a.py:6:1: This file has several agents: B, C.")
                .withMessageContaining("'type: FILE.py:B'");
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> Texts.type("a.py:D", Map.of("a.py", text)))
                .withMessageContaining("There is no class 'D'");
    }

    @Test
    void modulesAreFoundHoweverTheyAreImported() {
        var texts = Map.of(
                "a.py",
                """
                import numpy as np, one
                import two as second, \\
                    three
                from four import (  # not five (5)
                    x as y,
                )
                import os; import six
                try: import seven
                except ImportError: pass
                # import eight
                """,
                "one.py",
                "",
                "two.py",
                "",
                "three.py",
                "",
                "four.py",
                "",
                "six.py",
                "",
                "seven.py",
                "",
                "eight.py",
                "");
        assertThat(PythonSources.read("a.py", Texts.files(texts), Location.of("scenario.yaml"))
                        .texts())
                .containsOnlyKeys("a.py", "one.py", "two.py", "three.py", "four.py", "six.py", "seven.py");
    }

    @ParameterizedTest
    @ValueSource(strings = {"random.py", "rsal.py", "statistics.py"})
    void namesOfPythonsOwnModulesAreRefused(String file) {
        String text = "import rsal\nclass A(rsal.Agent):\n    pass\n";
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> Texts.type(file, Map.of(file, text)))
                .withMessageContainingAll(
                        "A module of an agent cannot be called '%s': Python has one of that name."
                                .formatted(file.replace(".py", "")),
                        "Give '%s' another name.".formatted(file));
    }

    @Test
    void soAreThoseOfModulesBesideIt() {
        var texts =
                Map.of("own/a.py", "import random\nimport rsal\nclass A(rsal.Agent):\n    pass\n", "own/random.py", "");
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> Texts.type("own/a.py", texts))
                .withMessageContaining("own/a.py:1:1: A module of an agent cannot be called 'random'");
    }

    @Test
    void modulesInFoldersBesideItAreReadAsFarAsTheyAreImported() {
        var texts = Map.of(
                "own/a.py",
                """
                import os.path, parts.scan
                from parts import (  # several lines
                    tail,
                    head as first,
                )
                from bare.deep import x
                import rsal
                class A(rsal.Agent):
                    pass
                """,
                "own/parts/__init__.py",
                "",
                "own/parts/scan.py",
                "from .side import y\nfrom ..upper import z\nfrom . import more\n",
                "own/parts/side.py",
                "",
                "own/parts/more.py",
                "",
                "own/parts/tail.py",
                "",
                "own/upper.py",
                "",
                "own/bare/deep.py",
                "",
                "own/bare/other.py",
                "nobody imports it",
                "parts/scan.py",
                "of another folder");
        var sources = PythonSources.read("own/a.py", Texts.files(texts), Location.of("scenario.yaml"));
        assertThat(sources.module()).isEqualTo("a");
        assertThat(sources.folder()).isEqualTo("own/");
        assertThat(sources.texts())
                .containsOnlyKeys(
                        "own/a.py",
                        "own/parts/__init__.py",
                        "own/parts/scan.py",
                        "own/parts/side.py",
                        "own/parts/more.py",
                        "own/parts/tail.py",
                        "own/upper.py",
                        "own/bare/deep.py");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            python:numpy.version:Agent  | There is no class 'Agent' that inherits from 'rsal.Agent' in this file.
            python:numpy.nothing:Agent  | There is no module 'numpy.nothing' in
            python:numpy.version        | names no class of an installed package.
            """)
    void agentsOfInstalledPackagesAreLookedForThere(String type, String message) {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> Texts.type(type, Map.of()))
                .withMessageContaining(message);
    }

    @Test
    void aPythonThatCannotBeStartedIsNamed() {
        AgentType known = Texts.type(HUNTER);
        assertThat(known.key()).isEqualTo("a.py");
        String before = System.setProperty(Interpreter.PROPERTY, "/nowhere/python3");
        try {
            assertThatExceptionOfType(InvalidSettings.class)
                    .isThrownBy(() -> new PythonLanguage()
                            .read(
                                    "a.py",
                                    (_, _, _) -> "import rsal".getBytes(StandardCharsets.UTF_8),
                                    Location.of("scenario.yaml")))
                    .withMessageContaining("scenario.yaml: Python can't be run for 'a.py'")
                    .withMessageContaining("pip install numpy");
        } finally {
            System.setProperty(Interpreter.PROPERTY, before);
        }
    }
}
