package rsal.world.yaml;

import java.util.ArrayList;
import java.util.List;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.scene.Surface;
import rsal.settings.Section;

/// Reads what stands in a world: furniture, boxes, pucks, markers.
final class ThingReader {
    private final Names names;
    private final List<Entity> things = new ArrayList<>();
    private final List<Entity> fixed = new ArrayList<>();
    private final List<Entity> moving = new ArrayList<>();

    ThingReader(Names names) {
        this.names = names;
    }

    /// All of them.
    List<Entity> things() {
        return things;
    }

    /// Those of them that stay.
    List<Entity> fixed() {
        return fixed;
    }

    /// Those of them that may be elsewhere later.
    List<Entity> moving() {
        return moving;
    }

    /// @param section named groups
    void read(Section section) {
        for (String name : section.names()) {
            thing(name, section.section(name));
        }
        section.done();
    }

    private void thing(String name, Section section) {
        int count = section.has("count") ? (int) Keys.whole(section, Keys.COUNT) : 0;
        boolean several =
                count > 0 || section.find("pose").filter(FloorPlace::isList).isPresent();
        List<FloorPlace> places =
                several ? FloorPlace.several(section, "pose", count) : List.of(FloorPlace.one(section, "pose"));
        Surface surface = SurfaceReader.read(section, Surface.PLAIN);
        if (!section.has("body")) {
            section.problem(section.location(), "'%s' is missing.".formatted(section.path("body")), "{radius: 0.2}");
            section.done();
            return;
        }
        List<Block> blocks = SolidReader.read(section.section("body"), surface).blocks(surface.color());
        if (blocks.isEmpty()) {
            section.problem("body", "'%s' must have pieces.".formatted(section.path("body")), "{radius: 0.2}");
        }
        boolean moves = section.has("moves") ? Keys.flag(section, Keys.MOVES) : surface.grippable();
        double giving = section.has("givingPower") ? Keys.number(section, Keys.GIVING) : 0;
        section.done();
        for (int i = 0; i < places.size(); i++) {
            String own = several ? name + "-" + (i + 1) : name;
            names.claim(own, blocks.size(), section.location());
            FloorPlace place = places.get(i);
            var thing = new Entity(own, blocks, place.pose(), place.height(), giving);
            things.add(thing);
            (moves ? moving : fixed).add(thing);
        }
    }
}
