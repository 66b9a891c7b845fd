package rsal.cli.terminal;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.encoder.PatternLayoutEncoder;
import ch.qos.logback.classic.filter.ThresholdFilter;
import ch.qos.logback.classic.spi.Configurator;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.classic.spi.ThrowableProxy;
import ch.qos.logback.core.ConsoleAppender;
import ch.qos.logback.core.filter.Filter;
import ch.qos.logback.core.rolling.FixedWindowRollingPolicy;
import ch.qos.logback.core.rolling.RollingFileAppender;
import ch.qos.logback.core.rolling.SizeBasedTriggeringPolicy;
import ch.qos.logback.core.spi.ContextAwareBase;
import ch.qos.logback.core.spi.FilterReply;
import ch.qos.logback.core.util.FileSize;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import rsal.settings.OwnCode;

/// Sends logs to stderr, warnings and worse. In Java rather than XML, which would take longer to read than the rest
/// of a start.
public final class Logging extends ContextAwareBase implements Configurator {
    /// The logger of what happens in runs.
    public static final String EVENTS = "rsal.run";

    private static final String OURS = "rsal";
    private static final int MOST_OLD_FILES = 5;
    private static final long MOST_BYTES = 10_000_000;

    private static final ConsoleAppender<ILoggingEvent> STDERR = new ConsoleAppender<>();

    /// What of a log goes to stderr.
    private static final ThresholdFilter FOR_PEOPLE = new ThresholdFilter();

    /// Leaves out that code of users failed, with a stack: an event of the run and its result say it in a line.
    private static final Filter<ILoggingEvent> WITHOUT_OWN_CODE = new Filter<>() {
        @Override
        public FilterReply decide(ILoggingEvent event) {
            return isStarted()
                            && event.getThrowableProxy() instanceof ThrowableProxy proxy
                            && OwnCode.hasFailed(proxy.getThrowable())
                    ? FilterReply.DENY
                    : FilterReply.NEUTRAL;
        }
    };

    /// Leaves out events of runs, which people read as lines of the progress.
    private static final Filter<ILoggingEvent> WITHOUT_EVENTS = new Filter<>() {
        @Override
        public FilterReply decide(ILoggingEvent event) {
            return event.getLoggerName().equals(EVENTS) ? FilterReply.DENY : FilterReply.NEUTRAL;
        }
    };

    @Override
    public ExecutionStatus configure(LoggerContext context) {
        var encoder = new PatternLayoutEncoder();
        encoder.setContext(context);
        encoder.setPattern("%d{HH:mm:ss} %-5level %logger{0}: %msg%n");
        encoder.start();
        STDERR.setContext(context);
        STDERR.setTarget("System.err");
        STDERR.setEncoder(encoder);
        STDERR.addFilter(FOR_PEOPLE);
        FOR_PEOPLE.setLevel(Level.WARN.toString());
        FOR_PEOPLE.start();
        STDERR.addFilter(WITHOUT_OWN_CODE);
        WITHOUT_OWN_CODE.start();
        STDERR.addFilter(WITHOUT_EVENTS);
        WITHOUT_EVENTS.start();
        STDERR.start();
        var root = context.getLogger(Logger.ROOT_LOGGER_NAME);
        root.setLevel(Level.WARN);
        root.addAppender(STDERR);
        return ExecutionStatus.DO_NOT_INVOKE_NEXT_IF_ANY;
    }

    /// Has logs ready before several threads write some at once: SLF4J would print that it kept lines meanwhile.
    public static void begin() {
        context();
    }

    /// Tells everything our own code has to say from now on.
    static void printMore() {
        FOR_PEOPLE.setLevel(Level.DEBUG.toString());
        WITHOUT_OWN_CODE.stop();
        context().getLogger(OURS).setLevel(Level.DEBUG);
    }

    /// Also keeps a log in a file from now on, as [JsonLines]. At 10 MB it becomes `FILE.1`, and so on to `FILE.5`,
    /// which is then lost.
    ///
    /// @param levels of what our own code says; of libraries that are not named, warnings and worse are kept
    /// @throws Unreachable if the file can't be written
    public static void keep(Path file, LogLevels levels) {
        try { // logback would only say it somewhere
            Files.newOutputStream(file, StandardOpenOption.CREATE, StandardOpenOption.APPEND)
                    .close();
        } catch (IOException e) {
            throw new Unreachable("The log '%s' can't be written: %s.".formatted(file, e));
        }
        LoggerContext context = context();
        var appender = new RollingFileAppender<ILoggingEvent>();
        appender.setContext(context);
        appender.setFile(file.toString());
        appender.setEncoder(jsonLines());
        var names = new FixedWindowRollingPolicy();
        names.setContext(context);
        names.setParent(appender);
        names.setFileNamePattern(file + ".%i");
        names.setMaxIndex(MOST_OLD_FILES);
        names.start();
        var size = new SizeBasedTriggeringPolicy<ILoggingEvent>();
        size.setContext(context);
        size.setMaxFileSize(new FileSize(MOST_BYTES));
        size.start();
        appender.setRollingPolicy(names);
        appender.setTriggeringPolicy(size);
        appender.start();
        context.getLogger(Logger.ROOT_LOGGER_NAME).addAppender(appender);
        set(levels);
    }

    /// Writes logs to stderr as [JsonLines] from now on, as containers collect them.
    public static void printAsJson(LogLevels levels) {
        STDERR.stop();
        STDERR.setEncoder(jsonLines());
        STDERR.clearAllFilters(); // the levels alone decide
        STDERR.start();
        set(levels);
    }

    private static JsonLines jsonLines() {
        var lines = new JsonLines();
        lines.setContext(context());
        lines.start();
        return lines;
    }

    private static void set(LogLevels levels) {
        var ours = context().getLogger(OURS);
        Level least = Level.valueOf(levels.least().name());
        if (ours.getLevel() == null || ours.getLevel().isGreaterOrEqual(least)) { // --debug asks for more
            ours.setLevel(least);
        }
        levels.byPart()
                .forEach((part, level) ->
                        context().getLogger(LogLevels.logger(part)).setLevel(Level.valueOf(level.name())));
    }

    private static LoggerContext context() {
        return (LoggerContext) LoggerFactory.getILoggerFactory();
    }
}
