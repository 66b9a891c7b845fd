/// Agents and plugins written in Java, in files beside a scenario (`type: Hunter.java`), which are compiled
/// when the scenario is read. Knows nothing of scenarios.
module rsal.java {
    requires transitive rsal.agent.api;
    requires java.compiler;
    requires org.eclipse.jdt.core.compiler.batch; // where the Java runtime has no compiler
    requires static org.jspecify;

    exports rsal.java;

    provides rsal.agent.AgentLanguage with
            rsal.java.JavaLanguage;
    provides rsal.settings.PluginLanguage with
            rsal.java.JavaPlugins;
}
