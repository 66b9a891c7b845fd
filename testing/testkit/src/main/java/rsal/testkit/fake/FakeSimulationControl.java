package rsal.testkit.fake;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import rsal.data.Fan;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.SimulationControl;

/// The truth about the fake robots, and about things.
public final class FakeSimulationControl extends DeviceCore implements SimulationControl {
    private final List<FakeDriveBase> bases;
    private final FakeWorld things;
    private final OccupancyGrid world;
    private final List<Contact> contacts = new ArrayList<>();

    FakeSimulationControl(List<FakeDriveBase> bases, FakeWorld things, OccupancyGrid world) {
        super(new DeviceInfo("", "simulation", "fake"));
        this.bases = bases;
        this.things = things;
        this.world = world;
    }

    @Override
    public List<String> entities() {
        return Stream.concat(bases.stream().map(base -> base.info().robot()), things.names().stream())
                .toList();
    }

    @Override
    public Optional<Pose2d> truth(String entity) {
        return base(entity)
                .map(FakeDriveBase::mapFromBase)
                .or(() -> things.find(entity).map(Thing::mapFromThing));
    }

    @Override
    public Placement place(String entity, Pose2d mapFromEntity) {
        return world.isFree(mapFromEntity.x(), mapFromEntity.y())
                ? placeAnyway(entity, mapFromEntity)
                : new Placement.Refused("A wall is there.");
    }

    @Override
    public Placement placeAnyway(String entity, Pose2d mapFromEntity) {
        Optional<FakeDriveBase> base = base(entity);
        Optional<Thing> thing = things.find(entity);
        if (base.isEmpty() && thing.isEmpty()) {
            return new Placement.Refused("Nothing is called '%s'.".formatted(entity));
        }
        if (isOutside(mapFromEntity)) {
            return new Placement.Refused("That is outside.");
        }
        base.ifPresent(robot -> robot.place(mapFromEntity));
        thing.ifPresent(moved -> things.move(moved.name(), mapFromEntity));
        return new Placement.Placed();
    }

    @Override
    public Placement placeAnyway(String thing, Pose2d mapFromThing, double height) {
        return things.find(thing).isPresent()
                ? placeAnyway(thing, mapFromThing)
                : new Placement.Refused("There is no thing '%s'.".formatted(thing));
    }

    private boolean isOutside(Pose2d pose) {
        return !pose.isFinite() || !world.contains(world.column(pose.x()), world.row(pose.y()));
    }

    @Override
    public Placement add(Thing thing) {
        return world.isFree(thing.mapFromThing().x(), thing.mapFromThing().y())
                ? addAnyway(thing)
                : new Placement.Refused("A wall is there.");
    }

    @Override
    public Placement addAnyway(Thing thing) {
        if (entities().contains(thing.name())) {
            return new Placement.Refused("Something is called '%s' already.".formatted(thing.name()));
        }
        if (isOutside(thing.mapFromThing())) {
            return new Placement.Refused("That is outside.");
        }
        things.add(thing);
        return new Placement.Placed();
    }

    @Override
    public boolean remove(String thing) {
        return things.remove(thing);
    }

    @Override
    public double[] ranges(List<Fan> fans, Pose2d mapFromBase, double height, double reach, Set<String> through) {
        return fans.stream()
                .flatMapToDouble(fan -> IntStream.range(0, fan.count())
                        .mapToObj(ray -> mapFromBase
                                .compose(fan.baseFromSensor())
                                .compose(new Pose2d(0, 0, fan.first() + ray * fan.increment())))
                        .mapToDouble(mapFromRay -> range(mapFromRay, height, through)))
                .map(range -> range <= reach ? range : Double.POSITIVE_INFINITY)
                .toArray();
    }

    private double range(Pose2d mapFromRay, double height, Set<String> through) {
        double ofRobots = bases.stream()
                .filter(base -> !through.contains(base.info().robot()))
                .mapToDouble(base -> FakeWorld.range(mapFromRay, base.mapFromBase(), base.radius()))
                .min()
                .orElse(Double.POSITIVE_INFINITY);
        return things.things().stream()
                .filter(thing -> !through.contains(thing.name()))
                .filter(thing -> height <= thing.body().top())
                .mapToDouble(thing -> FakeWorld.range(mapFromRay, thing.mapFromThing(), FakeWorld.radius(thing)))
                .reduce(ofRobots, Math::min);
    }

    @Override
    public List<Contact> contacts() {
        return List.copyOf(contacts);
    }

    void touched(Instant time, String robot) {
        contacts.add(new Contact(time, robot, "wall"));
    }

    private Optional<FakeDriveBase> base(String robot) {
        return bases.stream().filter(base -> base.info().robot().equals(robot)).findFirst();
    }
}
