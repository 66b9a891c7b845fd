/// What agents may ask of robots: devices and their health, robots, behaviors, time, and the contracts that robot
/// systems and device drivers fulfil. Knows nothing of agents, simulators, networks or algorithms.
module rsal.devices {
    requires transitive rsal.data;
    requires org.snakeyaml.engine;
    requires java.desktop; // ImageIO reads map images
    requires static org.jspecify;

    exports rsal.behavior;
    exports rsal.device;
    exports rsal.fault;
    exports rsal.image;
    exports rsal.map;
    exports rsal.robot;
    exports rsal.scene;
    exports rsal.scene.yaml;
    exports rsal.settings;
    exports rsal.system;
    exports rsal.time;

    uses rsal.robot.DeviceDriver;
    uses rsal.system.BridgeProvider;
    uses rsal.system.RobotSystemProvider;
    uses rsal.scene.SceneFormat;

    provides rsal.robot.DeviceDriver with
            rsal.behavior.PilotDriver;
    provides rsal.scene.SceneFormat with
            rsal.scene.yaml.YamlFormat;
}
