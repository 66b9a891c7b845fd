package rsal.bare;

import java.util.Map;

/// A language in which agents are written, on the system that it comes from, as those have it who use nothing else. The
/// same programs run on our host ([rsal.agent.AgentLanguage]): what that costs beside it is what we cost.
/// Found by [java.util.ServiceLoader].
public interface BareLanguage {
    /// What a program calls the belief in which it counts.
    String COUNT = "count";

    /// What a program calls its belief of how long a [Program#TALKER] or a [Program#MANAGER] waits before it does
    /// again what it did [ms]: 0, if nobody says otherwise.
    String MOMENT = "moment";

    /// That of the host: `jason`.
    String key();

    /// How its files' names end: `.asl`.
    String suffix();

    /// A program's text, as its file would have it.
    String text(Program program);

    /// Starts a platform, in real time and on threads of its own. One at a time in a process.
    Platform start();

    /// What agents do for benchmarks. All but bidders count in one belief what they have done.
    enum Program {
        /// Counts one when it has begun, and does no more.
        BEGINNER,
        /// Says a pose to all others ten times a second, as far as it can, and counts those that it hears.
        TELLER,
        /// Says a pose to all others, and again whenever it has heard as many as there are others; counts what it
        /// hears.
        TALKER,
        /// Calls all others for proposals, accepts the best when it has all, refuses the others, and calls again when
        /// the work is done; counts those contract nets.
        MANAGER,
        /// Proposes whenever somebody calls, and says that the work is done as soon as it has been accepted.
        BIDDER
    }

    interface Platform extends AutoCloseable {
        /// Starts agents, none of which begins before all are there. Called once.
        ///
        /// @param agents what each does, by name, in the order in which they start
        void start(Map<String, Program> agents);

        /// What an agent that counts has counted so far, as it believes between two of its steps.
        ///
        /// @throws IllegalStateException when it does not tell for seconds
        long count(String agent);

        /// Returns when no agent does anything any more.
        @Override
        void close();
    }
}
