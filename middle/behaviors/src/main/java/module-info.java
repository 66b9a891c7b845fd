/// Behaviors that drive a robot without a map, and the pilot, a device that decides which of them does.
module rsal.behaviors {
    requires transitive rsal.devices;
    requires static org.jspecify;

    exports rsal.behavior;

    provides rsal.robot.DeviceDriver with
            rsal.behavior.PilotDriver;
}
