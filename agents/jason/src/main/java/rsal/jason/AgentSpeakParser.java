package rsal.jason;

import jason.JasonException;
import jason.asSemantics.Agent;
import jason.asSyntax.parser.ParseException;
import jason.asSyntax.parser.as2j;
import jason.asSyntax.parser.as2jConstants;
import java.io.Reader;
import java.util.Optional;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// Jason's parser, but that files are included only from where the agent's own file is. Of its other directives none
/// is read: they load classes by name.
final class AgentSpeakParser extends as2j {
    private final String file;
    private final Includes includes;
    private final Parser parser;

    /// Gives the text of a file.
    interface Includes {
        /// @param askedAt where it is named
        /// @return empty when it has been read already
        Optional<String> text(String file, Location askedAt);

        /// There is a directive that is not read; what follows it is.
        void refuse(InvalidSettings error);
    }

    /// Reads a file into an agent.
    interface Parser {
        void read(String file, Location askedAt, Agent agent, Includes includes);
    }

    AgentSpeakParser(Reader text, String file, Includes includes, Parser parser) {
        super(text);
        this.file = file;
        this.includes = includes;
        this.parser = parser;
        setASLSource(file);
    }

    /// Of what was read last.
    int line() {
        return Math.max(1, getToken(0).beginLine);
    }

    int column() {
        return Math.max(1, getToken(0).beginColumn);
    }

    /// Reads all that is in the file.
    void into(Agent agent) throws ParseException, JasonException {
        setAg(agent);
        while (getToken(1).kind != EOF) {
            if (getToken(1).image.equals("{")) {
                include(agent);
            } else {
                agent_component(agent);
            }
        }
    }

    /// To the end of a directive.
    private void skip() {
        while (getToken(0).kind != EOF && !getToken(0).image.equals("}")) {
            getNextToken();
        }
    }

    private void include(Agent agent) {
        getNextToken();
        String name = getNextToken().image;
        boolean include = name.equals("include")
                && getToken(1).image.equals("(")
                && getToken(2).kind == as2jConstants.STRING
                && getToken(3).image.equals(")")
                && getToken(4).image.equals("}");
        if (!include) {
            includes.refuse(new InvalidSettings(
                    new Location(file, line(), column()),
                    "Directive '%s' is not read here. Only {include(\"FILE.asl\")} is.".formatted(name),
                    ""));
            skip();
            return;
        }
        getNextToken();
        String quoted = getNextToken().image;
        var at = new Location(file, line(), column());
        getNextToken();
        getNextToken();
        parser.read(quoted.substring(1, quoted.length() - 1), at, agent, includes);
    }
}
