package rsal.stage;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Suggestion;
import rsal.settings.Value;
import rsal.stage.WorldfileEntity.Setting;

/// A world file as it is written: properties and entities, includes and macros put in.
///
/// ```
/// # a comment
/// include "robots.inc"
/// define cart position ( size [0.4 0.3 0.2] )
/// resolution 0.02
/// cart ( name "r0" pose [1 2 0 90] )
/// ```
///
/// Line ends mean nothing but the end of a comment, a text, or an `include`, so that values and tuples may go
/// on in the next line.
///
/// @param root the world's own properties and its entities
/// @param known names of all types and macros, to guess what was meant
/// @param complete whether all included files were there; when not, much else follows from that
public record WorldFile(WorldfileEntity root, Set<String> known, boolean complete) {

    /// @param path of the world
    /// @param findings takes all errors that leave something to read
    /// @throws InvalidSettings when there is no such file, or too much of anything
    static WorldFile read(String path, WorldFiles files, WorldProblems findings) {
        return read(path, files, findings, Dialect.STAGE);
    }

    /// Reads another kind of file in the same way.
    public static WorldFile read(String path, WorldFiles files, WorldProblems findings, Dialect dialect) {
        Lexer.Tokens tokens = Lexer.read(path, files, findings, dialect);
        var parser = new Parser(tokens, findings, dialect);
        WorldfileEntity root = parser.world(path);
        boolean complete = tokens.complete() && !parser.incomplete;
        if (complete) {
            parser.macros.reportBaseless();
        }
        return new WorldFile(root, parser.macros.known(), complete);
    }

    /// Recursive descent; on an error it tells and goes on behind it.
    private static final class Parser {
        private static final String FINITE = "Only finite numbers can be written.";

        private final List<Token> tokens;
        private final WorldProblems findings;
        private final Macros macros;
        private final boolean closed;
        private boolean incomplete; // a file was meant to be included
        private int next;

        Parser(Lexer.Tokens tokens, WorldProblems findings, Dialect dialect) {
            this.tokens = tokens.all();
            this.closed = tokens.closed();
            this.findings = findings;
            this.macros = new Macros(findings, dialect);
        }

        WorldfileEntity world(String path) {
            var settings = new LinkedHashMap<String, Setting>();
            var entities = new ArrayList<WorldfileEntity>();
            long size = 1;
            while (next < tokens.size()) {
                Token token = tokens.get(next);
                if (token instanceof Token.Word word && word.text().equals("define")) {
                    next++;
                    define(word);
                } else if (Token.isBracket(token, ')')) {
                    findings.error(token.location(), "This ) closes nothing.", "Maybe there is one ) too many above.");
                    next++;
                } else {
                    var children = new ArrayList<Syntax>();
                    statement(settings, children, 0);
                    for (Syntax child : children) {
                        WorldfileEntity entity = macros.expand(child);
                        entities.add(entity);
                        size += entity.size();
                        if (size > Macros.MAX_ENTITIES) {
                            throw findings.fatal(
                                    child.location(),
                                    "The world has more than %d entities.".formatted(Macros.MAX_ENTITIES),
                                    "Use fewer or simpler models.");
                        }
                    }
                }
            }
            return new WorldfileEntity("world", "world", Location.of(path), settings, entities, Optional.empty(), size);
        }

        /// A property, or an entity with all that is in it.
        private void statement(Map<String, Setting> settings, List<Syntax> children, int depth) {
            Token token = tokens.get(next++);
            if (!(token instanceof Token.Word word)) {
                findings.error(
                        token.location(),
                        "Here a name was expected, not %s.".formatted(quoted(token)),
                        "Properties are written as NAME VALUE, models as TYPE ( ... ).");
                skipLine(token);
                return;
            }
            Token after = next < tokens.size() ? tokens.get(next) : null;
            if (after != null && Token.isBracket(after, '(')) {
                next++;
                children.add(body(word.text(), word.location(), after, depth + 1));
            } else if (after instanceof Token.Literal literal) {
                next++;
                settings.put(word.text(), new Setting(word.text(), word.location(), literal.scalar()));
                if (findings.isSpoiled(literal.location())) {
                    findings.spoil(word.location());
                }
                checkSingle(word, literal);
                if (depth == 0) {
                    checkNoInclude(word, literal);
                }
            } else if (after != null && Token.isBracket(after, '[')) {
                next++;
                Value.Sequence tuple = tuple(word, after);
                if (tuple.items().size() == 1
                        && next < tokens.size()
                        && Token.isBracket(tokens.get(next), '[')
                        && onLine(tokens.get(next), word)) {
                    indexed(settings, word, Units.text(tuple));
                } else {
                    settings.put(word.text(), new Setting(word.text(), word.location(), tuple));
                }
            } else {
                findings.error(
                        word.location(),
                        "'%s' has no value.".formatted(WorldProblems.shortened(word.text())),
                        after instanceof Token.Word value && onLine(after, word) ? meant(word, value) : "");
                skipLine(word);
            }
        }

        /// A name and its index with a blank between.
        private void indexed(Map<String, Setting> settings, Token.Word word, String index) {
            String name = "%s[%s]".formatted(word.text(), index);
            findings.error(
                    word.location(),
                    "There is a blank between '%s' and its index.".formatted(WorldProblems.shortened(word.text())),
                    "Maybe %s was meant?".formatted(WorldProblems.shortened(name)));
            Token opening = tokens.get(next++);
            settings.put(name, new Setting(name, word.location(), tuple(word, opening)));
        }

        /// What a word may have been meant to be that stands where a value should.
        private String meant(Token.Word name, Token.Word value) {
            String word = value.text();
            Token third = next + 1 < tokens.size() ? tokens.get(next + 1) : null;
            if (macros.isKnown(name.text())) {
                return "Models are written as %s ( ... ).".formatted(WorldProblems.shortened(name.text()));
            }
            if (Suggestion.closest(name.text(), List.of("define")).isPresent() && third instanceof Token.Word) {
                return "Maybe 'define' was meant?";
            }
            return Units.flag(word).orElseGet(() -> {
                if (isInfinite(word)) {
                    return FINITE;
                }
                return third instanceof Token.Literal || (third != null && Token.isBracket(third, '['))
                        ? "Write one before '%s'.".formatted(WorldProblems.shortened(word))
                        : "Maybe \"%s\" was meant? Texts stand in \" \".".formatted(word);
            });
        }

        private static boolean isInfinite(String word) {
            return Set.of("nan", "inf", "infinity").contains(word.toLowerCase(Locale.ROOT));
        }

        /// Several values stand in a tuple.
        private void checkSingle(Token.Word name, Token.Literal first) {
            var values = new ArrayList<String>(List.of(first.source()));
            while (next < tokens.size() && tokens.get(next) instanceof Token.Literal more && onLine(more, name)) {
                values.add(more.source());
                next++;
            }
            if (values.size() > 1) {
                findings.error(
                        name.location(),
                        "'%s' has %d values.".formatted(WorldProblems.shortened(name.text()), values.size()),
                        "Several stand in [ ]: %s [%s]."
                                .formatted(name.text(), WorldProblems.shortened(String.join(" ", values))));
                findings.spoil(name.location());
            }
        }

        /// A slip in `include` would be a property that is not known, and what the file has would be missed later.
        private void checkNoInclude(Token.Word name, Token.Literal value) {
            if (value.value() instanceof String
                    && Suggestion.closest(name.text(), List.of("include")).isPresent()) {
                findings.error(
                        name.location(),
                        "'%s' is not known in a world.".formatted(WorldProblems.shortened(name.text())),
                        "Maybe 'include' was meant?");
                incomplete = true;
            }
        }

        /// What stands between ( and ).
        private Syntax body(String name, Location location, Token opening, int depth) {
            if (depth > Macros.MAX_DEPTH) {
                throw findings.fatal(
                        location,
                        "'%s' is more than %d deep in others."
                                .formatted(WorldProblems.shortened(name), Macros.MAX_DEPTH),
                        "Maybe a ) is missing.");
            }
            var settings = new LinkedHashMap<String, Setting>();
            var children = new ArrayList<Syntax>();
            Token.Word atMargin = null; // what begins a line, though it is in here
            while (next < tokens.size() && !Token.isBracket(tokens.get(next), ')')) {
                Token token = tokens.get(next);
                if (token instanceof Token.Word word && word.text().equals("define")) {
                    findings.error(
                            token.location(),
                            "'define' can't stand inside of '%s'.".formatted(WorldProblems.shortened(name)),
                            "Maybe a ) is missing above; else put the definition first.");
                    next++;
                    define(word);
                } else {
                    if (atMargin == null
                            && token instanceof Token.Word word
                            && word.location().column() == 1
                            && next + 1 < tokens.size()
                            && Token.isBracket(tokens.get(next + 1), '(')) {
                        atMargin = word;
                    }
                    statement(settings, children, depth);
                }
            }
            if (next == tokens.size()) {
                if (closed) {
                    findings.error(
                            opening.location(),
                            "The ( of '%s' is not closed.".formatted(WorldProblems.shortened(name)),
                            atMargin == null
                                    ? "Close it with )."
                                    : "Close it with ), maybe before '%s' at %s."
                                            .formatted(WorldProblems.shortened(atMargin.text()), atMargin.location()));
                }
            } else {
                next++;
            }
            return new Syntax(name, location, settings, children);
        }

        private void define(Token.Word define) {
            int at = next;
            boolean whole = at + 2 < tokens.size()
                    && tokens.get(at) instanceof Token.Word
                    && tokens.get(at + 1) instanceof Token.Word
                    && Token.isBracket(tokens.get(at + 2), '(');
            if (!whole) {
                findings.error(
                        define.location(),
                        "'define' is incomplete.",
                        "Write define NAME BASE ( ... ), BASE being a type or a macro that is defined above.");
                skipLine(define);
                return;
            }
            Token name = tokens.get(at);
            Token base = tokens.get(at + 1);
            next = at + 3;
            Syntax body = body(base.text(), base.location(), tokens.get(at + 2), 1);
            macros.define(name.text(), name.location(), body);
        }

        /// Values up to ], on however many lines.
        private Value.Sequence tuple(Token.Word name, Token opening) {
            var items = new ArrayList<Value>();
            while (next < tokens.size() && tokens.get(next) instanceof Token.Literal literal) {
                items.add(literal.scalar());
                if (findings.isSpoiled(literal.location())) {
                    findings.spoil(name.location());
                }
                next++;
            }
            if (next < tokens.size() && Token.isBracket(tokens.get(next), ']')) {
                next++;
            } else if (next < tokens.size() && tokens.get(next) instanceof Token.Word word && onLine(word, opening)) {
                findings.error(
                        word.location(),
                        "'%s' can't stand in a tuple.".formatted(WorldProblems.shortened(word.text())),
                        isInfinite(word.text())
                                ? FINITE
                                : "Maybe \"%s\" was meant, or a ] is missing before it.".formatted(word.text()));
                findings.spoil(name.location());
                skipTuple(opening);
            } else {
                findings.error(opening.location(), "This [ is not closed.", "Close it with ].");
                findings.spoil(name.location());
            }
            return new Value.Sequence(opening.location(), items);
        }

        private void skipTuple(Token opening) {
            while (next < tokens.size() && onLine(tokens.get(next), opening)) {
                if (Token.isBracket(tokens.get(next++), ']')) {
                    return;
                }
                if (next < tokens.size() && Token.isBracket(tokens.get(next), ')')) {
                    return;
                }
            }
        }

        /// Goes on in the next line, or where a bracket of an entity must be counted.
        private void skipLine(Token error) {
            while (next < tokens.size() && onLine(tokens.get(next), error) && !Token.isBracket(tokens.get(next), ')')) {
                if (Token.isBracket(tokens.get(next), '(')) {
                    next++;
                    skipBody();
                } else {
                    next++;
                }
            }
        }

        private void skipBody() {
            for (int depth = 1; next < tokens.size() && depth > 0; next++) {
                Token token = tokens.get(next);
                depth += Token.isBracket(token, '(') ? 1 : Token.isBracket(token, ')') ? -1 : 0;
            }
        }

        private static boolean onLine(Token token, Token other) {
            return token.location().line() == other.location().line()
                    && token.location().file().equals(other.location().file());
        }

        private static String quoted(Token token) {
            return token instanceof Token.Literal ? token.text() : "'" + WorldProblems.shortened(token.text()) + "'";
        }
    }
}
