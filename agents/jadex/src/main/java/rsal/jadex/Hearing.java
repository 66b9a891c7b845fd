package rsal.jadex;

import jadex.bridge.service.annotation.Reference;
import jadex.bridge.service.annotation.Service;
import jadex.commons.future.IFuture;

/// The service of each agent by which others have conversations with it, so that Jadex's tools see those.
@Service
public interface Hearing {
    /// What is said is handed over as it is, not copied.
    ///
    /// @return done when it has been taken, which is before it is heard
    IFuture<Void> hear(@Reference Spoken said);
}
