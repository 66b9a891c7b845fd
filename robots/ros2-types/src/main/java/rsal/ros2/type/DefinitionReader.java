package rsal.ros2.type;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/// Reads definitions as ROS 2 writes them (design.ros2.org, *Interface definition using .msg / .srv / .action files*).
/// Comments and constants are passed over.
public final class DefinitionReader {
    /// Between messages of one text, as in schemas of MCAP.
    private static final Pattern NEXT = Pattern.compile("(?m)^={80}\\R");

    private static final String NAME = "MSG: ";
    private static final Pattern PARTS = Pattern.compile("(?m)^---[ \\t]*$");
    private static final Pattern CONSTANT = Pattern.compile("\\S+\\s+[A-Za-z]\\w*\\s*=.*");
    private static final Pattern FIELD = Pattern.compile(
            "(?<element>[A-Za-z][\\w/]*)(?:<=(?<most>\\d{1,9}))?(?:\\[(?<bound><=)?(?<count>\\d{0,9})])?\\s+(?<name>[A-Za-z]\\w*)(?:\\s+(?<fallback>\\S.*))?");
    private static final String GOAL_ID = "unique_identifier_msgs/UUID goal_id\n";
    private static final String STAMP = "builtin_interfaces/Time stamp\n";
    private static final int MOST_CHARACTERS = 1_000_000;
    private static final int MOST_FIELDS = 1_000;

    private DefinitionReader() {}

    /// @param name in full, `sensor_msgs/msg/LaserScan`
    /// @param text of a `.msg` file
    /// @throws InvalidDefinition when it can't be read
    public static RosType message(String name, String text) {
        return message(name, text, new Source(name, 1));
    }

    /// Where a text is from, for people.
    ///
    /// @param file its name, or that of its type
    /// @param firstLine the number of its first line there
    private record Source(String file, int firstLine) {}

    private static RosType message(String name, String text, Source source) {
        checkName(name);
        if (text.length() > MOST_CHARACTERS) {
            throw new InvalidDefinition("%s has %d characters. At most %d are allowed."
                    .formatted(source.file, text.length(), MOST_CHARACTERS));
        }
        var fields = new ArrayList<Field>();
        int number = source.firstLine - 1;
        for (String line : text.lines().toList()) {
            number++;
            String content = withoutComment(line).strip();
            if (!content.isEmpty() && !CONSTANT.matcher(content).matches()) {
                fields.add(field(name, "%s:%d".formatted(source.file, number), content));
            }
        }
        if (fields.size() > MOST_FIELDS) {
            throw new InvalidDefinition(
                    "%s has %d fields. At most %d are allowed.".formatted(source.file, fields.size(), MOST_FIELDS));
        }
        return new RosType(name, fields);
    }

    /// The types of a file of a package: one for a `.msg` file, several for a `.srv` or an `.action` file.
    ///
    /// @param name in full, `my_msgs/msg/Gas`; its second word says which kind of file it is
    /// @param file for people
    static List<RosType> file(String name, String text, String file) {
        return switch (name.split("/", -1)[1]) {
            case "srv" -> service(name, text, file);
            case "action" -> action(name, text, file);
            default -> List.of(message(name, text, new Source(file, 1)));
        };
    }

    /// The messages of a service.
    ///
    /// @param name `std_srvs/srv/SetBool`
    /// @param text of a `.srv` file
    public static List<RosType> service(String name, String text) {
        return service(name, text, name);
    }

    private static List<RosType> service(String name, String text, String file) {
        List<Part> parts = parts(text, file, 2);
        return List.of(parts.get(0).message(name + "_Request"), parts.get(1).message(name + "_Response"));
    }

    /// The messages of an action, with those of its services and topics.
    ///
    /// @param name `nav2_msgs/action/Spin`
    /// @param text of an `.action` file
    public static List<RosType> action(String name, String text) {
        return action(name, text, name);
    }

    private static List<RosType> action(String name, String text, String file) {
        List<Part> parts = parts(text, file, 3);
        return List.of(
                parts.get(0).message(name + "_Goal"),
                parts.get(1).message(name + "_Result"),
                parts.get(2).message(name + "_Feedback"),
                message(name + "_SendGoal_Request", GOAL_ID + name + "_Goal goal\n"),
                message(name + "_SendGoal_Response", "bool accepted\n" + STAMP),
                message(name + "_GetResult_Request", GOAL_ID),
                message(name + "_GetResult_Response", "int8 status\n" + name + "_Result result\n"),
                message(name + "_FeedbackMessage", GOAL_ID + name + "_Feedback feedback\n"));
    }

    /// A message with those that it needs, as schemas `ros2msg` of MCAP have them: the first one's text, then for each
    /// other one a line of 80 `=` and a line `MSG: std_msgs/Header`.
    ///
    /// @param name of the first
    public static List<RosType> withDependencies(String name, String text) {
        String[] blocks = NEXT.split(text, -1);
        return Stream.concat(
                        Stream.of(message(name, blocks[0])),
                        Stream.of(blocks).skip(1).map(DefinitionReader::block))
                .toList();
    }

    /// All blocks of a text that begins with a line of 80 `=`.
    static List<RosType> blocks(String text) {
        return NEXT.splitAsStream(text)
                .filter(block -> !block.isBlank())
                .map(DefinitionReader::block)
                .toList();
    }

    private static RosType block(String block) {
        String first = block.lines().findFirst().orElse("");
        String name = first.startsWith(NAME) ? first.substring(NAME.length()).strip() : "";
        if (!name.contains("/")) {
            throw new InvalidDefinition("'%s' should be a line like 'MSG: std_msgs/Header'.".formatted(first));
        }
        return message(full(name, ""), block.substring(first.length()));
    }

    /// A part of a file, between two lines of `---`.
    private record Part(String text, Source source) {
        RosType message(String name) {
            return DefinitionReader.message(name, text, source);
        }
    }

    private static List<Part> parts(String text, String file, int count) {
        String[] texts = PARTS.split(text, -1);
        if (texts.length != count) {
            throw new InvalidDefinition(
                    "%s has %d parts, separated by '---', instead of %d.".formatted(file, texts.length, count));
        }
        var parts = new ArrayList<Part>();
        int line = 1;
        for (String part : texts) {
            parts.add(new Part(part, new Source(file, line)));
            line += (int) part.chars().filter(c -> c == '\n').count();
        }
        return parts;
    }

    /// @param place of the line, for people
    private static Field field(String type, String place, String content) {
        Matcher field = FIELD.matcher(content);
        if (!field.matches()) {
            throw new InvalidDefinition("%s: '%s' is not a field. Write a type and a name, as 'float32 range_min'."
                    .formatted(place, content));
        }
        int most = field.group("most") == null ? 0 : Integer.parseInt(field.group("most"));
        Element element = element(type, field.group("element"), most);
        String fallback = field.group("fallback") == null ? "" : field.group("fallback");
        return new Field(field.group("name"), repeated(place, field, element), fallback);
    }

    private static FieldType repeated(String place, Matcher field, Element element) {
        String count = field.group("count");
        if (count == null) {
            return new FieldType(element, FieldType.Repeat.ONE, 0);
        }
        boolean isBounded = field.group("bound") != null;
        if (count.isEmpty() && !isBounded) {
            return new FieldType(element, FieldType.Repeat.ANY, 0);
        }
        if (count.isEmpty() || Integer.parseInt(count) == 0) {
            throw new InvalidDefinition(
                    "%s: '%s' needs a number above 0 in its brackets.".formatted(place, field.group("name")));
        }
        return new FieldType(
                element, isBounded ? FieldType.Repeat.BOUNDED : FieldType.Repeat.ARRAY, Integer.parseInt(count));
    }

    private static Element element(String type, String name, int most) {
        return switch (name) {
            case "string" -> new Element.Text(false, most);
            case "wstring" -> new Element.Text(true, most);
            default ->
                Primitive.named(name)
                        .<Element>map(primitive -> primitive)
                        .orElseGet(() -> new Element.Nested(full(name, type)));
        };
    }

    /// `Header` and `std_msgs/Header` as `std_msgs/msg/Header`; a name alone is of the same package.
    private static String full(String name, String user) {
        String[] words = name.split("/", -1);
        return switch (words.length) {
            case 1 ->
                name.equals("Header") ? "std_msgs/msg/Header" : user.substring(0, user.indexOf('/')) + "/msg/" + name;
            case 2 -> words[0] + "/msg/" + words[1];
            default -> name;
        };
    }

    private static void checkName(String name) {
        if (!name.matches("[A-Za-z]\\w*/(msg|srv|action)/[A-Za-z]\\w*")) {
            throw new InvalidDefinition(
                    "'%s' is not a name of a type. Write it in full, as 'sensor_msgs/msg/LaserScan'.".formatted(name));
        }
    }

    /// Up to a `#` outside of quotes.
    private static String withoutComment(String line) {
        char quote = 0;
        for (int i = 0; i < line.length(); i++) {
            char c = line.charAt(i);
            if (quote != 0) {
                quote = c == quote ? 0 : quote;
            } else if (c == '"' || c == '\'') {
                quote = c;
            } else if (c == '#') {
                return line.substring(0, i);
            }
        }
        return quote == 0 || !line.contains("#") ? line : line.substring(0, line.indexOf('#'));
    }
}
