package rsal.java;

import rsal.agent.AgentLanguage;
import rsal.agent.AgentType;
import rsal.settings.FileSource;
import rsal.settings.Location;

/// Java, in files of people's own. Such a file has a public class of its name, an [AgentType] or an
/// [rsal.agent.Agent]. It may use classes of other files in its folder, each called as its class is. Files of
/// one folder see the same classes, so that their agents can exchange messages of their own.
public final class JavaLanguage implements AgentLanguage {
    @Override
    public String suffix() {
        return ".java";
    }

    @Override
    public boolean runsCode() {
        return true;
    }

    @Override
    public AgentType read(String path, FileSource files, Location askedAt) {
        var sources = Sources.read(path, files, askedAt);
        return JavaType.of(sources, FolderClasses.of(askedAt.file(), sources));
    }
}
