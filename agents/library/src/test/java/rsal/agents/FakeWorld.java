package rsal.agents;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Prism;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.SimulationControl;

/// A world that holds names and poses, within 100 m of its origin, and discs to look at.
public final class FakeWorld extends DeviceCore implements SimulationControl {
    private static final double EDGE = 100; // m
    public static final double WALL = 50; // x [m]: nothing fits there

    public final Map<String, Pose2d> things = new LinkedHashMap<>();
    private final List<Standing> discs = new ArrayList<>();

    public FakeWorld() {
        super(new DeviceInfo("", "simulation", "fake"));
    }

    /// @param height of its underside above the floor [m]
    public void addDisc(String name, Rgb color, double x, double y, double height) {
        var disc = Prism.standing(new Shape.Disc(new Point2d(0, 0), 0.1), 0.1).in(color);
        discs.add(new Standing(discs.size() + 1, name, new Solid(List.of(disc)), new Pose2d(x, y, 0), height, true));
    }

    @Override
    public List<Standing> things() {
        return List.copyOf(discs);
    }

    @Override
    public List<String> entities() {
        return List.copyOf(things.keySet());
    }

    @Override
    public Optional<Pose2d> truth(String entity) {
        return Optional.ofNullable(things.get(entity));
    }

    @Override
    public Placement place(String entity, Pose2d mapFromEntity) {
        return mapFromEntity.x() == WALL
                ? new Placement.Refused("a wall is there")
                : placeAnyway(entity, mapFromEntity);
    }

    @Override
    public Placement placeAnyway(String entity, Pose2d mapFromEntity) {
        return things.replace(entity, mapFromEntity) == null
                ? new Placement.Refused("no such thing")
                : new Placement.Placed();
    }

    @Override
    public Placement add(Thing thing) {
        if (thing.mapFromThing().distanceTo(Pose2d.ORIGIN) > EDGE) {
            return new Placement.Refused("it is outside");
        }
        things.put(thing.name(), thing.mapFromThing());
        return new Placement.Placed();
    }

    @Override
    public List<Contact> contacts() {
        return List.of();
    }
}
