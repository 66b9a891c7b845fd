package rsal.jason;

import jason.util.Config;
import java.lang.System.Logger.Level;
import java.util.logging.Handler;
import java.util.logging.LogRecord;
import java.util.logging.Logger;

/// Keeps Jason from what it does by default: to open a port for its mind inspector, to be set by files in the
/// working and the home folder, and to write to the console.
public final class JasonDefaults {
    private static final System.Logger LOG = System.getLogger("rsal.jason");
    private static final Logger JASON = Logger.getLogger("jason"); // held, else it is forgotten with its settings
    private static final Logger PARSER = Logger.getLogger("aslparser");

    static {
        Config settings = Config.get();
        settings.clear();
        settings.setProperty(Config.START_WEB_MI, "false");
        handOver(JASON);
        handOver(PARSER);
    }

    private JasonDefaults() {}

    /// Does so once in a process; again, it does nothing.
    public static void override() {}

    private static void handOver(Logger logger) {
        logger.setUseParentHandlers(false);
        logger.addHandler(new Handler() {
            @Override
            public void publish(LogRecord said) {
                LOG.log(Level.DEBUG, said::getMessage); // what matters of it, agents tell themselves
            }

            @Override
            public void flush() {}

            @Override
            public void close() {}
        });
    }
}
