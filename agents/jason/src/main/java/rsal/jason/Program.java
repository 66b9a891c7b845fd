package rsal.jason;

import jason.JasonException;
import jason.asSemantics.Agent;
import jason.asSyntax.Literal;
import jason.asSyntax.parser.ParseException;
import jason.asSyntax.parser.TokenMgrError;
import java.io.StringReader;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problems;

/// The text of an agent and of all files that it includes, as it was when it was read. Immutable.
///
/// @param path of the agent's own file
/// @param texts of all its files, by path
record Program(String path, Map<String, String> texts) {
    private static final int MAX_BYTES = 1 << 18;
    private static final int MOST_FILES = 30;
    private static final Pattern LEXICAL = Pattern.compile("line (\\d+), column (\\d+)");
    private static final Pattern UNPLACED = Pattern.compile("^\\[\\]\\s*");
    private static final Pattern SOURCE = Pattern.compile("\\[?[^\\[]*:(\\d+)\\]?\\s*(.*)", Pattern.DOTALL);

    Program {
        texts = Map.copyOf(texts);
    }

    /// @throws InvalidSettings with all files that can't be read and directives that aren't, or with the
    /// first error of grammar
    static Program read(String path, FileSource files, Location askedAt) {
        var reading = new Reading(files);
        parse(path, askedAt, new Reasoner(), reading);
        reading.problems.throwIfAny();
        return new Program(path, reading.texts);
    }

    /// The files of an agent, each read once.
    private static final class Reading implements AgentSpeakParser.Includes {
        private final FileSource files;
        private final Map<String, String> texts = new LinkedHashMap<>(); // by path
        private final Problems problems = new Problems();

        Reading(FileSource files) {
            this.files = files;
        }

        @Override
        public Optional<String> text(String file, Location askedAt) {
            if (texts.containsKey(file)) {
                return Optional.empty();
            }
            if (texts.size() == MOST_FILES) {
                throw new InvalidSettings(askedAt, "An agent has at most %d files.".formatted(MOST_FILES), "");
            }
            String text = readable(file, askedAt);
            texts.put(file, text);
            return Optional.of(text);
        }

        /// Nothing of one that can't be read, so that all these are told at once.
        private String readable(String file, Location askedAt) {
            try {
                if (file.startsWith("$")) {
                    throw new InvalidSettings(
                            askedAt,
                            "File '%s' can't be included: '%s' is a folder of Jason's or JaCaMo's own, which is not here."
                                    .formatted(file, file.replaceFirst("/.*", "")),
                            "Copy the file into the folder of the agent, or remove the line.");
                }
                return files.text(file, MAX_BYTES, askedAt);
            } catch (InvalidSettings e) {
                refuse(e);
                return "";
            }
        }

        @Override
        public void refuse(InvalidSettings error) {
            problems.addAll(error);
        }
    }

    /// Gives an agent its beliefs, goals and plans; nothing happens yet.
    void into(Agent agent) {
        var left = new LinkedHashMap<>(texts);
        parse(path, Location.of(path), agent, new AgentSpeakParser.Includes() {
            @Override
            public Optional<String> text(String file, Location at) {
                return Optional.ofNullable(left.remove(file));
            }

            @Override
            public void refuse(InvalidSettings error) {
                throw error; // none is left when it was read
            }
        });
    }

    private static void parse(String path, Location askedAt, Agent agent, AgentSpeakParser.Includes includes) {
        String text = includes.text(path, askedAt).orElse("");
        var grammar = new AgentSpeakParser(new StringReader(text), path, includes, Program::parse);
        try {
            grammar.into(agent);
        } catch (ParseException e) {
            throw error(new Location(path, grammar.line(), grammar.column()), e);
        } catch (TokenMgrError e) {
            throw new InvalidSettings(
                    lexical(path, String.valueOf(e.getMessage())),
                    "This is not AgentSpeak: a text has no end, or a character is not allowed.",
                    "");
        } catch (JasonException e) {
            throw new InvalidSettings(
                    new Location(path, grammar.line(), grammar.column()), String.valueOf(e.getMessage()), "");
        } catch (StackOverflowError _) {
            throw new InvalidSettings(
                    new Location(path, grammar.line(), grammar.column()), "This is nested too deeply.", "");
        } catch (InvalidSettings e) {
            throw e;
        } catch (RuntimeException _) { // which the parser throws on some that it does not expect
            throw new InvalidSettings(
                    new Location(path, grammar.line(), grammar.column()), "This can't be read as AgentSpeak.", "");
        }
    }

    /// @param near it is, as far as it was read
    private static InvalidSettings error(Location near, ParseException e) {
        String path = near.file();
        if (e.currentToken == null) { // what the parser says itself begins with the place
            Matcher said = SOURCE.matcher(String.valueOf(e.getMessage()));
            return said.matches()
                    ? new InvalidSettings(
                            new Location(path, Integer.parseInt(said.group(1)), 1),
                            said.group(2).strip(),
                            "")
                    : new InvalidSettings(
                            near,
                            UNPLACED.matcher(String.valueOf(e.getMessage())).replaceFirst(""),
                            "");
        }
        var read = e.currentToken.next;
        var at = new Location(path, read.beginLine, read.beginColumn);
        boolean ends = read.kind == 0;
        return new InvalidSettings(
                at,
                ends
                        ? "The file ends within a belief, a goal or a plan."
                        : "'%s' can't stand here.".formatted(read.image),
                missing(e));
    }

    /// Where a step of a plan is followed by another one, a semicolon is more likely than the end of the plan.
    private static String missing(ParseException e) {
        boolean semicolon = expects(e, "\";\"");
        boolean stop = expects(e, "\".\"");
        if (semicolon && stop) {
            return "Maybe a semicolon (between two steps) or a full stop (at the end of a plan) is missing before.";
        }
        return semicolon ? "Maybe a semicolon is missing before." : stop ? "Maybe a full stop is missing before." : "";
    }

    private static boolean expects(ParseException e, String token) {
        for (int[] expected : e.expectedTokenSequences) {
            if (e.tokenImage[expected[0]].equals(token)) {
                return true;
            }
        }
        return false;
    }

    private static Location lexical(String path, String message) {
        Matcher place = LEXICAL.matcher(message);
        return place.find()
                ? new Location(path, Integer.parseInt(place.group(1)), Integer.parseInt(place.group(2)))
                : Location.of(path);
    }

    /// Where something was read.
    Location locationOf(Literal literal) {
        var source = literal.getSrcInfo();
        if (source == null || source.getSrcLine() <= 0) {
            return Location.of(path);
        }
        String file = source.getSrcFile() == null ? path : source.getSrcFile();
        int column = line(file, source.getSrcLine()).indexOf(literal.getFunctor()); // Jason does not keep it
        return new Location(file, source.getSrcLine(), Math.max(0, column) + 1);
    }

    private String line(String file, int number) {
        return texts.getOrDefault(file, "")
                .lines()
                .skip(Math.max(0, number - 1))
                .findFirst()
                .orElse("");
    }

    /// What a comment at the end of a line says; empty when there is none.
    String comment(Location at) {
        String line = line(at.file(), at.line());
        return line.contains("//") ? line.substring(line.indexOf("//") + 2).strip() : "";
    }

    /// The first comment, a line; empty when the file begins with something else.
    String title() {
        return texts.getOrDefault(path, "")
                .lines()
                .findFirst()
                .filter(line -> line.startsWith("//"))
                .map(line -> line.substring(2).strip())
                .orElse("");
    }
}
