package rsal.yaml;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.Optional;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.snakeyaml.engine.v2.composer.Composer;
import org.snakeyaml.engine.v2.exceptions.Mark;
import org.snakeyaml.engine.v2.exceptions.MarkedYamlEngineException;
import org.snakeyaml.engine.v2.exceptions.YamlEngineException;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.NodeTuple;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import org.snakeyaml.engine.v2.nodes.Tag;
import org.snakeyaml.engine.v2.parser.ParserImpl;
import org.snakeyaml.engine.v2.scanner.StreamReader;
import org.snakeyaml.engine.v2.schema.CoreSchema;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Value;

/// Reads YAML 1.2 (core schema) that nobody vouches for: no tags, no doubled keys, bounded size, depth and number
/// of values, so that aliases can't blow it up.
public final class Yaml {
    /// More is refused.
    public static final int MAX_CHARACTERS = 1 << 20;

    private static final int MAX_DEPTH = 32;
    private static final Limits USUAL = new Limits(MAX_CHARACTERS, 20_000);

    private final String file;
    private final Limits limits;
    private int values;

    private Yaml(String file, Limits limits) {
        this.file = file;
        this.limits = limits;
    }

    /// How large a file may be.
    ///
    /// @param values how many texts, numbers, lists and groups
    public record Limits(int characters, int values) {}

    /// A file of settings.
    ///
    /// @param askedAt where it is named
    /// @throws InvalidSettings when there is none, or as for its text
    public static Value.Mapping read(FileSource files, String path, Location askedAt) {
        return read(path, files.text(path, MAX_CHARACTERS, askedAt));
    }

    /// @param file what to call it in messages
    /// @throws InvalidSettings when it isn't YAML, isn't a group of settings at the top, or is too much
    public static Value.Mapping read(String file, String text) {
        return read(file, text, USUAL);
    }

    /// @param file what to call it in messages
    /// @throws InvalidSettings when it isn't YAML, isn't a group of settings at the top, or is too much
    public static Value.Mapping read(String file, String text, Limits limits) {
        if (text.length() > limits.characters) {
            throw new InvalidSettings(
                    Location.of(file),
                    "The file has %d characters; at most %d are read.".formatted(text.length(), limits.characters),
                    "Maybe this isn't a settings file?");
        }
        var settings = LoadSettings.builder()
                .setLabel(file)
                .setSchema(new CoreSchema())
                .setCodePointLimit(limits.characters)
                .setAllowRecursiveKeys(false)
                .build();
        Optional<Node> root;
        try {
            var parser = new ParserImpl(settings, new StreamReader(settings, text));
            root = new Composer(settings, new ShallowParser(parser, file, MAX_DEPTH)).getSingleNode();
        } catch (MarkedYamlEngineException e) {
            Location place = e.getProblemMark()
                    .or(e::getContextMark)
                    .map(mark -> location(file, mark))
                    .orElse(Location.of(file));
            throw new InvalidSettings(
                    place,
                    "This is not YAML: %s.".formatted(YamlWords.of(e.getProblem())),
                    "Maybe a quote, a bracket or the indentation is off.");
        } catch (YamlEngineException e) {
            throw new InvalidSettings(
                    Location.of(file),
                    "This is not YAML: %s.".formatted(firstLine(e.getMessage())),
                    "Maybe it is another kind of file.");
        }
        var yaml = new Yaml(file, limits);
        if (root.isEmpty()) {
            throw new InvalidSettings(Location.of(file), "The file is empty.", "");
        }
        if (yaml.convert(root.get(), 0) instanceof Value.Mapping mapping) {
            return mapping;
        }
        throw new InvalidSettings(
                location(file, root.get().getStartMark().orElse(null)),
                "The file must hold settings (name: value) at its top.",
                "Maybe this isn't a settings file?");
    }

    private Value convert(Node node, int depth) {
        Location place = location(file, node.getStartMark().orElse(null));
        if (++values > limits.values) {
            throw new InvalidSettings(
                    place,
                    "The file holds more than %d values.".formatted(limits.values),
                    "Maybe its aliases (*name) multiply.");
        }
        if (depth > MAX_DEPTH) {
            throw new InvalidSettings(
                    place,
                    "Settings are nested deeper than %d.".formatted(MAX_DEPTH),
                    "Maybe an alias (*name) holds itself.");
        }
        return switch (node) {
            case ScalarNode scalar -> new Value.Scalar(place, scalar(scalar, place));
            case SequenceNode sequence -> {
                refuseTag(sequence, Tag.SEQ, place);
                var items = new ArrayList<Value>();
                for (Node item : sequence.getValue()) {
                    items.add(convert(item, depth + 1));
                }
                yield new Value.Sequence(place, items);
            }
            case MappingNode mapping -> {
                refuseTag(mapping, Tag.MAP, place);
                var entries = new LinkedHashMap<String, Value>();
                var keys = new LinkedHashMap<String, Location>();
                for (NodeTuple tuple : mapping.getValue()) {
                    Location keyPlace =
                            location(file, tuple.getKeyNode().getStartMark().orElse(null));
                    if (!(tuple.getKeyNode() instanceof ScalarNode key)) {
                        throw new InvalidSettings(keyPlace, "A setting's name must be a word.", "");
                    }
                    if (entries.putIfAbsent(key.getValue(), convert(tuple.getValueNode(), depth + 1)) != null) {
                        throw new InvalidSettings(
                                keyPlace, "'%s' is set twice.".formatted(key.getValue()), "Keep one of the two.");
                    }
                    keys.put(key.getValue(), keyPlace);
                }
                yield new Value.Mapping(place, entries, keys);
            }
            default -> throw new InvalidSettings(place, "This kind of YAML is not read here.", "");
        };
    }

    private static Object scalar(ScalarNode node, Location place) {
        String text = node.getValue();
        Tag tag = node.getTag();
        if (tag.equals(Tag.STR)) {
            return text;
        }
        if (tag.equals(Tag.NULL)) {
            return "";
        }
        try {
            if (tag.equals(Tag.BOOL)) {
                return flag(text);
            }
            if (tag.equals(Tag.INT)) {
                return integer(text);
            }
            if (tag.equals(Tag.FLOAT)) {
                return number(text);
            }
        } catch (NumberFormatException _) {
            throw new InvalidSettings(place, "'%s' is not a %s that can be read here.".formatted(text, name(tag)), "");
        }
        throw new InvalidSettings(place, "Tags '%s' are not read here.".formatted(tag.getValue()), "Remove the tag.");
    }

    private static String name(Tag tag) {
        return tag.equals(Tag.BOOL) ? "true or false" : tag.equals(Tag.INT) ? "whole number" : "number";
    }

    private static boolean flag(String text) {
        return switch (text.toLowerCase(java.util.Locale.ROOT)) {
            case "true" -> true;
            case "false" -> false;
            default -> throw new NumberFormatException(text);
        };
    }

    private static long integer(String text) {
        if (text.startsWith("0x")) {
            return Long.parseLong(text.substring(2), 16);
        }
        return text.startsWith("0o") ? Long.parseLong(text.substring(2), 8) : Long.parseLong(text);
    }

    private static double number(String text) {
        String word = text.replace("+", "").toLowerCase(java.util.Locale.ROOT);
        return switch (word) {
            case ".inf" -> Double.POSITIVE_INFINITY;
            case "-.inf" -> Double.NEGATIVE_INFINITY;
            case ".nan" -> Double.NaN;
            default -> Double.parseDouble(text);
        };
    }

    private static void refuseTag(Node node, Tag expected, Location place) {
        if (!node.getTag().equals(expected)) {
            throw new InvalidSettings(
                    place,
                    "Tags '%s' are not read here.".formatted(node.getTag().getValue()),
                    "Remove the tag.");
        }
    }

    static Location location(String file, @org.jspecify.annotations.Nullable Mark mark) {
        return mark == null ? Location.of(file) : new Location(file, mark.getLine() + 1, mark.getColumn() + 1);
    }

    private static String firstLine(@org.jspecify.annotations.Nullable String text) {
        return text == null ? "unreadable" : text.lines().findFirst().orElse("unreadable");
    }
}
