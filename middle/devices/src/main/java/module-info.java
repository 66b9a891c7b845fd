/// What agents may ask of robots: devices and their health, robots, time, and the contracts that robot systems,
/// bridges and device drivers fulfil. Contracts and values only: no file format, no picture, no algorithm.
module rsal.devices {
    requires transitive rsal.settings;
    requires static org.jspecify;

    exports rsal.device;
    exports rsal.device.camera;
    exports rsal.device.gnss;
    exports rsal.device.imu;
    exports rsal.fault;
    exports rsal.robot;
    exports rsal.scene;
    exports rsal.system;
    exports rsal.time;

    uses rsal.robot.DeviceDriver;
    uses rsal.robot.DeviceKind;
    uses rsal.system.BridgeProvider;
    uses rsal.system.RobotRecorderProvider;
    uses rsal.system.RobotSystemProvider;

    provides rsal.robot.DeviceKind with
            rsal.device.camera.CameraKind,
            rsal.device.gnss.GnssKind,
            rsal.device.imu.ImuKind;
}
