/// JADE (jade.tilab.com), a multi-agent system after FIPA's standards, as a host of our agents. Knows nothing of robots
/// beyond what agents know of them, and nothing of scenarios.
@SuppressWarnings("module") // which is compiled later
module rsal.jade {
    requires rsal.agent.platform;
    requires jade;
    requires java.desktop;
    requires java.logging;
    requires static org.jspecify;

    exports rsal.jade to
            rsal.bench; // which measures JADE without RSAL

    provides rsal.agent.AgentHostProvider with
            rsal.jade.JadeHostProvider;
}
