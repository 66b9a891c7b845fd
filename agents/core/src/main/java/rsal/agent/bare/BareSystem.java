package rsal.agent.bare;

import rsal.data.Pose2d;

/// A multi-agent system as those have it who use nothing else: agents written for it, which talk by the fastest means
/// that it has for one that speaks to all. What our hosts cost beside it is what we cost. Found by
/// [java.util.ServiceLoader].
public interface BareSystem {
    /// What its agents say.
    Pose2d POSE = Pose2d.ORIGIN;

    /// That of the host: `jade`.
    String key();

    /// Starts a platform, in real time and on threads of its own. Takes as long as that takes.
    Platform start();

    interface Platform extends AutoCloseable {
        /// Starts agents, soon. Called once.
        void start(int agents, Life life);

        /// Each of its agents says [#POSE] to all others so often, soon. May be called on any thread, also by one that
        /// hears something.
        void say(int times);

        /// Returns when no agent does anything any more, or soon will.
        @Override
        void close();
    }
}
