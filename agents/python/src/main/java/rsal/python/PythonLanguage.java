package rsal.python;

import java.util.Optional;
import rsal.agent.AgentLanguage;
import rsal.agent.AgentType;
import rsal.agent.RunPreparation;
import rsal.settings.FileSource;
import rsal.settings.Location;

/// Python, in files of people's own: `hunter.py`, or `hunter.py:Hunter` where a file has several agents; or in a
/// package
/// that is installed: `python:package.module:Hunter`. What there is to know of an agent before a run is read from the
/// text of its file, which is run only when a run begins.
public final class PythonLanguage implements AgentLanguage {
    @Override
    public String suffix() {
        return PythonSources.SUFFIX;
    }

    @Override
    public boolean reads(String type) {
        return type.endsWith(suffix()) || type.contains(suffix() + ":") || PythonSources.isInstalled(type);
    }

    @Override
    public String pattern() {
        return "\\.py(:\\w+)?$|^python:[\\w.]+:\\w+$";
    }

    @Override
    public Optional<String> file(String type) {
        return PythonSources.isInstalled(type) ? Optional.empty() : Optional.of(PythonSources.path(type));
    }

    @Override
    public boolean runsCode() {
        return true;
    }

    @Override
    public Optional<String> unavailable() {
        return Interpreter.missing();
    }

    @Override
    public RunPreparation prepare(int atOnce, int inAll) {
        return ProcessesAhead.prepare(atOnce, inAll);
    }

    @Override
    public AgentType read(String type, FileSource files, Location askedAt) {
        var sources = PythonSources.read(type, files, askedAt);
        return PythonType.of(type, sources, Inspection.of(sources, askedAt));
    }
}
