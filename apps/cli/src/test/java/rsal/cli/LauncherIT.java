package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;
import rsal.cli.page.PageCommand;
import rsal.cli.terminal.Exit;
import rsal.testkit.LongTest;

/// Starts the launcher in a project of three files, whose "Maven" copies a jar and notes that it was called.
class LauncherIT {
    private static final Path LAUNCHER = Path.of("../../rsal");
    private static final String SOURCE = """
            package rsal.cli;
            public class Main {
                public static void main(String[] args) throws java.io.IOException {
                    System.out.println("args " + String.join(" ", args));
                    System.out.println("in " + System.getProperty("user.dir"));
                    System.out.println("page " + System.getProperty("rsal.page"));
                    System.out.println("launcher " + System.getProperty("rsal.launcher"));
                    if (args[0].equals("wait")) System.in.read();
                }
            }
            """;
    private static final String MAVEN = """
            #!/bin/sh
            [ "$1" != --version ] || exit 0
            cd "$(dirname "$0")"
            echo $$ >> builds
            echo "$@" >> arguments
            echo "[INFO] compiling"
            echo "[INFO] Building RSAL data 0.1.0-SNAPSHOT                                     [1/2]"
            echo "[INFO] Building RSAL command line 0.1.0-SNAPSHOT                             [2/2]"
            if [ -e slow ]; then touch began; sleep 60; fi
            if [ -e broken ]; then echo "[ERROR] Main.java: there is no such thing"; exit 1; fi
            mkdir -p apps/cli/target/lib
            cp main.jar apps/cli/target/rsal-cli.jar
            cp main.jar apps/cli/target/lib/other.jar
            case "$*" in *-Ddist*)
                mkdir -p apps/release/target
                cp main.jar apps/release/target/rsal-release.jar
                touch apps/cli/target/bom.json;;
            esac
            if [ -e report.xml ]; then
                mkdir -p apps/cli/target/surefire-reports
                cp report.xml apps/cli/target/surefire-reports/TEST-rsal.A.xml
            fi
            """;

    private static final String NPM = """
            #!/bin/sh
            [ -z "$NODE_ENV" ] || { echo "npm error What is built depends on NODE_ENV=$NODE_ENV"; exit 1; }
            echo "$3 $4" >> "$2/../../builds"
            if [ -e "$2/broken" ]; then echo "npm error code EUSAGE"; yes "npm error" | head -n 40; exit 1; fi
            if [ -e "$2/broken-$4" ]; then echo "npm error code EBROKEN"; exit 1; fi
            if [ -e "$2/slow-$4" ]; then echo $$ > "$2/new"; mv "$2/new" "$2/began"; sleep 60; fi
            case "$3" in
                ci) mkdir -p "$2/node_modules"; touch "$2/node_modules/.package-lock.json";;
                run)
                    case "$2" in */docs/site) made="$2/../../target/site";; *) made="$2/dist";; esac
                    mkdir -p "$made"; touch "$made/index.html";;
            esac
            """;
    private static final String APT_GET = """
            #!/bin/sh
            cd "$(dirname "$0")"
            echo "$@" >> installing
            [ ! -e ../no-network ] || exit 100
            case "$*" in
                *headless-shell*) for name in chromium-headless-shell Xvfb; do ln -s unzip $name; done;;
                install*) for name in chromium Xvfb; do ln -s unzip $name; done;;
            esac
            """;
    /// Of the packages that a system has.
    private static final String APT_CACHE = """
            #!/bin/sh
            [ "$*" = "show chromium-headless-shell" ] && [ -e "$(dirname "$0")/../headless-shell" ]
            """;
    /// Makes no cache of classes, which would take seconds in each test.
    private static final String UNTRAINED_JAVA = """
            #!/bin/sh
            for word; do
                case "$word" in -XX:AOTCacheOutput=*) : >"${word#*=}"; exit 0;; esac
            done
            exec "$REAL_JAVA" "$@"
            """;

    private static final String SUDO = """
            #!/bin/sh
            shift
            exec "$@"
            """;
    private static final Set<String> WHAT_TESTS_NEED = Set.of(
            "chromium-headless-shell", "chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "Xvfb");
    private static final Duration PATIENCE = Duration.ofSeconds(10);

    private static byte[] mainJar = {};

    @TempDir
    Path folder;

    private Path project;
    private final Map<String, String> environment = new HashMap<>();

    @BeforeEach
    void layOut() throws IOException {
        project = Files.createDirectories(folder.resolve("a project")); // with a space
        Files.copy(LAUNCHER, project.resolve("rsal"), StandardCopyOption.COPY_ATTRIBUTES);
        Files.createDirectories(project.resolve("apps/cli/src/main"));
        Files.writeString(project.resolve("pom.xml"), "");
        Files.write(project.resolve("main.jar"), mainJar);
        writeExecutable(project.resolve("mvnw"), MAVEN);
        writeExecutable(Files.createDirectories(folder.resolve("bin")).resolve("unzip"), "#!/bin/sh\n");
        writeExecutable(folder.resolve("bin/apt-get"), APT_GET); // else a test would install
        writeExecutable(folder.resolve("bin/apt-cache"), APT_CACHE);
        writeExecutable(folder.resolve("bin/sudo"), SUDO);
        environment.put("JAVA_HOME", layOutJdk().toString());
    }

    private Path layOutJdk() throws IOException {
        Path real = Path.of(System.getProperty("java.home"));
        Path jdk = folder.resolve("untrained");
        writeExecutable(Files.createDirectories(jdk.resolve("bin")).resolve("java"), UNTRAINED_JAVA);
        environment.put("REAL_JAVA", real.resolve("bin/java").toString());
        Files.createSymbolicLink(jdk.resolve("bin/javac"), real.resolve("bin/javac"));
        Files.createSymbolicLink(jdk.resolve("release"), real.resolve("release"));
        return jdk;
    }

    @Test
    void buildsOnceAndRuns() throws Exception {
        Ended first = run("list", "--json", "a b");
        Ended second = run("list");

        assertThat(first.code()).isZero();
        assertThat(first.out()).startsWith("args list --json a b\n");
        assertThat(first.err())
                .contains(
                        "rsal: Building RSAL…\nrsal:   1/2 RSAL data\nrsal:   2/2 RSAL command line\nrsal: Building RSAL took");
        assertThat(second.out()).startsWith("args list\n");
        assertThat(second.err()).isEmpty();
        assertThat(builds()).hasSize(1);
    }

    @Test
    void mavenTakesTheSameJdkWhereAnOlderOneIsTheDefault() throws Exception {
        Path old = folder.resolve("old");
        Files.createDirectories(old.resolve("bin"));
        for (String program : List.of("java", "javac")) {
            writeExecutable(old.resolve("bin").resolve(program), "#!/bin/sh\necho the old $0\n");
        }
        Path installed = Files.createDirectories(folder.resolve(".jdks")).resolve("new"); // in a home of its own
        Files.createSymbolicLink(installed, Path.of(System.getProperty("java.home")));
        Files.writeString(old.resolve("release"), "JAVA_VERSION=\"17.0.1\"\n");
        Files.copy(Path.of("../../mvnw"), project.resolve("mvnw"), StandardCopyOption.REPLACE_EXISTING);
        Path settings = Files.createDirectories(project.resolve(".mvn/wrapper"));
        Files.copy(
                Path.of("../../.mvn/wrapper/maven-wrapper.properties"), settings.resolve("maven-wrapper.properties"));
        String url = Files.readAllLines(settings.resolve("maven-wrapper.properties")).stream()
                .filter(line -> line.startsWith("distributionUrl="))
                .map(line -> line.substring("distributionUrl=".length()).strip())
                .findAny()
                .orElseThrow();
        Path maven = folder.resolve("m2/wrapper/dists")
                .resolve(url.substring(url.lastIndexOf('/') + 1).replace("-bin.zip", ""))
                .resolve(Integer.toHexString(url.hashCode()));
        Files.createDirectories(maven.resolve("bin"));
        writeExecutable(maven.resolve("bin/mvn"), "#!/bin/sh\necho \"$JAVA_HOME $*\"\n");

        for (String set : List.of("", old.toString())) {
            var launcher = builder(project, "./rsal", "--jdk");
            var wrapper = builder(folder, project.resolve("mvnw").toString(), "a b", "c");
            for (var started : List.of(launcher, wrapper)) {
                started.environment().put("HOME", folder.toString());
                started.environment().put("JAVA_HOME", set);
                started.environment()
                        .put("MAVEN_USER_HOME", folder.resolve("m2").toString());
                started.environment().merge("PATH", old.resolve("bin").toString(), (path, bin) -> bin + ":" + path);
            }
            String jdk = Ended.of(launcher.start()).out().strip();
            assertThat(Path.of(jdk).resolve("bin/javac")).exists();
            assertThat(jdk).isNotEqualTo(old.toString());
            assertThat(Ended.of(wrapper.start()).out()).isEqualTo(jdk + " a b c\n");
        }
    }

    @Test
    void describesTestsWithoutRunningThem() throws Exception {
        assertThat(run("test", "--help").out()).startsWith("args test --help\n");
    }

    @Test
    void buildsAgainWhenASourceIsNewer() throws Exception {
        run("list");
        Path source = Files.writeString(project.resolve("apps/cli/src/main/New.java"), "");
        Files.setLastModifiedTime(source, FileTime.from(Instant.now().plusSeconds(1)));
        run("list");
        assertThat(builds()).hasSize(2);
    }

    @Test
    void buildsAgainWhenASourceIsGone() throws Exception {
        Path source = Files.writeString(project.resolve("apps/cli/src/main/Old.java"), "");
        run("list");
        Files.delete(source);
        run("list");
        assertThat(builds()).hasSize(2);
    }

    @Test
    @LongTest
    void keepsABuildForAsLongAsSomethingRunsFromIt() throws Exception {
        Process waiting = start(project, "./rsal", "wait");
        try (var out = waiting.inputReader()) {
            assertThat(out.readLine()).isEqualTo("args wait");
            Path first = published();
            buildAgain(4);
            assertThat(first).exists();

            waiting.getOutputStream().close();
            assertThat(waiting.waitFor()).isZero();
            buildAgain(1);
            assertThat(first).doesNotExist();
        }
    }

    private Path published() throws IOException {
        Path state = project.resolve("target/launcher");
        return state.resolve(Files.readString(state.resolve("java")).strip());
    }

    private void buildAgain(int times) throws Exception {
        Path source = project.resolve("apps/cli/src/main/New.java");
        for (int i = 0; i < times; i++) {
            Path before = published();
            Files.writeString(source, "");
            Files.setLastModifiedTime(source, FileTime.from(Instant.now().plusSeconds(5)));
            run("list");
            assertThat(published()).isNotEqualTo(before);
        }
    }

    @Test
    void addsWhatPeopleAskForBesides() throws Exception {
        run("list");
        Ended added = with("jadex");
        with("jadex");
        Ended unknown = with("jade");

        assertThat(added.code()).isZero();
        List<String> builds = Files.readAllLines(project.resolve("arguments"));
        assertThat(builds).hasSize(2);
        assertThat(builds.getFirst()).doesNotContain("-P");
        assertThat(builds.getLast()).contains("-Pjadex");
        assertThat(unknown.code()).isEqualTo(Exit.USAGE);
        assertThat(unknown.err()).contains("RSAL_WITH='jade'", "RSAL_WITH=jadex");
    }

    private Ended with(String what) throws Exception {
        var builder = builder(project, "./rsal", "list");
        builder.environment().put("RSAL_WITH", what);
        return Ended.of(builder.start());
    }

    @Test
    void saysWhyABuildFailedAndRunsNothing() throws Exception {
        Files.createFile(project.resolve("broken"));
        Ended ended = run("list");
        assertThat(ended.code()).isEqualTo(Exit.INTERNAL);
        assertThat(ended.out()).isEmpty();
        assertThat(ended.err()).contains("Building RSAL failed", "build.log", "there is no such thing");
    }

    @Test
    void namesTheTestsThatFailedAtTheEnd() throws Exception {
        Files.writeString(project.resolve("report.xml"), """
                <testsuite name="rsal.A" tests="4" errors="1" skipped="1" failures="1">
                  <testcase name="adds(int)[1]" classname="rsal.A">
                    <failure message="&#10;expected: &lt;1&gt; &amp; &quot;x&quot;" type="Error"><![CDATA[<a>]]></failure>
                  </testcase>
                  <testcase name="ends" classname="rsal.A"><error type="Timeout"/></testcase>
                  <testcase name="waits" classname="rsal.A"><skipped/></testcase>
                  <testcase name="passes" classname="rsal.A"/>
                </testsuite>
                """);

        Ended ended = run("test");

        assertThat(ended.code()).isEqualTo(1);
        assertThat(ended.out().strip()).isEqualTo("1 passed, 2 failed, 1 skipped");
        assertThat(ended.err()).contains("rsal: FAILED rsal.A: adds(int)[1]:  expected: <1> & \"x\"\n");
        assertThat(ended.err()).endsWith("rsal: FAILED rsal.A: ends\n");
    }

    @Test
    void longTestsRunOnlyWhenTheyAreAskedForAndAreSaidToHavePassed() throws Exception {
        Files.writeString(project.resolve("report.xml"), "<testsuite name=\"rsal.A\" tests=\"2\"/>");
        Path passed = Files.createDirectories(project.resolve("testing")).resolve("all-passed");

        assertThat(run("test").err()).doesNotContain("Long tests");
        assertThat(project.resolve("arguments"))
                .content()
                .contains("-Drsal.test.whole=true", "-Derrorprone.tests=-XepDisableAllChecks")
                .doesNotContain("rsal.test.all");
        assertThat(passed).doesNotExist();

        assertThat(run("test", "--all").out()).isEqualTo("2 passed, 0 failed\n");
        assertThat(project.resolve("arguments"))
                .content()
                .contains("-Drsal.test.all=true")
                .satisfies(all -> assertThat(all.substring(all.indexOf("-Drsal.test.all")))
                        .as("checked by Error Prone, too")
                        .doesNotContain("errorprone"));
        assertThat(passed).content().endsWith(": 2 passed, 0 failed\n");
        assertThat(run("test").err())
                .contains("Long tests run by './rsal test --all', which last passed on " + Files.readString(passed));
    }

    @Test
    void classesThatTakeTooLongForEachLandingAreNamed() throws Exception {
        Files.writeString(project.resolve("report.xml"), """
                <testsuite name="rsal.A" tests="1" time="12.34"><testcase name="a" classname="rsal.A" time="12"/></testsuite>
                <testsuite name="rsal.B" tests="1" time="9.96"/>
                <testsuite name="rsal.C" tests="1" time="0.5"/>
                <testsuite name="pytest" tests="2" time="30">
                  <testcase name="d" classname="tests.d" time="2.5"/>
                  <testcase name="e" classname="tests.d" time="1.5"/>
                </testsuite>
                """);
        assertThat(run("test").err())
                .contains(
                        "rsal: The tests that took longest:\n",
                        "  12.3 s rsal.A: too long for each landing.",
                        "  10.0 s rsal.B: too long",
                        "  4.0 s tests.d\n")
                .doesNotContain("rsal.C", "pytest");
        assertThat(run("test", "--all").err()).doesNotContain("took longest");
    }

    @Test
    void librariesAreFetchedBesideJava() throws Exception {
        Files.writeString(project.resolve("report.xml"), "<testsuite name=\"rsal.A\" tests=\"2\"/>");
        layOutPage("#!/bin/sh\n");

        assertThat(run("test").err()).doesNotContain("Fetching the page's libraries");
        assertThat(builds()).containsOnlyOnce("ci --no-audit").contains("run build", "run types", "run lint");
    }

    @Test
    void checksOfThePageAreMadeOnceBesideJavaAndCounted() throws Exception {
        Files.writeString(project.resolve("report.xml"), "<testsuite name=\"rsal.A\" tests=\"2\"/>");
        layOutPage("#!/bin/sh\n");
        Files.createFile(project.resolve("apps/web/broken-lint"));

        Ended ended = run("test");

        assertThat(ended.code()).isEqualTo(1);
        assertThat(ended.out()).isEqualTo("2 passed, 1 failed\n");
        assertThat(ended.err())
                .containsOnlyOnce("Page: checks and tests FAILED")
                .contains("EBROKEN");
        assertThat(builds()).containsOnlyOnce("run lint");
        assertThat(project.resolve("target/launcher/build.log")).content().contains("EBROKEN");
    }

    @Test
    void aSignalEndsWhatRunsBesideJava() throws Exception {
        Files.writeString(project.resolve("report.xml"), "<testsuite name=\"rsal.A\" tests=\"2\"/>");
        layOutPage("#!/bin/sh\n");
        Path web = project.resolve("apps/web");
        Files.createFile(web.resolve("slow-lint"));
        Process launcher = start(project, "./rsal", "test");
        while (!Files.exists(web.resolve("began"))) {
            assertThat(launcher.waitFor(10, TimeUnit.MILLISECONDS)).isFalse();
        }
        long npm = Long.parseLong(Files.readString(web.resolve("began")).strip());

        Ended.signal("TERM", launcher);

        assertThat(Ended.of(launcher).code()).isEqualTo(143);
        var gone = ProcessHandle.of(npm).map(ProcessHandle::onExit);
        assertThat(gone.orElse(CompletableFuture.completedFuture(null))).succeedsWithin(PATIENCE);
    }

    @Test
    void testsThatAreNamedRunAloneAndUnchecked() throws Exception {
        for (String test :
                List.of("robots/sim/src/test/java/rsal/ATest.java", "apps/cli/src/test/java/rsal/BIT.java")) {
            Files.createDirectories(project.resolve(test).getParent());
            Files.createFile(project.resolve(test));
        }

        assertThat(run("test", "ATest#turns").code()).isZero();
        assertThat(project.resolve("arguments"))
                .content()
                .contains("-Dfast", "-pl robots/sim -am -Dtest=ATest#turns", "useIncrementalCompilation=false")
                .endsWith(" test -Dmaven.compiler.useIncrementalCompilation=false\n");

        assertThat(run("test", "ATest", "BIT").code()).isZero();
        assertThat(project.resolve("arguments"))
                .content()
                .contains("-pl robots/sim,apps/cli -am -Dtest=ATest", " verify -DskipITs=false -Dit.test=BIT")
                .contains("--offline");

        Ended unknown = run("test", "CTest");
        assertThat(unknown.code()).isEqualTo(Exit.USAGE);
        assertThat(unknown.err()).contains("There is no test 'CTest'.");
    }

    /// A class that has not changed may call what has.
    @Test
    void namedTestsThatFailAreTriedAgainWithWholeModules() throws Exception {
        Path test = project.resolve("robots/sim/src/test/java/rsal/ATest.java");
        Files.createDirectories(test.getParent());
        Files.createFile(test);
        Files.createFile(project.resolve("broken"));

        Ended ended = run("test", "ATest");

        assertThat(ended.code()).isEqualTo(1);
        assertThat(ended.err()).contains("A class may be older than what it calls");
        assertThat(project.resolve("arguments")).content().endsWith(" test\n");
    }

    @Test
    void countsAStepThatBreaksWithoutATest() throws Exception {
        Files.writeString(project.resolve("report.xml"), "<testsuite name=\"rsal.A\" tests=\"2\"/>");
        layOutPage("#!/bin/sh\n");
        Files.createFile(layOutSite().resolve("broken"));

        Ended ended = run("test", "--all"); // which builds the site

        assertThat(ended.code()).isEqualTo(1);
        assertThat(ended.out().strip()).isEqualTo("2 passed, 1 failed");
        assertThat(ended.err()).contains("Fetching the documentation's libraries failed", "npm error code EUSAGE\n");
        assertThat(ended.err())
                .contains("rsal: FAILED a step without a test that failed:\n")
                .endsWith("  npm error code EUSAGE\n");
    }

    @Test
    @LongTest
    void installsWhatTestsNeedAtOnce() throws Exception {
        Files.writeString(project.resolve("report.xml"), "<testsuite name=\"rsal.A\" tests=\"2\"/>");
        layOutPage("#!/bin/sh\n");

        Ended first = testOnABareMachine();
        Ended again = testOnABareMachine();

        assertThat(first.out()).isEqualTo("2 passed, 0 failed\n");
        assertThat(first.err())
                .contains("Installing chromium xvfb libxi6 libxrender1 libxtst6…")
                .doesNotContain("SKIPPED");
        assertThat(again.err()).doesNotContain("Installing", "SKIPPED");
        assertThat(folder.resolve("bin/installing"))
                .hasContent("update\ninstall -y --no-install-recommends chromium xvfb libxi6 libxrender1 libxtst6\n");
        assertThat(builds()).contains("run test:browser");
    }

    @Test
    void installsABrowserWithoutWindowsWhereThereIsOne() throws Exception {
        Files.writeString(project.resolve("report.xml"), "<testsuite name=\"rsal.A\" tests=\"2\"/>");
        Files.createFile(folder.resolve("headless-shell"));
        layOutPage("#!/bin/sh\n");

        testOnABareMachine();
        Ended again = testOnABareMachine();

        assertThat(again.err()).doesNotContain("Installing", "SKIPPED");
        assertThat(folder.resolve("bin/installing"))
                .hasContent(
                        "update\ninstall -y --no-install-recommends chromium-headless-shell xvfb libxi6 libxrender1 libxtst6\n");
        assertThat(builds()).contains("run test:browser");
    }

    @Test
    void skipsTestsWhoseNeedsCanNotBeInstalled() throws Exception {
        Files.writeString(project.resolve("report.xml"), "<testsuite name=\"rsal.A\" tests=\"2\"/>");
        Files.createFile(folder.resolve("no-network"));
        layOutPage("#!/bin/sh\n");

        Ended ended = testOnABareMachine();

        assertThat(ended.out()).isEqualTo("2 passed, 0 failed\n");
        assertThat(ended.err())
                .contains(
                        "TESTS OF JADE'S WINDOWS SKIPPED: they need Xvfb", "BROWSER TESTS SKIPPED: they need Chromium");
        assertThat(builds()).doesNotContain("run test:browser");
    }

    /// As this one, but without browsers and screens.
    private Ended testOnABareMachine() throws Exception {
        Path programs = Files.createDirectories(folder.resolve("programs"));
        List<Path> places = Stream.of(System.getenv("PATH").split(":", -1))
                .map(Path::of)
                .filter(Files::isDirectory)
                .toList();
        for (Path place : places) {
            try (Stream<Path> there = Files.list(place)) {
                for (Path program : there.toList()) {
                    Path link = programs.resolve(program.getFileName());
                    if (!WHAT_TESTS_NEED.contains(program.getFileName().toString())
                            && Files.notExists(link, LinkOption.NOFOLLOW_LINKS)) {
                        Files.createSymbolicLink(link, program.toAbsolutePath());
                    }
                }
            }
        }
        var builder = builder(project, "./rsal", "test");
        builder.environment().put("PATH", folder.resolve("bin") + ":" + programs);
        return Ended.of(builder.start());
    }

    @Test
    void givesANewScenariosTestItsPlace() throws Exception {
        assertThat(run("new", "mine").out())
                .contains("launcher " + project.toRealPath().resolve("rsal"));
    }

    @Test
    void operatorsNeedNoBuildAndWaitForNone() throws Exception {
        run("list");
        Path source = Files.createFile(project.resolve("apps/cli/src/main/New.java")); // somebody works on it
        Files.setLastModifiedTime(source, FileTime.from(Instant.now().plusSeconds(2)));
        Files.writeString(project.resolve("broken"), "");
        Path lock = project.resolve("target/launcher/lock"); // and builds
        Files.createSymbolicLink(
                lock, Path.of("%d now".formatted(ProcessHandle.current().pid())));
        for (String line : List.of(
                "estop",
                "stop --json",
                "arm r1",
                "goal r1 1 2 0",
                "pose r1 1 2 0",
                "status",
                "agent mind a",
                "--version",
                "--help",
                "help run",
                "run --help",
                "sweep patrol -h")) {
            Ended ended = run(line.split(" "));

            assertThat(ended.err()).as(line).isEmpty();
            assertThat(ended.out()).startsWith("args " + line + "\n");
        }
        assertThat(builds()).hasSize(1);
    }

    @Test
    void whereNothingWasEverBuiltOperatorsBuildToo() throws Exception {
        assertThat(run("estop").out()).startsWith("args estop\n");
        assertThat(builds()).hasSize(1);
    }

    @Test
    void theLauncherKnowsWhichCommandsAreForOperators() throws Exception {
        String names = Files.readAllLines(LAUNCHER).stream()
                .filter(line -> line.startsWith("OF_OPERATORS="))
                .map(line -> line.replaceAll("OF_OPERATORS=|\"", "").strip())
                .findAny()
                .orElseThrow();
        assertThat(names.split(" "))
                .containsExactlyElementsOf(
                        Main.commandLine(OutputStream.nullOutputStream()).getSubcommands().entrySet().stream()
                                .filter(command -> isForOperators(command.getValue()))
                                .map(Map.Entry::getKey)
                                .sorted()
                                .toList());
    }

    private static boolean isForOperators(CommandLine command) {
        return command.getCommand() instanceof PageCommand
                || (!command.getSubcommands().isEmpty()
                        && command.getSubcommands().values().stream().allMatch(LauncherIT::isForOperators));
    }

    @ParameterizedTest
    @ValueSource(strings = {"C", "POSIX"})
    void namesOfFilesMayHaveAnyLetters(String locale) throws Exception {
        assumeThat(System.getProperty("sun.jnu.encoding")).isEqualTo("UTF-8"); // else this test can't write their names
        project = Files.move(project, folder.resolve("Müllers Köder 机器人"));
        environment.put("LC_ALL", locale);

        Ended ended = run("list", "Größe.yaml");

        assertThat(ended.code()).isZero();
        assertThat(ended.out()).startsWith("args list Größe.yaml\n");
    }

    @Test
    void saysThatItCanNotRunFromAFolderWithAColon() throws Exception {
        project = Files.move(project, folder.resolve("a:b"));

        Ended ended = run("list");

        assertThat(ended.code()).isEqualTo(Exit.UNREACHABLE);
        assertThat(ended.err()).contains("/a:b': Java takes the colon in it", "Rename the folder");
        assertThat(project.resolve("builds")).doesNotExist();
    }

    @Test
    void staysInTheFolderOfTheCallerAndFollowsLinks() throws Exception {
        Path elsewhere = Files.createDirectories(folder.resolve("elsewhere"));
        Path link = Files.createSymbolicLink(folder.resolve("link"), Path.of("a project/rsal"));
        Ended ended = Ended.of(start(elsewhere, link.toString(), "list"));
        assertThat(ended.out()).contains("in " + elsewhere.toRealPath());
    }

    @Test
    void twoStartsAtOnceBuildOnce() throws Exception {
        Process one = start(project, "./rsal", "one");
        Process two = start(project, "./rsal", "two");
        assertThat(Ended.of(one).out()).startsWith("args one");
        assertThat(Ended.of(two).out()).startsWith("args two");
        assertThat(builds()).hasSize(1);
    }

    @Test
    void aSignalEndsTheBuildToo() throws Exception {
        Files.createFile(project.resolve("slow"));
        for (var signal : List.of("INT", "TERM")) {
            Process launcher = start(project, "./rsal", "list");
            while (!Files.deleteIfExists(project.resolve("began"))) {
                assertThat(launcher.waitFor(10, TimeUnit.MILLISECONDS)).isFalse();
            }
            long maven = Long.parseLong(builds().getLast());

            Ended.signal(signal, launcher);

            assertThat(Ended.of(launcher).code()).isEqualTo(signal.equals("INT") ? 130 : 143);
            var gone = ProcessHandle.of(maven).map(ProcessHandle::onExit);
            assertThat(gone.orElse(CompletableFuture.completedFuture(null))).succeedsWithin(PATIENCE);
            assertThat(project.resolve("target/launcher/lock")).doesNotExist();
        }
    }

    @Test
    void saysWhereItCanNotBuild() throws Exception {
        Files.createFile(project.resolve("target")); // where the launcher's folder should be
        Ended ended = run("list");
        assertThat(ended.code()).isEqualTo(Exit.INTERNAL);
        assertThat(ended.out()).isEmpty();
        assertThat(ended.err()).contains("can't be written", "target/launcher");
        assertThat(project.resolve("builds")).doesNotExist();
    }

    @Test
    void takesTheLockOfOneWhoIsGone() throws Exception {
        Path lock = Files.createDirectories(project.resolve("target/launcher")).resolve("lock");
        Files.createSymbolicLink(lock, Path.of("1 Thu Jan  1 00:00:00 1970")); // another process has this id now
        assertThat(run("list").code()).isZero();
        assertThat(Files.isSymbolicLink(lock)).isFalse();
    }

    @Test
    @LongTest
    void aBrokenCacheDoesNotMatter() throws Exception {
        environment.put("JAVA_HOME", System.getProperty("java.home"));
        run("list");
        try (var caches = Files.newDirectoryStream(project.resolve("target/launcher"), "java-*")) {
            for (Path folder : caches) {
                try (var files = Files.newDirectoryStream(folder, "*.aot")) {
                    for (Path cache : files) {
                        assertThat(cache).isNotEmptyFile();
                        Files.writeString(cache, "not a cache");
                    }
                }
            }
        }
        Ended ended = run("list");
        assertThat(ended.code()).isZero();
        assertThat(ended.out()).startsWith("args list\n");
        assertThat(ended.err()).isEmpty();
    }

    @Test
    void buildsThePageOnceAndOnlyForThoseWhoLookAtIt() throws Exception {
        layOutPage("#!/bin/sh\n");
        assertThat(run("run", "--headless").out()).contains("page null");
        Ended watched = run("run");
        Ended again = run("run");
        assertThat(run("serve").out()).contains("page " + project.toRealPath().resolve("target/launcher/page-"));

        assertThat(watched.out()).contains("page " + project.toRealPath().resolve("target/launcher/page-"));
        assertThat(again.out()).isEqualTo(watched.out());
        assertThat(builds().subList(1, builds().size())).containsExactly("ci --no-audit", "run build");
    }

    @Test
    void reportsToTheDoctorWhereThePageIs() throws Exception {
        layOutPage("#!/bin/sh\n");
        assertThat(run("doctor").out()).contains("page null");
        Ended watched = run("run");
        assertThat(run("doctor")
                        .out()
                        .lines()
                        .filter(line -> line.startsWith("page"))
                        .toList())
                .isEqualTo(watched.out()
                        .lines()
                        .filter(line -> line.startsWith("page"))
                        .toList());
        assertThat(watched.out()).doesNotContain("page null");
    }

    @Test
    void buildsTheDocumentationOnceAndSaysWhereItIs() throws Exception {
        layOutPage("#!/bin/sh\n");
        layOutSite();
        Ended built = run("docs");
        Ended again = run("docs");
        assertThat(built.code()).isZero();
        assertThat(built.out()).isEqualTo(project.toRealPath().resolve("target/site") + "\n");
        assertThat(again.out()).isEqualTo(built.out());
        assertThat(builds())
                .as("Java, of which Javadoc is, and the site")
                .hasSize(3)
                .endsWith("ci --no-audit", "run build");
    }

    @Test
    @LongTest
    void aReleaseIsBuiltAgainOnlyWhenItsSourcesHaveChanged() throws Exception {
        layOutPage("#!/bin/sh\n");
        layOutSite();
        Path source = Files.writeString(project.resolve("apps/cli/src/main/Main.java"), "class Main {}");
        Path other = Files.writeString(project.resolve("apps/cli/src/main/Other.java"), "class Other {}");
        FileTime longAgo = FileTime.fromMillis(0);

        assertThat(releases(1)).contains("Building RSAL…");
        assertThat(releases(1)).contains("Nothing of Java has changed").doesNotContain("Building RSAL…");
        Files.writeString(source, "class Main { }");
        Files.setLastModifiedTime(source, longAgo); // as archives and rsync set it
        assertThat(releases(2)).contains("Building RSAL…");
        Files.delete(other);
        assertThat(releases(3)).contains("Building RSAL…");
        assertThat(releases(3)).doesNotContain("Building RSAL…");
        Files.setLastModifiedTime(source, FileTime.from(Instant.now().plusSeconds(60)));
        run("list"); // builds as for a run, where classes may stay whose sources are gone
        assertThat(releases(4)).contains("Building RSAL…");
    }

    @Test
    void aWheelIsForAllSystems() throws Exception {
        layOutPage("#!/bin/sh\n");
        Ended ended = run("dist", "--wheel", "linux-x64");
        assertThat(ended.code()).isEqualTo(2);
        assertThat(ended.err()).contains("'linux-x64' is not for wheels", "./rsal dist --wheel");
        assertThat(run("dist", "--wheel", "--out").err()).contains("--out needs a folder");
    }

    @Test
    void saysWhatAWheelNeedsWhereThereIsNoPython() throws Exception {
        layOutPage("#!/bin/sh\n");
        writeExecutable(folder.resolve("bin/python3"), "#!/bin/sh\nexit 1\n");
        Ended ended = run("dist", "--wheel");
        assertThat(ended.code()).isEqualTo(5);
        assertThat(ended.err()).contains("A wheel needs Python 3.10 or newer", "python3-venv");
    }

    /// @param built how many releases were built until then
    private String releases(int built) throws Exception {
        String err = run("dist").err();
        assertThat(Files.readAllLines(project.resolve("arguments")).stream().filter(line -> line.contains("-Ddist")))
                .hasSize(built);
        return err;
    }

    @Test
    void runsWithoutThePageWhereNodeIsTooOld() throws Exception {
        layOutPage("#!/bin/sh\nexit 1\n");
        Ended ended = run("run", "patrol.yaml");
        assertThat(ended.code()).isZero();
        assertThat(ended.out()).startsWith("args run patrol.yaml --headless\n");
        assertThat(ended.err()).contains("The page needs Node.js", "apt-get install");
    }

    private void layOutPage(String node) throws IOException {
        Path web = Files.createDirectories(project.resolve("apps/web"));
        Files.writeString(web.resolve("package-lock.json"), "{}");
        writeExecutable(folder.resolve("bin/node"), node);
        writeExecutable(folder.resolve("bin/npm"), NPM);
    }

    private Path layOutSite() throws IOException {
        Path tools = Files.createDirectories(project.resolve("docs/site"));
        Files.writeString(tools.resolve("package-lock.json"), "{}");
        return tools;
    }

    @Test
    void refusesJavaThatIsTooOld() throws Exception {
        Path old = Files.createDirectories(folder.resolve("jdk/bin")).getParent();
        writeExecutable(old.resolve("bin/javac"), "#!/bin/sh\n");
        writeExecutable(old.resolve("bin/java"), "#!/bin/sh\necho old java\n");
        Path installed = Files.createDirectories(folder.resolve(".jdks")).resolve("new"); // in a home of its own
        Files.createSymbolicLink(installed, Path.of(System.getProperty("java.home")));
        Files.writeString(old.resolve("release"), "JAVA_VERSION=\"17.0.1\"\n");
        var builder = builder(project, "./rsal", "list");
        builder.environment().put("JAVA_HOME", old.toString());
        Ended ended = Ended.of(builder.start());
        assertThat(ended.out()).doesNotContain("old java");
        assertThat(ended.code()).isIn(Exit.SUCCESS, Exit.UNREACHABLE); // where there is another JDK, that is taken
    }

    private Ended run(String... arguments) throws Exception {
        var command = new String[arguments.length + 1];
        command[0] = "./rsal";
        System.arraycopy(arguments, 0, command, 1, arguments.length);
        return Ended.of(start(project, command));
    }

    private Process start(Path in, String... command) throws Exception {
        return builder(in, command).start();
    }

    private ProcessBuilder builder(Path in, String... command) throws Exception {
        var builder = new ProcessBuilder(Ended.interruptible(List.of(command))).directory(in.toFile());
        builder.environment().compute("PATH", (_, path) -> folder.resolve("bin") + ":" + path);
        builder.environment().put("NODE_ENV", "test"); // as where tests in a browser start it
        builder.environment().putAll(environment);
        return builder;
    }

    private List<String> builds() throws IOException {
        return Files.readAllLines(project.resolve("builds"));
    }

    @BeforeAll
    static void writeMain(@TempDir Path folder) throws IOException {
        Path source = Files.writeString(folder.resolve("Main.java"), SOURCE);
        ToolProvider.getSystemJavaCompiler().run(null, null, null, "-d", folder.toString(), source.toString());
        var jar = new ByteArrayOutputStream();
        try (var out = new JarOutputStream(jar)) {
            out.putNextEntry(new JarEntry("rsal/cli/Main.class"));
            Files.copy(folder.resolve("rsal/cli/Main.class"), out);
        }
        mainJar = jar.toByteArray();
    }

    private static void writeExecutable(Path file, String text) throws IOException {
        Files.writeString(file, text);
        assertThat(file.toFile().setExecutable(true)).isTrue();
    }
}
