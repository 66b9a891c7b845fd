package rsal.jason;

import java.util.Set;
import rsal.agent.AgentLanguage;
import rsal.agent.AgentType;
import rsal.settings.FileSource;
import rsal.settings.Location;

/// AgentSpeak(L) as Jason reads it: Bordini, Hübner and Wooldridge, Programming Multi-Agent Systems in AgentSpeak using
/// Jason, Wiley 2007.
public final class AgentSpeak implements AgentLanguage {
    static final Set<String> TAKEN = Set.of("self", "percept");

    @Override
    public String suffix() {
        return ".asl";
    }

    /// Sources of what an agent believes.
    @Override
    public Set<String> takenNames() {
        return TAKEN;
    }

    @Override
    public AgentType read(String path, FileSource files, Location askedAt) {
        return new AgentSpeakType(Program.read(path, files, askedAt));
    }
}
