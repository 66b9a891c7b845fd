package rsal.jason;

import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Optional;
import java.util.logging.Handler;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import org.jspecify.annotations.Nullable;

/// What the interpreter of one agent complains of: plans that fail or are missing are logged, as the author's affair;
/// what would make it begin again with an empty mind is kept for the agent to fail of.
final class Diagnostics extends Handler {
    private static final System.Logger LOG = System.getLogger("rsal.jason");
    private static final String BEGINS_ANEW = "*** ERROR in the transition system";
    private static final String IN_ACTION = "Error in internal action";
    private static final List<String> TOLD_BETTER =
            List.of("No fail", "Could not finish intention", IN_ACTION, "Found a goal for which", "\n");

    private final String agent;
    private String last = "";
    private @Nullable String broken;
    private boolean endless;
    private String inAction = "";

    /// @param agent its name
    Diagnostics(String agent) {
        this.agent = agent;
    }

    Logger logger() {
        var logger = Logger.getAnonymousLogger();
        logger.setUseParentHandlers(false);
        logger.setLevel(java.util.logging.Level.INFO);
        logger.addHandler(this);
        return logger;
    }

    /// The newest; empty when there was none.
    String last() {
        return last;
    }

    /// Why it can't go on; empty while it can.
    Optional<String> broken() {
        return Optional.ofNullable(broken);
    }

    /// Whether it has searched without an end.
    boolean endless() {
        return endless;
    }

    /// What an internal action threw since this was asked, in words; empty when nothing. What is no `JasonException`,
    /// by which actions say that they failed, is logged with its trace, too.
    String takeThrownInAction() {
        String words = inAction;
        inAction = "";
        return words;
    }

    @Override
    public void publish(LogRecord said) {
        if (said.getLevel().intValue() < java.util.logging.Level.WARNING.intValue()) {
            return;
        }
        String words = String.valueOf(said.getMessage());
        Throwable cause = said.getThrown();
        if (cause instanceof StackOverflowError) {
            endless = true;
            return; // the agent fails with that
        }
        if (cause != null && words.startsWith(IN_ACTION)) {
            inAction = cause.getMessage() == null ? cause.toString() : cause.getMessage();
            LOG.log(Level.WARNING, () -> "Agent '%s': %s".formatted(agent, Terms.masked(words)), cause);
        }
        if (TOLD_BETTER.stream().anyMatch(words::startsWith)) {
            return; // by the deliberation
        }
        if (words.startsWith(BEGINS_ANEW)) {
            broken = cause == null ? words : String.valueOf(cause);
            return; // the agent fails with that
        }
        last = Terms.masked(words);
        LOG.log(Level.WARNING, () -> "Agent '%s': %s".formatted(agent, last));
    }

    @Override
    public void flush() {}

    @Override
    public void close() {}
}
