package rsal.stage;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// Cuts a world file into tokens; what it includes is put in its place.
///
/// More lenient than Stage where nothing else could be meant: numbers may have an exponent, names may begin with
/// an underscore, and no blank is needed before a tuple (`size[1 1 1]`).
final class Lexer {
    /// Of one file.
    static final int MAX_BYTES = 1 << 24;

    static final int MAX_INCLUDE_DEPTH = 32;
    static final int MAX_INCLUDES = 1000;
    static final int MAX_TOKENS = 2_000_000;
    private static final Set<String> FLAGS = Set.of("true", "false", "yes", "no");
    private static final Pattern NUMBER = Pattern.compile("[+-]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][+-]?\\d+)?");
    private static final Set<String> UNITS = Set.of(
            "m", "cm", "mm", "km", "deg", "degree", "degrees", "rad", "radians", "s", "sec", "ms", "kg", "g", "px", "w",
            "j");
    private static final String QUOTES = "'\u2018\u2019\u201c\u201d\u201e"; // that no text of Stage stands in

    private final WorldFiles files;
    private final String world;
    private final WorldProblems findings;
    private final Dialect dialect;
    private final List<Token> tokens = new ArrayList<>();
    private final Deque<String> open = new ArrayDeque<>(); // paths of files that are being read
    private int includes;
    private boolean missing;
    private boolean unclosed;

    private Lexer(WorldFiles files, String world, WorldProblems findings, Dialect dialect) {
        this.files = files;
        this.world = world;
        this.findings = findings;
        this.dialect = dialect;
    }

    /// @param complete whether all that is included was there
    /// @param closed whether all texts are; those that are not may have brackets in them that are missed elsewhere
    record Tokens(List<Token> all, boolean complete, boolean closed) {}

    static Tokens read(String world, WorldFiles files, WorldProblems findings, Dialect dialect) {
        var lexer = new Lexer(files, world, findings, dialect);
        lexer.read(files.open(world, MAX_BYTES));
        return new Tokens(lexer.tokens, !lexer.missing, !lexer.unclosed);
    }

    private void read(WorldFiles.Found file) {
        open.addLast(file.path());
        new Text(file.path(), decode(file.bytes())).read();
        open.removeLast();
    }

    /// UTF-8, or Latin-1 when it is none, as some authors' names are.
    private static String decode(byte[] bytes) {
        try {
            String text = StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(ByteBuffer.wrap(bytes))
                    .toString();
            return text.startsWith("\uFEFF") ? text.substring(1) : text;
        } catch (CharacterCodingException _) {
            return new String(bytes, StandardCharsets.ISO_8859_1);
        }
    }

    /// Whether no author writes it: control characters, but for the blanks and the end of a file of DOS.
    private static boolean isBinary(char c) {
        return c < ' ' && !Character.isWhitespace(c) && c != 0x1a;
    }

    private void include(String name, Location at) {
        if (open.size() > MAX_INCLUDE_DEPTH || ++includes > MAX_INCLUDES) {
            throw findings.fatal(
                    at,
                    "Files are included %d deep or more than %d times.".formatted(open.size(), MAX_INCLUDES),
                    "At most %d deep and %d times is read.".formatted(MAX_INCLUDE_DEPTH, MAX_INCLUDES));
        }
        WorldFiles.Found file;
        try {
            file = files.find(name, world, MAX_BYTES, at);
        } catch (InvalidSettings e) {
            missing = true;
            findings.error(
                    at,
                    e.problems().getFirst().message(),
                    e.problems().getFirst().remedy());
            return;
        }
        if (open.contains(file.path())) {
            findings.error(
                    at,
                    "'%s' includes itself: %s.".formatted(file.path(), String.join(" → ", open) + " → " + file.path()),
                    "Take one of these includes out.");
            return;
        }
        read(file);
    }

    private void add(Token token) {
        if (tokens.size() >= MAX_TOKENS) {
            throw findings.fatal(
                    token.location(),
                    "The world has more than %d words, numbers and brackets.".formatted(MAX_TOKENS),
                    "Maybe files include each other many times.");
        }
        tokens.add(token);
    }

    /// One file's text.
    private final class Text {
        private final String file;
        private final String text;
        private int next;
        private int line = 1;
        private int lineStart;
        private final Set<Character> strange = new HashSet<>(); // told in this line

        Text(String file, String text) {
            this.file = file;
            this.text = text;
        }

        void read() {
            checkIsText();
            while (next < text.length()) {
                char c = text.charAt(next);
                if (c == '\n' || c == '\r') {
                    newline();
                } else if (c == '#') {
                    skipLine();
                } else if (c == '"') {
                    string();
                } else if (c == '(' || c == ')' || c == '[' || c == ']') {
                    add(new Token.Bracket(here(), c));
                    next++;
                } else if (isLetter(c)) {
                    word();
                } else if (isNumeric(c)) {
                    number();
                } else if (Character.isWhitespace(c) || Character.isSpaceChar(c)) {
                    next++;
                } else {
                    strange(c);
                }
            }
        }

        /// What means nothing, taken for what was probably meant.
        private void strange(char c) {
            if (strange.add(c)) { // one each is enough in a line
                findings.error(here(), "'%s' is not allowed here.".formatted(c), maybe(c));
            }
            if (text.startsWith("//", next)) {
                skipLine();
            } else if (text.startsWith("/*", next)) {
                skipComment();
            } else if (QUOTES.indexOf(c) >= 0) {
                quoted();
            } else {
                if (c == '{' || c == '}') {
                    add(new Token.Bracket(here(), c == '{' ? '(' : ')'));
                }
                next++;
            }
        }

        private void skipComment() {
            int end = text.indexOf("*/", next);
            int stop = end < 0 ? text.length() : end + 2;
            while (next < stop) {
                if (text.charAt(next) == '\n' || text.charAt(next) == '\r') {
                    newline();
                } else {
                    next++;
                }
            }
        }

        /// A text in other quotes, if it is closed.
        private void quoted() {
            int end = next + 1;
            while (end < text.length() && (QUOTES + "\n\r").indexOf(text.charAt(end)) < 0) {
                end++;
            }
            if (end < text.length() && QUOTES.indexOf(text.charAt(end)) >= 0) {
                add(new Token.Literal(here(), text.substring(next + 1, end)));
                next = end + 1;
            } else {
                next++;
            }
        }

        /// A picture or a program instead of a world would else be told character by character.
        private void checkIsText() {
            int at = 0;
            while (at < text.length() && !isBinary(text.charAt(at))) {
                at++;
            }
            if (at < text.length()) {
                int code = text.charAt(at);
                throw findings.fatal(
                        locationOf(at),
                        "'%s' is not a text file: there is a byte %d in it.".formatted(file, code),
                        "Maybe it is another file, or one to be saved as UTF-8.");
            }
        }

        private Location locationOf(int at) {
            String before = text.substring(0, at);
            int lines = (int) before.chars().filter(c -> c == '\n').count();
            return new Location(file, lines + 1, at - before.lastIndexOf('\n'));
        }

        private Location here() {
            return new Location(file, line, next - lineStart + 1);
        }

        /// LF, CR, or CR LF.
        private void newline() {
            if (text.startsWith("\r\n", next)) {
                next++;
            }
            next++;
            line++;
            lineStart = next;
            strange.clear();
        }

        private void skipLine() {
            while (next < text.length() && text.charAt(next) != '\n' && text.charAt(next) != '\r') {
                next++;
            }
        }

        private void string() {
            Location at = here();
            int start = ++next;
            while (next < text.length() && "\"\n\r".indexOf(text.charAt(next)) < 0) {
                next++;
            }
            String value = text.substring(start, next);
            if (next < text.length() && text.charAt(next) == '"') {
                next++;
            } else {
                findings.error(at, "The text that begins here is not closed.", "Close it with \" on the same line.");
                unclosed = true;
            }
            add(new Token.Literal(at, value));
        }

        private void word() {
            Location at = here();
            int start = next;
            while (next < text.length() && (isWordPart(text.charAt(next)) || isColon() || isIndex())) {
                next = text.charAt(next) == '[' ? text.indexOf(']', next) + 1 : next + 1;
            }
            String word = text.substring(start, next);
            if (isPath()) {
                path(at, start);
            } else if (word.equals("include")) {
                include(at);
            } else if (dialect.player() && FLAGS.contains(word)) {
                add(new Token.Literal(at, word.equals("true") || word.equals("yes")));
            } else {
                add(new Token.Word(at, word));
            }
        }

        /// Whether a slash goes on that begins no comment.
        private boolean isPath() {
            return next + 1 < text.length() && text.charAt(next) == '/' && isWordPart(text.charAt(next + 1));
        }

        /// A path without quotes.
        private void path(Location at, int start) {
            while (next < text.length() && (isWordPart(text.charAt(next)) || text.charAt(next) == '/')) {
                next++;
            }
            String path = text.substring(start, next);
            findings.error(
                    at,
                    "'%s' stands without quotes.".formatted(WorldProblems.shortened(path)),
                    "Maybe \"%s\" was meant? Texts stand in \" \".".formatted(WorldProblems.shortened(path)));
            add(new Token.Literal(at, path));
        }

        private boolean isColon() {
            return dialect.player() && text.charAt(next) == ':';
        }

        /// Whether digits in brackets follow, `[12]`: part of a name.
        private boolean isIndex() {
            if (text.charAt(next) != '[') {
                return false;
            }
            int end = next + 1;
            while (end < text.length() && end - next < 12 && isDigit(text.charAt(end))) {
                end++;
            }
            return end > next + 1 && end < text.length() && text.charAt(end) == ']';
        }

        private void include(Location at) {
            while (next < text.length() && (text.charAt(next) == ' ' || text.charAt(next) == '\t')) {
                next++;
            }
            int end = next + 1;
            while (end < text.length() && "\"\n\r".indexOf(text.charAt(end)) < 0) {
                end++;
            }
            boolean begun = next < text.length() && text.charAt(next) == '"';
            if (begun && end < text.length() && text.charAt(end) == '"') {
                String name = text.substring(next + 1, end);
                skipLine();
                Lexer.this.include(name, at);
                return;
            }
            int start = Math.min(begun ? next + 1 : next, text.length());
            skipLine();
            String name = text.substring(start, next).split("#", 2)[0].strip();
            missing = true;
            findings.error(
                    at,
                    begun ? "'include' does not close the name of its file." : "'include' names no file in quotes.",
                    name.isEmpty() || name.indexOf('"') >= 0
                            ? "Write include \"FILE\" on one line."
                            : "Maybe include \"%s\"?".formatted(WorldProblems.shortened(name)));
        }

        private void number() {
            Location at = here();
            int start = next;
            while (next < text.length() && isNumeric(text.charAt(next))) {
                next++;
            }
            if (next < text.length() && (text.charAt(next) == 'e' || text.charAt(next) == 'E')) {
                int end = next + 1;
                while (end < text.length() && isNumeric(text.charAt(end))) {
                    end++;
                }
                boolean exponent = end > next + 1 && (end == text.length() || !isWordPart(text.charAt(end)));
                next = exponent ? end : next;
            }
            String digits = text.substring(start, next);
            int end = next;
            while (end < text.length() && isWordPart(text.charAt(end))) {
                end++;
            }
            String unit = text.substring(next, end);
            if (UNITS.contains(unit.toLowerCase(Locale.ROOT))) {
                next = end;
                wrong(
                        at,
                        digits + unit,
                        "Units are not written here; unit_length and unit_angle give those of all numbers.");
            } else {
                String read = begun(digits);
                double value = parse(read);
                if (Double.isNaN(value)) {
                    wrong(at, digits, "");
                } else {
                    if (!read.equals(digits)) {
                        findings.warn(
                                at,
                                "'%s' is read as %s, as Stage reads it."
                                        .formatted(WorldProblems.shortened(digits), read),
                                "Write the number that is meant.");
                    }
                    add(new Token.Literal(at, Double.isInfinite(value) ? digits : plain(value)));
                }
            }
        }

        /// What Stage reads of it, which goes as far as it is a number (C's `atof`); all when it does not begin with
        /// one.
        private static String begun(String digits) {
            Matcher number = NUMBER.matcher(digits);
            return number.lookingAt() ? number.group() : digits;
        }

        private void wrong(Location at, String number, String remedy) {
            findings.error(at, "'%s' is not a number.".formatted(WorldProblems.shortened(number)), remedy);
            findings.spoil(at);
            add(new Token.Literal(at, 0L));
        }
    }

    /// Whole numbers as such, so that messages show them as they were written.
    private static Object plain(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e15 ? (Object) (long) value : (Object) value;
    }

    private static double parse(String digits) {
        try {
            return Double.parseDouble(digits);
        } catch (NumberFormatException _) {
            return Double.NaN;
        }
    }

    private static String maybe(char c) {
        return switch (c) {
            case '{', '}' -> "Maybe ( ) was meant?";
            case ',' -> "Values are set apart by blanks, and decimals by a point.";
            case ';' -> "Blanks are enough between values.";
            case '=', ':' -> "A blank is enough between a name and its value.";
            case '/', '*', '%' -> "Comments begin with #.";
            default ->
                QUOTES.indexOf(c) >= 0
                        ? "Texts stand in \" \"."
                        : Character.isLetter(c) ? "Names are made of a to z, A to Z, digits and _." : "";
        };
    }

    private static boolean isLetter(char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    }

    private static boolean isDigit(char c) {
        return c >= '0' && c <= '9';
    }

    private static boolean isNumeric(char c) {
        return isDigit(c) || c == '+' || c == '-' || c == '.';
    }

    private static boolean isWordPart(char c) {
        return isLetter(c) || isDigit(c) || c == '.' || c == '-';
    }
}
