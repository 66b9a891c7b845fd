package rsal.jason;

import rsal.agent.AgentLanguage;
import rsal.agent.AgentType;
import rsal.settings.FileSource;
import rsal.settings.Location;

/// AgentSpeak(L) as Jason reads it: Bordini, Hübner and Wooldridge, Programming Multi-Agent Systems in AgentSpeak using
/// Jason, Wiley 2007.
final class AgentSpeak implements AgentLanguage {
    @Override
    public String suffix() {
        return ".asl";
    }

    @Override
    public AgentType read(String path, FileSource files, Location askedAt) {
        return new WrittenType(Program.read(path, files, askedAt));
    }
}
