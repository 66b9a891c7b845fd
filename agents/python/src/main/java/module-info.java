/// Agents written in Python, in files beside a scenario (`type: hunter.py`). They live in a process of Python, and are
/// proxies here. Knows robots only as devices of the middle layer; knows nothing of scenarios.
module rsal.python {
    requires transitive rsal.agent.platform;
    requires rsal.behaviors;
    requires rsal.frames;
    requires static org.jspecify;

    exports rsal.python;

    uses rsal.python.ObservationService;

    provides rsal.agent.AgentLanguage with
            rsal.python.PythonLanguage;
}
