package rsal.testkit.architecture;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaCodeUnitAccess;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.Location;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.library.dependencies.SliceAssignment;
import com.tngtech.archunit.library.dependencies.SliceIdentifier;
import java.io.IOException;
import java.io.InputStream;
import java.lang.module.ModuleDescriptor;
import java.lang.module.ModuleFinder;
import java.lang.module.ModuleReference;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Predicate;
import java.util.stream.BaseStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;
import rsal.time.AllowedToReadWallClock;

/// What all of our classes keep to. `ArchitectureRules` has each module's own tests try it.
@TestInstance(Lifecycle.PER_CLASS) // reads the classes once
public abstract class ClassRules {
    private static final String[] AGENTS = {"rsal.agent..", "rsal.agents.."};
    private static final String NAVIGATION = "rsal.navigation..";
    private static final String SCENARIOS = "rsal.scenario..";
    private static final String ENGINE = "rsal.engine..";
    private static final String RECORDING = "rsal.recording..";
    private static final String EXPERIMENTS = "rsal.experiment..";
    private static final String SERVER = "rsal.server..";
    private static final String CLI = "rsal.cli..";
    private static final String[] ROBOT_SYSTEMS = {
        "rsal.sim..", "rsal.stage..", "rsal.gazebo..", "rsal.player..", "rsal.ros2.."
    };
    private static final String[] VALUES = {"rsal.data..", "rsal.settings.."};
    private static final String[] CONTRACTS = {
        "rsal.device..", "rsal.fault..", "rsal.robot..", "rsal.scene..", "rsal.system..", "rsal.time.."
    };
    private static final String[] FILES = {"rsal.yaml..", "rsal.model..", "rsal.world..", "rsal.image..", "rsal.map.."};
    private static final String[] MIDDLE = with(VALUES, with(CONTRACTS, with(FILES, "rsal.behavior..")));
    private static final String[] APPS = {SCENARIOS, ENGINE, RECORDING, EXPERIMENTS, SERVER, CLI};

    private static final SliceAssignment PACKAGES = new SliceAssignment() {
        @Override
        public SliceIdentifier getIdentifierOf(JavaClass javaClass) {
            return SliceIdentifier.of(javaClass.getPackageName());
        }

        @Override
        public String getDescription() {
            return "packages";
        }
    };

    private final JavaClasses classes;
    private final List<Path> homes; // of modules' classes

    /// @param homes folders or jars of modules' classes
    protected ClassRules(List<Path> homes) {
        this.homes = List.copyOf(homes);
        this.classes = classesIn(homes);
    }

    /// A module's declarations count on the module path only; the launcher uses the class path.
    @Test
    void providersAreFoundOnBothPaths() throws IOException {
        for (ModuleReference module :
                ModuleFinder.of(homes.toArray(Path[]::new)).findAll()) {
            for (ModuleDescriptor.Provides provided : module.descriptor().provides()) {
                assertThat(named(provided.service())).as(provided.service()).containsAll(provided.providers());
            }
        }
    }

    @Test
    void timeIsHandedIn() {
        check(noClasses()
                .that(areNot(AllowedToReadWallClock.class))
                .should()
                .accessTargetWhere(use("asks the machine for the time or waits for it", ClassRules::readsTheClock))
                .because("a run must be repeatable: take a Scheduler or an InstantSource, or say why not with"
                        + " @AllowedToReadWallClock"));
    }

    @Test
    void timeLimitsAreTheSchedulers() {
        check(noClasses()
                .should()
                .accessTargetWhere(use(
                        "uses the JDK's own timer",
                        c -> Set.of("orTimeout", "completeOnTimeout", "delayedExecutor")
                                .contains(c.getName())))
                .because("Scheduler.within follows the run's time"));
    }

    @Test
    void nothingRunsInTheCommonPool() {
        check(noClasses()
                .should()
                .accessTargetWhere(use("runs in the common pool", ClassRules::usesTheCommonPool))
                .because("work goes through Scheduler.compute, or to an executor that is named"));
    }

    @Test
    void randomnessIsHandedIn() {
        check(noClasses()
                .should()
                .accessTargetWhere(use("makes up random numbers of its own", ClassRules::makesUpRandomNumbers))
                .because("all randomness of a run comes from its seed"));
    }

    @Test
    void onlyTheCommandLineTalksToTheConsole() {
        check(noClasses()
                .that()
                .resideOutsideOfPackage(CLI)
                .should()
                .accessFieldWhere(
                        DescribedPredicate.describe("uses System.out or System.err", ClassRules::isTheConsole))
                .orShould()
                .accessTargetWhere(use("prints a stack trace", c -> c.getName().equals("printStackTrace")))
                .because("results and logs have their own ways out"));
    }

    @Test
    void packagesKnowEachOtherOneWayOnly() {
        check(slices().assignedFrom(PACKAGES).should().beFreeOfCycles());
    }

    @Test
    void valuesKnowNothing() {
        check(noClasses().that().resideInAPackage("rsal.data..").should().dependOnClassesThat(outside("rsal.data..")));
    }

    @Test
    void theMiddleKnowsOnlyTheMiddle() {
        check(noClasses().that().resideInAnyPackage(MIDDLE).should().dependOnClassesThat(outside(MIDDLE)));
    }

    /// A robot system or a device can be written without any file format.
    @Test
    void contractsKnowOnlyValues() {
        check(noClasses()
                .that()
                .resideInAnyPackage(CONTRACTS)
                .should()
                .dependOnClassesThat(outside(with(CONTRACTS, VALUES))));
        check(noClasses()
                .that()
                .resideInAnyPackage("rsal.sim..", "rsal.player..")
                .should()
                .dependOnClassesThat(within(FILES)));
    }

    @Test
    void settingsKnowNoFileFormat() {
        check(noClasses().that().resideInAPackage("rsal.settings..").should().dependOnClassesThat(outside(VALUES)));
    }

    @Test
    void agentsDoNotSeeWhereRobotsComeFrom() {
        check(noClasses().that().resideInAnyPackage(AGENTS).should().dependOnClassesThat(within(ROBOT_SYSTEMS)));
        check(noClasses()
                .that()
                .resideInAnyPackage(AGENTS)
                .should()
                .dependOnClassesThat(within(with(APPS, NAVIGATION))));
    }

    /// What an agent is and what runs it are two things, and both know none of those that come with RSAL. Only
    /// agents that work together with those use their messages.
    @Test
    void agentsContractsKnowNoPlatformAndNoAgent() {
        check(noClasses()
                .that()
                .resideInAnyPackage("rsal.agent", "rsal.metric")
                .should()
                .dependOnClassesThat(
                        within("rsal.agent.*..", "rsal.behavior..", "rsal.yaml..", "rsal.model..", "rsal.world..")));
        check(noClasses()
                .that()
                .resideOutsideOfPackages("rsal.agents..", "rsal.jadex.hunt..")
                .should()
                .dependOnClassesThat(within("rsal.agents..")));
    }

    @Test
    void robotSystemsDoNotSeeAgents() {
        check(noClasses()
                .that()
                .resideInAnyPackage(ROBOT_SYSTEMS)
                .should()
                .dependOnClassesThat(within(with(APPS, AGENTS))));
    }

    /// Except the contract of formats of logs, by which they bring recordings of theirs.
    @Test
    void robotSystemsDoNotNavigate() {
        check(noClasses()
                .that()
                .resideInAnyPackage(ROBOT_SYSTEMS)
                .should()
                .dependOnClassesThat(within(NAVIGATION).and(not(within("rsal.navigation.log..")))));
    }

    /// What makes devices and plugins of them sees devices and settings.
    @Test
    void navigationsAlgorithmsSeeOnlyValues() {
        check(noClasses()
                .that()
                .resideInAPackage(NAVIGATION)
                .and()
                .resideOutsideOfPackages(
                        "rsal.navigation.device..",
                        "rsal.navigation.control..",
                        "rsal.navigation.parameter..",
                        "rsal.navigation.recovery..",
                        "rsal.navigation.traffic..")
                .should()
                .dependOnClassesThat(outside("rsal.data..", NAVIGATION)));
        check(noClasses()
                .that()
                .resideInAPackage(NAVIGATION)
                .should()
                .dependOnClassesThat(within(with(APPS, with(ROBOT_SYSTEMS, AGENTS)))));
    }

    @Test
    void scenariosNameRobotSystemsAndDriversByKey() {
        check(noClasses()
                .that()
                .resideInAPackage(SCENARIOS)
                .should()
                .dependOnClassesThat(
                        within(with(ROBOT_SYSTEMS, NAVIGATION, ENGINE, RECORDING, EXPERIMENTS, SERVER, CLI))));
    }

    @Test
    void theEngineDoesNotSeeWhatLooksAtRuns() {
        check(noClasses()
                .that()
                .resideInAPackage(ENGINE)
                .should()
                .dependOnClassesThat(within(with(ROBOT_SYSTEMS, NAVIGATION, RECORDING, EXPERIMENTS, SERVER, CLI))));
    }

    @Test
    void recordingsSeeRunsOnly() {
        check(noClasses()
                .that()
                .resideInAPackage(RECORDING)
                .should()
                .dependOnClassesThat(within(with(ROBOT_SYSTEMS, NAVIGATION, EXPERIMENTS, SERVER, CLI))));
    }

    @Test
    void experimentsKnowOnlyScenarios() {
        check(noClasses()
                .that()
                .resideInAPackage(EXPERIMENTS)
                .should()
                .dependOnClassesThat(within(with(ROBOT_SYSTEMS, NAVIGATION, RECORDING, SERVER, CLI))));
    }

    @Test
    void serverAndCommandLineDoNotEither() {
        check(noClasses()
                .that()
                .resideInAPackage(SERVER)
                .should()
                .dependOnClassesThat(within(with(ROBOT_SYSTEMS, NAVIGATION))));
        check(noClasses()
                .that()
                .resideInAPackage(CLI)
                .should()
                .dependOnClassesThat(within(with(ROBOT_SYSTEMS, "rsal.navigation.device..")))
                .because("of navigation it may only try the algorithms on recorded data"));
    }

    private void check(ArchRule rule) {
        rule.allowEmptyShould(true).check(classes);
    }

    private static boolean readsTheClock(JavaCodeUnitAccess<?> use) {
        JavaClass owner = use.getTargetOwner();
        String name = use.getName();
        if (owner.isEquivalentTo(System.class)) {
            return name.equals("nanoTime") || name.equals("currentTimeMillis");
        }
        if (owner.isEquivalentTo(Thread.class) || owner.isEquivalentTo(TimeUnit.class)) {
            return name.equals("sleep");
        }
        if (owner.isEquivalentTo(LockSupport.class)) {
            return name.startsWith("park");
        }
        return owner.getPackageName().equals("java.time") && (name.equals("now") || name.startsWith("system"));
    }

    private static boolean usesTheCommonPool(JavaCodeUnitAccess<?> use) {
        JavaClass owner = use.getTargetOwner();
        String name = use.getName();
        if (owner.isAssignableTo(CompletionStage.class) && name.endsWith("Async")) {
            return use.getTarget().getRawParameterTypes().stream().noneMatch(p -> p.isEquivalentTo(Executor.class));
        }
        return name.equals("parallelStream")
                || (owner.isEquivalentTo(Arrays.class) && name.startsWith("parallel"))
                || (owner.isAssignableTo(BaseStream.class) && name.equals("parallel"))
                || (owner.isEquivalentTo(ForkJoinPool.class) && name.equals("commonPool"));
    }

    private static boolean makesUpRandomNumbers(JavaCodeUnitAccess<?> use) {
        JavaClass owner = use.getTargetOwner();
        String name = use.getName();
        if (owner.isEquivalentTo(Math.class) || owner.isEquivalentTo(StrictMath.class)) {
            return name.equals("random");
        }
        if (owner.isEquivalentTo(java.util.Random.class) || owner.isEquivalentTo(java.util.SplittableRandom.class)) {
            return name.equals("<init>")
                    && use.getTarget().getRawParameterTypes().isEmpty();
        }
        if (owner.isEquivalentTo(Collections.class)) {
            return name.equals("shuffle")
                    && use.getTarget().getRawParameterTypes().size() == 1;
        }
        return (owner.isEquivalentTo(ThreadLocalRandom.class) && name.equals("current"))
                || (owner.getPackageName().equals("java.util.random")
                        && (name.equals("getDefault") || name.equals("create"))
                        && use.getTarget().getRawParameterTypes().stream()
                                .noneMatch(p -> p.isEquivalentTo(long.class)));
    }

    private static boolean isTheConsole(JavaAccess<?> access) {
        return access.getTargetOwner().isEquivalentTo(System.class)
                && (access.getName().equals("out") || access.getName().equals("err"));
    }

    /// A call, or a reference such as `Instant::now`.
    private static DescribedPredicate<JavaAccess<?>> use(
            String description, Predicate<JavaCodeUnitAccess<?>> predicate) {
        return DescribedPredicate.describe(
                description, access -> access instanceof JavaCodeUnitAccess<?> use && predicate.test(use));
    }

    /// Neither the class nor one around it is marked.
    private static DescribedPredicate<JavaClass> areNot(Class<? extends java.lang.annotation.Annotation> mark) {
        return DescribedPredicate.describe("are not @" + mark.getSimpleName(), c -> {
            for (JavaClass around = c; ; around = around.getEnclosingClass().get()) {
                if (around.isAnnotatedWith(mark)) {
                    return false;
                }
                if (around.getEnclosingClass().isEmpty()) {
                    return true;
                }
            }
        });
    }

    private static DescribedPredicate<JavaClass> within(String... packages) {
        return resideInAnyPackage(packages);
    }

    /// Our own classes outside of some packages. Which libraries a module sees, its module-info.java says.
    private static DescribedPredicate<JavaClass> outside(String... packages) {
        return DescribedPredicate.<JavaClass>not(resideInAnyPackage(packages))
                .and(resideInAPackage("rsal.."))
                .as("are ours, but reside outside of %s", String.join(", ", packages));
    }

    private static String[] with(String[] packages, String... more) {
        var all = Arrays.copyOf(packages, packages.length + more.length);
        System.arraycopy(more, 0, all, packages.length, more.length);
        return all;
    }

    /// All providers of a service that files on the class path name.
    private static List<String> named(String service) throws IOException {
        var lines = new ArrayList<String>();
        for (URL file :
                Collections.list(ClassRules.class.getClassLoader().getResources("META-INF/services/" + service))) {
            try (InputStream in = file.openStream()) {
                new String(in.readAllBytes(), StandardCharsets.UTF_8).lines().forEach(lines::add);
            }
        }
        return lines;
    }

    /// Where the classes of a module are.
    ///
    /// @param anchor any of them
    protected static Path home(Class<?> anchor) {
        try {
            return Path.of(
                    anchor.getProtectionDomain().getCodeSource().getLocation().toURI());
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }

    private static JavaClasses classesIn(List<Path> homes) {
        return new ClassFileImporter()
                .importLocations(homes.stream().map(Location::of).toList());
    }
}
