/// Agents written in AgentSpeak, on the interpreter Jason (jason-lang.github.io, LGPL-3.0), with percepts and actions
/// of their robots. Knows robots only as devices of the middle layer; knows nothing of scenarios.
module rsal.jason {
    requires rsal.behaviors;
    requires transitive rsal.agent.platform;
    requires jason.interpreter;
    requires java.logging;
    requires java.management;
    requires static org.jspecify;

    exports rsal.jason;

    provides rsal.agent.AgentHostProvider with
            rsal.jason.JasonHostProvider;
    provides rsal.agent.AgentLanguage with
            rsal.jason.AgentSpeak;
}
