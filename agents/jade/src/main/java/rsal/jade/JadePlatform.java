package rsal.jade;

import jade.core.AID;
import jade.core.Agent;
import jade.core.Runtime;
import jade.core.messaging.TopicManagementHelper;
import jade.wrapper.AgentContainer;
import jade.wrapper.ControllerException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import rsal.time.AllowedToReadWallClock;

/// A JADE platform in this process. There may be several, side by side or one after the other.
///
/// What JADE has once for the whole process (threads that deliver messages, a timer) is started with the first platform
/// and ended with the last, by threads of its own. A platform that starts just then would get what is about to end. So
/// starts and ends wait for each other.
@AllowedToReadWallClock(
        "JADE ends a platform only three seconds after its start. Others can start in the " + "meantime.")
public final class JadePlatform {
    private static final Logger LOG = System.getLogger(JadePlatform.class.getName());
    private static final AtomicLong PLATFORMS = new AtomicLong();
    private static final String DESCRIPTION = "APDescription.txt"; // JADE's only file
    private static final Duration LEAST_LIFE = Duration.ofMillis(3_100);
    private static final Duration PATIENCE = Duration.ofSeconds(5);

    private static final Object PROCESS = new Object(); // guards these two
    private static int running;
    private static CountDownLatch ended = new CountDownLatch(0); // what JADE has once

    private final String id;
    private final Path files;
    private final LonelyProfile profile;
    private final AgentContainer container;
    private final long startNanos;

    private JadePlatform(String id, Path files, LonelyProfile profile, AgentContainer container) {
        this.id = id;
        this.files = files;
        this.profile = profile;
        this.container = container;
        this.startNanos = System.nanoTime();
    }

    /// @throws IllegalStateException when JADE can't
    static JadePlatform start() {
        JadePlatform platform = startBare();
        AgentTables.mend(platform.container);
        return platform;
    }

    /// Starts one as JADE has it, in which what is said while others start may be lost ([AgentTables]).
    ///
    /// @throws IllegalStateException when JADE can't
    public static JadePlatform startBare() {
        JadeLog.redirect();
        String id = "rsal-" + PLATFORMS.incrementAndGet();
        Path files = folder();
        var profile = new LonelyProfile(id, files);
        synchronized (PROCESS) {
            if (running == 0) {
                var last = new CountDownLatch(1);
                Runtime.instance().invokeOnTermination(last::countDown); // what is asked for first is done last
                ended = last;
            }
            AgentContainer container = Runtime.instance().createMainContainer(profile);
            if (container == null) {
                throw new IllegalStateException("JADE does not start. Its log says why.");
            }
            running++;
            return new JadePlatform(id, files, profile, container);
        }
    }

    /// Of files that JADE writes wherever it is, and nobody reads.
    private static Path folder() {
        try {
            Path folder = Files.createTempDirectory("rsal-jade-");
            folder.toFile().deleteOnExit();
            folder.resolve(DESCRIPTION).toFile().deleteOnExit();
            return folder;
        } catch (IOException e) {
            throw new UncheckedIOException("JADE needs a folder for its files.", e);
        }
    }

    public AID agent(String agent) {
        return new AID(AID.createGUID(agent, id), AID.ISGUID);
    }

    AID topic(String topic) {
        return new AID(AID.createGUID(topic, TopicManagementHelper.TOPIC_SUFFIX), AID.ISGUID);
    }

    /// Starts an agent.
    ///
    /// @throws IllegalArgumentException when there is one of that name
    public void start(String name, Agent agent) {
        try {
            container.acceptNewAgent(name, agent).start();
        } catch (ControllerException e) {
            throw new IllegalArgumentException(
                    "JADE can't start an agent '%s': %s Maybe one of its own has that name, or one that differs in upper and lower case; give it another."
                            .formatted(name, e.getMessage()),
                    e);
        }
    }

    /// Opens one of JADE's windows.
    void open(Tool tool) {
        JadeLog.redirect(tool.agent());
        JadeLog.redirect("%s-on-Main-Container@%s".formatted(tool.agent(), id)); // who watches for it
        try {
            container
                    .createNewAgent(tool.agent(), tool.type(), tool.arguments())
                    .start();
        } catch (ControllerException e) {
            throw new IllegalStateException("JADE can't open its window (%s).".formatted(tool.agent()), e);
        }
    }

    /// Ends it on a thread of its own.
    public void endSoon() {
        Thread.ofPlatform().daemon().name("end of JADE").start(this::end);
    }

    /// Ends it and all that is left of it. Waits for its agents, but not for ever; not on a thread that they may wait
    /// for.
    void end() {
        try {
            Duration rest = LEAST_LIFE.minusNanos(System.nanoTime() - startNanos);
            TimeUnit.NANOSECONDS.sleep(Math.max(0, rest.toNanos()));
            synchronized (PROCESS) {
                running--; // also when a person has ended it already, by a tool
                profile.end();
                container.getPlatformController().kill();
                if (running == 0 && !ended.await(PATIENCE.toMillis(), TimeUnit.MILLISECONDS)) {
                    LOG.log(Level.WARNING, "JADE does not end its threads.");
                }
            }
            Files.deleteIfExists(files.resolve(DESCRIPTION));
            Files.deleteIfExists(files);
        } catch (ControllerException | IOException | RuntimeException e) {
            LOG.log(Level.WARNING, () -> "JADE's platform '%s' does not end.".formatted(id), e);
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt(); // then it is left as it is; its threads keep nothing alive
        }
    }
}
