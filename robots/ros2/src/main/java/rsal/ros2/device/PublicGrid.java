package rsal.ros2.device;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.Optional;
import java.util.function.ObjLongConsumer;
import rsal.data.OccupancyGrid;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.RosLink.Subscribed;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.CellMeaning;
import rsal.ros2.message.MapMessage;
import rsal.ros2.message.RosMessages;

/// A map that somebody publishes as `nav_msgs/OccupancyGrid`, and whose changes come as `map_msgs/OccupancyGridUpdate`
/// on a topic beside it (`map_updates`). Changes that do not fit the map change nothing; the first is
/// told, and at the end how many there were.
final class PublicGrid {
    private static final Logger LOG = System.getLogger(PublicGrid.class.getName());
    private static final String GRID = "nav_msgs/msg/OccupancyGrid";
    private static final String UPDATE = "map_msgs/msg/OccupancyGridUpdate";
    private static final long EARLIEST = 1_000_000_000; // ns, by which clocks of several machines may be apart
    private static final int UPDATES_WAITING = 20; // each may be as large as the map

    private final RosTopic updates;
    private final CellMeaning meaning;
    private final ObjLongConsumer<OccupancyGrid> listener;
    private final RobotClock clock;
    private final Subscribed whole;
    private final Subscribed changes;
    private Optional<OccupancyGrid> newest = Optional.empty();
    private long stamp; // of the newest whole one [ns]
    private long updated; // stamp of its newest update [ns]; 0 for none
    private int resets; // of the robot's time, when it was last looked at
    private Optional<RosMessage> outdated = Optional.empty(); // the newest whole one, if time was not seen to go back
    private long damaged; // updates

    /// @param topic of whole maps
    /// @param listener gets each map with its stamp [ns]
    PublicGrid(RosTopic topic, CellMeaning meaning, RosContext context, ObjLongConsumer<OccupancyGrid> listener) {
        this.meaning = meaning;
        this.listener = listener;
        clock = context.clock();
        updates = new RosTopic(topic.name() + "_updates", UPDATE);
        RobotTopics topics = context.topics();
        whole = context.link().subscribe(topic, context.reliable(topic), context.inbox(GRID, 1, this::take));
        changes = context.link()
                .subscribe(updates, topics.reliable(updates), context.inbox(UPDATE, UPDATES_WAITING, this::takeUpdate));
    }

    /// One that is older than an update comes again or late, and would undo it. It may also be of a time that began
    /// again, which odometry has yet to say: so it is kept until then.
    private void take(RosMessage message) {
        long when = stamp(message);
        look();
        if (when != 0 && when < updated) {
            outdated = Optional.of(message);
            return;
        }
        outdated = Optional.empty();
        MapMessage.of(message, meaning).ifPresent(map -> {
            stamp = when;
            updated = 0;
            publish(map, stamp);
        });
    }

    /// Stamps from before the robot's time went back say nothing any more, which is to be looked at now and then.
    void look() {
        if (resets != clock.resets()) {
            resets = clock.resets();
            stamp = 0;
            updated = 0;
            Optional<RosMessage> kept = outdated;
            outdated = Optional.empty();
            kept.ifPresent(this::take);
        }
    }

    /// [ns]; 0 for none, and for one of the future, by which all that comes after it would be old.
    private long stamp(RosMessage message) {
        long when = RosMessages.stamp(message.message("header"));
        long now = clock.stamp();
        return now != 0 && when > now + EARLIEST ? 0 : when;
    }

    private void publish(OccupancyGrid map, long when) {
        newest = Optional.of(map);
        listener.accept(map, when);
    }

    /// Those that are older than the map are in it already. Updates of Nav2's costmaps in Humble and Jazzy have no time
    /// (stamp 0), and come after the map.
    private void takeUpdate(RosMessage update) {
        long when = stamp(update);
        look();
        if (newest.isEmpty() || (when != 0 && when < stamp)) {
            return;
        }
        Optional<OccupancyGrid> changed = MapMessage.updated(newest.get(), update, meaning);
        changed.ifPresent(map -> {
            updated = Math.max(updated, when);
            publish(map, when == 0 ? stamp : when);
        });
        if (changed.isEmpty() && damaged++ == 0) {
            LOG.log(
                    Level.WARNING,
                    () -> "An update on '%s' does not fit the map of %d × %d cells. It is ignored, as others like it."
                            .formatted(
                                    updates.name(),
                                    newest.get().width(),
                                    newest.get().height()));
        }
    }

    /// The newest map; empty before the first one.
    Optional<OccupancyGrid> newest() {
        look();
        return newest;
    }

    /// How many publish whole maps.
    int publishers() {
        return whole.publishers();
    }

    void close() {
        if (damaged > 0) {
            LOG.log(Level.INFO, () -> "%d updates on '%s' did not fit the map.".formatted(damaged, updates.name()));
        }
        whole.close();
        changes.close();
    }
}
