/// Agents and plugins written in Java, in files beside a scenario (`type: Hunter.java`), which are compiled
/// when the scenario is read. Knows nothing of scenarios.
module rsal.java {
    requires transitive rsal.agent.api;
    requires java.compiler;
    requires static org.jspecify;

    exports rsal.java;

    uses javax.tools.JavaCompiler;

    provides rsal.agent.AgentLanguage with
            rsal.java.JavaLanguage;
    provides rsal.settings.PluginLanguage with
            rsal.java.JavaPlugins;
}
