package rsal.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;
import rsal.scene.Entity;
import rsal.scene.Surface;
import rsal.sim.world.CollisionShape;
import rsal.sim.world.Extent;
import rsal.sim.world.World;

class ThingsTest {
    private final World world = new World(List.of(), new Extent(0, 0, 10, 10));
    private final Things things = new Things();

    @Test
    void knowsWhatChargesRobotsInTheOrderInWhichItCame() {
        add("a", 5);
        add("b", 0);
        add("c", 7);
        assertThat(givers()).containsExactly("a", "c");
        things.remove("a");
        things.remove("b");
        add("d", 1);
        assertThat(givers()).containsExactly("c", "d");
    }

    /// Else worlds of many things would take long to load.
    @Test
    void doesNotLookThroughAllThingsForEachThatComes() {
        add("charger", 5);
        var before = things.givers();
        add("box", 0);
        assertThat(things.givers()).isSameAs(before);
        things.remove("box");
        assertThat(things.givers()).isSameAs(before);
    }

    private List<String> givers() {
        return things.givers().stream().map(item -> item.body().name()).toList();
    }

    private void add(String name, double givingPower) {
        var blocks = Entity.blocks(Models.box(Models.DRIVE).body(), Surface.PLAIN.color());
        things.add(world.add(name, CollisionShape.of(blocks), new Pose2d(1, 1, 0), 0), blocks, givingPower);
    }
}
