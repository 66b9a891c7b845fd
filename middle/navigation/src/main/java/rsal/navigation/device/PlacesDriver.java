package rsal.navigation.device;

import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.device.PlaceFinder;
import rsal.robot.DeviceDriver;
import rsal.settings.Arguments;

/// Makes place finders that spread places over the run's map ([rsal.navigation.spread.Spreader]), or choose
/// them by another objective ([rsal.navigation.spread.TeamPlaces]).
public final class PlacesDriver implements DeviceDriver {
    private final MapPlaceFinder.Kept kept = new MapPlaceFinder.Kept();

    @Override
    public String key() {
        return "places";
    }

    @Override
    public String description() {
        return "Finds places for a team, by an objective, that robots can reach.";
    }

    @Override
    public Class<? extends Device> makes() {
        return PlaceFinder.class;
    }

    @Override
    public Device create(Context context, Arguments arguments) {
        return new MapPlaceFinder(
                new DeviceInfo(context.robot().id(), context.name(), key()),
                context.map(),
                kept,
                context.random().nextLong(),
                context.scheduler());
    }
}
