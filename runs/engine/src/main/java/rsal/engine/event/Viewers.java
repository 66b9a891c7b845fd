package rsal.engine.event;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import rsal.device.Subscription;

/// Those who want to know when there is something new of a run. They come and go on any thread, and are told on the
/// run's. One that throws is told no more.
public final class Viewers {
    private static final Logger LOG = System.getLogger(Viewers.class.getName());

    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();

    public Subscription add(Runnable listener) {
        listeners.add(listener);
        return () -> listeners.remove(listener);
    }

    public void publish() {
        listeners.forEach(listener -> {
            try {
                listener.run();
            } catch (RuntimeException e) {
                listeners.remove(listener);
                LOG.log(Level.ERROR, "A viewer failed and is not notified any more.", e);
            }
        });
    }
}
