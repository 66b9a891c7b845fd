package rsal.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.SimulationControl.Contact;
import rsal.sim.world.Body;
import rsal.sim.world.CollisionShape;
import rsal.sim.world.RasterWalls;
import rsal.sim.world.World;
import rsal.testkit.DrawnMap;

class ContactTrackerTest {
    @Test
    void contactsThatWereShownStayAsTheyAre() {
        var world = new World(RasterWalls.of(DrawnMap.grid(10, ".").grid()));
        List<CollisionShape> box = CollisionShape.of(Footprint.box(0.5, 0.4, new Point2d(0, 0)));
        Body robot = world.add("r", box, new Pose2d(5, 5, 0), 0);
        var tracker = new ContactTracker();
        var copies = new ArrayList<List<Contact>>();
        var shown = new ArrayList<List<Contact>>();
        for (int i = 0; i < 300; i++) {
            if (i % 3 > 0) {
                tracker.ranInto(robot, Optional.empty(), Instant.ofEpochSecond(i));
            }
            tracker.update(world); // it is far from walls
            shown.add(tracker.contacts());
            copies.add(List.copyOf(tracker.contacts()));
        }
        assertThat(shown).isEqualTo(copies);
        assertThat(tracker.contacts()).hasSize(200);
        assertThat(tracker.contacts().getLast()).isEqualTo(new Contact(Instant.ofEpochSecond(299), "r", World.WALL));
    }
}
