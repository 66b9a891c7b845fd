package rsal.robot;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.random.RandomGenerator;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Device;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.time.Scheduler;

/// Makes a device from a robot's other devices (AMCL, VFH…), so that an agent cannot tell it from hardware. Found
/// by [java.util.ServiceLoader] and named by its key in a scenario (`localizer: {type: amcl}`).
public interface DeviceDriver {
    /// `amcl`, `navigator`.
    String key();

    /// A sentence about what it makes.
    String description();

    /// What it makes.
    Class<? extends Device> makes();

    /// Why it can not work on robots of a model, in a sentence; empty when it can.
    default Optional<String> refusal(RobotModel model) {
        return Optional.empty();
    }

    /// Why it can not work with what other drivers make, in a sentence; empty when it can.
    ///
    /// @param before drivers of the robot's software devices that are made before this one
    default Optional<String> refusal(List<DeviceDriver> before) {
        return Optional.empty();
    }

    /// Why it can not be set like that, though each of its options may be, in a sentence; empty when it can.
    default Optional<String> refusal(Arguments arguments) {
        return Optional.empty();
    }

    /// Types of devices that the robot must have before this one can be made.
    default List<Class<? extends Device>> needs() {
        return List.of();
    }

    default List<Parameter<?>> parameters() {
        return List.of();
    }

    /// What to say to somebody who sets something that is no parameter here but is one of a program that people come
    /// from: what is instead, or why there is nothing. In a sentence; empty when it is not known.
    default Optional<String> advice(String option) {
        return Optional.empty();
    }

    /// What people should know who tell nobody where a robot with such a device starts, in a sentence; empty when
    /// there is nothing to know.
    default Optional<String> noteWithoutStart() {
        return Optional.empty();
    }

    /// Which places robots don't get to that such a device drives, and why: sentences that name the place, by its
    /// index among those asked about. Empty when they get to all, or it can't tell. Takes a while on large maps.
    default SortedMap<Integer, String> misplaced(Places asked, Arguments arguments) {
        return Collections.emptySortedMap();
    }

    /// Makes the device and starts its work on the scheduler.
    Device create(Context context, Arguments arguments);

    /// @param name of the device to make, as the scenario calls it (`localizer`)
    /// @param robot with the devices made so far
    /// @param mapFromBase where the scenario says the robot starts; empty when it must find out
    /// @param random a stream of this device's own
    /// @param team by which it hears devices of other robots
    record Context(
            String name,
            Robot robot,
            OccupancyGrid map,
            Optional<Pose2d> mapFromBase,
            Scheduler scheduler,
            RandomGenerator random,
            TeamLink team) {
        /// Of a robot that hears no other.
        public Context(
                String name,
                Robot robot,
                OccupancyGrid map,
                Optional<Pose2d> mapFromBase,
                Scheduler scheduler,
                RandomGenerator random) {
            this(name, robot, map, mapFromBase, scheduler, random, TeamLink.ALONE);
        }
    }

    /// Places where robots of a model are to go.
    ///
    /// @param mapFromStarts where robots are at first: it is enough to get there from one of them; none when
    /// that is not known
    /// @param mapFromPlaces where they are to go
    /// @param within how near is near enough, for each of the places [m]
    record Places(
            OccupancyGrid map,
            RobotModel model,
            List<Point2d> mapFromStarts,
            List<Point2d> mapFromPlaces,
            List<Double> within) {
        public Places {
            mapFromStarts = List.copyOf(mapFromStarts);
            mapFromPlaces = List.copyOf(mapFromPlaces);
            within = List.copyOf(within);
        }
    }
}
