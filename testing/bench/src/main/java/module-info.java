/// How fast RSAL is on this machine, area by area. Robot systems it asks through the middle layer's contracts, as
/// agents and scenarios do, and knows nothing of what is behind them; navigation's algorithms and the protocol of ROS 2
/// it calls, scenarios it runs, and runs it shows to a browser.
module rsal.bench {
    requires rsal.yaml;
    requires rsal.models;
    requires rsal.worlds;
    requires transitive rsal.devices;
    requires rsal.bare;
    requires rsal.agent.platform;
    requires rsal.jade;
    requires rsal.jason;
    requires jade;
    requires jason.interpreter;
    requires rsal.navigation;
    requires rsal.ros2.messages;
    requires rsal.rtps;
    requires rsal.engine;
    requires rsal.server;
    requires java.net.http; // what browsers are told
    requires jdk.management; // time of the processor, bytes allocated
    requires tools.jackson.databind;
    requires static org.jspecify;

    exports rsal.bench;
    exports rsal.bench.measurement;

    uses rsal.bare.BareLanguage;
    uses rsal.bare.BareSystem;
    uses rsal.robot.DeviceDriver;
    uses rsal.system.RobotSystemProvider;

    provides rsal.bare.BareLanguage with
            rsal.bench.bare.BareJason;
    provides rsal.bare.BareSystem with
            rsal.bench.bare.BareJava,
            rsal.bench.bare.BareJade;
}
