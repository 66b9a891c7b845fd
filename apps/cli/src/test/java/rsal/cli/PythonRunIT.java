package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.cli.terminal.Exit;
import rsal.testkit.LongTest;
import rsal.testkit.OfficialPython;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// Agents in Python beside those in AgentSpeak and Java, in whole runs.
class PythonRunIT {
    @TempDir
    Path folder;

    @Test
    @LongTest
    void agentsInThreeLanguagesRunTogetherAndEqualSeedsGiveEqualRuns() throws Exception {
        Rsal rsal = python();
        assertThat(rsal.run("new", "mine", "--from", "hunt-and-prey").code()).isEqualTo(Exit.SUCCESS);
        Path scenario = folder.resolve("mine/mine.yaml");
        String text = Files.readString(scenario);
        Files.writeString(scenario, text + """
                  three:
                    agents:
                      watcher: {type: Watcher.java}
                      escape: {type: prey.asl, robot: prey, parameters: {hunter: hunter}}
                      follow: {type: hunter.py, robot: hunter, parameters: {prey: prey}}
                """);
        JsonNode first = result(rsal, "7");
        assertThat(first.get("outcome").stringValue()).isEqualTo("success");
        assertThat(first.get("failed").isEmpty()).isTrue();
        assertThat(first.get("metrics").get("captureTime").doubleValue()).isBetween(5.0, 120.0);
        assertThat(result(rsal, "7").get("eventHash")).isEqualTo(first.get("eventHash"));
    }

    @Test
    void agentsInPythonAndAgentSpeakTalkOnJade() throws Exception {
        Files.writeString(folder.resolve("talk.yaml"), """
                rsal: 1
                scenario: talk
                title: Agents in Python and AgentSpeak talk on JADE
                world: {map: office}
                robots:
                  idle: {model: pioneer2dx, pose: {free: true}}
                agents:
                  asker: {type: asker.py}
                  echo: {type: echo.asl}
                mas: {use: jade}
                mrs: {use: sim}
                run:
                  clock: {mode: wall}
                  stop:
                    - {when: metric(answered) > 2, outcome: success}
                    - {when: time > 60, outcome: timeout}
                """);
        Files.writeString(folder.resolve("asker.py"), """
                import rsal
                from rsal.agents.messages import Caught, PoseReport
                from rsal.agents.values import Pose2d


                class Asker(rsal.Agent):
                    def on_start(self):
                        self.answered = 0.0
                        self.subscribe(Caught, self.on_caught)
                        self.every(0.1, self.ask_again)

                    def ask_again(self):
                        self.publish(PoseReport("idle", "asker", Pose2d(1.0, 2.0, 0.0)))

                    def on_caught(self, message):
                        self.answered += message.content.distance
                        self.metric("answered", self.answered)
                """);
        Files.writeString(folder.resolve("echo.asl"), """
                +heard(pose, asker, pose_report(Robot, asker, pose(X, _, _)))
                   <- publish(caught, Robot, echo, X).
                """);
        Ended ended = python().run("run", "talk.yaml", "--headless", "--json");
        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        JsonNode result = JsonMapper.shared().readTree(ended.out());
        assertThat(result.get("outcome").stringValue()).isEqualTo("success");
        assertThat(result.get("failed").isEmpty()).isTrue();
    }

    private Rsal python() throws Exception {
        return new Rsal(folder)
                .inEnvironment(
                        Map.of("RSAL_PYTHON", OfficialPython.interpreter().toString()));
    }

    private static JsonNode result(Rsal rsal, String seed) throws Exception {
        Ended ended = rsal.run("run", "mine/mine.yaml:three", "--headless", "--speed", "max", "--seed", seed, "--json");
        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        return JsonMapper.shared().readTree(ended.out());
    }
}
