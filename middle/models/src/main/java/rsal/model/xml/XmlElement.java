package rsal.model.xml;

import java.io.StringReader;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// An element of an XML file, with the place where it begins.
///
/// @param text of its own, without that of its children, stripped
public record XmlElement(
        String name, Map<String, String> attributes, List<XmlElement> children, String text, Location location) {
    private static final Pattern SPACES = Pattern.compile("\\s+");
    private static final int DEEPEST = 50;
    private static final int LONGEST = 60; // letters of a text in a message

    public XmlElement {
        attributes = Collections.unmodifiableMap(new LinkedHashMap<>(attributes));
        children = List.copyOf(children);
    }

    /// Reads a whole file. Other files that it names are not read, nor are declarations of its own (DTD).
    ///
    /// @param most elements
    /// @param remedy what to try when it is not XML; may be empty
    /// @throws InvalidSettings when it is not XML, or too deep or too large
    public static XmlElement read(String text, String file, int most, String remedy) {
        XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        factory.setProperty(XMLInputFactory.IS_NAMESPACE_AWARE, false);
        try {
            return read(factory.createXMLStreamReader(new StringReader(text)), file, most);
        } catch (XMLStreamException e) {
            javax.xml.stream.Location at = e.getLocation();
            String message = String.valueOf(e.getMessage());
            throw new InvalidSettings(
                    at == null
                            ? Location.of(file)
                            : new Location(file, Math.max(1, at.getLineNumber()), Math.max(1, at.getColumnNumber())),
                    "This is not XML: %s"
                            .formatted(message.substring(message.lastIndexOf('\n') + 1)
                                    .replaceFirst("^Message: ", "")),
                    remedy);
        }
    }

    /// An element that is not closed yet.
    private record Open(
            String name, Map<String, String> attributes, List<XmlElement> children, StringBuilder text, Location at) {
        XmlElement close() {
            return new XmlElement(name, attributes, children, text.toString().strip(), at);
        }
    }

    private static XmlElement read(XMLStreamReader xml, String file, int most) throws XMLStreamException {
        Deque<Open> open = new ArrayDeque<>();
        int count = 0;
        while (xml.hasNext()) {
            switch (xml.next()) {
                case XMLStreamConstants.START_ELEMENT -> {
                    var at = new Location(
                            file,
                            Math.max(1, xml.getLocation().getLineNumber()),
                            Math.max(1, xml.getLocation().getColumnNumber()));
                    if (open.size() == DEEPEST || ++count > most) {
                        throw new InvalidSettings(
                                at,
                                "This file is nested deeper than %d, or has more than %d elements."
                                        .formatted(DEEPEST, most),
                                "");
                    }
                    open.push(
                            new Open(xml.getLocalName(), attributes(xml), new ArrayList<>(), new StringBuilder(), at));
                }
                case XMLStreamConstants.CHARACTERS -> {
                    if (!open.isEmpty()) {
                        open.peek().text.append(xml.getText());
                    }
                }
                case XMLStreamConstants.END_ELEMENT -> {
                    XmlElement closed = open.pop().close();
                    if (open.isEmpty()) {
                        return closed;
                    }
                    open.peek().children.add(closed);
                }
                default -> {} // comments and the like
            }
        }
        throw new InvalidSettings(Location.of(file), "There is nothing in this file.", "");
    }

    private static Map<String, String> attributes(XMLStreamReader xml) {
        var attributes = new LinkedHashMap<String, String>();
        for (int i = 0; i < xml.getAttributeCount(); i++) {
            attributes.put(xml.getAttributeLocalName(i), xml.getAttributeValue(i));
        }
        return attributes;
    }

    /// Its children of a name.
    public Stream<XmlElement> all(String child) {
        return children.stream().filter(each -> each.name.equals(child));
    }

    /// The first descendant on a path of names; empty when there is none.
    public Optional<XmlElement> first(String... path) {
        Optional<XmlElement> found = Optional.of(this);
        for (String step : path) {
            found = found.flatMap(each -> each.all(step).findFirst());
        }
        return found;
    }

    /// What an attribute says; nothing when there is none.
    public String attribute(String key) {
        return attributes.getOrDefault(key, "");
    }

    /// Numbers in an attribute; the fallback when there is no such attribute.
    ///
    /// @throws InvalidSettings when there are others than so many finite ones
    public double[] numbers(String key, double... fallback) {
        return attributes.containsKey(key) ? numbers(key, attribute(key), fallback.length) : fallback;
    }

    /// The number that is its text.
    public double number() {
        return numbers(name, text, 1)[0];
    }

    /// The numbers that are its text.
    ///
    /// @throws InvalidSettings when there are others than so many finite ones
    public double[] numbers(int count) {
        return numbers(name, text, count);
    }

    private double[] numbers(String what, String written, int count) {
        String[] words = SPACES.split(written.strip(), -1);
        var numbers = new double[count];
        boolean right = words.length == count;
        for (int i = 0; right && i < count; i++) {
            try {
                numbers[i] = Double.parseDouble(words[i]);
                right = Double.isFinite(numbers[i]);
            } catch (NumberFormatException _) {
                right = false;
            }
        }
        if (!right) {
            throw new InvalidSettings(
                    location,
                    "'%s' must be %s, not '%s'."
                            .formatted(
                                    what,
                                    count == 1 ? "a number" : count + " numbers",
                                    written.length() > LONGEST ? written.substring(0, LONGEST) + "…" : written),
                    "");
        }
        return numbers;
    }
}
