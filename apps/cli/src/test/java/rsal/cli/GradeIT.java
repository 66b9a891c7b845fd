package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;
import rsal.testkit.LongTest;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// `rsal grade` and `rsal test-agent`, on agents that do all kinds of wrong.
class GradeIT {
    private static final String SCENARIO = """
            rsal: 1
            scenario: lab
            title: A robot waits
            world: {map: office}
            robots:
              one: {model: pioneer2dx, pose: [0, -1, 0], devices: {pilot: {}}}
            agents:
              go: {type: Go.java, robot: one}
            mas: {use: plain}
            run:
              stop:
                - {when: time > 0.5, outcome: success}
            """;
    private static final String AGENT = """
            import rsal.agent.*;
            public class Go implements Agent {
                public void start(AgentContext self) { %s }
            }
            """;

    @TempDir(factory = WarmProcess.Folder.class, cleanup = CleanupMode.NEVER)
    private Path folder;

    @BeforeEach
    void setTheTask() throws IOException {
        write("lab/lab.yaml", SCENARIO);
    }

    private void write(String file, String text) throws IOException {
        Path path = folder.resolve(file);
        Files.createDirectories(path.getParent());
        Files.writeString(path, text);
    }

    private void handIn(String student, String statements) throws IOException {
        write("students/%s/Go.java".formatted(student), AGENT.formatted(statements));
    }

    private Ended rsal(String... arguments) throws Exception {
        return new Rsal(folder).run(arguments);
    }

    @Test
    @LongTest
    void eachStudentGetsARowWhateverTheirAgentDoes() throws Exception {
        handIn("alice", "");
        handIn("bob", "this is no Java");
        handIn("carol", "while (true) {}");
        handIn("dave", "var all = new java.util.ArrayList<long[]>(); while (true) all.add(new long[1 << 20]);");
        handIn("erin", "throw new IllegalStateException(\"my error\");");
        handIn("frank", "Helper.help();");
        write("students/frank/Helper.java", "class Helper { static void help() {} }");
        write("students/frank/lab.yaml", "rsal: 1"); // replaces nothing of the teacher's
        write("students/grace/go.java", "");
        handIn("heidi", "System.exit(0);");

        Ended graded = rsal(
                "grade",
                "students",
                "--scenario",
                "lab/lab.yaml",
                "--seeds",
                "1:1",
                "--time",
                "10",
                "--memory",
                "128",
                "--out",
                "out");

        assertThat(graded.code()).as(graded.err()).isZero();
        assertThat(Files.readAllLines(folder.resolve("out/summary.csv")))
                .satisfiesExactly(
                        line -> assertThat(line).isEqualTo("student,runs,successes,message"),
                        line -> assertThat(line).isEqualTo("alice,1,1,"),
                        line -> assertThat(line).startsWith("bob,1,0,").contains("Go.java:3:"),
                        line -> assertThat(line).isEqualTo("carol,1,0,It did not end within 10 s."),
                        line -> assertThat(line)
                                .isEqualTo("dave,1,0,It needs more memory than it may have (--memory)."),
                        line -> assertThat(line).startsWith("erin,1,0,").contains("my error"),
                        line -> assertThat(line).isEqualTo("frank,1,1,"),
                        line -> assertThat(line)
                                .startsWith("grace,1,0,There is no 'Go.java' in 'grace'. There is 'go.java'."),
                        line -> assertThat(line).isEqualTo("heidi,1,0,It printed no result."));
        assertThat(Files.readAllLines(folder.resolve("out/grades.csv"))).hasSize(1 + 8);
        assertThat(folder.resolve("out/alice/seed-1.log")).content().contains("Running lab:default with seed 1");
        assertThat(graded.err()).contains("frank: 1 of 1").doesNotContain("SLF4J");
        assertThat(graded.out())
                .contains("frank     1 of 1")
                .contains("carol     0 of 1    It did not end within 10 s.");

        Ended again = rsal("grade", "students", "--scenario", "lab/lab.yaml", "--out", "out");
        assertThat(again.code()).isEqualTo(3);
        assertThat(again.err()).contains("is there already");
    }

    @Test
    void anAgentThatCanNotBeCompiledHarmsNoOther() throws Exception {
        handIn("alice", "");
        handIn("bob", "this is no Java");

        Ended graded = rsal(
                "grade", "students", "--scenario", "lab/lab.yaml", "--seeds", "1:1", "--time", "30", "--out", "out");

        assertThat(graded.code()).as(graded.err()).isZero();
        assertThat(Files.readAllLines(folder.resolve("out/summary.csv")))
                .satisfiesExactly(
                        line -> assertThat(line).isEqualTo("student,runs,successes,message"),
                        line -> assertThat(line).isEqualTo("alice,1,1,"),
                        line -> assertThat(line).startsWith("bob,1,0,").contains("Go.java:3:"));
    }

    @Test
    void errorsOfTheTeacherAreReported() throws Exception {
        handIn("alice", "");
        write("lab/none.yaml", SCENARIO.replace("Go.java", "wander"));
        assertThat(rsal("grade", "students", "--scenario", "lab/none.yaml", "--out", "out")
                        .err())
                .contains("This scenario names no agent in a file.");
        assertThat(rsal("grade", "nobody", "--scenario", "lab/lab.yaml", "--out", "out")
                        .err())
                .contains("There is no such folder");
        assertThat(rsal("grade", "students", "--scenario", "lab/no.yaml", "--out", "out")
                        .err())
                .contains("There is no such file");
        assertThat(rsal("grade", "students", "--scenario", "lab/lab.yaml", "--out", "students/out")
                        .err())
                .contains("is in the folder of students");
        assertThat(rsal("grade", "students", "--scenario", "lab/lab.yaml", "--agent", "../Go.java", "--out", "out")
                        .err())
                .contains("Name it without a folder");
        assertThat(folder.resolve("out")).doesNotExist();
    }

    @Test
    @LongTest
    void anAgentIsTestedWithSeveralSeeds() throws Exception {
        write("lab/Go.java", AGENT.formatted(""));

        Ended tested = rsal("test-agent", "lab", "--seeds", "5:6", "--json");

        assertThat(tested.code()).as(tested.err()).isZero();
        JsonNode runs = JsonMapper.shared().readTree(tested.out()).path("runs");
        assertThat(runs).hasSize(2);
        assertThat(tested.err())
                .contains("1 of 2: seed ", "2 of 2: seed ", ", success")
                .doesNotContain("SLF4J");
        assertThat(runs.get(1).path("seed").asLong()).isEqualTo(6);
        Ended same = rsal("run", "lab", "--headless", "--speed", "max", "--seed", "6", "--json");
        assertThat(JsonMapper.shared().readTree(same.out()).path("eventHash").asString())
                .isEqualTo(runs.get(1).path("eventHash").asString());

        assertThat(rsal("test-agent", "lab", "--seeds", "1", "--for", "0.1").out())
                .contains("limit", "--for ended it before its own end.");

        write("lab/Go.java", AGENT.formatted("throw new IllegalStateException(\"my error\");"));
        Ended failed = rsal("test-agent", "lab", "--seeds", "1");
        assertThat(failed.code()).isEqualTo(4);
        assertThat(failed.out()).contains("my error").contains("0 of 1 runs ended in success.");
    }
}
