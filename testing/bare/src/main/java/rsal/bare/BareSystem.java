package rsal.bare;

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

        /// Starts a manager and so many bidders, soon, instead of [#start]. The manager calls for proposals,
        /// accepts the first when it has all, refuses the others, and calls again when the work is done: by the
        /// system's own contract net where it has one. Called once.
        ///
        /// @param ended told of each net that has ended, on the manager's thread
        void contract(int bidders, Runnable ended);

        /// Returns when no agent does anything any more, or soon will.
        @Override
        void close();
    }
}
