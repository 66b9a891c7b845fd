/// Runs of scenarios, from start to result: time, agents and robots, events, metrics, messages between robots
/// that may be lost, and what people command. Names robot systems, agent hosts and agents by key, and knows
/// nothing of those that stand behind.
module rsal.engine {
    requires rsal.models;
    requires rsal.behaviors;
    requires transitive rsal.scenarios;
    requires java.management; // processor time of threads
    requires static org.jspecify;

    exports rsal.engine;
    exports rsal.engine.report;
}
