package rsal.jade;

import java.lang.System.Logger.Level;
import java.util.logging.Handler;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import java.util.logging.SimpleFormatter;

/// Takes what JADE logs, which would go to the terminal, to where our own logs go.
final class JadeLog extends Handler {
    private static final Logger JADE = Logger.getLogger("jade"); // above all of JADE's own; held, else it is forgotten
    private static final System.Logger OURS = System.getLogger(JadeLog.class.getName());

    private final SimpleFormatter formatter = new SimpleFormatter();

    static {
        JADE.setUseParentHandlers(false);
        JADE.addHandler(new JadeLog());
    }

    private JadeLog() {}

    /// May be called again.
    static void redirect() {} // done when this class is first used

    @Override
    public void publish(LogRecord line) {
        OURS.log(level(line.getLevel()), () -> formatter.formatMessage(line), line.getThrown());
    }

    /// What JADE calls information is of use to those who look for mistakes.
    private static Level level(java.util.logging.Level level) {
        if (level.intValue() >= java.util.logging.Level.SEVERE.intValue()) {
            return Level.ERROR;
        }
        return level.intValue() >= java.util.logging.Level.WARNING.intValue() ? Level.WARNING : Level.DEBUG;
    }

    @Override
    public void flush() {}

    @Override
    public void close() {}
}
