/// Scenarios: the format in which people write them, what is planned from it, and the scenarios themselves. Names
/// robot systems, device drivers, agent hosts and agents by key, and knows nothing of those that stand behind.
module rsal.scenarios {
    requires rsal.yaml;
    requires rsal.models;
    requires transitive rsal.worlds;
    requires rsal.behaviors;
    requires transitive rsal.agent.platform;
    requires transitive rsal.devices;
    requires transitive java.desktop; // draws worlds
    requires tools.jackson.databind;
    requires static org.jspecify;

    exports rsal.scenario;
    exports rsal.scenario.condition;
    exports rsal.scenario.fault;
    exports rsal.scenario.installed;
    exports rsal.scenario.picture;
    exports rsal.scenario.text;

    uses rsal.agent.AgentHostProvider;
    uses rsal.agent.AgentLanguage;
    uses rsal.agent.AgentType;
    uses rsal.metric.MetricType;
    uses rsal.settings.PluginLanguage;
    uses rsal.robot.DeviceDriver;
    uses rsal.world.SceneFormat;
    uses rsal.system.BridgeProvider;
    uses rsal.system.RobotRecorderProvider;
    uses rsal.system.RobotSystemProvider;
}
