/// How fast RSAL is on this machine, area by area. Robot systems it asks through the middle layer's contracts, as
/// agents and scenarios do, and knows nothing of what is behind them; navigation's algorithms it calls, scenarios
/// it runs, and runs it shows to a browser.
module rsal.bench {
    requires rsal.yaml;
    requires rsal.models;
    requires rsal.worlds;
    requires transitive rsal.devices;
    requires rsal.agent.platform;
    requires rsal.navigation;
    requires rsal.engine;
    requires rsal.server;
    requires java.net.http; // what browsers are told
    requires jdk.management; // time of the processor, bytes allocated
    requires tools.jackson.databind;
    requires static org.jspecify;

    exports rsal.bench;
    exports rsal.bench.measurement;

    uses rsal.agent.bare.BareLanguage;
    uses rsal.agent.bare.BareSystem;
    uses rsal.robot.DeviceDriver;
    uses rsal.system.RobotSystemProvider;
}
