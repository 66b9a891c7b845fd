package rsal.robot;

import java.util.function.BiConsumer;
import rsal.device.Subscription;

/// How software devices of a robot exchange messages with those of the other robots in the run, without agents: as
/// far as the robots' radio reaches. A message may be lost or late, and two may arrive in another order, so
/// senders repeat what matters. A robot of any robot system takes part in the same way. All calls and callbacks on the
/// run's thread.
public interface TeamLink {
    /// That of a robot that nobody hears.
    TeamLink ALONE = new TeamLink() {
        @Override
        public void publish(Record message) {}

        @Override
        public void send(String robot, Record message) {}

        @Override
        public <M extends Record> Subscription onMessage(Class<M> type, BiConsumer<String, M> listener) {
            return () -> {};
        }
    };

    /// Says something to all other robots.
    ///
    /// @param message immutable
    void publish(Record message);

    /// Says something to one other robot; nothing happens where nobody has that id.
    ///
    /// @param robot its id
    /// @param message immutable
    void send(String robot, Record message);

    /// Hears messages of one type.
    ///
    /// @param listener gets the id of the sender and the message
    <M extends Record> Subscription onMessage(Class<M> type, BiConsumer<String, M> listener);
}
