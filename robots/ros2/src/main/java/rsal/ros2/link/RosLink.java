package rsal.ros2.link;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletionStage;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Supplier;
import rsal.ros2.type.Distribution;

/// How this program takes part in ROS 2. Messages are bytes in CDR, with their encapsulation header. Safe for
/// several threads.
public interface RosLink extends RosPublisher, AutoCloseable {
    /// A node of this program, as tools show it. What is opened by it is the node's; closing it takes all of
    /// that away, and the node. Closing the link closes its nodes.
    ///
    /// @param namespace `/robot1`; `/` for none
    RosLink node(String namespace, String name);

    /// All that others publish and subscribe to; the same list while nothing changes.
    List<RosEndpoint> endpoints();

    /// The distribution whose types all of its messages have; empty where each robot has its own.
    default Optional<Distribution> distribution() {
        return Optional.empty();
    }

    /// What keeps it from hearing others, for people.
    default Optional<String> trouble() {
        return Optional.empty();
    }

    /// What may be wrong where nothing of others is found, for people.
    default String suspicion() {
        return "maybe another 'domain' or 'address'?";
    }

    /// Opens or closes many things, of any node, of which others then hear once. What other threads open
    /// meanwhile waits for that, too.
    default void together(Runnable opening) {
        opening.run();
    }

    /// @param listener gets each message, on a thread of the link: be quick. The bytes are valid during the
    ///         call only.
    Subscribed subscribe(RosTopic topic, Profile profile, Consumer<ByteBuffer> listener);

    /// As [#subscribe], where it matters who publishes a message. Publishers that the link can't tell apart are one.
    ///
    /// @param listener gets the publisher's id, one of [Subscribed#publisherIds]
    default Subscribed subscribeEach(RosTopic topic, Profile profile, BiConsumer<String, ByteBuffer> listener) {
        return subscribe(topic, profile, message -> listener.accept(Subscribed.SOMEBODY, message));
    }

    /// The program of a publisher or subscriber with an id, for people.
    default String program(String id) {
        return "A program";
    }

    /// A service that others offer.
    ///
    /// @param name with its namespace: `/robot1/set_speed`
    /// @param type `example/srv/SetSpeed`; parts of actions are `nav2_msgs/action/NavigateToPose_SendGoal`
    ServiceClient client(String name, String type);

    /// Serves others.
    ///
    /// @param name and type as of [#client]
    /// @param server gets each request
    Served serve(String name, String type, Server server);

    @Override
    void close();

    /// Answers requests.
    interface Server {
        /// @param request in CDR, with its encapsulation header; called on a thread of the link
        /// @return the response in CDR, on any thread; none where it ends exceptionally
        CompletionStage<byte[]> answer(byte[] request);

        /// As [#answer(byte[])], where responses differ between distributions.
        ///
        /// @param responseHash says of which type the client wants its response: `RIHS01_…`; empty where it
        ///         does not
        default CompletionStage<byte[]> answer(byte[] request, Supplier<Optional<String>> responseHash) {
            return answer(request);
        }
    }

    /// A service that we offer.
    interface Served extends AutoCloseable {
        @Override
        void close();
    }

    /// Asks somebody for something. An answer never comes when the one who was asked is gone.
    interface ServiceClient extends AutoCloseable {
        /// Whether somebody serves it, and can answer.
        boolean isAvailable();

        /// @param request in CDR, with its encapsulation header
        /// @return the response in CDR, on a thread of the link; exceptionally when nobody serves it
        CompletionStage<byte[]> call(byte[] request);

        @Override
        void close();
    }

    /// A topic that we hear.
    interface Subscribed extends AutoCloseable {
        /// The id of all publishers, where they are not told apart.
        String SOMEBODY = "";

        /// How many publish it now.
        int publishers();

        /// Who publishes it now.
        default Set<String> publisherIds() {
            return publishers() > 0 ? Set.of(SOMEBODY) : Set.of();
        }

        @Override
        void close();
    }
}
