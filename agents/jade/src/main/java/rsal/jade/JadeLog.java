package rsal.jade;

import java.lang.System.Logger.Level;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.logging.Handler;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import java.util.logging.SimpleFormatter;

/// Takes what JADE logs, which would go to the terminal, to where our own logs go.
final class JadeLog extends Handler {
    private static final System.Logger OURS = System.getLogger(JadeLog.class.getName());
    private static final JadeLog HANDLER = new JadeLog();
    private static final Set<Logger> REDIRECTED = ConcurrentHashMap.newKeySet(); // who is not held is forgotten

    private final SimpleFormatter formatter = new SimpleFormatter();

    static {
        redirect("jade"); // above those of its classes
        redirect("ams");
        redirect("df");
    }

    private JadeLog() {}

    /// What classes of JADE log, and its own agents, some of which do so in their names. May be called again.
    static void redirect() {} // done when this class is first used

    /// The same for another agent.
    ///
    /// @param name in which it logs
    static void redirect(String name) {
        Logger logger = Logger.getLogger(name);
        if (REDIRECTED.add(logger)) {
            logger.setUseParentHandlers(false);
            logger.addHandler(HANDLER);
        }
    }

    @Override
    public void publish(LogRecord line) {
        OURS.log(level(line.getLevel()), () -> formatter.formatMessage(line), line.getThrown());
    }

    /// JADE warns of what is usual, such as somebody who is not there any more.
    private static Level level(java.util.logging.Level level) {
        return level.intValue() >= java.util.logging.Level.SEVERE.intValue() ? Level.WARNING : Level.DEBUG;
    }

    @Override
    public void flush() {}

    @Override
    public void close() {}
}
